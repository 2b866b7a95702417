// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "brachisto/model/mass_distribution.hpp"
#include "math/portable_random.hpp"
#include "reproduction/claims.hpp"

namespace brachisto::reproduction {

namespace {

/// A body of three parts at random: points, rings and discs that lie within it.
MassProperties random_body(const RandomStream& random, std::uint64_t index) {
  constexpr int kParts = 3;
  constexpr int kDraws = 5;
  std::uint64_t next = index * kParts * kDraws;
  const auto draw = [&] { return random.draw(next++) / random.kWhole; };
  std::vector<MassPart> parts;
  for (int i = 0; i < kParts; ++i) {
    const double mass = 0.01 + draw();
    const double angle = 2.0 * std::numbers::pi * draw();
    const double reach = draw();
    const double size = (1.0 - reach) * (0.01 + 0.99 * draw());
    const Point at{reach * std::cos(angle), reach * std::sin(angle)};
    const double kind = draw();
    parts.push_back(kind < 1.0 / 3.0   ? MassPart::point(mass, at)
                    : kind < 2.0 / 3.0 ? MassPart::ring(mass, at, size)
                                       : MassPart::disc(mass, at, size));
  }
  return mass_properties(parts, 1.0);
}

}  // namespace

Claim about_possible_bodies() {
  constexpr std::uint64_t kBodies = 10'000;
  const RandomStream random(1, "possible bodies");
  double most = 0.0;
  for (std::uint64_t i = 0; i < kBodies; ++i) {
    const MassProperties body = random_body(random, i);
    most = std::max(most, body.k + body.eta_m * body.eta_m);
  }
  // Two bodies of the figure, both with all mass on the rim.
  const MassProperties ring =
      mass_properties(std::vector{MassPart::ring(1.0, {0.0, 0.0}, 1.0)}, 1.0);
  const MassProperties pair =
      mass_properties(std::vector{MassPart::point(1.0, {1.0, 0.0}),
                                  MassPart::point(1.0, {-1.0, 0.0})},
                      1.0);
  constexpr double kRounding = 1e-15;
  const bool same = std::abs(ring.k - pair.k) < kRounding &&
                    std::abs(ring.eta_m - pair.eta_m) < kRounding;
  return {"App. A", "No body has k > 1 − η_m^2; several may share η_m and k.",
          most <= 1.0 && same ? Verdict::Holds : Verdict::Fails,
          fmt::format("Of {} bodies of random parts the largest k + η_m^2 is "
                      "{:.4f}. A ring and two opposite masses on the rim have "
                      "η_m = {:.0f}, k = {:.0f} and η_m = {:.0f}, k = {:.0f}.",
                      kBodies, most, ring.eta_m, ring.k, pair.eta_m, pair.k)};
}

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

/// Whether the row of the map with this offset has its minimum at −30° if only
/// multiples of 30° are looked at.
bool minimum_at_30(const SweepTable& map, std::size_t row) {
  const std::size_t count = map.axes.back().count;
  const auto theta =
      std::ranges::find(map.columns, "scene.body.theta_m", &SweepColumn::key);
  std::size_t best = map.outcomes.size();
  for (std::size_t i = row * count; i < (row + 1) * count; ++i) {
    const double steps = theta->numbers[i] * kDegrees / 30.0;
    if (std::abs(steps - std::round(steps)) > 1e-9) continue;
    if (best == map.outcomes.size() ||
        map.outcomes[i].tau < map.outcomes[best].tau) {
      best = i;
    }
  }
  return std::abs(theta->numbers[best] * kDegrees + 30.0) < 1e-9;
}

/// Largest less smallest τ of each row of the map.
std::vector<double> spreads(const SweepTable& map) {
  const std::size_t count = map.axes.back().count;
  std::vector<double> out;
  for (std::size_t first = 0; first < map.outcomes.size(); first += count) {
    const auto begin =
        map.outcomes.begin() + static_cast<std::ptrdiff_t>(first);
    const auto [least, most] =
        std::minmax_element(begin, begin + static_cast<std::ptrdiff_t>(count),
                            [](const SweepOutcome& a, const SweepOutcome& b) {
                              return a.tau < b.tau;
                            });
    out.push_back(most->tau - least->tau);
  }
  return out;
}

}  // namespace

Claim about_orientation(const Results& found) {
  const auto [least, most] = std::ranges::minmax_element(
      found.orientations, {},
      [](const OrientationRow& row) { return row.fastest.theta_m.value; });
  double error = 0.0;
  for (const OrientationRow& row : found.orientations) {
    error = std::max(error, row.fastest.theta_m.error);
  }
  constexpr double kClaimed = -std::numbers::pi / 6.0;
  const double spread =
      std::max(std::abs(least->fastest.theta_m.value - kClaimed),
               std::abs(most->fastest.theta_m.value - kClaimed));
  const std::size_t rows = found.map.axes.front().count;
  std::size_t same = 0;
  for (std::size_t row = 1; row < rows; ++row) {
    same += minimum_at_30(found.map, row) ? 1 : 0;
  }
  return {"Fig. 13", "The minimum stays at θ_m = −π/6 for every η_m.",
          spread <= error ? Verdict::Holds : Verdict::Fails,
          with_minus_signs(fmt::format(
              "It moves from {:.4f}° (η_m = {:.6f}) to {:.4f}° (η_m = {:.6f}), "
              "known to {:.0e}°. On a grid of 30° it is −30° for {} of {} "
              "offsets.",
              least->fastest.theta_m.value * kDegrees, least->eta_m,
              most->fastest.theta_m.value * kDegrees, most->eta_m,
              error * kDegrees, same, rows - 1))};
}

Claim about_effect_of_orientation(const Results& found) {
  const std::vector<double> spread = spreads(found.map);
  const bool grows = std::ranges::is_sorted(spread);
  constexpr double kNone = 1e-9;
  return {
      "Fig. 13",
      "Without offset θ_m does not matter; its effect grows with η_m.",
      grows && spread.front() < kNone ? Verdict::Holds : Verdict::Fails,
      fmt::format("Over all θ_m τ varies by {:.0e} at η_m = 0 and by {:.4f} "
                  "at the largest η_m{}.",
                  spread.front(), spread.back(),
                  grows ? ", more for each offset of the map than for the "
                          "one before"
                        : "")};
}

Claim about_minimum(const Results& found) {
  const std::size_t count = found.map.axes.back().count;
  const std::size_t rows = found.map.axes.front().count;
  std::size_t inside = 0;
  for (std::size_t row = 1; row < rows; ++row) {
    const auto begin =
        found.map.outcomes.begin() + static_cast<std::ptrdiff_t>(row * count);
    const auto least =
        std::min_element(begin, begin + static_cast<std::ptrdiff_t>(count),
                         [](const SweepOutcome& a, const SweepOutcome& b) {
                           return a.tau < b.tau;
                         });
    const auto place = static_cast<std::size_t>(least - begin);
    inside += place > 0 && place + 1 < count ? 1 : 0;
  }
  return {"Fig. 13",
          "τ does not vary monotonically with θ_m but has a minimum.",
          inside == rows - 1 ? Verdict::Holds : Verdict::HoldsInPart,
          fmt::format("Between the ends of the map for {} of {} offsets.",
                      inside, rows - 1)};
}

}  // namespace brachisto::reproduction
