// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reproduction/comparison.hpp"

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
  const double exact = tau(found, "fig04_reference_case");
  double largest = 0.0;
  for (const GridRow& row : found.grid) {
    largest = std::max(largest, std::abs(row.quintic - exact));
  }
  return {"Sec. II.C", "The result does not depend on the grid.",
          largest < 0.005 ? Verdict::Holds : Verdict::Fails,
          fmt::format("With degree 5 no mesh of 26 to 201 nodes is off by more "
                      "than {:.0e}. The value itself is {:.4f}, not 4.99.",
                      largest, exact)};
}

Claim about_normal_force(const Findings& found) {
  std::vector<std::string> lifted;
  std::size_t count = 0;
  for (const auto& [name, one] : found.cases.all()) {
    if (one.scene().path || !one.scene().body.rolls()) continue;
    ++count;
    if (one.fine.diagnostics->min_normal_force.value <= 0.0) {
      lifted.push_back(words(name));
    }
  }
  return {"Sec. III.A", "R_n > 0 in every case studied.",
          lifted.empty() ? Verdict::Holds : Verdict::Fails,
          lifted.empty()
              ? fmt::format("In all {} cases after the start; at the start "
                            "itself R_n = 0 for every body.",
                            count)
              : fmt::format("Not in {}.", fmt::join(lifted, ", "))};
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

Claim about_order(const Findings& found) {
  const double bead = tau(found, "fig06_bead");
  const double off = tau(found, "fig04_reference_case");
  const double uniform = tau(found, "fig06_uniform_cylinder");
  return {"Fig. 6",
          "The bead is the quickest, the off-centred cylinder second, the "
          "uniform cylinder last.",
          bead < off && off < uniform ? Verdict::Holds : Verdict::Fails,
          fmt::format("{:.4f} < {:.4f} < {:.4f}; the off-centred one wins by "
                      "{:.1f} %, not by the printed 2.5 %.",
                      bead, off, uniform, 100.0 * (uniform - off) / uniform)};
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

Claim about_orientation(const Findings& found) {
  const auto [least, most] = std::ranges::minmax_element(
      found.orientations, {},
      [](const OrientationRow& row) { return row.fastest.theta_m.value; });
  double error = 0.0;
  for (const OrientationRow& row : found.orientations) {
    error = std::max(error, row.fastest.theta_m.error);
  }
  const double spread =
      std::max(std::abs(least->fastest.theta_m.value + std::numbers::pi / 6.0),
               std::abs(most->fastest.theta_m.value + std::numbers::pi / 6.0));
  return {"Fig. 13", "The minimum stays at θ_m = −π/6 for every η_m.",
          spread <= error ? Verdict::Holds : Verdict::Fails,
          fmt::format("It moves from {:.4f}° (η_m = {:.4f}) to {:.4f}° (η_m = "
                      "{:.4f}), known to {:.0e}°. On a grid of 30° it is −30° "
                      "for all of them.",
                      least->fastest.theta_m.value * kDegrees, least->eta_m,
                      most->fastest.theta_m.value * kDegrees, most->eta_m,
                      error * kDegrees)};
}

Claim about_beating_the_bead(const Findings& found) {
  const double bead = tau(found, "fig06_bead");
  const double fast = tau(found, "fig13_faster_than_bead");
  const double between = found.bead_between_centres;
  return {"Sec. III.H", "An off-centred cylinder can be faster than the bead.",
          fast < bead ? Verdict::Holds : Verdict::Fails,
          fmt::format(
              "{:.6f} against {:.6f}, by {:.1f} % (printed: 10 %). A "
              "bead between the ends of the path of that cylinder's "
              "centre takes {:.6f}: {} that it starts beside A and "
              "ends above B.",
              fast, bead, 100.0 * (bead - fast) / bead, between,
              fast < between ? "the gain is not merely" : "the whole gain is")};
}

Claim about_axisymmetric_bodies(const Findings& found) {
  const double k = found.boundary.front().k;
  return {"Sec. III.H", "Axisymmetric objects are always slower than the bead.",
          k > 0.0 ? Verdict::HoldsInPart : Verdict::Holds,
          fmt::format("Between fixed ends of the centre's path, by the factor "
                      "√(1 + k). Between A and B, with r = 1/3 and L = 3, "
                      "uniform cylinders of k < {:.6f} are faster than the "
                      "bead.",
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
          about_lengths(found),
          about_radius(found),
          about_length_of_domain(found),
          about_orientation(found),
          about_beating_the_bead(found),
          about_axisymmetric_bodies(found)};
}

}  // namespace brachisto::reproduction
