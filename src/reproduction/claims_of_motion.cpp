// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "brachisto/model/inertia.hpp"
#include "brachisto/model/mass_distribution.hpp"
#include "brachisto/model/start_angle.hpp"
#include "reproduction/claims.hpp"

namespace brachisto::reproduction {

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

/// sin(θ − β): −1 with the centre of mass as far from the track as it comes, 1
/// with it next to the track.
double nearness(const TrajectoryPoint& at) {
  return std::sin(at.theta - at.beta);
}

}  // namespace

Claim about_rise_of_normal_force(const Results& found) {
  constexpr int kSamples = 2000;
  const Motion& motion = found.cases["fig04_reference_case"].motion();
  const std::vector<TrajectoryPoint> path = motion.fine_sample(kSamples);
  double together = 0.0;
  double far_off = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double nearer = nearness(path[i]) - nearness(path[i - 1]);
    const double rise = path[i].motion.R_n - path[i - 1].motion.R_n;
    const double time = path[i].t - path[i - 1].t;
    if (nearer * rise > 0.0) {
      together += time;
    } else if (nearness(path[i]) < 0.0) {
      far_off += time;
    }
  }
  const double share = together / motion.transit_time();
  const auto most = std::ranges::max_element(
      path, {}, [](const TrajectoryPoint& at) { return at.motion.R_n; });
  // A sample or two may straddle an extremum.
  constexpr double kAlways = 1.0 - 4.0 / kSamples;
  return {"Sec. III.A",
          "R_n rises as the centre of mass rolls towards the track and falls "
          "as it rolls away.",
          share > kAlways ? Verdict::Holds
          : share > 0.5   ? Verdict::HoldsInPart
                          : Verdict::Fails,
          fmt::format("On the track of Fig. 4 for {:.0f} % of the time. Where "
                      "R_n is largest the centre of mass is {:.0f}° from its "
                      "place next to the track. In {:.0f} % of the time that "
                      "is left it is farther from the track than the axis.",
                      100.0 * share,
                      std::acos(std::min(1.0, nearness(*most))) * kDegrees,
                      100.0 * far_off / (motion.transit_time() - together))};
}

Claim about_bulk_of_normal_force(const Results& found) {
  constexpr int kSamples = 2000;
  const Case& one = found.cases["fig04_reference_case"];
  const Scene& scene = one.scene();
  const std::vector<TrajectoryPoint> path = one.motion().fine_sample(kSamples);
  const TrajectoryPoint& most = *std::ranges::max_element(
      path, {}, [](const TrajectoryPoint& at) { return at.motion.R_n; });
  // m r η ω², along the normal.
  const double centripetal = scene.body.radius * scene.body.eta_m *
                             most.motion.omega * most.motion.omega *
                             nearness(most) / scene.gravity;
  const double share = centripetal / most.motion.R_n;
  return {
      "Sec. III.A",
      "The bulk of the largest R_n counters the centripetal force of the "
      "centre of mass about the axis.",
      share > 0.5 ? Verdict::Holds : Verdict::Fails,
      fmt::format("It takes {:.3f} m g; R_n is {:.3f} m g{}.", centripetal,
                  most.motion.R_n,
                  share > 1.0 ? ", less, for the track bends away there" : "")};
}

Claim about_angular_speed(const Results& found) {
  const Case& one = found.cases["fig04_reference_case"];
  const Scene& scene = one.scene();
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  constexpr int kSamples = 400;
  for (const TrajectoryPoint& at : one.motion().fine_sample(kSamples)) {
    if (at.motion.v_c <= 0.0) continue;
    const double energy = kinetic_energy(scene.body, scene.gravity, at.theta,
                                         at.beta, at.motion.v_c)
                              .total();
    const double ratio = at.motion.omega / std::sqrt(energy);
    least = std::min(least, ratio);
    most = std::max(most, ratio);
  }
  constexpr double kSame = 1.0 + 1e-9;
  return {"Sec. III.B", "Speeds follow the kinetic energy, ω ∝ √TKE.",
          most < kSame * least ? Verdict::Holds : Verdict::HoldsInPart,
          fmt::format("For axisymmetric bodies. In general TKE = m r^2 ω^2 A/2 "
                      "with A(θ, β): on the track of Fig. 4 ω/√TKE varies by "
                      "the factor {:.2f}.",
                      most / least)};
}

Claim about_incline(const Results& found) {
  const double off = found.cases["fig04_straight"].tau().value;
  const double uniform = found.uniform_on_incline;
  return {"Sec. III.B",
          "On an inclined plane too the off-centred cylinder is quicker than "
          "the uniform one.",
          off < uniform ? Verdict::Holds : Verdict::Fails,
          fmt::format("On the straight line of Fig. 4 τ = {:.4f} against "
                      "{:.4f}.",
                      off, uniform)};
}

Claim about_start(const Results& found) {
  constexpr int kOffsets = 20;
  constexpr int kInertias = 10;
  constexpr int kDirections = 180;
  double steepest_rise = std::numeric_limits<double>::infinity();
  double least_fall = std::numeric_limits<double>::infinity();
  for (int i = 1; i < kOffsets; ++i) {
    const double eta_m = static_cast<double>(i) / kOffsets;
    for (int j = 0; j <= kInertias; ++j) {
      const double k = largest_k(eta_m) * j / kInertias;
      for (int d = 0; d < kDirections; ++d) {
        // Beyond a quarter turn, to either side.
        const double theta_m =
            std::numbers::pi * (0.5 + (d + 0.5) / kDirections);
        const double beta = start_angle(Body::cylinder(1.0, eta_m, theta_m, k));
        steepest_rise = std::min(steepest_rise, std::sin(beta));
        least_fall =
            std::min(least_fall, std::sin(beta) + eta_m * std::cos(theta_m));
      }
    }
  }
  const auto feasible = std::ranges::count_if(
      found.backward_starts,
      [](const BackwardStart& one) { return one.feasible; });
  const bool centre = steepest_rise > 0.0;
  const bool mass = least_fall < 0.0;
  return {
      "Sec. III.H",
      "For |θ_m| > π/2 the centre still starts downwards, but the centre "
      "of mass may start upwards or the body slip.",
      !centre ? Verdict::Fails
      : mass  ? Verdict::Holds
              : Verdict::HoldsInPart,
      fmt::format("In {} directions of {} bodies the centre starts "
                  "downwards on the extremal, sin β ≥ {:.3f}, and so does "
                  "the centre of mass, dz_cm/ds ≥ {:.0e}: it falls by less "
                  "than the centre, but falls. Of the body of Fig. 4 {} of "
                  "{} tracks with |θ_m| from 100° to 175° are feasible. "
                  "Every body with k > 0 slips at first, whatever its θ_m.",
                  kDirections, (kOffsets - 1) * (kInertias + 1), steepest_rise,
                  least_fall, feasible, found.backward_starts.size())};
}

}  // namespace brachisto::reproduction
