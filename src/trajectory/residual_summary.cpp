// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/residual_summary.hpp"

#include <cstddef>

namespace brachisto {

ExtendedResidual summarise(const nlp::Problem& problem, const PrimalDual& point,
                           std::span<const long double> gradient,
                           const Worst& defect) {
  Worst stationarity;
  Worst fixed_value;
  for (int i = 0; i < problem.num_variables(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double value = problem.lower()[k];
    if (value == problem.upper()[k]) {
      fixed_value.see(static_cast<long double>(point.x[k]) - value, i);
    } else {
      stationarity.see(gradient[k], i);
    }
  }
  ExtendedResidual out{static_cast<double>(stationarity.value),
                       static_cast<double>(defect.value),
                       static_cast<double>(fixed_value.value),
                       {},
                       {}};
  if (stationarity.index >= 0) {
    out.worst_variable = problem.variable_name(stationarity.index);
  }
  if (defect.index >= 0) {
    out.worst_constraint = problem.constraint_name(defect.index);
  }
  return out;
}

}  // namespace brachisto
