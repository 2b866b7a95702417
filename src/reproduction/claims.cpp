// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "brachisto/model/kinetic_energy.hpp"
#include "reproduction/comparison.hpp"
#include "reproduction/printed.hpp"

namespace brachisto::reproduction {

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

double tau(const Findings& found, const char* name) {
  return found.cases[name].tau().value;
}

/// The name of a case without what would be markup.
std::string words(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return name;
}

Claim about_standard_curves(const Findings& found) {
  const double best = tau(found, "fig04_reference_case");
  double next = std::numeric_limits<double>::infinity();
  for (const char* curve : {"fig04_straight", "fig04_parabola",
                            "fig04_circular_arc", "fig04_cycloid"}) {
    next = std::min(next, tau(found, curve));
  }
  return {"Fig. 4", "The brachistochrone is faster than the standard curves.",
          best < next ? Verdict::Holds : Verdict::Fails,
          fmt::format("τ = {:.6f}; the best standard curve has {:.6f}.", best,
                      next)};
}

Claim about_grid(const Findings& found) {
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
          converged ? Verdict::Holds : Verdict::HoldsInPart,
          fmt::format("The paper's own equations go from {} or from {}, as "
                      "their energy is read, between n = {} and {}. Degree 5 "
                      "moves by {:.0e} from {} nodes on.",
                      rest, release, coarse.nodes, fine.nodes, ours,
                      found.grid.front().nodes + 1)};
}

Claim about_normal_force(const Findings& found) {
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
  const auto infeasible = std::ranges::count_if(
      found.map.outcomes,
      [](const SweepOutcome& outcome) { return !outcome.feasible; });
  return {"Sec. III.A", "R_n > 0 in every case studied.",
          lifted.empty() && infeasible == 0 ? Verdict::Holds : Verdict::Fails,
          fmt::format("After the start, where R_n = 0 for every body. Lift-off "
                      "in {} of {} single scenes{}{}; {} of the {} scenes of "
                      "Fig. 13 are infeasible.",
                      lifted.size(), count, lifted.empty() ? "" : ": ",
                      fmt::join(lifted, ", "), infeasible,
                      found.map.outcomes.size())};
}

Claim about_curvature(const Findings& found) {
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
          bent.empty() ? Verdict::Holds : Verdict::Fails,
          fmt::format("{}The condition is sufficient, not necessary: a track "
                      "folds where 1 − r κ_c ≤ 0, and the least 1 − r κ_c of "
                      "all cases is {:.3f}.",
                      bent.empty()
                          ? std::string()
                          : fmt::format("Not in {}. ", fmt::join(bent, ", ")),
                      least_margin)};
}

Claim about_lengths(const Findings& found) {
  const double uniform =
      found.cases["fig06_uniform_cylinder"].motion().rail_length();
  const double off = found.cases["fig04_reference_case"].motion().rail_length();
  const double share = std::abs(uniform - off) / uniform;
  return {"Fig. 6",
          "The uniform and the off-centred cylinder have near equal path "
          "lengths.",
          share < 0.01 ? Verdict::Holds : Verdict::HoldsInPart,
          fmt::format("{:.4f} and {:.4f}, {:.1f} % apart.", uniform, off,
                      100.0 * share)};
}

/// By how many percent the second is less than the first.
double percent_less(double first, double second) {
  return 100.0 * (first - second) / first;
}

Claim about_order(const Findings& found) {
  const double bead = tau(found, "fig06_bead");
  const double off = tau(found, "fig04_reference_case");
  const double uniform = tau(found, "fig06_uniform_cylinder");
  return {"Fig. 6",
          "The bead is the quickest, the off-centred cylinder second, the "
          "uniform cylinder last.",
          bead < off && off < uniform ? Verdict::Holds : Verdict::Fails,
          fmt::format("{:.4f}, {:.4f}, {:.4f}. The off-centred cylinder is "
                      "faster than the uniform one by {:.1f} %; by the printed "
                      "times it would be {:.1f} %.",
                      bead, off, uniform, percent_less(uniform, off),
                      percent_less(number_in(printed::kUniform),
                                   number_in(printed::kOffCentred)))};
}

Claim about_angular_speed(const Findings& found) {
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

Claim about_radius(const Findings& found) {
  std::vector<std::string> values;
  const auto [least, most] =
      std::ranges::minmax_element(found.uniform, {}, &RadiusRow::tau);
  for (const RadiusRow& row : found.uniform) {
    values.push_back(fmt::format("{:.4f} (r = {:.3g})", row.tau, row.radius));
  }
  return {
      "Sec. III.F",
      "Transit times of axisymmetric cylinders do not depend on r.",
      most->tau - least->tau < 0.005 ? Verdict::Holds : Verdict::HoldsInPart,
      fmt::format("Between fixed ends of the centre's path. Between fixed "
                  "points A and B of the track τ = {}.",
                  fmt::join(values, ", "))};
}

Claim about_length_of_domain(const Findings& found) {
  const double a = tau(found, "fig12_L_2");
  const double b = tau(found, "fig04_reference_case");
  const double c = tau(found, "fig12_L_4");
  return {"Sec. III.G", "Longer domains take longer.",
          a < b && b < c ? Verdict::Holds : Verdict::Fails,
          fmt::format("τ = {:.4f}, {:.4f}, {:.4f} for L = 2, 3, 4.", a, b, c)};
}

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

Claim about_orientation(const Findings& found) {
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
              "It moves from {:.4f}° (η_m = {:.4f}) to {:.4f}° (η_m = {:.4f}), "
              "known to {:.0e}°. On a grid of 30° it is −30° for {} of {} "
              "offsets.",
              least->fastest.theta_m.value * kDegrees, least->eta_m,
              most->fastest.theta_m.value * kDegrees, most->eta_m,
              error * kDegrees, same, rows - 1))};
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

Claim about_effect_of_orientation(const Findings& found) {
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

Claim about_beating_the_bead(const Findings& found) {
  const double bead = tau(found, "fig06_bead");
  const double fast = tau(found, "fig13_faster_than_bead");
  const double between = found.bead_between_centres;
  return {
      "Sec. III.H", "An off-centred cylinder can be faster than the bead.",
      fast < bead ? Verdict::Holds : Verdict::Fails,
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

Claim about_axisymmetric_bodies(const Findings& found) {
  const double k = found.boundary.front().k;
  return {"Sec. III.H", "Axisymmetric objects are always slower than the bead.",
          k > 0.0 ? Verdict::HoldsInPart : Verdict::Holds,
          fmt::format("Between fixed ends of the centre's path, by the factor "
                      "√(1 + k). Between A and B, with r = 1/3 and L = 3, "
                      "axisymmetric cylinders of k < {:.6f} are faster "
                      "than the bead.",
                      k)};
}

}  // namespace

std::string_view name(Verdict verdict) {
  switch (verdict) {
    case Verdict::Holds:
      return "holds";
    case Verdict::HoldsInPart:
      return "holds in part";
    case Verdict::Fails:
      return "does not hold";
  }
  return "";
}

std::vector<Claim> judge(const Findings& found) {
  return {about_standard_curves(found),
          about_grid(found),
          about_normal_force(found),
          about_curvature(found),
          about_order(found),
          about_angular_speed(found),
          about_lengths(found),
          about_radius(found),
          about_length_of_domain(found),
          about_orientation(found),
          about_effect_of_orientation(found),
          about_beating_the_bead(found),
          about_axisymmetric_bodies(found)};
}

}  // namespace brachisto::reproduction
