// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Where some unknowns lead, one scene in each lane.

#pragma once

#include <array>
#include <cstddef>

#include "lanes/many_scenes.hpp"

namespace brachisto::lanes::detail {

/// Equations that a shot has to meet, and what else is known at its end.
template <class Number, class State>
struct Shot {
  using Unknowns = std::array<Number, Extremal::kUnknowns>;
  using Mask = typename Number::Mask;

  Unknowns residual;
  std::array<Unknowns, Extremal::kUnknowns> jacobian;  ///< rows
  State y, rates;
  Number T, beta, start_beta;
  // Of a shot with derivatives: by the unknowns, and see Extremal.
  Unknowns beta_by, start_beta_by, time_by;
  Number least_jacobian, last_jacobian, by_length;

  /// What the equations and T are of another one, in some lanes.
  void take_values(const Shot& other, const Mask& there) {
    take_all(residual, other.residual, there);
    T = where(there, other.T, T);
  }
  /// And what a search needs of its derivatives.
  void take(const Shot& other, const Mask& there) {
    take_values(other, there);
    for (std::size_t i = 0; i < jacobian.size(); ++i) {
      take_all(jacobian[i], other.jacobian[i], there);
    }
    take_all(time_by, other.time_by, there);
    least_jacobian = where(there, other.least_jacobian, least_jacobian);
    last_jacobian = where(there, other.last_jacobian, last_jacobian);
    by_length = where(there, other.by_length, by_length);
  }

 private:
  static void take_all(Unknowns& own, const Unknowns& others,
                       const Mask& there) {
    for (std::size_t i = 0; i < own.size(); ++i) {
      own[i] = where(there, others[i], own[i]);
    }
  }
};

}  // namespace brachisto::lanes::detail
