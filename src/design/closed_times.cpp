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
#include "brachisto/math/index.hpp"
#include "brachisto/study/solution.hpp"
#include "math/cpu_clock.hpp"
#include "model/contact.hpp"
#include "search/continuation.hpp"
#include "study/in_lanes.hpp"
#include "study/pose.hpp"
#include "study/solve_beside.hpp"
#include "study/tau_rates.hpp"

namespace brachisto {

namespace {

/// Of the free motion Newton's method alone gives the same digits in less time,
/// and lanes in even less.
SolveOptions of_inner_solves(SolveOptions options, const Scene& scene) {
  if (options.of<Collocation>() != nullptr && !is_limited(scene)) {
    options.use<Collocation>().solver = ProgramSolver::NewtonKkt;
    options.use<Collocation>().certify = Certify::None;
    // Newton's method goes nowhere from elsewhere; the last body is solved
    // anew.
    options.use<Collocation>().guess = Guess::Cycloid;
    options.use<Collocation>().in_lanes = true;
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

double branch_margin(double contact_response) {
  return std::isnan(contact_response) ? 1.0 : std::atan(contact_response);
}

Margins margins_of(const Solution& solution, double contact_response,
                   const std::optional<MaxGrip>& max_grip) {
  const Scene& scene = solution.scene;
  const PathDiagnostics path = solution.diagnostics
                                   ? *solution.diagnostics
                                   : solution.motion()->diagnose();
  const Point start = start_of_centre(scene);
  const double distance =
      std::hypot(scene.L - start.x, scene.H - start.z) - scene.body.radius;
  const double of_grip =
      max_grip ? grip_margin(*solution.motion(), *max_grip) : 1.0;
  const StartLimits& leaves = path.at_start;
  const double at_start =
      leaves.normal_force != 0.0
          ? leaves.normal_force
          : leaves.normal_force_rate * std::sqrt(scene.H / scene.gravity);
  Margins out;
  out << branch_margin(contact_response),
      tamed(path.normal_force_after_rise.value), tamed(at_start),
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

ClosedTimes::Solved ClosedTimes::solved(const Body& body,
                                        const Neighbour* neighbour) {
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
  return {std::move(solution), follows};
}

std::vector<std::optional<Solution>> ClosedTimes::in_lanes(
    const std::vector<Scene>& scenes, const Solution* beside) {
  const SolveOptions options = options_until(options_, end_);
  if (interrupt_ != nullptr && interrupt_->load() != 0) throw Stopped();
  const double begin = thread_cpu_seconds();
  std::vector<SceneToSolve> posed;
  for (const Scene& scene : scenes) posed.push_back({scene, options});
  std::vector<std::optional<Solution>> out = seek_in_lanes(posed, beside);
  cpu_seconds_ += thread_cpu_seconds() - begin;
  solves_ += static_cast<int>(std::ranges::count_if(
      out, [](const auto& one) { return one.has_value(); }));
  return out;
}

Scene ClosedTimes::scene_of(const Traits& traits, const Body& like) const {
  Scene scene = scene_;
  scene.body = body_of(traits, like);
  return scene;
}

void ClosedTimes::use(const SolveOptions& options) {
  options_ = of_inner_solves(options, scene_);
}

std::shared_ptr<const Neighbour> ClosedTimes::on_a_mesh(
    const Solution& from_lanes) {
  constexpr double kSame = 1e-6;  // relative; on the way few digits are asked
  const Solution own = solved(from_lanes.scene.body, nullptr).solution;
  const bool same =
      is_extremal(own) &&
      std::abs(own.motion()->tau() / from_lanes.motion()->tau() - 1.0) <= kSame;
  return same ? neighbour_of(own) : nullptr;
}

bool ClosedTimes::move_to(const Traits& traits, const Traits& wanted) {
  const Scene scene =
      scene_of(traits, held_            ? held_->scene.body
                       : held_in_lanes_ ? held_in_lanes_->scene.body
                                        : scene_.body);
  if (const auto errors = validate(scene); !errors.empty()) {
    refusal_ = errors.front().message;
    return false;
  }
  std::optional<Solution> side_by_side;
  if (!held_followed_) {
    side_by_side = in_lanes({scene}, held_in_lanes_.get()).front();
  }
  const bool as_sought = side_by_side.has_value();
  if (!as_sought && held_in_lanes_ && !held_ && !held_alone_) {
    // Beyond what lanes can it is followed from here, as any other.
    held_ = on_a_mesh(*held_in_lanes_);
    held_alone_ = held_ == nullptr;
  }
  auto [solution, followed] = as_sought ? Solved{std::move(*side_by_side)}
                                        : solved(scene.body, held_.get());
  const bool beyond_folds =
      !solution.folds.empty() || solution.continued_from_L;
  if (!as_sought && (!is_extremal(solution) ||
                     (beyond_folds && follow_ == Follow::Neighbours))) {
    refusal_ = fmt::format(
        "the branch was not followed to η_m = {:.6g}, θ_m = {:.6g}, k = "
        "{:.6g}, r = {:.6g} m",
        scene.body.eta_m, scene.body.theta_m, scene.body.k, scene.body.radius);
    return false;
  }
  // They are in the order of traits.
  std::vector<SceneCoordinate> coordinates;
  for (int i = 0; i < 4; ++i) {
    if (wanted[i] != 0.0) coordinates.push_back(kSceneCoordinates[at(i)]);
  }
  const std::optional<TauRates> slopes = tau_rates(solution, coordinates);
  if (!slopes) {
    refusal_ =
        "τ has no derivatives there: the branch turns, or limits hold along "
        "arcs that are not known";
    return false;
  }
  gradient_ = Traits::Map(slopes->by.data());
  contact_response_ = slopes->contact_response;
  here_ = traits;
  solution_ = std::move(solution);
  followed_ = followed;
  return true;
}

void ClosedTimes::hold_on() {
  if (follow_ != Follow::Neighbours) return;
  held_followed_ = followed_;
  held_ = neighbour_of(solution_);
  held_in_lanes_ =
      held_ ? nullptr : std::make_shared<const Solution>(solution_);
  held_alone_ = false;
}

std::vector<std::optional<Margins>> ClosedTimes::margins_at(
    const std::vector<Traits>& places) {
  std::vector<Scene> scenes;
  for (const Traits& traits : places) {
    scenes.push_back(scene_of(traits, solution_.scene.body));
  }
  std::vector<std::optional<Solution>> found(places.size());
  std::shared_ptr<const Neighbour> beside = neighbour_of(solution_);
  const bool from_lanes = !beside;
  if (from_lanes) found = in_lanes(scenes, &solution_);
  if (from_lanes && std::ranges::any_of(found, [](const auto& one) {
        return !one.has_value();
      })) {
    beside = on_a_mesh(solution_);
  }
  std::vector<std::optional<Margins>> out(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!validate(scenes[i]).empty()) continue;
    const bool as_sought = found[i].has_value();
    const Solution there = as_sought
                               ? std::move(*found[i])
                               : solved(scenes[i].body, beside.get()).solution;
    if (!as_sought && !is_extremal(there)) continue;
    const std::optional<TauRates> slopes = tau_rates(there, {});
    if (!slopes) continue;
    out[i] = margins_of(there, slopes->contact_response, max_grip_);
  }
  return out;
}

/// Central where both sides are bodies, else one-sided to the second order.
MarginGradient ClosedTimes::margin_gradient(const Traits& wanted) {
  // Margins are good to 1e-9 or so where their place is smooth in the body.
  constexpr double kStep = 1e-4;
  MarginGradient out = MarginGradient::Zero();
  const auto moved = [&](int trait, double shift) {
    Traits there = here_;
    there[trait] += shift;
    return there;
  };
  std::vector<int> traits;
  std::vector<double> steps;
  std::vector<Traits> places;
  for (int i = 0; i < 4; ++i) {
    if (wanted[i] == 0.0) continue;
    traits.push_back(i);
    steps.push_back(i == 3 ? kStep * here_[3] : kStep);
    places.push_back(moved(i, steps.back()));
    places.push_back(moved(i, -steps.back()));
  }
  const std::vector<std::optional<Margins>> there = margins_at(places);
  const Margins middle = margins();
  for (std::size_t j = 0; j < traits.size(); ++j) {
    const double h = steps[j];
    const auto &above = there[2 * j], &below = there[2 * j + 1];
    if (above && below) {
      out.col(traits[j]) = (*above - *below) / (2.0 * h);
      continue;
    }
    const double inward = above ? h : -h;
    const auto& near = above ? above : below;
    if (!near) continue;
    const auto far = margins_at({moved(traits[j], 2.0 * inward)}).front();
    if (far) {
      out.col(traits[j]) =
          (-3.0 * middle + 4.0 * *near - *far) / (2.0 * inward);
    }
  }
  return out;
}

}  // namespace brachisto
