// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "search/continuation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "brachisto/solvers/newton_kkt.hpp"
#include "brachisto/study/solve_options.hpp"
#include "math/index.hpp"
#include "model/scene_coordinate.hpp"
#include "model/units.hpp"
#include "refinement/turn_meshes.hpp"
#include "search/branch_history.hpp"
#include "transcription/contact_equation.hpp"
#include "transcription/initial_guess.hpp"
#include "transcription/prolongation.hpp"

namespace brachisto {

namespace {

// Newton's method near its solution doubles the digits in each step; more than
// a handful means that it went looking.
constexpr int kMostNewtonSteps = 6;
// How far a slope angle may end from its prediction [rad], and how far is
// wanted: the secant predicts to second order in the step.
constexpr double kLargestPredictorError = 0.1;
constexpr double kWantedPredictorError = 0.03;
// Good enough to tell where the branch runs; the final mesh does the rest.
constexpr double kTolerance = 1e-8;

// Of θ on equal turns, where it is all but known: far from the next turn.
constexpr double kMostTurned = 0.5;

/// How far unknowns, `index(0)` to `index(count − 1)`, ended from their
/// prediction.
template <class Index>
double largest_error(int count, Index&& index, const NewtonResult& found,
                     const BranchPoint& predicted) {
  double worst = 0.0;
  for (int n = 0; n < count; ++n) {
    const std::size_t i = at(index(n));
    worst = std::max(worst, std::abs(found.point.x[i] - predicted.point.x[i]));
  }
  return worst;
}

bool moves_forward(const ExtremalCurve& curve) {
  const auto& w = curve.w_at_points();
  return std::all_of(w.begin(), w.end(), [](double v) { return v > 0.0; });
}

/// A solution in terms of the body's rotation: on the mesh of equal turns.
BranchPoint by_equal_turns(const RollingTime& problem, double fraction,
                           const NewtonResult& found) {
  const ExtremalCurve curve(problem, found.point);
  Mesh mesh = mesh_of_equal_turns(problem, found.point.x);
  const RollingTime moved(problem.scene(), mesh, found.phi);
  return {fraction, std::move(mesh), prolong(curve, moved), found.phi};
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
  Prediction prediction;
  double largest_growth = 4.0;  ///< of a step over the last
  double tolerance = kTolerance;
};

/// A line through the space of scenes, in natural units.
using SceneLine = std::function<Scene(double fraction)>;

/// Follows the extremal from `start` at fraction 0 to fraction 1.
Continuation follow(const SceneLine& scene_at, BranchPoint start,
                    const Way& way, const StopCondition& stop,
                    const ProgressHook& progress) {
  Continuation result;
  NewtonOptions newton;
  newton.tolerance = way.tolerance;
  newton.max_iterations = kMostNewtonSteps;
  newton.max_halvings = 1;
  newton.stop = stop;
  const auto correct = [&](RollingTime& problem, const BranchPoint& predicted) {
    std::optional<ContactEquation> contact;
    if (problem.scene().contact == Contact::Smooth) contact.emplace(problem);
    return solve_with_newton(problem, contact ? &*contact : nullptr,
                             predicted.point, predicted.phi, newton);
  };

  result.steps.push_back({scene_at(0.0).body.eta_m, start.phi, 0});
  BranchHistory history(std::move(start), way.prediction);
  int orientation = 0;  // of the branch: sign of the Jacobian's determinant
  double step = history.distance(way.first_step);
  while (history.last().fraction < 1.0) {
    const double from = history.last().fraction;
    const double here = history.distance(from);
    const double fraction = std::min(1.0, history.fraction_at(here + step));
    const double gone = history.distance(fraction) - here;
    const BranchPoint predicted = history.predict(fraction);
    const Scene scene = scene_at(fraction);
    NewtonResult corrected;
    double slope_error = 0.0;
    double rotation_error = 0.0;
    bool on_branch = in_order(predicted.mesh);
    std::optional<RollingTime> problem;
    if (on_branch) {
      problem.emplace(scene, predicted.mesh, predicted.phi);
      corrected = correct(*problem, predicted);
      result.newton_steps += corrected.iterations;
      if (stop.met()) {
        result.status = stopped_by(stop);
        return result;
      }
      // A point without a Newton step is the prediction itself.
      const int sign = corrected.determinant_sign;
      const VariableLayout& layout = problem->layout();
      slope_error = std::max(
          std::abs(corrected.phi - predicted.phi),
          largest_error(
              layout.num_points(), [&](int c) { return layout.beta(c); },
              corrected, predicted));
      if (way.prediction.moving_mesh) {
        rotation_error = largest_error(
            layout.num_nodes(),
            [&](int n) { return layout.state(n, StateComponent::Theta); },
            corrected, predicted);
      }
      on_branch = corrected.status == Status::Solved &&
                  slope_error <= kLargestPredictorError &&
                  rotation_error <= kMostTurned &&
                  (sign == orientation || orientation == 0 || sign == 0) &&
                  moves_forward(ExtremalCurve(*problem, corrected.point));
    }
    if (!on_branch) {
      ++result.rejected_steps;
      step = 0.5 * gone;
      if (0.5 * (fraction - from) >= way.smallest_step) continue;
      result.message = fmt::format(
          "the extremal that continues from η_m = {:.6g} could be followed to "
          "η_m = {:.6g} only, of {:.6g}",
          scene_at(0.0).body.eta_m, scene_at(from).body.eta_m,
          scene_at(1.0).body.eta_m);
      return result;
    }
    if (corrected.determinant_sign != 0) {
      orientation = corrected.determinant_sign;
    }
    // The predictor's error is of the order that follows the prediction's.
    const int order = std::max(history.degree(), 1) + 1;
    step =
        gone *
        std::clamp(std::pow(kWantedPredictorError /
                                std::max({slope_error, rotation_error, 1e-6}),
                            1.0 / order),
                   0.5, way.largest_growth);
    result.steps.push_back(
        {scene.body.eta_m, corrected.phi, corrected.iterations});
    if (progress) {
      progress("continuation",
               fmt::format("η_m = {:.4g} of {:.4g} after {} steps on {} × {}",
                           scene.body.eta_m, scene_at(1.0).body.eta_m,
                           result.steps.size() - 1, predicted.mesh.degree,
                           predicted.mesh.num_elements()));
    }
    if (fraction == 1.0) {
      result.curve.emplace(*problem, corrected.point);
      result.phi = corrected.phi;
      break;
    }
    history.add(way.prediction.moving_mesh
                    ? by_equal_turns(*problem, fraction, corrected)
                    : BranchPoint{fraction, predicted.mesh,
                                  std::move(corrected.point), corrected.phi});
  }
  result.status = Status::Solved;
  return result;
}

/// The way from the cycloid of a body that turns many times. At a fixed share
/// of the rolling time θ runs through many radians as η_m grows, and with it
/// all that depends on it; at a fixed share of the turns only the slow part of
/// the motion changes, and polynomials predict it far ahead.
Continuation follow_turns(const SceneLine& scene_at, const RollingTime& uniform,
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
  constexpr double kTurnsAtTolerance = 300.0;
  const double tolerance =
      kTolerance * std::min(1.0, kTurnsAtTolerance / number);
  const double phi = arc.slope_angle(arc.psi_end);
  const Mesh mesh = mesh_of_equal_turns(uniform, cycloid_guess(uniform, arc).x);
  const RollingTime problem(uniform.scene(), mesh, phi);
  return follow(scene_at, {0.0, mesh, cycloid_extremal(problem, arc), phi},
                {knee,
                 kSmallestShareOfKnee * knee,
                 {kDegree, knee, true},
                 kLargestGrowth,
                 tolerance},
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
  if (are_many(number)) {
    return follow_turns(scene_at, problem, arc, number, stop, progress);
  }
  // The first step has no secant to follow and tells on which side of a
  // neighbouring branch the path begins: near η_m = 0 there may be one so close
  // that a step of a tenth already lands on it.
  constexpr double kFirstStep = 1.0 / 256.0;
  constexpr double kSmallestStep = 1e-5;
  return follow(
      scene_at, {0.0, mesh, cycloid_extremal(problem, arc), phi_0},
      {scene.body.off_centred() ? kFirstStep : 1.0, kSmallestStep, {}}, stop,
      progress);
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
                                     const StopCondition& stop) {
  const Scene from = in_natural_units(neighbour.scene);
  const auto scene_at = [&](double fraction) {
    return between(from, scene, fraction);
  };
  // Beyond a few steps the way from the cycloid is the shorter one.
  constexpr double kSmallestStep = 1.0 / 8.0;
  return follow(scene_at, {0.0, neighbour.mesh, neighbour.point, neighbour.phi},
                {1.0, kSmallestStep, {}}, stop, {});
}

}  // namespace brachisto
