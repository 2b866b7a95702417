// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "brachisto/model/mass_distribution.hpp"
#include "io/portable_random.hpp"
#include "reproduction/claims.hpp"

namespace brachisto::reproduction {

namespace {

/// A body of three parts at random: points, rings and discs that lie within it.
MassProperties random_body(const io::RandomStream& random,
                           std::uint64_t index) {
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
  const io::RandomStream random(1, "possible bodies");
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

}  // namespace brachisto::reproduction
