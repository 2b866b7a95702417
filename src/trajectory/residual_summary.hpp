// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The largest residuals of a problem in long double, and where they are.

#pragma once

#include <cmath>
#include <span>

#include "brachisto/nlp/primal_dual.hpp"
#include "brachisto/nlp/problem.hpp"
#include "brachisto/trajectory/extended_residual.hpp"

namespace brachisto {

/// Keeps the largest absolute value and its index; a NaN stays.
struct Worst {
  long double value = 0.0L;
  int index = -1;

  void see(long double candidate, int i) {
    if (std::isnan(value) || std::abs(candidate) <= value) return;
    value = std::abs(candidate);
    index = i;
  }
};

/// \param gradient  of the Lagrangian at `point`; free variables have to make
///                  it zero, fixed ones have to have their value
/// \param defect    the worst constraint
[[nodiscard]] ExtendedResidual summarise(const nlp::Problem& problem,
                                         const PrimalDual& point,
                                         std::span<const long double> gradient,
                                         const Worst& defect);

}  // namespace brachisto
