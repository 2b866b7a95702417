// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Where some unknowns lead, one scene in each lane.

#pragma once

#include <array>
#include <bit>
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

  /// Takes another one, in some lanes.
  void take(const Shot& other, const Mask& there) {
    // A shot is nothing but numbers.
    using Numbers = std::array<Number, sizeof(Shot) / sizeof(Number)>;
    auto own = std::bit_cast<Numbers>(*this);
    const auto others = std::bit_cast<Numbers>(other);
    for (std::size_t i = 0; i < own.size(); ++i) {
      own[i] = where(there, others[i], own[i]);
    }
    *this = std::bit_cast<Shot>(own);
  }
  /// What the equations and T are of it, and keeps derivatives.
  void take_values(const Shot& other, const Mask& there) {
    for (std::size_t i = 0; i < residual.size(); ++i) {
      residual[i] = where(there, other.residual[i], residual[i]);
    }
    T = where(there, other.T, T);
  }
};

}  // namespace brachisto::lanes::detail
