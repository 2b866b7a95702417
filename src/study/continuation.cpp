// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/study/continuation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "brachisto/transcription/initial_guess.hpp"
#include "brachisto/transcription/prolongation.hpp"

namespace brachisto {

namespace {

// Steps in η_m, as fractions of the whole way.
constexpr double kFirstStep = 0.25;
constexpr double kSmallestStep = 1e-3;
// A step of Newton's method near its solution needs a handful of iterations;
// more mean that it went looking.
constexpr int kQuickIterations = 8;
// How far a slope angle may end from its prediction [rad]. The secant predicts
// to the second order in the step; branches lie further apart.
constexpr double kLargestSurprise = 0.35;

/// A solution at one η_m.
struct State {
  double fraction;  // of the whole way in η_m
  PrimalDual point;
  double phi;
};

/// `from` moved on along the line through `before` and `from`.
void extrapolate(const State& before, const State& from, double fraction,
                 MeshStart& start) {
  const double ratio =
      (fraction - from.fraction) / (from.fraction - before.fraction);
  const auto move = [&](const std::vector<double>& a,
                        const std::vector<double>& b,
                        std::vector<double>& out) {
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i] = b[i] + ratio * (b[i] - a[i]);
    }
  };
  move(before.point.x, from.point.x, start.point.x);
  move(before.point.lambda, from.point.lambda, start.point.lambda);
  start.phi = from.phi + ratio * (from.phi - before.phi);
}

double largest_surprise(const VariableLayout& layout, const PrimalDual& found,
                        const PrimalDual& predicted) {
  double worst = 0.0;
  for (int c = 0; c < layout.num_points(); ++c) {
    const auto i = static_cast<std::size_t>(layout.beta(c));
    worst = std::max(worst, std::abs(found.x[i] - predicted.x[i]));
  }
  return worst;
}

bool final(Status status) {
  return status == Status::Interrupted || status == Status::TimeLimit ||
         status == Status::OutOfMemory || status == Status::InternalError;
}

}  // namespace

Continuation continue_from_cycloid(const Scene& scene, const CycloidArc& arc,
                                   const Mesh& mesh,
                                   const MeshOptions& options) {
  Continuation result;
  const auto record = [&](const MeshSolution& solution) {
    result.iterations += solution.iterations;
    result.passes += solution.closure.passes;
    result.log += solution.log;
    result.status = solution.status;
    result.message = solution.message;
  };
  const auto at_fraction = [&](double fraction) {
    Scene scaled = scene;
    scaled.body.eta_m *= fraction;
    return scaled;
  };

  // η = 0: the axisymmetric body, whose problem has no θ.
  const double phi_0 = arc.slope_angle(arc.psi_end);
  RollingTime axisymmetric(at_fraction(0.0), mesh, phi_0);
  MeshSolution solution = solve_on_mesh(
      axisymmetric, {cycloid_guess(axisymmetric, arc), phi_0}, options);
  record(solution);
  if (!solution.solved()) return result;
  result.steps.push_back({0.0, solution.closure.phi, solution.iterations});
  const ExtremalCurve cycloid(axisymmetric, solution.point);

  // From here on all problems have the same unknowns.
  RollingTime problem(scene, mesh, phi_0);
  State last{0.0, prolong(cycloid, problem), solution.closure.phi};
  std::optional<State> before;
  double slope = solution.closure.slope;
  double step = kFirstStep;
  while (last.fraction < 1.0) {
    const double fraction = std::min(1.0, last.fraction + step);
    problem = RollingTime(at_fraction(fraction), mesh, last.phi);
    MeshStart start{last.point, last.phi, slope};
    if (before) extrapolate(*before, last, fraction, start);
    MeshOptions remaining = options;
    remaining.ipopt.max_iterations -= result.iterations;
    if (remaining.ipopt.max_iterations <= 0) {
      result.status = Status::IterationLimit;
      break;
    }
    solution = solve_on_mesh(problem, start, remaining);
    record(solution);
    if (final(solution.status)) break;
    const bool on_branch = solution.solved() &&
                           solution.first_iterations <= kQuickIterations &&
                           largest_surprise(problem.layout(), solution.point,
                                            start.point) <= kLargestSurprise;
    if (!on_branch) {
      step *= 0.5;
      if (step >= kSmallestStep) continue;
      if (solution.solved()) result.status = Status::NotConverged;
      break;
    }
    before = std::move(last);
    last = {fraction, std::move(solution.point), solution.closure.phi};
    slope = solution.closure.slope;
    result.steps.push_back(
        {fraction * scene.body.eta_m, last.phi, solution.iterations});
    if (solution.first_iterations <= kQuickIterations / 2) step *= 2.0;
  }
  if (last.fraction < 1.0) {
    result.message = fmt::format(
        "the branch from the cycloid was followed to η_m = {:.6g} of {:.6g}: "
        "{}",
        last.fraction * scene.body.eta_m, scene.body.eta_m, result.message);
    return result;
  }
  result.status = Status::Solved;
  result.phi = last.phi;
  result.closure_slope = slope;
  result.curve.emplace(problem, last.point);
  return result;
}

}  // namespace brachisto
