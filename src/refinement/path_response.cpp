// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/path_response.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "math/index.hpp"
#include "refinement/open_conditions.hpp"

namespace brachisto {

PathResponse::PathResponse(const LimitedCurve& curve, PathSetting setting)
    : curve_(curve),
      setting_(std::move(setting)),
      problem_(curve.problem()),
      active_(nlp::active_set(problem_, curve.point())),
      system_(problem_, nullptr, active_) {
  LimitedCurve copy = curve;
  num_open_ = open_conditions(copy, setting_.arcs, setting_.ends).size();
  const PrimalDual& point = curve.point();
  if (!system_.evaluate(point.x, point.lambda, 0.0)) return;
  system_.evaluate_jacobian();
  chain_ = BorderedChain::make(system_);
  if (chain_ && !chain_->factorise()) chain_.reset();
}

LimitedTime PathResponse::problem_of(const PathSetting& changed) const {
  return {problem_.scene(), changed.limits,
          mesh_of(changed.arcs, problem_.mesh().degree), changed.ends,
          held_limits(changed.arcs)};
}

std::vector<double> PathResponse::residual_of(LimitedTime changed) const {
  KktSystem other(changed, nullptr, active_);
  const PrimalDual& point = curve_.point();
  if (!other.evaluate(point.x, point.lambda, 0.0)) {
    return std::vector<double>(at(system_.size()), std::nan(""));
  }
  return {other.residual().begin(), other.residual().end()};
}

PathRates PathResponse::to(const PathSetting& less, const PathSetting& more,
                           double width) const {
  const LimitedTime before = problem_of(less);
  const LimitedTime after = problem_of(more);
  std::vector<double> rhs = residual_of(before);
  const std::vector<double> high = residual_of(after);
  for (std::size_t i = 0; i < rhs.size(); ++i) {
    rhs[i] = (rhs[i] - high[i]) / width;
  }
  std::vector<double> rate(rhs.size());
  if (!chain_->solve(rhs, rate)) {
    std::fill(rate.begin(), rate.end(), std::nan(""));
  }
  const auto follow = [&](const LimitedTime& there, const PathSetting& changed,
                          double by) {
    PrimalDual point = curve_.point();
    std::size_t i = 0;
    for (double& x : point.x) x += by * rate[i++];
    for (double& lambda : point.lambda) lambda += by * rate[i++];
    LimitedTime problem = there;
    const bool finite = std::ranges::all_of(
        rate, [](double value) { return std::isfinite(value); });
    if (!finite || !problem.set_point(point.x)) {
      return PathRates{std::nan(""),
                       Eigen::VectorXd::Constant(num_open_, std::nan(""))};
    }
    LimitedCurve curve(there, std::move(point));
    return PathRates{curve.transit_time(),
                     open_conditions(curve, changed.arcs, changed.ends)};
  };
  const PathRates low = follow(before, less, -0.5 * width);
  const PathRates up = follow(after, more, 0.5 * width);
  return {(up.time - low.time) / width, (up.open - low.open) / width};
}

double PathResponse::lagrangian(const PathSetting& changed) const {
  LimitedTime problem = problem_of(changed);
  const PrimalDual& point = curve_.point();
  if (!problem.set_point(point.x)) return std::nan("");
  std::vector<double> g(point.lambda.size());
  problem.eval_g(g);
  long double sum = problem.eval_f();
  for (std::size_t i = 0; i < g.size(); ++i) {
    const nlp::Range range = problem.constraint_range(static_cast<int>(i));
    if (!range.single()) continue;
    sum += static_cast<long double>(point.lambda[i]) * (g[i] - range.lower);
  }
  return static_cast<double>(sum);
}

std::vector<PathRates> PathResponse::to_unknowns() const {
  constexpr double kStep = 1e-6, kShare = 1e-3;
  std::vector<PathRates> rates;
  const auto add = [&](double step,
                       const std::function<void(PathSetting&, double)>& move) {
    PathSetting less = setting_, more = setting_;
    move(less, -step);
    move(more, step);
    rates.push_back(to(less, more, 2.0 * step));
  };
  double begin = 0.0;
  for (std::size_t i = 0; i + 1 < setting_.arcs.size(); ++i) {
    const double end = setting_.arcs[i].end;
    const double room = std::min(end - begin, setting_.arcs[i + 1].end - end);
    add(std::min(kStep, kShare * room),
        [=](PathSetting& moved, double by) { moved.arcs[i].end += by; });
    begin = end;
  }
  if (end_is_sought(problem_.scene())) {
    add(kStep, [](PathSetting& moved, double by) { moved.ends.phi += by; });
  }
  if (start_is_sought(problem_.scene(), problem_.limits())) {
    add(kStep, [](PathSetting& moved, double by) { *moved.ends.start += by; });
  }
  return rates;
}

Eigen::MatrixXd jacobian_of(const std::vector<PathRates>& rates) {
  const auto n = static_cast<Eigen::Index>(rates.size());
  Eigen::MatrixXd jacobian(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    jacobian.col(i) = rates[static_cast<std::size_t>(i)].open;
  }
  return jacobian;
}

}  // namespace brachisto
