// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/solvers/damped_newton.hpp"

#include <cmath>
#include <utility>

#include "solvers/counted_residual.hpp"

namespace brachisto {

namespace {

constexpr double kSufficientFall = 1e-4;
constexpr double kSmallestShare = 0x1p-30;

}  // namespace

SquareResult solve_by_damped_newton(const SquareResidual& residual,
                                    const NewtonCorrection& correction,
                                    std::vector<double> start,
                                    const SquareOptions& options) {
  SquareResult result;
  std::vector<double> x = start;
  CountedResidual counted(residual, std::move(start), result);
  std::vector<double> F(x.size()), step(x.size());
  std::vector<double> trial(x.size()), trial_F(x.size());
  double norm = counted(x, F);
  const char* reason = "";
  while (true) {
    if (std::isnan(norm)) reason = "F is not defined at the start";
    if (options.stop.met() || result.iterations >= options.max_iterations) {
      reason = "stopped at a limit";
    }
    if (norm <= options.tolerance || *reason != '\0') break;
    ++result.jacobians;
    if (!correction(x, F, step)) {
      reason = "the Jacobian is singular";
      break;
    }
    double share = 1.0;
    double trial_norm = norm;
    for (; share >= kSmallestShare && !options.stop.met(); share *= 0.5) {
      for (std::size_t i = 0; i < x.size(); ++i) {
        trial[i] = x[i] + share * step[i];
      }
      trial_norm = counted(trial, trial_F);
      if (trial_norm < (1.0 - kSufficientFall * share) * norm) break;
    }
    if (!(trial_norm < norm)) {
      reason = "no share of Newton's step makes ‖F‖ fall";
      break;
    }
    ++result.iterations;
    std::swap(x, trial);
    std::swap(F, trial_F);
    norm = trial_norm;
  }
  conclude(options, reason, result);
  return result;
}

}  // namespace brachisto
