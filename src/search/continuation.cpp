// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "search/continuation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "brachisto/math/index.hpp"
#include "brachisto/run/solve_options.hpp"
#include "model/scene_coordinate.hpp"
#include "model/units.hpp"
#include "refinement/turn_meshes.hpp"
#include "search/branch_history.hpp"
#include "solvers/newton_solver.hpp"
#include "transcription/contact_equation.hpp"
#include "transcription/initial_guess.hpp"
#include "transcription/prolongation.hpp"

namespace brachisto {

namespace {

// How far a slope angle may end from its prediction [rad].
constexpr double kLargestPredictorError = 0.1;
// Good enough to tell where the branch runs; the final mesh does the rest.
constexpr double kTolerance = 1e-8;
// Of θ on equal turns, where it is all but known: far from the next turn.
constexpr double kMostTurned = 0.5;

/// How far two solutions are apart [rad].
struct Gap {
  double slope = 0.0;     ///< φ and β
  double rotation = 0.0;  ///< θ

  [[nodiscard]] double largest() const { return std::max(slope, rotation); }
};

/// \param rotation  whether that counts too
Gap gap_between(const VariableLayout& layout, const BranchPoint& a,
                const BranchPoint& b, bool rotation) {
  const auto difference = [&](int unknown) {
    const std::size_t i = at(unknown);
    return std::abs(a.point.x[i] - b.point.x[i]);
  };
  Gap gap{std::abs(a.phi - b.phi), 0.0};
  for (int c = 0; c < layout.num_points(); ++c) {
    gap.slope = std::max(gap.slope, difference(layout.beta(c)));
  }
  for (int n = 0; rotation && n < layout.num_nodes(); ++n) {
    gap.rotation = std::max(gap.rotation,
                            difference(layout.state(n, StateComponent::Theta)));
  }
  return gap;
}

/// Whether the speed is positive at all nodes but the first.
bool moves_forward(const VariableLayout& layout, const BranchPoint& found) {
  for (int n = 1; n < layout.num_nodes(); ++n) {
    if (!(found.point.x[at(layout.state(n, StateComponent::W))] > 0.0)) {
      return false;
    }
  }
  return true;
}

/// A solution of `problem` in terms of the body's rotation: on the mesh of
/// equal turns, to which the problem moves.
BranchPoint by_equal_turns(RollingTime& problem, const BranchPoint& found) {
  const ExtremalCurve curve(problem, found.point);
  Mesh mesh = mesh_of_equal_turns(problem, found.point.x);
  problem.move_to(Scene(problem.scene()), mesh, found.phi);
  return {found.fraction, std::move(mesh), prolong(curve, problem), found.phi};
}

bool in_order(const Mesh& mesh) {
  const auto& ends = mesh.boundaries;
  return std::adjacent_find(ends.begin(), ends.end(), std::greater_equal<>()) ==
         ends.end();
}

/// How a branch is followed.
struct Way {
  double first_step;     ///< as a fraction of the whole way
  double smallest_step;  ///< a shorter one that fails ends the way
  Prediction prediction = {};
  /// How far a slope angle should end from its prediction [rad].
  double wanted_error = 0.05;
  double largest_growth = 16.0;  ///< of a step over the last
  /// The same after a step that failed. Next to a fold steps shrink from one to
  /// the next, and one that does not may lead across.
  double growth_after_failure = 1.5;
  double stretch = 1.15;  ///< of the last step, so that it is the last
  /// Newton's method near its solution doubles the digits in each step; more
  /// than a handful means that it went looking.
  int most_newton_steps = 5;
  int most_halvings = 0;
  double tolerance_between = 1e-5;  ///< of the residual, on the way
  double tolerance = kTolerance;    ///< at its end
};

/// A line through the space of scenes, in natural units.
using SceneLine = std::function<Scene(double fraction)>;

/// Follows the extremal from `start` at fraction 0, a solution of `problem`, to
/// fraction 1.
Continuation follow(const SceneLine& scene_at, RollingTime problem,
                    BranchPoint start, const Way& way,
                    const StopCondition& stop, const ProgressHook& progress) {
  Continuation result;
  NewtonOptions newton;
  newton.max_iterations = way.most_newton_steps;
  newton.max_halvings = way.most_halvings;
  newton.stop = stop;
  std::optional<ContactEquation> contact;
  if (problem.scene().contact == Contact::Smooth) contact.emplace(problem);
  NewtonSolver solver(problem, contact ? &*contact : nullptr);
  const auto correct = [&](const BranchPoint& predicted) {
    const bool between = predicted.fraction < 1.0;
    newton.tolerance = between ? way.tolerance_between : way.tolerance;
    // On the way one step at least is made, which tells the determinant's sign.
    newton.to_rounding = between;
    newton.rounding = newton.tolerance;
    return solver.solve(predicted.point, predicted.phi, newton);
  };
  const bool turning = way.prediction.moving_mesh;
  const BranchDistance error = [&](const BranchPoint& a, const BranchPoint& b) {
    return gap_between(problem.layout(), a, b, false).slope;
  };

  result.steps.push_back({scene_at(0.0).body.eta_m, start.phi, 0});
  BranchHistory history(std::move(start), way.prediction);
  int orientation = 0;  // of the branch: sign of the Jacobian's determinant
  double growth = way.largest_growth;
  double step = history.distance(way.first_step);
  while (history.last().fraction < 1.0) {
    const double from = history.last().fraction;
    const double here = history.distance(from);
    const double fraction = history.fraction_at(here + way.stretch * step) < 1.0
                                ? history.fraction_at(here + step)
                                : 1.0;
    const BranchPoint predicted = history.predict(fraction);
    const Scene scene = scene_at(fraction);
    BranchPoint found;
    Gap gap;
    bool on_branch = in_order(predicted.mesh);
    if (on_branch) {
      problem.move_to(scene, predicted.mesh, predicted.phi);
      NewtonResult corrected = correct(predicted);
      result.newton_steps += corrected.iterations;
      if (stop.met()) {
        result.status = stopped_by(stop);
        return result;
      }
      found = {fraction, predicted.mesh, std::move(corrected.point),
               corrected.phi};
      gap = gap_between(problem.layout(), found, predicted, turning);
      // A point without a Newton step is the prediction itself.
      const int sign = corrected.determinant_sign;
      on_branch = corrected.status == Status::Solved &&
                  gap.slope <= kLargestPredictorError &&
                  gap.rotation <= kMostTurned &&
                  (sign == orientation || orientation == 0 || sign == 0) &&
                  moves_forward(problem.layout(), found);
      if (on_branch) {
        if (sign != 0) orientation = sign;
        result.steps.push_back(
            {scene.body.eta_m, found.phi, corrected.iterations});
      }
    }
    if (!on_branch) {
      ++result.rejected_steps;
      history.expect_less();
      growth = way.growth_after_failure;
      step = 0.5 * (history.distance(fraction) - here);
      if (0.5 * (fraction - from) >= way.smallest_step) continue;
      result.reached = from;
      return result;
    }
    if (progress) {
      progress("continuation",
               fmt::format("η_m = {:.4g} of {:.4g} after {} steps on {} × {}",
                           scene.body.eta_m, scene_at(1.0).body.eta_m,
                           result.steps.size() - 1, predicted.mesh.degree,
                           predicted.mesh.num_elements()));
    }
    if (fraction == 1.0) {
      result.curve.emplace(problem, found.point);
      result.phi = found.phi;
      break;
    }
    step = turning
               ? history.add(by_equal_turns(problem, found), gap.largest(),
                             way.wanted_error, growth)
               : history.add(std::move(found), error, way.wanted_error, growth);
    growth = way.largest_growth;
  }
  result.status = Status::Solved;
  result.reached = 1.0;
  return result;
}

/// The way from the cycloid of a body that turns many times. At a fixed share
/// of the rolling time θ runs through many radians as η_m grows, and with it
/// all that depends on it; at a fixed share of the turns only the slow part of
/// the motion changes, and polynomials predict it far ahead.
Continuation follow_turns(const SceneLine& scene_at, RollingTime problem,
                          const CycloidArc& arc, double number,
                          const StopCondition& stop,
                          const ProgressHook& progress) {
  constexpr int kDegree = 4;
  // The last turn falls into place within η_m ≈ 1/number.
  const double knee = 1.0 / number;
  constexpr double kSmallestShareOfKnee = 1e-2;
  // Polynomials amplify noise, so that steps twice as far must not be twice as
  // daring; and what a residual means for the phase grows with the turns.
  constexpr double kLargestGrowth = 2.0;
  constexpr double kWantedError = 0.03;
  constexpr double kTurnsAtTolerance = 300.0;
  const double tolerance =
      kTolerance * std::min(1.0, kTurnsAtTolerance / number);
  const double phi = arc.slope_angle(arc.psi_end);
  const Mesh mesh = mesh_of_equal_turns(problem, cycloid_guess(problem, arc).x);
  problem.move_to(Scene(problem.scene()), mesh, phi);
  BranchPoint start{0.0, mesh, cycloid_extremal(problem, arc), phi};
  return follow(scene_at, std::move(problem), std::move(start),
                {.first_step = knee,
                 .smallest_step = kSmallestShareOfKnee * knee,
                 .prediction = {kDegree, knee, true},
                 .wanted_error = kWantedError,
                 .largest_growth = kLargestGrowth,
                 .growth_after_failure = kLargestGrowth,
                 .stretch = 1.0,
                 .most_newton_steps = 6,
                 .most_halvings = 1,
                 .tolerance_between = tolerance,
                 .tolerance = tolerance},
                stop, progress);
}

}  // namespace

Continuation continue_from_cycloid(const Scene& scene, const CycloidArc& arc,
                                   const Mesh& mesh, const StopCondition& stop,
                                   const ProgressHook& progress) {
  // At η_m = 0 the cycloid is the solution. An offset next to nothing stands
  // for none, so that the problem has its θ from the start.
  constexpr double kNextToNothing = 1e-12;
  const auto scene_at = [&scene](double fraction) {
    Scene scaled = scene;
    scaled.body.eta_m *= fraction;
    return scaled;
  };
  const double phi_0 = arc.slope_angle(arc.psi_end);
  const double number = turns(scene.body, arc.arc_length(arc.psi_end));
  RollingTime problem(scene_at(kNextToNothing), mesh, phi_0);
  const auto told = [&scene](Continuation way) {
    if (way.status == Status::NotConverged) {
      way.message = fmt::format(
          "the extremal that continues from the cycloid, η_m = 0, was followed "
          "to η_m = {:.6g}, not to {:.6g}",
          way.reached * scene.body.eta_m, scene.body.eta_m);
    }
    return way;
  };
  if (are_many(number)) {
    return told(follow_turns(scene_at, std::move(problem), arc, number, stop,
                             progress));
  }
  // The first step has no secant to follow and tells on which side of a
  // neighbouring branch the path begins: near η_m = 0 there may be one so close
  // that a step of a tenth already lands on it.
  constexpr double kFirstStep = 1.0 / 256.0;
  constexpr double kSmallestStep = 1e-5;
  BranchPoint start{0.0, mesh, cycloid_extremal(problem, arc), phi_0};
  return told(
      follow(scene_at, std::move(problem), std::move(start),
             {scene.body.off_centred() ? kFirstStep : 1.0, kSmallestStep}, stop,
             progress));
}

bool comparable(const Scene& a, const Scene& b) {
  return a.body.shape == b.body.shape && a.contact == b.contact &&
         a.body.off_centred() == b.body.off_centred() && a.world.ordinary() &&
         b.world.ordinary();
}

bool can_continue(const Neighbour& neighbour, const Scene& scene) {
  const Mesh& mesh = neighbour.mesh;
  const auto finite = [](const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(),
                       [](double value) { return std::isfinite(value); });
  };
  if (!validate(neighbour.scene).empty() ||
      !comparable(scene, neighbour.scene) || mesh.degree < kMinDegree ||
      mesh.degree > kMaxDegree || mesh.boundaries.size() < 2 ||
      mesh.boundaries.front() != 0.0 || mesh.boundaries.back() != 1.0 ||
      !finite(mesh.boundaries) || !in_order(mesh)) {
    return false;
  }
  const VariableLayout layout(mesh.num_points(), scene.body.off_centred());
  const std::vector<double>& x = neighbour.point.x;
  const std::vector<double>& lambda = neighbour.point.lambda;
  return x.size() == static_cast<std::size_t>(layout.num_variables()) &&
         lambda.size() == static_cast<std::size_t>(layout.num_constraints()) &&
         finite(x) && finite(lambda) && std::isfinite(neighbour.phi);
}

Continuation continue_from_neighbour(const Scene& scene,
                                     const Neighbour& neighbour,
                                     const StopCondition& stop,
                                     double smallest_step) {
  const Scene from = in_natural_units(neighbour.scene);
  const auto scene_at = [&](double fraction) {
    return between(from, scene, fraction);
  };
  Continuation way =
      follow(scene_at, RollingTime(from, neighbour.mesh, neighbour.phi),
             {0.0, neighbour.mesh, neighbour.point, neighbour.phi},
             {1.0, smallest_step}, stop, {});
  if (way.status == Status::NotConverged) {
    way.message = fmt::format(
        "the extremal of the neighbouring scene could be followed {:.3g} of "
        "the way only",
        way.reached);
  }
  return way;
}

}  // namespace brachisto
