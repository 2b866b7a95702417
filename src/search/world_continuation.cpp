// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "search/world_continuation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

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
  const auto places = collocation_scheme(mesh.degree).points.nodes();
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

}  // namespace

Continuation continue_into_world(const Scene& scene, Continuation ordinary,
                                 const StopCondition& stop,
                                 const ProgressHook& progress) {
  constexpr double kFirstStep = 0.25;
  constexpr double kSmallestStep = 1.0 / 512.0;
  // Newton's method keeps to an extremal that turns less.
  constexpr double kLargestTurn = 0.25;
  constexpr double kWantedTurn = 0.1;
  // Good enough to tell where the branch runs; the final mesh does the rest.
  constexpr double kTolerance = 1e-9;
  MeshOptions options;
  options.ipopt.stop = stop;
  Continuation out = std::move(ordinary);
  double fraction = 0.0;
  double step = kFirstStep;
  while (fraction < 1.0) {
    const double next = std::min(1.0, fraction + step);
    Scene part = part_of_world(scene, next);
    if (slope_at_A_is_open(part)) {
      part.world.start_slope = out.curve->at(0.0).beta;
    }
    // Its field has a kink on the surface of its sphere.
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
      return out;
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
      step = 0.5 * (next - fraction);
      if (step >= kSmallestStep) continue;
      out.status = Status::NotConverged;
      out.message = fmt::format(
          "the extremal that continues from the uniform field without air, "
          "from rest, was followed as far as {:.3g} of the start "
          "speed, the drag and the field of a sphere that are asked for, not "
          "further: energy may not carry the body to B, or no slope make 𝓗 "
          "minimal all along",
          fraction);
      out.curve.reset();
      return out;
    }
    out.curve = std::move(curve);
    out.phi = found.tangency.phi;
    fraction = next;
    step *= std::clamp(kWantedTurn / std::max(turn, 1e-6), 0.5, 4.0);
    if (progress) {
      progress("continuation",
               fmt::format("{:.4g} of the way into the world", fraction));
    }
  }
  out.status = Status::Solved;
  return out;
}

}  // namespace brachisto
