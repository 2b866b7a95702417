// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "design/closed_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "brachisto/math/clock.hpp"
#include "brachisto/study/solution.hpp"
#include "math/cpu_clock.hpp"
#include "model/contact.hpp"
#include "search/continuation.hpp"
#include "study/pose.hpp"
#include "study/solve_beside.hpp"

namespace brachisto {

namespace {

/// Of the free motion Newton's method alone gives the same digits in less time.
SolveOptions of_inner_solves(SolveOptions options, const Scene& scene) {
  if (options.of<Collocation>() != nullptr && !is_limited(scene)) {
    options.use<Collocation>().solver = ProgramSolver::NewtonKkt;
    options.use<Collocation>().certify = Certify::None;
  }
  return options;
}

/// Whether every check has passed, but for that of the second order: a search
/// may pass through extremals that are no minima between their fixed ends.
bool is_extremal(const Solution& solution) {
  const std::vector<Check>& checks = solution.certificate.checks;
  return solution.status == Status::Solved && solution.motion() != nullptr &&
         std::isfinite(solution.motion()->tau()) && !checks.empty() &&
         std::ranges::all_of(checks, [](const Check& check) {
           return check.passed || check.name == "second_order";
         });
}

/// A range that numbers without bound are put into.
double tamed(double margin) {
  constexpr double kMost = 100.0;
  return std::isnan(margin) ? -kMost : std::clamp(margin, -kMost, kMost);
}

}  // namespace

SolveOptions options_until(SolveOptions options, WallClock::time_point end) {
  const double left = seconds_until(end);
  if (left <= 0.0) throw Stopped();
  options.limits.seconds = std::min(options.limits.seconds, left);
  return options;
}

double grip_margin(const Motion& motion, const MaxGrip& max_grip) {
  return std::atan(max_grip.mu) - motion.friction_angle_after(max_grip.after);
}

Margins margins_of(const Solution& solution, double contact_response,
                   const std::optional<MaxGrip>& max_grip) {
  const double q = contact_response;
  const double of_branch = std::isnan(q) ? 1.0 : std::atan(q);
  const Scene& scene = solution.scene;
  const PathDiagnostics& path = *solution.diagnostics;
  const Point start = start_of_centre(scene);
  const double distance =
      std::hypot(scene.L - start.x, scene.H - start.z) - scene.body.radius;
  const double of_grip =
      max_grip ? grip_margin(*solution.motion(), *max_grip) : 1.0;
  Margins out;
  out << of_branch, tamed(path.normal_force_after_rise.value),
      tamed(path.at_start.normal_force_rate *
            std::sqrt(scene.H / scene.gravity)),
      tamed(path.min_fold_margin.value), tamed(distance / scene.body.radius),
      tamed(of_grip);
  return out;
}

ClosedTimes::ClosedTimes(Scene scene, const SolveOptions& options,
                         std::optional<MaxGrip> max_grip,
                         const std::atomic<int>* interrupt)
    : scene_(std::move(scene)),
      options_(of_inner_solves(options, scene_)),
      max_grip_(max_grip),
      interrupt_(interrupt),
      end_(seconds_from_now(options.limits.seconds)) {}

Solution ClosedTimes::solved(const Body& body, const Neighbour* neighbour) {
  const SolveOptions options = options_until(options_, end_);
  ++solves_;
  const double begin = thread_cpu_seconds();
  Scene scene = scene_;
  scene.body = body;
  const SolveHooks hooks{.interrupt = interrupt_, .neighbour = neighbour};
  const bool follows = neighbour != nullptr && can_continue(*neighbour, scene);
  Solution solution = follows ? solve_beside(scene, options, hooks)
                              : solve(scene, options, hooks);
  cpu_seconds_ += thread_cpu_seconds() - begin;
  // A solve that would not fit into the time left ends before the time does.
  if (was_stopped(solution.status) || seconds_until(end_) <= 0.0) {
    throw Stopped();
  }
  return solution;
}

void ClosedTimes::use(const SolveOptions& options) {
  options_ = of_inner_solves(options, scene_);
}

bool ClosedTimes::move_to(const Traits& traits) {
  const Body& like = held_ ? held_->scene.body : scene_.body;
  Scene scene = scene_;
  scene.body = body_of(traits, like);
  if (const auto errors = validate(scene); !errors.empty()) {
    refusal_ = errors.front().message;
    return false;
  }
  Solution solution = solved(scene.body, held_.get());
  const bool beyond_folds =
      !solution.folds.empty() || solution.continued_from_L;
  if (!is_extremal(solution) ||
      (beyond_folds && follow_ == Follow::Neighbours)) {
    refusal_ = fmt::format(
        "the branch was not followed to η_m = {:.6g}, θ_m = {:.6g}, k = "
        "{:.6g}, r = {:.6g} m",
        scene.body.eta_m, scene.body.theta_m, scene.body.k, scene.body.radius);
    return false;
  }
  const std::optional<Sensitivities> slopes = sensitivities(solution);
  if (!slopes) {
    refusal_ = "the branch turns there, and τ has no derivatives";
    return false;
  }
  gradient_ = {slopes->by_offset[0].tau, slopes->by_offset[1].tau,
               slopes->by[SceneParameter::K].tau,
               slopes->by[SceneParameter::Radius].tau};
  contact_response_ = slopes->contact_response;
  here_ = traits;
  solution_ = std::move(solution);
  return true;
}

void ClosedTimes::hold_on() {
  if (follow_ == Follow::Neighbours) held_ = solution_.as_neighbour();
}

/// Central where both sides are bodies, else one-sided to the second order.
MarginGradient ClosedTimes::margin_gradient(const Traits& wanted) {
  // Margins are good to 1e-9 or so where their place is smooth in the body.
  constexpr double kStep = 1e-4;
  MarginGradient out = MarginGradient::Zero();
  const std::shared_ptr<const Neighbour> beside = solution_.as_neighbour();
  const auto at = [&](int trait, double shift) -> std::optional<Margins> {
    Traits moved = here_;
    moved[trait] += shift;
    Scene scene = scene_;
    scene.body = body_of(moved, solution_.scene.body);
    if (!validate(scene).empty()) return std::nullopt;
    const Solution there = solved(scene.body, beside.get());
    if (!is_extremal(there)) return std::nullopt;
    const std::optional<Sensitivities> slopes = sensitivities(there);
    if (!slopes) return std::nullopt;
    return margins_of(there, slopes->contact_response, max_grip_);
  };
  const Margins middle = margins();
  for (int i = 0; i < 4; ++i) {
    if (wanted[i] == 0.0) continue;
    const double h = i == 3 ? kStep * here_[3] : kStep;
    const auto above = at(i, h), below = at(i, -h);
    if (above && below) {
      out.col(i) = (*above - *below) / (2.0 * h);
      continue;
    }
    const double inward = above ? h : -h;
    const auto& near = above ? above : below;
    const auto far = at(i, 2.0 * inward);
    if (near && far) {
      out.col(i) = (-3.0 * middle + 4.0 * *near - *far) / (2.0 * inward);
    }
  }
  return out;
}

}  // namespace brachisto
