// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/limited_shooting.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

namespace brachisto {

namespace {

using limited::LimitedSystem;

constexpr double kUlp = std::numeric_limits<double>::epsilon();

using Orthogonal = Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>;

/// The shortest step to a residual of zero; where unknowns are left open, as
/// the costates of a path that limits hold all along, they stay.
Eigen::VectorXd newton_step(const LimitedSystem::Linearisation& at) {
  return -Orthogonal(at.jacobian).solve(at.residual);
}

void read_results(const LimitedSystem& system,
                  const LimitedSystem::Linearisation& at,
                  const Eigen::VectorXd& point, LimitedExtremal& out) {
  const Eigen::MatrixXd inverse = Orthogonal(at.jacobian).pseudoInverse();
  const auto slope_at = [&](int node) {
    const int beta = system.of_node(node) + static_cast<int>(limited::kBeta);
    return Loose{point(beta), inverse.row(beta).norm()};
  };
  out.start_angle = slope_at(0);
  out.end_angle = slope_at(system.num_nodes() - 1);
  double u = 0.0;
  Eigen::RowVectorXd moves = Eigen::RowVectorXd::Zero(inverse.cols());
  for (int a = 0; a < system.num_arcs(); ++a) {
    u += point(system.of_duration(a));
    moves += inverse.row(system.of_duration(a));
    out.junctions.push_back({u, moves.norm()});
  }
}

void find_root(const LimitedSystem& system, LimitedExtremal& out,
               Eigen::VectorXd& point) {
  constexpr int kMostSteps = 30;
  constexpr double kSmallestFactor = 1e-3;
  constexpr double kConverged = 1e-12, kRounding = 1e-10;
  const shooting::StepControl control;
  LimitedSystem::Linearisation here;
  point = system.start();
  if (!system.evaluate(point, control, here)) {
    out.message = fmt::format("the path nearby cannot be integrated on {}",
                              system.place_of(here.arc));
    return;
  }
  for (;; ++out.newton_steps) {
    out.residual = here.residual.lpNorm<Eigen::Infinity>();
    if (out.residual <= kConverged || out.newton_steps == kMostSteps) break;
    const Eigen::VectorXd change = newton_step(here);
    LimitedSystem::Linearisation there;
    double factor = 1.0;
    const auto closer = [&] {
      return system.evaluate(point + factor * change, control, there) &&
             there.residual.norm() < here.residual.norm();
    };
    while (factor >= kSmallestFactor && !closer()) factor *= 0.5;
    if (factor < kSmallestFactor) break;  // rounding, or no way
    point += factor * change;
    here = std::move(there);
  }
  if (!(out.residual <= kRounding)) {
    Eigen::Index worst = 0;
    here.residual.cwiseAbs().maxCoeff(&worst);
    out.message = fmt::format(
        "Newton's method stops at the residual {:.1e} after {} steps, of the "
        "conditions for {}",
        out.residual, out.newton_steps,
        system.place_of(here.arc_of_row[static_cast<std::size_t>(worst)]));
    return;
  }
  // What the last residual, and steps half as long, would change.
  LimitedSystem::Linearisation finer;
  if (!system.evaluate(point, {.halve = true}, finer)) {
    out.message = "the solution cannot be integrated again";
    return;
  }
  const Eigen::VectorXd change = newton_step(finer);
  out.transit_time = finer.transit_time + finer.time_gradient * change;
  out.integration_steps = finer.steps;
  out.error_estimate =
      std::abs(out.transit_time - here.transit_time) / out.transit_time +
      kUlp * std::sqrt(1.0 + finer.steps);
  read_results(system, finer, point, out);
  point += change;
  out.solved = true;
}

}  // namespace

LimitedExtremal solve_limited_extremal(const Scene& natural,
                                       const limited::Guess& guess,
                                       const StopCondition& stop) {
  const StopScope scope(stop);
  LimitedExtremal out;
  const LimitedSystem system(natural, guess);
  if (!system.refusal().empty()) {
    out.message = "arcs of this kind are not known to it: " + system.refusal();
    return out;
  }
  try {
    Eigen::VectorXd point;
    find_root(system, out, point);
    if (!out.solved) return out;
    out.path = system.path(point, {.halve = true});
    // The first node is not at rest then.
    if (out.path.blind(0)) {
      out.start_angle.value = out.path.at(0, 0.0)[limited::kBeta];
    }
    const std::string objection =
        out.path.empty()
            ? "it cannot be integrated again"
            : out.path.objection(inequalities(natural.body, natural.limits));
    if (!objection.empty()) {
      out.solved = false;
      out.message = "its arcs are not those of an extremal: " + objection;
    }
  } catch (const Stopped&) {
    if (!stop.met()) throw;
    out.solved = false;
    out.message = "stopped within an arc";
  }
  return out;
}

}  // namespace brachisto
