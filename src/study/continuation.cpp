// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/study/continuation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "brachisto/model/units.hpp"
#include "brachisto/solvers/newton_kkt.hpp"
#include "brachisto/transcription/contact_equation.hpp"
#include "brachisto/transcription/initial_guess.hpp"

namespace brachisto {

namespace {

// Newton's method near its solution doubles the digits in each step; more than
// a handful means that it went looking.
constexpr int kMostNewtonSteps = 6;
// How far a slope angle may end from its prediction [rad], and how far is
// wanted: the secant predicts to second order in the step.
constexpr double kLargestSurprise = 0.1;
constexpr double kWantedSurprise = 0.03;
constexpr double kLargestGrowth = 4.0;
// Good enough to tell where the branch runs; the final mesh does the rest.
constexpr double kTolerance = 1e-8;

/// A solution on the way.
struct State {
  double fraction;  // of the whole way
  PrimalDual point;
  double phi;
};

/// The line through `before` and `from`, at `fraction`.
State extrapolate(const State& before, const State& from, double fraction) {
  const double ratio =
      (fraction - from.fraction) / (from.fraction - before.fraction);
  State out{fraction, from.point, from.phi + ratio * (from.phi - before.phi)};
  const auto move = [&](const std::vector<double>& a,
                        const std::vector<double>& b,
                        std::vector<double>& result) {
    for (std::size_t i = 0; i < result.size(); ++i) {
      result[i] = b[i] + ratio * (b[i] - a[i]);
    }
  };
  move(before.point.x, from.point.x, out.point.x);
  move(before.point.lambda, from.point.lambda, out.point.lambda);
  return out;
}

/// How far slope angles ended from their prediction, φ included [rad].
double largest_surprise(const VariableLayout& layout, const NewtonResult& found,
                        const State& predicted) {
  double worst = std::abs(found.phi - predicted.phi);
  for (int c = 0; c < layout.num_points(); ++c) {
    const auto i = static_cast<std::size_t>(layout.beta(c));
    worst = std::max(worst, std::abs(found.point.x[i] - predicted.point.x[i]));
  }
  return worst;
}

bool moves_forward(const ExtremalCurve& curve) {
  const auto& w = curve.w_at_points();
  return std::all_of(w.begin(), w.end(), [](double v) { return v > 0.0; });
}

/// Lengths of steps, as fractions of the whole way.
struct Steps {
  double first;
  double smallest;  ///< a shorter one that fails ends the way
};

/// A line through the space of scenes, in natural units.
using SceneLine = std::function<Scene(double fraction)>;

/// Follows the extremal from `start` at fraction 0 to fraction 1 on its mesh.
Continuation follow(const SceneLine& scene_at, const Mesh& mesh, State start,
                    const Steps& steps, const StopCondition& stop) {
  Continuation result;
  NewtonOptions newton;
  newton.tolerance = kTolerance;
  newton.max_iterations = kMostNewtonSteps;
  newton.max_halvings = 1;
  newton.stop = stop;
  const auto correct = [&](RollingTime& problem, const State& predicted) {
    std::optional<ContactEquation> contact;
    if (problem.scene().contact == Contact::Smooth) contact.emplace(problem);
    return solve_with_newton(problem, contact ? &*contact : nullptr,
                             predicted.point, predicted.phi, newton);
  };

  State last = std::move(start);
  std::optional<State> before;
  int orientation = 0;  // of the branch: sign of the Jacobian's determinant
  double step = steps.first;
  result.steps.push_back({scene_at(0.0).body.eta_m, last.phi, 0});
  while (last.fraction < 1.0) {
    const double fraction = std::min(1.0, last.fraction + step);
    State predicted = before ? extrapolate(*before, last, fraction) : last;
    const Scene scene = scene_at(fraction);
    RollingTime problem(scene, mesh, predicted.phi);
    const NewtonResult corrected = correct(problem, predicted);
    result.newton_steps += corrected.iterations;
    if (stop.met()) {
      result.status =
          stop.interrupted() ? Status::Interrupted : Status::TimeLimit;
      return result;
    }
    // A point without a Newton step is the prediction itself.
    const int sign = corrected.determinant_sign;
    const double surprise =
        largest_surprise(problem.layout(), corrected, predicted);
    const bool on_branch =
        corrected.status == Status::Solved && surprise <= kLargestSurprise &&
        (sign == orientation || orientation == 0 || sign == 0) &&
        moves_forward(ExtremalCurve(problem, corrected.point));
    if (!on_branch) {
      ++result.rejected_steps;
      step = 0.5 * (fraction - last.fraction);
      if (step >= steps.smallest) continue;
      result.message = fmt::format(
          "the extremal that continues from η_m = {:.6g} could be followed to "
          "η_m = {:.6g} only, of {:.6g}",
          scene_at(0.0).body.eta_m, scene_at(last.fraction).body.eta_m,
          scene_at(1.0).body.eta_m);
      return result;
    }
    if (sign != 0) orientation = sign;
    step = (fraction - last.fraction) *
           std::clamp(std::sqrt(kWantedSurprise / std::max(surprise, 1e-6)),
                      0.5, kLargestGrowth);
    before = std::move(last);
    last = {fraction, corrected.point, corrected.phi};
    result.steps.push_back({scene.body.eta_m, last.phi, corrected.iterations});
    if (fraction == 1.0) result.curve.emplace(problem, last.point);
  }
  result.status = Status::Solved;
  result.phi = last.phi;
  return result;
}

}  // namespace

Continuation continue_from_cycloid(const Scene& scene, const CycloidArc& arc,
                                   const Mesh& mesh,
                                   const StopCondition& stop) {
  // At η_m = 0 the cycloid is the solution. An offset next to nothing stands
  // for none, so that the problem has its θ from the start.
  constexpr double kNextToNothing = 1e-12;
  const auto scene_at = [&scene](double fraction) {
    Scene scaled = scene;
    scaled.body.eta_m *= fraction;
    return scaled;
  };
  const double phi_0 = arc.slope_angle(arc.psi_end);
  RollingTime problem(scene_at(kNextToNothing), mesh, phi_0);
  // The first step has no secant to follow and tells on which side of a
  // neighbouring branch the path begins: near η_m = 0 there may be one so close
  // that a step of a tenth already lands on it.
  constexpr double kFirstStep = 1.0 / 256.0;
  constexpr double kSmallestStep = 1e-5;
  return follow(scene_at, mesh, {0.0, cycloid_extremal(problem, arc), phi_0},
                {scene.body.off_centred() ? kFirstStep : 1.0, kSmallestStep},
                stop);
}

bool comparable(const Scene& a, const Scene& b) {
  return a.body.shape == b.body.shape && a.contact == b.contact &&
         a.body.off_centred() == b.body.off_centred();
}

Continuation continue_from_neighbour(const Scene& scene,
                                     const Neighbour& neighbour,
                                     const StopCondition& stop) {
  const Scene from = in_natural_units(neighbour.scene);
  const auto scene_at = [&](double fraction) {
    Scene between = scene;
    const auto mix = [fraction](double a, double b) {
      return std::lerp(a, b, fraction);
    };
    between.L = mix(from.L, scene.L);
    between.H = mix(from.H, scene.H);
    Body& body = between.body;
    body.radius = mix(from.body.radius, scene.body.radius);
    body.eta_m = mix(from.body.eta_m, scene.body.eta_m);
    body.theta_m = mix(from.body.theta_m, scene.body.theta_m);
    body.k = mix(from.body.k, scene.body.k);
    return between;
  };
  // Beyond a few steps the way from the cycloid is the shorter one.
  constexpr double kSmallestStep = 1.0 / 8.0;
  return follow(scene_at, neighbour.mesh, {0.0, neighbour.point, neighbour.phi},
                {1.0, kSmallestStep}, stop);
}

}  // namespace brachisto
