// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "brachisto/model/body.hpp"
#include "model/start_angle.hpp"
#include "reproduction/claims.hpp"

namespace brachisto::reproduction {

namespace {

using enum Verdict;

/// Whether τ is least at −30° if only multiples of 30° are looked at.
bool minimum_at_30(const MapRow& row) {
  const MapPoint* best = nullptr;
  for (const MapPoint& at : row.points) {
    const double steps = at.theta_m * kDegrees / 30.0;
    if (std::abs(steps - std::round(steps)) > 1e-9) continue;
    if (best == nullptr || at.tau < best->tau) best = &at;
  }
  return std::abs(best->theta_m * kDegrees + 30.0) < 1e-9;
}

/// Whether τ has a minimum between the ends of the row.
bool minimum_inside(const MapRow& row) {
  const auto least = std::ranges::min_element(row.points, {}, &MapPoint::tau);
  return least != row.points.begin() && least + 1 != row.points.end();
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
  const auto feasible =
      std::ranges::count(found.backward_starts, true, &BackwardStart::feasible);
  const bool centre = steepest_rise > 0.0;
  const bool mass = least_fall < 0.0;
  return {
      "Sec. III.H",
      "For |θ_m| > π/2 the centre still starts downwards, but the centre "
      "of mass may start upwards or the body slip.",
      !centre ? Fails
      : mass  ? Holds
              : HoldsInPart,
      fmt::format("In {} directions of {} bodies the centre starts "
                  "downwards on the extremal, sin β ≥ {:.3f}, and so does "
                  "the centre of mass, dz_cm/ds ≥ {:.0e}: it falls by less "
                  "than the centre, but falls. Of the body of Fig. 4 {} of "
                  "{} tracks with |θ_m| from 100° to 175° are feasible. "
                  "Every body with k > 0 slips at first, whatever its θ_m.",
                  kDirections, (kOffsets - 1) * (kInertias + 1), steepest_rise,
                  least_fall, feasible, found.backward_starts.size())};
}

Claim about_effect_of_orientation(const std::vector<MapRow>& map) {
  const auto effect = [](const MapRow& row) {
    return spread(row.points, &MapPoint::tau);
  };
  const bool grows = std::ranges::is_sorted(map, {}, effect);
  constexpr double kNone = 1e-9;
  return {
      "Fig. 13",
      "Without offset θ_m does not matter; its effect grows with η_m.",
      grows && effect(map.front()) < kNone ? Holds : Fails,
      fmt::format("Over all θ_m τ varies by {:.0e} at η_m = 0 and by {:.4f} "
                  "at the largest η_m{}.",
                  effect(map.front()), effect(map.back()),
                  grows ? ", more for each offset of the map than for the "
                          "one before"
                        : "")};
}

Claim about_minimum(std::span<const MapRow> off_centred) {
  const auto inside = std::ranges::count_if(off_centred, minimum_inside);
  const std::ptrdiff_t rows = std::ssize(off_centred);
  return {"Fig. 13",
          "τ does not vary monotonically with θ_m but has a minimum.",
          inside == rows ? Holds : HoldsInPart,
          fmt::format("Between the ends of the map for {} of {} offsets.",
                      inside, rows)};
}

Claim about_orientation(const std::vector<OrientationRow>& found,
                        std::span<const MapRow> off_centred) {
  const auto angle = [](const OrientationRow& row) {
    return row.fastest.theta_m.value;
  };
  const auto [least, most] = std::ranges::minmax(found, {}, angle);
  const double error = largest_error(found);
  constexpr double kClaimed = -std::numbers::pi / 6.0;
  const double spread = std::max(std::abs(angle(least) - kClaimed),
                                 std::abs(angle(most) - kClaimed));
  return {"Fig. 13", "The minimum stays at θ_m = −π/6 for every η_m.",
          spread <= error ? Holds : Fails,
          with_minus_signs(fmt::format(
              "It moves from {:.4f}° (η_m = {:.6f}) to {:.4f}° (η_m = {:.6f}), "
              "known to {:.0e}°. On a grid of 30° it is −30° for {} of {} "
              "offsets.",
              angle(least) * kDegrees, least.eta_m, angle(most) * kDegrees,
              most.eta_m, error * kDegrees,
              std::ranges::count_if(off_centred, minimum_at_30),
              off_centred.size()))};
}

Claim about_beating_the_bead(const Results& found) {
  const double bead = found.tau("fig06_bead");
  const double fast = found.tau("fig13_faster_than_bead");
  const double between = found.bead_between_centres;
  return {
      "Sec. III.H", "An off-centred cylinder can be faster than the bead.",
      fast < bead ? Holds : Fails,
      fmt::format(
          "{:.6f} against {:.6f}, by {:.1f} %; by the printed times "
          "it would be {:.1f} %. A bead between the ends of the "
          "path of that cylinder's centre takes {:.6f}{}.",
          fast, bead, percent_less(bead, fast),
          percent_less(number_in(printed::kBead), number_in(printed::kFast)),
          between,
          between < bead ? ": part of the gain is that the cylinder starts "
                           "beside A and ends above B"
                         : ", so that starting beside A and ending above B "
                           "is no gain in itself")};
}

Claim about_axisymmetric_bodies(const Results& found) {
  const double k = found.boundary.front().k;
  return {"Sec. III.H", "Axisymmetric objects are always slower than the bead.",
          k > 0.0 ? HoldsInPart : Holds,
          fmt::format("Between fixed ends of the centre's path, by the factor "
                      "√(1 + k). Between A and B, with r = 1/3 and L = 3, "
                      "axisymmetric cylinders of k < {:.6f} are faster "
                      "than the bead.",
                      k)};
}

}  // namespace

std::vector<Claim> claims_of_orientation(const Results& found) {
  const std::vector<MapRow> map = rows_of(found.map);
  const std::span<const MapRow> off_centred = std::span(map).subspan(1);
  return {about_start(found),
          about_effect_of_orientation(map),
          about_minimum(off_centred),
          about_orientation(found.orientations, off_centred),
          about_beating_the_bead(found),
          about_axisymmetric_bodies(found)};
}

}  // namespace brachisto::reproduction
