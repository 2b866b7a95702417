// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/square_system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "math/dense.hpp"

namespace brachisto {

namespace {

constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();

/// A residual that counts its evaluations and remembers the best point.
class CountedResidual {
 public:
  /// \param result  keeps counts and the best point; outlives this
  CountedResidual(const SquareResidual& residual, std::vector<double> start,
                  SquareResult& result)
      : residual_(residual), result_(result) {
    result_ = {};
    result_.x = std::move(start);
    result_.residual = kUndefined;
  }

  /// The norm of F(x); NaN if F is not defined there.
  double operator()(std::span<const double> x, std::span<double> residual) {
    ++result_.evaluations;
    if (!residual_(x, residual)) {
      ++result_.refused_points;
      if (result_.first_refused.empty()) {
        result_.first_refused.assign(x.begin(), x.end());
      }
      std::fill(residual.begin(), residual.end(), kUndefined);
      return kUndefined;
    }
    double sum = 0.0;
    for (const double value : residual) sum += value * value;
    const double norm = std::sqrt(sum);
    if (!(norm >= result_.residual)) {
      result_.residual = norm;
      result_.x.assign(x.begin(), x.end());
    }
    return norm;
  }

 private:
  const SquareResidual& residual_;
  SquareResult& result_;
};

/// The status of an iteration that ended for a reason of its own: by the best
/// residual, then by what stopped it.
void conclude(const SquareOptions& options, std::string reason,
              SquareResult& result) {
  if (result.residual <= options.tolerance) {
    result.status = Status::Solved;
    result.message = fmt::format("‖F‖ = {:.1e}", result.residual);
    return;
  }
  result.status = options.stop.interrupted()   ? Status::Interrupted
                  : options.stop.out_of_time() ? Status::TimeLimit
                  : result.iterations >= options.max_iterations
                      ? Status::IterationLimit
                  : result.refused_points > 0 ? Status::NotEvaluable
                                              : Status::NotConverged;
  result.message =
      fmt::format("{}; ‖F‖ = {:.1e} after {} iterations", std::move(reason),
                  result.residual, result.iterations);
}

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

SquareResult solve_by_hybrid(const SquareResidual& residual,
                             std::vector<double> start,
                             const SquareOptions& options) {
  SquareResult result;
  const Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(
      start.data(), static_cast<Eigen::Index>(start.size()));
  CountedResidual counted(residual, std::move(start), result);
  const math::HybridEnd end = math::run_hybrid(
      [&](const Eigen::VectorXd& at, Eigen::VectorXd& values,
          Eigen::Index iterations) {
        const auto size = static_cast<std::size_t>(at.size());
        const double norm = counted({at.data(), size}, {values.data(), size});
        const bool undefined = iterations == 0 && std::isnan(norm);
        return undefined || norm <= options.tolerance ||
               iterations > options.max_iterations || options.stop.met();
      },
      x);
  if (std::isnan(result.residual)) {
    conclude(options, "F is not defined at the start", result);
    return result;
  }
  result.jacobians = end.steps;
  result.iterations = end.iterations;
  // Eigen does not count the step that ends it.
  if (result.residual <= options.tolerance) ++result.iterations;
  conclude(options, end.reason, result);
  return result;
}

}  // namespace brachisto
