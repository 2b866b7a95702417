// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How the user says which mesh to compute on.

#pragma once

#include <optional>

namespace brachisto {

/// Which discretisation of the optimal-control problem to solve.
enum class Formulation { RollingTime };

inline constexpr int kMinDegree = 1;
inline constexpr int kMaxDegree = 8;
inline constexpr double kDefaultTolerance = 1e-10;

/// The wanted accuracy or a fixed mesh.
///
/// With neither `elements` nor `nodes` the mesh follows from `tolerance`.
/// `nodes` means N p + 1 for degree p and N elements and excludes `elements`.
struct Discretisation {
  Formulation formulation = Formulation::RollingTime;
  std::optional<double> tolerance;  ///< wanted relative error of T, in
                                    ///< [1e-13, 1e-1]; default 1e-10 where the
                                    ///< mesh is not fixed
  std::optional<int> degree;    ///< p, in [kMinDegree, kMaxDegree]; default 5
  std::optional<int> elements;  ///< N ≥ 1
  std::optional<int> nodes;     ///< N p + 1

  [[nodiscard]] bool fixed() const { return elements || nodes; }
};

}  // namespace brachisto
