// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/study/continuation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "brachisto/solvers/newton_kkt.hpp"
#include "brachisto/transcription/contact_equation.hpp"
#include "brachisto/transcription/initial_guess.hpp"

namespace brachisto {

namespace {

// Steps in η_m, as fractions of the whole way. The first has no secant to
// follow and tells on which side of a neighbouring branch the path begins: near
// η_m = 0 there may be one so close that a step of a tenth already lands on it.
constexpr double kFirstStep = 1.0 / 256.0;
constexpr double kSmallestStep = 1e-5;
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

/// A solution at one η_m.
struct State {
  double fraction;  // of the whole way in η_m
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

}  // namespace

Continuation continue_from_cycloid(const Scene& scene, const CycloidArc& arc,
                                   const Mesh& mesh,
                                   const StopCondition& stop) {
  Continuation result;
  NewtonOptions newton;
  newton.tolerance = kTolerance;
  newton.max_iterations = kMostNewtonSteps;
  newton.max_halvings = 1;
  newton.stop = stop;
  const auto at_fraction = [&](double fraction, double phi) {
    Scene scaled = scene;
    scaled.body.eta_m *= fraction;
    return RollingTime(scaled, mesh, phi);
  };
  const auto correct = [&](RollingTime& problem, const State& predicted) {
    if (scene.contact == Contact::Centre) {
      return solve_with_newton(problem, nullptr, predicted.point, predicted.phi,
                               newton);
    }
    ContactEquation contact(problem);
    return solve_with_newton(problem, &contact, predicted.point, predicted.phi,
                             newton);
  };

  // At η_m = 0 the cycloid is the solution. An offset next to nothing stands
  // for none, so that the problem has its θ from the start.
  constexpr double kNextToNothing = 1e-12;
  const double phi_0 = arc.slope_angle(arc.psi_end);
  RollingTime problem = at_fraction(kNextToNothing, phi_0);
  State last{0.0, cycloid_extremal(problem, arc), phi_0};
  std::optional<State> before;
  int orientation = 0;  // of the branch: sign of the Jacobian's determinant
  result.steps.push_back({0.0, phi_0, 0});
  double step = scene.body.off_centred() ? kFirstStep : 1.0;
  while (last.fraction < 1.0) {
    const double fraction = std::min(1.0, last.fraction + step);
    State predicted = before ? extrapolate(*before, last, fraction) : last;
    problem = at_fraction(fraction, predicted.phi);
    const NewtonResult corrected = correct(problem, predicted);
    result.newton_steps += corrected.iterations;
    if (stop.met()) {
      result.status =
          stop.interrupted() ? Status::Interrupted : Status::TimeLimit;
      break;
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
      if (step >= kSmallestStep) continue;
      break;
    }
    if (sign != 0) orientation = sign;
    const double taken_from = last.fraction;
    before = std::move(last);
    last = {fraction, corrected.point, corrected.phi};
    result.steps.push_back(
        {fraction * scene.body.eta_m, last.phi, corrected.iterations});
    step = (fraction - taken_from) *
           std::clamp(std::sqrt(kWantedSurprise / std::max(surprise, 1e-6)),
                      0.5, kLargestGrowth);
  }
  if (last.fraction < 1.0) {
    result.message = fmt::format(
        "the extremal that continues from the cycloid could be followed to "
        "η_m = {:.6g} only, of {:.6g}",
        last.fraction * scene.body.eta_m, scene.body.eta_m);
    return result;
  }
  result.status = Status::Solved;
  result.phi = last.phi;
  result.curve.emplace(problem, last.point);
  return result;
}

}  // namespace brachisto
