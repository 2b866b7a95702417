// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>

#include "brachisto/model/body.hpp"
#include "math/portable_random.hpp"
#include "reproduction/claims.hpp"

namespace brachisto::reproduction {

namespace {

using enum Verdict;

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

/// sin(θ − β): −1 with the centre of mass as far from the track as it comes, 1
/// with it next to the track.
double nearness(const TrajectoryPoint& at) {
  return std::sin(at.theta - at.beta);
}

/// The name of a case without what would be markup.
std::string words(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return name;
}

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
          most <= 1.0 && same ? Holds : Fails,
          fmt::format("Of {} bodies of random parts the largest k + η_m^2 is "
                      "{:.4f}. A ring and two opposite masses on the rim have "
                      "η_m = {:.0f}, k = {:.0f} and η_m = {:.0f}, k = {:.0f}.",
                      kBodies, most, ring.eta_m, ring.k, pair.eta_m, pair.k)};
}

Claim about_dependence_on_inertia(const Results& found) {
  const auto& [axisymmetric, off_centred] = found.shift_by_inertia;
  constexpr double kNone = 1e-6;
  const bool holds = axisymmetric < kNone && off_centred > kNone;
  return {"Sec. II.A",
          "The track depends on k too; that of an axisymmetric body does not.",
          holds ? Holds : Fails,
          fmt::format("Between k = 0.1 and k = 5/9 a point of the track at the "
                      "same share of the rolling time moves by up to {:.3f} "
                      "for η_m = 2/3 and by {:.0e} for η_m = 0.",
                      off_centred, axisymmetric)};
}

Claim about_grid(const Results& found) {
  const GridRow& coarse = found.grid[1];
  const GridRow& fine = found.grid.back();
  constexpr double kTwoDecimals = 0.005;
  bool converged = true;
  const auto change = [&](const std::optional<double>& a,
                          const std::optional<double>& b) -> std::string {
    converged = converged && a && b && std::abs(*a - *b) < kTwoDecimals;
    return a && b ? fmt::format("{:.4f} to {:.4f}", *a, *b) : "no solution";
  };
  const std::string rest = change(coarse.equations.rest, fine.equations.rest);
  const std::string release =
      change(coarse.equations.release, fine.equations.release);
  const double ours =
      std::abs(found.grid.front().quintic - found.grid.back().quintic);
  return {"Sec. II.C",
          "The result does not depend on the grid, to two decimals from n = 50 "
          "on.",
          converged ? Holds : HoldsInPart,
          fmt::format("The paper's own equations go from {} or from {}, as "
                      "their energy is read, between n = {} and {}. Degree 5 "
                      "moves by {:.0e} from {} nodes on.",
                      rest, release, coarse.nodes, fine.nodes, ours,
                      found.grid.front().nodes + 1)};
}

/// That z_c is a function of x_c with a slope of moderate size.
Claim about_steep_gradients(const Results& found) {
  std::size_t count = 0, vertical = 0, backwards = 0;
  constexpr double kRounding = 1e-12;
  for (const auto& [name, one] : found.cases.all()) {
    if (one.scene().path) continue;
    const double beyond = one.motion().start_angle() - 0.5 * std::numbers::pi;
    ++count;
    if (std::abs(beyond) <= kRounding) ++vertical;
    if (beyond > kRounding) ++backwards;
  }
  return {"Sec. II.B",
          "Steep gradients prohibit a direct numeric solution for z_c(x_c).",
          vertical + backwards > 0 ? Holds : Fails,
          fmt::format("Of {} extremals {} start vertically, where dz_c/dx_c is "
                      "infinite, and {} backwards, where z_c is no function "
                      "of x_c.",
                      count, vertical, backwards)};
}

Claim about_half_arch(const Results& found) {
  const Case& one = found.cases["check_uniform_half_arch"];
  const double exact = std::numbers::pi * std::sqrt(1.5 / one.scene().gravity);
  const double printed = 1.229, tolerance = 5e-4;
  const double off = printed / exact - 1.0;
  return {"Sec. II.C",
          "The uniform cylinder to (r + π, r + 2) takes 1.229 s, as π √(3/2g) "
          "within 0.05 %.",
          std::abs(off) <= tolerance ? Holds : Fails,
          fmt::format("π √(3/2g) = {:.6f} s with g = {:g} m/s^2, from which "
                      "1.229 s differs by {:.3f} %.",
                      exact, one.scene().gravity, 100.0 * off)};
}

Claim about_shortest_time(const Results& found) {
  constexpr double kBent = -0.8;  // that of docs/theory.md, section 3
  const double extremal = found.tau("fig04_reference_case");
  const BentTrack& bent = *std::ranges::min_element(
      found.arched, {},
      [](const BentTrack& track) { return std::abs(track.phi - kBent); });
  return {"Fig. 4", "The brachistochrone is the path of shortest transit time.",
          bent.tau < extremal ? Fails : Holds,
          fmt::format(
              "It is a minimum between the fixed ends of its centre's path. A "
              "track between the same A and B that turns up to the slope {} "
              "next to B, in a groove {:.3g} H wider than the body, takes τ = "
              "{:.4f} against {:.4f}{}. Without limits there is no fastest "
              "track.",
              with_minus_signs(fmt::format("{:.1f}", bent.phi)), bent.radius,
              bent.tau, extremal, bent.feasible ? ", and is feasible" : "")};
}

Claim about_standard_curves(const Results& found) {
  const double best = found.tau("fig04_reference_case");
  double next = std::numeric_limits<double>::infinity();
  for (const char* curve : {"fig04_straight", "fig04_parabola",
                            "fig04_circular_arc", "fig04_cycloid"}) {
    next = std::min(next, found.tau(curve));
  }
  return {"Fig. 4", "The brachistochrone is faster than the standard curves.",
          best < next ? Holds : Fails,
          fmt::format("τ = {:.6f}; the best standard curve has {:.6f}.", best,
                      next)};
}

Claim about_normal_force(const Results& found) {
  std::vector<std::string> lifted;
  std::size_t count = 0;
  for (const auto& [name, one] : found.cases.all()) {
    if (one.scene().path || !one.scene().body.rolls()) continue;
    ++count;
    const PathDiagnostics& d = *one.fine.diagnostics;
    if (d.at_start.lifts_off() || d.min_normal_force.value < 0.0) {
      lifted.push_back(words(name));
    }
  }
  const auto infeasible =
      std::ranges::count(found.map.outcomes, false, &SweepOutcome::feasible);
  return {"Sec. III.A", "R_n > 0 in every case studied.",
          lifted.empty() && infeasible == 0 ? Holds : Fails,
          fmt::format("After the start, where R_n = 0 for every body. Lift-off "
                      "in {} of {} single scenes{}{}; {} of the {} scenes of "
                      "Fig. 13 are infeasible.",
                      lifted.size(), count, lifted.empty() ? "" : ": ",
                      fmt::join(lifted, ", "), infeasible,
                      found.map.outcomes.size())};
}

/// The path of the reference case.
struct SampledPath {
  static constexpr int kSamples = 2000;
  const Motion& motion;
  std::vector<TrajectoryPoint> points = motion.fine_sample(kSamples);
  /// Where R_n is largest.
  TrajectoryPoint most = *std::ranges::max_element(
      points, {}, [](const TrajectoryPoint& at) { return at.motion.R_n; });
};

Claim about_rise_of_normal_force(const SampledPath& sampled) {
  const auto& [motion, path, most] = sampled;
  double together = 0.0, far_off = 0.0;
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
  // A sample or two may straddle an extremum.
  constexpr double kAlways = 1.0 - 4.0 / SampledPath::kSamples;
  return {"Sec. III.A",
          "R_n rises as the centre of mass rolls towards the track and falls "
          "as it rolls away.",
          share > kAlways ? Holds
          : share > 0.5   ? HoldsInPart
                          : Fails,
          fmt::format("On the track of Fig. 4 for {:.0f} % of the time. Where "
                      "R_n is largest the centre of mass is {:.0f}° from its "
                      "place next to the track. In {:.0f} % of the time that "
                      "is left it is farther from the track than the axis.",
                      100.0 * share,
                      std::acos(std::min(1.0, nearness(most))) * kDegrees,
                      100.0 * far_off / (motion.transit_time() - together))};
}

Claim about_bulk_of_normal_force(const SampledPath& sampled) {
  const Scene& scene = sampled.motion.scene();
  const TrajectoryPoint& most = sampled.most;
  // m r η ω², along the normal.
  const double centripetal = scene.body.radius * scene.body.eta_m *
                             most.motion.omega * most.motion.omega *
                             nearness(most) / scene.gravity;
  const double share = centripetal / most.motion.R_n;
  return {
      "Sec. III.A",
      "The bulk of the largest R_n counters the centripetal force of the "
      "centre of mass about the axis.",
      share > 0.5 ? Holds : Fails,
      fmt::format("It takes {:.3f} m g; R_n is {:.3f} m g{}.", centripetal,
                  most.motion.R_n,
                  share > 1.0 ? ", less, for the track bends away there" : "")};
}

Claim about_curvature(const Results& found) {
  std::vector<std::string> bent;
  double least_margin = 1.0;
  for (const auto& [name, one] : found.cases.all()) {
    if (one.scene().path || !one.scene().body.rolls()) continue;
    least_margin =
        std::min(least_margin, one.fine.diagnostics->min_fold_margin.value);
    if (bends_less_than_body(one)) continue;
    bent.push_back(fmt::format("{} (κ_b = {:.3f}, 1/r = {:.3f})", words(name),
                               one.fine.diagnostics->max_curvature.value,
                               1.0 / one.scene().body.radius));
  }
  return {"Sec. III.A", "κ_b < 1/r in every case studied.",
          bent.empty() ? Holds : Fails,
          fmt::format("{}The condition is sufficient, not necessary: a track "
                      "folds where 1 − r κ_c ≤ 0, and the least 1 − r κ_c of "
                      "all cases is {:.3f}.",
                      bent.empty()
                          ? std::string()
                          : fmt::format("Not in {}. ", fmt::join(bent, ", ")),
                      least_margin)};
}

}  // namespace

std::vector<Claim> judge(const Results& found) {
  const SampledPath sampled{found.cases["fig04_reference_case"].motion()};
  std::vector<Claim> claims = {about_possible_bodies(),
                               about_dependence_on_inertia(found),
                               about_steep_gradients(found),
                               about_half_arch(found),
                               about_grid(found),
                               about_shortest_time(found),
                               about_standard_curves(found),
                               about_normal_force(found),
                               about_rise_of_normal_force(sampled),
                               about_bulk_of_normal_force(sampled),
                               about_curvature(found)};
  for (auto&& more : {claims_of_shapes(found), claims_of_orientation(found)}) {
    claims.insert(claims.end(), more.begin(), more.end());
  }
  return claims;
}

}  // namespace brachisto::reproduction
