// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/counted_residual.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace brachisto {

namespace {

constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();

}  // namespace

CountedResidual::CountedResidual(const SquareResidual& residual,
                                 std::vector<double> start,
                                 SquareResult& result)
    : residual_(residual), result_(result) {
  result_ = {};
  result_.x = std::move(start);
  result_.residual = kUndefined;
}

double CountedResidual::operator()(std::span<const double> x,
                                   std::span<double> residual) {
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

}  // namespace brachisto
