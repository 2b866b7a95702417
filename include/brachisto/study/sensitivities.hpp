// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How the time of an answer changes with its scene.

#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>

namespace brachisto {

struct Solution;

/// The numbers of a scene that its time is differentiated by, as problem files
/// have them.
enum class SceneParameter { EtaM, ThetaM, K, Radius, L, H };

inline constexpr std::size_t kNumSceneParameters = 6;

/// Its key: "eta_m".
[[nodiscard]] const char* name(SceneParameter parameter);

/// One of each parameter.
template <class Value>
struct PerParameter : std::array<Value, kNumSceneParameters> {
  using Base = std::array<Value, kNumSceneParameters>;
  using Base::operator[];
  [[nodiscard]] Value& operator[](SceneParameter parameter) {
    return Base::operator[](static_cast<std::size_t>(parameter));
  }
  [[nodiscard]] const Value& operator[](SceneParameter parameter) const {
    return Base::operator[](static_cast<std::size_t>(parameter));
  }
};

/// Derivatives by one number, per unit of it: 1, rad or m.
struct TimeDerivatives {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  /// dτ and dT [s], the contacts moving along: slopes of τ and T over the
  /// number.
  double tau = kNone, transit_time = kNone;
  /// The same with the slopes at A and B held from which the places of the
  /// centre there follow.
  double tau_at_fixed_contacts = kNone, transit_time_at_fixed_contacts = kNone;
};

/// ∂²τ, symmetric.
using SecondDerivatives = PerParameter<PerParameter<double>>;

/// Derivatives of an answer. Those by what the body does not have, as a bead
/// has no radius, are NaN.
struct Sensitivities {
  /// At η_m = 0 those by η_m are of a step to the stated θ_m, and those by θ_m
  /// are 0.
  PerParameter<TimeDerivatives> by;
  /// By η_m cos θ_m and η_m sin θ_m, regular at η_m = 0 too.
  std::array<TimeDerivatives, 2> by_offset;
  std::optional<SecondDerivatives> second;  ///< of τ
  /// The same with η_m cos θ_m and η_m sin θ_m for the first two parameters.
  std::optional<SecondDerivatives> second_by_offset;
  /// How far the slope φ of the contact at B moves per kink κ = φ − β_end that
  /// is asked for there, dφ/dκ; NaN without a smooth contact, or under limits.
  /// It is positive and of order 1 on the whole, 0 where the path ceases to be
  /// a minimum between its fixed ends, and infinite where the branch turns.
  double contact_response = std::numeric_limits<double>::quiet_NaN();
};

/// From the optimality conditions of an answer, which is worth no more than the
/// solution is verified(). Costs a few Newton steps on its mesh; with second
/// derivatives some hundred.
///
/// \return nothing unless the answer was found by collocation in the rolling
///         time, and where its conditions are singular: a branch turns there;
///         without `second` where the neighbours for it are not found
[[nodiscard]] std::optional<Sensitivities> sensitivities(
    const Solution& solution, bool second = false);

}  // namespace brachisto
