// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "search/world_continuation.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

#include "model/field.hpp"
#include "model/start_angle.hpp"
#include "model/world_part.hpp"
#include "refinement/start_closure.hpp"
#include "refinement/surface_passages.hpp"
#include "transcription/prolongation.hpp"

namespace brachisto {

namespace {

/// By how much the slope turned at the collocation points of `after`.
double largest_turn(const ExtremalCurve& before, const ExtremalCurve& after) {
  double largest = 0.0;
  const Mesh& mesh = after.mesh();
  const auto places = gauss_scheme(mesh.degree).points.nodes();
  auto slope = after.continuous_slope().begin();
  for (int e = 0; e < mesh.num_elements(); ++e) {
    for (const double t : places) {
      // Written so that a NaN is the largest of all.
      const double turn =
          std::abs(*slope++ - before.interpolated_slope(mesh.sigma(e, t)));
      if (!(turn <= largest)) largest = turn;
    }
  }
  return largest;
}

bool keeps_moving(const ExtremalCurve& curve) {
  const auto& w = curve.w_at_points();
  return std::all_of(w.begin(), w.end(), [](double v) { return v > 0.0; });
}

/// What a world has that the ordinary one has not.
std::string asked_for(const World& world) {
  std::vector<std::string_view> parts;
  if (world.start_speed != 0.0) parts.emplace_back("the start speed");
  if (world.air.any()) parts.emplace_back("the drag");
  if (world.losses.any()) parts.emplace_back("the losses");
  if (const auto* kind = field_kind(world)) parts.emplace_back(kind->name);
  return fmt::format("{}", fmt::join(parts, " and "));
}

/// The balance of energy in the world that is asked for, between the ends of
/// the last path on the way there.
std::string left_at_B(const Scene& scene, const ExtremalCurve& last) {
  const ExtremalPoint start = last.at(0.0), end = last.at(1.0);
  const Body& body = scene.body;
  const double v_0 = scene.world.start_speed;
  const double at_start =
      0.5 * v_0 * v_0 * inertia_factor(body, start.theta, start.beta);
  const double left =
      (at_start + potential_fall(scene,
                                 mass_centre(body, start.centre, start.theta),
                                 mass_centre(body, end.centre, end.theta))) /
      (scene.gravity * scene.H);
  return fmt::format(
      "of energy the body would {} {:.4g} m g H where the last path ends, {}",
      left < 0.0 ? "lack" : "have", std::abs(left),
      scene.world.air.any() ? "before the air takes its part"
      : scene.world.losses.any()
          ? "before the losses take theirs; a larger start speed may help"
      : left < 0.0 ? "which a larger start speed can give"
                   : "but no extremal may lead there");
}

/// A line through the space of scenes, in natural units.
using SceneLine = std::function<Scene(double fraction)>;

/// Follows the extremal along a line through scenes, from `out` at fraction 0.
/// Where it ends early, `out` keeps the last curve, and has reached < 1.
void follow(const SceneLine& scene_at, Continuation& out,
            const StopCondition& stop,
            const std::function<void(double fraction)>& told) {
  constexpr double kFirstStep = 0.25;
  constexpr double kSmallestStep = 1.0 / 512.0;
  // Newton's method keeps to an extremal that turns less.
  constexpr double kLargestTurn = 0.25;
  constexpr double kWantedTurn = 0.1;
  // Good enough to tell where the branch runs; the final mesh does the rest.
  constexpr double kTolerance = 1e-9;
  MeshOptions options;
  options.ipopt.stop = stop;
  double step = kFirstStep;
  out.reached = 0.0;
  while (out.reached < 1.0) {
    const double next = std::min(1.0, out.reached + step);
    Scene part = scene_at(next);
    if (slope_at_A_is_open(part)) {
      part.world.start_slope = out.curve->at(0.0).beta;
    }
    // Its field may have a kink.
    const Mesh mesh =
        with_ends_at(out.curve->mesh(), surface_passages(part, *out.curve));
    RollingTime problem(part, mesh, out.phi);
    const MeshSolution found =
        close_start(problem, {prolong(*out.curve, problem), out.phi, -1.0},
                    options, stay_on_mesh, kTolerance);
    out.newton_steps += found.polish.newton_steps;
    if (stop.met()) {
      out.status = stopped_by(stop);
      out.curve.reset();
      return;
    }
    std::optional<ExtremalCurve> curve;
    double turn = 0.0;
    bool same = found.solved();
    if (same) {
      curve.emplace(problem, found.point);
      turn = largest_turn(*out.curve, *curve);
      same = turn <= kLargestTurn && keeps_moving(*curve);
    }
    if (!same) {
      ++out.rejected_steps;
      step = 0.5 * (next - out.reached);
      if (step >= kSmallestStep) continue;
      out.status = Status::NotConverged;
      return;
    }
    out.curve = std::move(curve);
    out.phi = found.tangency.phi;
    out.reached = next;
    step *= std::clamp(kWantedTurn / std::max(turn, 1e-6), 0.5, 4.0);
    told(next);
  }
  out.status = Status::Solved;
}

}  // namespace

Continuation continue_into_world(const Scene& scene, Continuation ordinary,
                                 const StopCondition& stop,
                                 const ProgressHook& progress) {
  Continuation out = std::move(ordinary);
  follow([&](double fraction) { return part_of_world(scene, fraction); }, out,
         stop,
         [&](double fraction) {
           if (!progress) return;
           progress("continuation",
                    fmt::format("{:.4g} of the way into the world", fraction));
         });
  if (out.status == Status::NotConverged) {
    out.message = fmt::format(
        "the extremal that continues from the uniform field without air, "
        "from rest, was followed as far as {:.3g} of {}, not further: {}",
        out.reached, asked_for(scene.world), left_at_B(scene, *out.curve));
    out.curve.reset();
  }
  return out;
}

Continuation continue_offset_in_world(const Scene& scene, Continuation uniform,
                                      const StopCondition& stop,
                                      const ProgressHook& progress) {
  const double least = uniform.curve->scene().body.eta_m;
  const auto offset = [&](double fraction) {
    return std::lerp(least, scene.body.eta_m, fraction);
  };
  Continuation out = std::move(uniform);
  follow(
      [&](double fraction) {
        Scene part = scene;
        part.body.eta_m = offset(fraction);
        return part;
      },
      out, stop,
      [&](double fraction) {
        if (!progress) return;
        progress("continuation",
                 fmt::format("η_m = {:.4g} of {:.4g}", offset(fraction),
                             scene.body.eta_m));
      });
  if (out.status == Status::NotConverged) {
    out.message = fmt::format(
        "in {}, the extremal of the uniform body was followed to η_m = {:.6g}, "
        "not to {:.6g}",
        asked_for(scene.world), offset(out.reached), scene.body.eta_m);
    out.curve.reset();
  }
  return out;
}

}  // namespace brachisto
