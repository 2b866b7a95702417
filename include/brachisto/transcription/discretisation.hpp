// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How the user says which mesh to compute on.

#pragma once

#include <optional>

namespace brachisto {

/// Which discretisation of the optimal-control problem to solve.
enum class Formulation {
  RollingTime,  ///< collocation of degree p in the rolling time; order 2p
  ArcLength,    ///< the paper's variables, on straight pieces; order 2
};

inline constexpr int kMinDegree = 1;
inline constexpr int kMaxDegree = 8;
/// Of a fixed mesh.
inline constexpr int kDefaultDegree = 5;
/// More elements are no mesh that any machine has the memory for.
inline constexpr int kMaxElements = 10'000'000;
inline constexpr int kMaxNodes = kMaxElements * kMaxDegree + 1;
inline constexpr double kSmallestTolerance = 1e-13;
inline constexpr double kLargestTolerance = 1e-1;
inline constexpr double kDefaultTolerance = 1e-10;
/// An arc_length mesh for a smaller relative error needs some 10⁵ pieces, which
/// collocation replaces by a hundred nodes.
inline constexpr double kSmallestArcLengthTolerance = 1e-9;
inline constexpr double kDefaultArcLengthTolerance = 1e-6;
/// So few that half as many still show an error.
inline constexpr int kFewestPieces = 8;

/// The wanted accuracy or a fixed mesh.
///
/// With neither `elements` nor `nodes` the mesh follows from `tolerance`.
/// `nodes` means N p + 1 for degree p and N elements and excludes `elements`.
/// An arc_length mesh has no degree; its N pieces have N + 1 nodes.
struct Discretisation {
  Formulation formulation = Formulation::RollingTime;
  /// Wanted relative error of T, in [kSmallestTolerance, kLargestTolerance],
  /// for arc_length from kSmallestArcLengthTolerance on; see
  /// wanted_tolerance().
  std::optional<double> tolerance;
  std::optional<int> degree;    ///< p, in [kMinDegree, kMaxDegree]; default 5
  std::optional<int> elements;  ///< N, in [1, kMaxElements]
  std::optional<int> nodes;     ///< N p + 1, at most kMaxNodes

  [[nodiscard]] bool fixed() const { return elements || nodes; }
  /// p of a mesh that is fixed; pieces are straight.
  [[nodiscard]] int degree_of_fixed() const {
    return formulation == Formulation::ArcLength
               ? 1
               : degree.value_or(kDefaultDegree);
  }
  /// The wanted relative error of T, where the mesh follows from it.
  [[nodiscard]] double wanted_tolerance() const {
    return tolerance.value_or(formulation == Formulation::ArcLength
                                  ? kDefaultArcLengthTolerance
                                  : kDefaultTolerance);
  }
};

}  // namespace brachisto
