// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/continuation.hpp"

#include <algorithm>
#include <cmath>

namespace brachisto::shooting {

namespace {

// Those repeated with half the length included.
constexpr int kMostSteps = 2000;
constexpr double kFirstStep = 0.1;  // in scaled globals, η among them
constexpr double kLongestStep = 0.4;
constexpr double kShortestStep = 1e-7;
constexpr double kWantedContraction = 0.1;
constexpr double kLargestContraction = 0.4;
constexpr double kLargestCorrection = 0.15;  // of the globals, in steps
constexpr double kSmallestCosine = 0.95;     // between successive tangents

/// Enough digits to stay on the branch; the last point gets the others. The
/// longer the path, the more a local error moves its end: measured, about with
/// the square of the number of turns.
ShootingOptions loose(int num_arcs) {
  constexpr double kLocalError = 1e-9;
  constexpr double kTightest = 1e-13;
  constexpr double kShort = 6.0;  // arcs
  const double excess = std::max(1.0, num_arcs / kShort);
  return {.integration = {.tolerance = std::max(
                              kTightest, kLocalError / (excess * excess)),
                          .halve = false},
          .tolerance = 1e-7,
          .max_steps = 6,
          .smallest_factor = 1.0};
}

Globals scaled(const Globals& q, const ChainScale& scale) {
  return q.cwiseQuotient(scale.globals);
}

/// Direction of the branch at a solution.
struct Tangent {
  ChainVector direction;  ///< of unit length in the scaled globals
  /// Sign of the determinant of the Jacobian with the direction as last row.
  /// It is the same all along a branch (Keller 1977), and different on the
  /// other side of two branches that nearly cross.
  int orientation = 0;
};

/// The tangent that makes an acute angle with `along`, a covector.
Tangent tangent_at(const Linearisation& at, const ChainScale& scale,
                   const Globals& along) {
  const ChainElimination chain(at.jacobian, along);
  Tangent tangent{chain.solve(1.0), chain.determinant_sign()};
  ChainVector& direction = tangent.direction;
  const double length = scaled(direction.globals, scale).norm();
  direction.globals /= length;
  for (Vector6& node : direction.nodes) node /= length;
  return tangent;
}

/// Covector that measures displacement along a tangent.
Globals covector(const Tangent& tangent, const ChainScale& scale) {
  return scaled(scaled(tangent.direction.globals, scale), scale);
}

void record(const ShootingResult& result, ContinuationReport& report) {
  report.points.push_back({result.point.globals(kEta),
                           result.point.globals(kPhi), result.at.transit_time});
}

/// η at the fold between two points of the branch, by regula falsi on how far
/// to go along the tangent until dη/ds vanishes.
///
/// \param slope  dη/ds at the end of the step of this length from `here`
double fold_between(const ShootingSystem& system, const ShootingResult& here,
                    const Tangent& tangent, double length, double slope,
                    const ChainScale& scale, const ShootingOptions& newton) {
  constexpr int kSteps = 8;
  constexpr double kFlat = 1e-5;
  const Globals along = covector(tangent, scale);
  double low = 0.0;
  double slope_low = tangent.direction.globals(kEta);
  double high = length;
  double slope_high = slope;
  double eta = here.point.globals(kEta);
  for (int i = 0; i < kSteps; ++i) {
    const double middle =
        low + (high - low) * slope_low / (slope_low - slope_high);
    const ChainVector predicted = moved(here.point, middle, tangent.direction);
    const ShootingResult at =
        solve_newton(system, predicted, scale,
                     {along, along.dot(predicted.globals)}, newton);
    if (at.end != NewtonEnd::Converged) return eta;
    eta = at.point.globals(kEta);
    const double found =
        tangent_at(at.at, scale, along).direction.globals(kEta);
    if (std::abs(found) < kFlat) return eta;
    if (found * slope_low > 0.0) {
      low = middle;
      slope_low = found;
      slope_high *= 0.5;  // the Illinois variant: never keep an end for long
    } else {
      high = middle;
      slope_high = found;
      slope_low *= 0.5;
    }
  }
  return eta;
}

}  // namespace

FollowedBranch follow_branch(const ShootingSystem& system,
                             const ChainVector& start, const ChainScale& scale,
                             double target, const ExtremalOptions& options) {
  const ShootingOptions newton = loose(system.num_arcs());
  FollowedBranch branch;
  branch.point = start;
  ShootingResult here =
      solve_newton(system, start, scale, TangencyRow::offset(0.0), newton);
  branch.newton_steps += here.steps;
  if (here.end == NewtonEnd::Stopped) branch.end = BranchEnd::Stopped;
  if (here.end != NewtonEnd::Converged) return branch;
  record(here, branch.report);
  branch.point = here.point;
  Tangent tangent = tangent_at(here.at, scale, Globals::Unit(kEta));
  double step = kFirstStep;

  for (int i = 0; i < kMostSteps; ++i) {
    const double eta = here.point.globals(kEta);
    const double eta_slope = tangent.direction.globals(kEta);
    const double to_target = (target - eta) / eta_slope;
    const bool lands = to_target > 0.0 && to_target <= step;
    const double length = lands ? to_target : step;
    const ChainVector predicted = moved(here.point, length, tangent.direction);
    TangencyRow tangency = TangencyRow::offset(target);
    if (!lands) {
      tangency.row = covector(tangent, scale);
      tangency.value = tangency.row.dot(predicted.globals);
    }

    ShootingResult next =
        solve_newton(system, predicted, scale, tangency, newton);
    branch.newton_steps += next.steps;
    if (next.end == NewtonEnd::Stopped) {
      branch.end = BranchEnd::Stopped;
      return branch;
    }
    bool good = next.end == NewtonEnd::Converged &&
                next.first_contraction <= kLargestContraction &&
                scaled(next.point.globals - predicted.globals, scale).norm() <=
                    kLargestCorrection * length &&
                next.point.globals(kEta) <= target + 1e-12;
    Tangent next_tangent;
    if (good) {
      const Globals along = covector(tangent, scale);
      next_tangent = tangent_at(next.at, scale, along);
      good = along.dot(next_tangent.direction.globals) >= kSmallestCosine &&
             next_tangent.orientation == tangent.orientation;
    }
    if (!good) {
      ++branch.report.rejected_steps;
      step = 0.5 * length;
      if (step < kShortestStep) {
        branch.end = BranchEnd::StepTooSmall;
        return branch;
      }
      continue;
    }

    const double next_slope = next_tangent.direction.globals(kEta);
    const bool fold = next_slope * eta_slope < 0.0;
    if (fold) {
      branch.report.folds.push_back(fold_between(system, here, tangent, length,
                                                 next_slope, scale, newton));
    }
    record(next, branch.report);
    here = std::move(next);
    tangent = std::move(next_tangent);
    branch.point = here.point;
    if (lands) {
      branch.end = BranchEnd::Reached;
      return branch;
    }
    if ((fold && !options.follow_folds) || here.point.globals(kEta) < 0.0) {
      branch.end = BranchEnd::TurnsBack;
      return branch;
    }
    const double growth =
        std::sqrt(kWantedContraction / std::max(here.first_contraction, 1e-3));
    step = std::min(kLongestStep, length * std::clamp(growth, 0.3, 2.0));
  }
  branch.end = BranchEnd::MaxSteps;
  return branch;
}

}  // namespace brachisto::shooting
