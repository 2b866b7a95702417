// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/world_shooting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "extremal/arc_newton.hpp"
#include "extremal/extremal_attempt.hpp"
#include "extremal/shooting_system.hpp"
#include "model/world_part.hpp"

namespace brachisto {

namespace {

using arcs::ArcSystem;

/// What a solve has and does, in natural units.
class SolveInWorld : public shooting::ExtremalAttempt {
 public:
  SolveInWorld(const Scene& scene, const ExtremalOptions& options,
               const ExtremalGuess& guess)
      : ExtremalAttempt(options),
        scene_(scene),
        units_(natural_units(scene)),
        natural_(in_natural_units(scene)),
        arcs_(shooting::choose_arcs(natural_, guess, options.arcs)),
        start_(in_natural_units_of(guess)) {
    solution_.arcs = arcs_;
  }

  /// From the ordinary world's extremal to the scene's; false if it fails.
  bool follow_into_world();
  void finish();

 private:
  [[nodiscard]] arcs::Guess in_natural_units_of(
      const ExtremalGuess& guess) const;
  [[nodiscard]] ArcSystem::Point point_of(const ArcSystem& system) const {
    return point_.nodes.empty() ? system.start() : point_;
  }
  void fill(const arcs::RefinedRoot& root, const arcs::ArcPath& path);

  const Scene& scene_;
  Units units_;
  Scene natural_;
  int arcs_;
  arcs::Guess start_;
  ArcSystem::Point point_;  ///< to go on from, if it has begun
};

arcs::Guess SolveInWorld::in_natural_units_of(
    const ExtremalGuess& guess) const {
  arcs::Guess out;
  out.arcs = {{.held = {}, .duration = guess.rolling_time / units_.time}};
  const auto state = guess.state;
  const Units units = units_;
  out.state = [state, units](std::size_t, double share) {
    const ExtremalState s = state(share);
    const double speed = units.speed();
    return arcs::State{s.x / units.length,
                       s.z / units.length,
                       s.theta,
                       s.w / speed,
                       s.beta,
                       s.p_x * speed,
                       s.p_z * speed,
                       s.p_theta / units.time,
                       s.p_w * speed / units.time,
                       0.0};
  };
  return out;
}

bool SolveInWorld::follow_into_world() {
  constexpr double kFirstStep = 0.25, kSmallestStep = 1.0 / 512.0;
  // Newton's method near its solution doubles the digits in each step.
  constexpr int kMostSteps = 8, kFewSteps = 5;
  constexpr double kLargestTurn = 0.25;
  double fraction = 0.0;
  double step = kFirstStep;
  double phi = start_.state(0, 1.0)[arcs::kBeta];
  while (fraction < 1.0) {
    const double next = std::min(1.0, fraction + step);
    const Scene part = part_of_world(natural_, next);
    const ArcSystem system(part, start_, arcs_);
    arcs::ArcRoot root =
        arcs::find_root(system, point_of(system), {}, kMostSteps);
    solution_.newton_steps += root.steps;
    const double turn =
        root.converged ? std::abs(root.at.slope_at_B.value - phi) : 0.0;
    if (options_.stop.met()) {
      stop(fmt::format("{:.3g} of the way into the world", fraction));
      return false;
    }
    if (!root.converged || turn > kLargestTurn) {
      step = 0.5 * (next - fraction);
      if (step >= kSmallestStep) continue;
      fail(ExtremalStatus::NewtonFailed,
           fmt::format("beyond {:.3g} of the way from the uniform field "
                       "without air, from rest, into the world that is asked "
                       "for",
                       fraction));
      return false;
    }
    phi = root.at.slope_at_B.value;
    point_ = std::move(root.point);
    fraction = next;
    if (root.steps <= kFewSteps) step *= 2.0;
  }
  return true;
}

void SolveInWorld::finish() {
  // The local error is well below the wanted accuracy of the whole.
  constexpr double kShare = 0.1, kTightest = 1e-15;
  const double wanted = std::max(options_.tolerance, 1e-14);
  const ocp::StepControl control{
      .tolerance = std::max(kShare * wanted, kTightest), .halve = false};
  const ArcSystem system(natural_, start_, arcs_);
  const arcs::ArcRoot root = arcs::find_root(system, point_of(system), control,
                                             options_.max_newton_steps);
  solution_.newton_steps += root.steps;
  solution_.residual = root.residual;
  if (!root.converged) {
    if (options_.stop.met()) return stop("in Newton's method");
    return fail(ExtremalStatus::NewtonFailed,
                fmt::format("after {} steps the residual is {:.1e}; try a "
                            "better guess, or more arcs",
                            root.steps, root.residual));
  }
  arcs::RefinedRoot refined;
  arcs::ArcPath path;
  if (arcs::refine_root(system, root, control, refined)) {
    path = system.path(refined.point, {control.tolerance, true});
  }
  if (path.empty()) {
    return fail(ExtremalStatus::NewtonFailed,
                "the solution cannot be integrated again");
  }
  fill(refined, path);
  judge();
}

void SolveInWorld::fill(const arcs::RefinedRoot& root,
                        const arcs::ArcPath& path) {
  solution_.transit_time = root.transit_time * units_.time;
  solution_.error_estimate = root.error_estimate;
  solution_.tau =
      solution_.transit_time * std::sqrt(2.0 * scene_.gravity / scene_.H);
  std::vector<ExtremalPath::Knot> knots;
  for (const arcs::Knot& at : path.arcs().front().knots) {
    const auto& y = at.y;
    knots.push_back({.u = at.u,
                     .y = {y(0), y(1), y(2), y(3), y(6), y(7)},
                     .t = at.t,
                     .beta = at.control,
                     .p_x = y(4),
                     .p_z = y(5)});
  }
  const double U = path.rolling_time();
  knots.back().u = U;
  // At rest exactly, not but for rounding.
  if (natural_.world.start_speed == 0.0) knots.front().y[shooting::kW] = 0.0;
  const ExtremalPath::Knot& last = knots.back();
  solution_.rolling_time = U * units_.time;
  solution_.phi = last.beta;
  solution_.start_angle = knots.front().beta;
  // No-slip: S = r (θ_end − θ_m). For a bead θ counts arc length.
  const double turned = last.y[shooting::kTheta] - natural_.body.theta_m;
  solution_.rotation = natural_.body.rolls() ? turned : 0.0;
  solution_.centre_path_length =
      turned / shooting::inverse_radius(natural_.body) * units_.length;
  solution_.p_x = last.p_x / units_.speed();
  solution_.p_z = last.p_z / units_.speed();
  solution_.integration_steps = root.at.steps;
  const double p_x = last.p_x, p_z = last.p_z;
  solution_.path = ExtremalPath(natural_, units_, p_x, p_z, std::move(knots));
}

}  // namespace

ExtremalSolution solve_extremal_in_world(const Scene& scene,
                                         const ExtremalGuess& guess,
                                         const ExtremalOptions& options) {
  SolveInWorld solve(scene, options, guess);
  return solve.within_its_stop([&] { solve.finish(); });
}

ExtremalSolution solve_extremal_in_world(const Scene& scene,
                                         const ExtremalSolution& ordinary,
                                         const ExtremalOptions& options) {
  ExtremalGuess guess;
  guess.rolling_time = ordinary.rolling_time;
  guess.phi = ordinary.phi;
  guess.p_x = ordinary.p_x;
  guess.p_z = ordinary.p_z;
  guess.state = [&](double sigma) { return ordinary.path.at(sigma); };
  SolveInWorld solve(scene, options, guess);
  return solve.within_its_stop([&] {
    if (solve.follow_into_world()) solve.finish();
  });
}

}  // namespace brachisto
