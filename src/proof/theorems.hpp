// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What is shown of an extremal once it is known to exist.

#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "proof/plain_system.hpp"

namespace brachisto::proof {

/// Whether a function of u is positive, shown or refuted by enclosures.
enum class Sign { Positive, Unknown, Refuted };

/// All from one end to the other.
[[nodiscard]] inline Real hull(const Real& from, const Real& to) {
  Real out;
  arb_union(out.get(), from.get(), to.get(), working_bits);
  return out;
}

/// The sign all along, the way cut into pieces if need be. It is refuted if the
/// function is negative at a point, which is then written down.
/// \param value  encloses the function over an interval of u
template <class Value>
[[nodiscard]] Sign sign_along(const Real& from, const Real& to,
                              const Value& value, Real& where, int pieces = 1) {
  constexpr int kMostPieces = 128;
  constexpr double kSplit = 0.5;
  if (value(hull(from, to)).positive()) return Sign::Positive;
  const Real middle = ((from + to) * Real(kSplit)).middle();
  if ((-value(middle)).positive()) {
    where = middle;
    return Sign::Refuted;
  }
  if (2 * pieces > kMostPieces) return Sign::Unknown;
  const Sign first = sign_along(from, middle, value, where, 2 * pieces);
  if (first == Sign::Refuted) return first;
  const Sign second = sign_along(middle, to, value, where, 2 * pieces);
  return first == Sign::Unknown && second == Sign::Positive ? first : second;
}

/// A statement, or why it is not shown.
struct Theorem {
  bool holds = false;
  bool refuted = false;  ///< its contrary is shown
  std::string why_not = {};

  /// What is shown of one more step of its way.
  /// \param what  "R_n > 0"
  /// \param u     where, from the start of its arc
  /// \param arc   its number from 1; 0 of a single one
  void meet(Sign sign, std::string_view what, double u, std::size_t arc = 0);
};

/// Numbers of the extremal, enclosed: without dimension and in radians.
struct Enclosures {
  Real tau;          ///< T √(2 g/H)
  Real start_angle;  ///< β₀
  Real end_angle;    ///< φ
  Real length;       ///< S/H
  Real rotation;     ///< θ − θ_m at the end
};

/// By their names in certificates.
inline constexpr std::array<std::pair<const char*, Real Enclosures::*>, 5>
    kEnclosures{{{"tau", &Enclosures::tau},
                 {"start_angle", &Enclosures::start_angle},
                 {"end_angle", &Enclosures::end_angle},
                 {"length_per_H", &Enclosures::length},
                 {"rotation", &Enclosures::rotation}}};

/// What is found of Weierstrass' excess, the time that another slope costs
/// more.
struct Excess {
  Theorem positive;  ///< for all other slopes, all along
  /// Slopes β + δ of which it is shown lie between.
  double least = 0.0, most = 0.0;
};

/// The least friction that suffices from a share of T on: max |R_t|/R_n.
struct Friction {
  double share = 0.0;
  Real mu;     ///< no number if it is not enclosed
  Real place;  ///< x/H of the centre there
};

/// An extremal of one free arc, in the units of in_own_units().
struct FreeExtremal {
  State start;  ///< components
  State end;
  Real length;  ///< U
  Enclosures enclosed;
  Real per_H;         ///< the unit of length over H
  Real start_place;   ///< x of the centre at A, if that is not in `start`
  bool rests = true;  ///< at A
};

[[nodiscard]] FreeExtremal as_free(const PlainSystem& system, const Root& root);

/// All that is shown.
struct Theorems {
  Enclosures enclosed;
  /// h_ββ > 0 and no point conjugate to the end: a strict weak local minimum
  /// between its fixed ends.
  Theorem legendre, no_conjugate_point;
  Theorem presses;  ///< R_n > 0 on (0, U]
  Theorem no_fold;  ///< r κ_c < 1 on (0, U]
  Theorem no_loop;  ///< −π < β < π
  Excess excess;
  std::vector<Friction> friction;

  [[nodiscard]] bool strict_minimum() const {
    return legendre.holds && no_conjugate_point.holds;
  }
  /// Among paths that stay near in place, of any slopes.
  [[nodiscard]] bool strong_minimum() const {
    return strict_minimum() && excess.positive.holds;
  }
};

/// \param extremal  of which that it exists is shown
/// \throws NotProven  if its motion cannot be enclosed
[[nodiscard]] Theorems prove_theorems(const Scene& scene,
                                      const FreeExtremal& extremal,
                                      const Accuracy& accuracy);

/// Whether no point of the extremal but its end is conjugate to that.
///
/// In the coordinates (x, θ, w), where the motion is regular from rest on and z
/// follows from the energy, all extremals that end in (x_B, z_B) with any θ,
/// p_θ = p_w = 0 and 𝓗 = 0 are a family of two parameters, θ and β at the end.
/// The determinant of its derivatives by both and by u vanishes at the end, and
/// is shown to vanish nowhere else, the start included. In other worlds, where
/// fields depend on the place and drag takes energy, the coordinates are
/// (x, z, θ, w) and w at the end is a third parameter.
///
/// \param end  the state at the end, enclosed; of its costates nothing is used
[[nodiscard]] Theorem no_conjugate_point(const Scene& scene, const State& end,
                                         const Real& length,
                                         const Accuracy& accuracy);

}  // namespace brachisto::proof
