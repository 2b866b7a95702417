// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "reproduction/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

namespace brachisto::reproduction {

namespace {

constexpr const char* kOffCentred =
    "Three independent methods agree on ours; no reading of the paper's "
    "discrete system that was tried gives the printed number.";

Measured transit_time(const Case& one) {
  const double T = one.motion().transit_time();
  return {T, one.fine.estimated_error.value_or(0.0) * T};
}

Measured track_length(const Case& one) {
  return one.measure(
      [](const Solution& s) { return s.motion()->rail_length(); });
}

/// Digits after the point.
int decimals(std::string_view printed) {
  const std::size_t point = printed.find('.');
  return point == std::string_view::npos
             ? 0
             : static_cast<int>(printed.size() - point - 1);
}

std::vector<Comparison> transit_times(const Cases& cases) {
  return {
      {"Fig. 6", "τ, bead, L = 3", "4.52", cases["fig06_bead"].tau(), "",
       "Closed form 4.510563136747. The paper is 0.2 % above."},
      {"Fig. 6", "τ, uniform cylinder, L = 3", "5.12",
       cases["fig06_uniform_cylinder"].tau(), "",
       "Closed form 5.115100653580."},
      {"Fig. 4", "τ, off-centred cylinder, L = 3", "4.99",
       cases["fig04_reference_case"].tau(), "", kOffCentred},
      {"Fig. 12", "τ, off-centred cylinder, L = 2", "3.96",
       cases["fig12_L_2"].tau(), "", kOffCentred},
      {"Fig. 12", "τ, off-centred cylinder, L = 4", "6.26",
       cases["fig12_L_4"].tau(), "", kOffCentred},
      {"Sec. III.H", "τ, k = 0.1, η_m = 4/5, θ_m = −π/6", "4.06",
       cases["fig13_faster_than_bead"].tau(), "",
       "The start is far from vertical here (112°), so that the printed energy "
       "z in place of z − z_0 makes a present of energy. " +
           std::string(kOffCentred)},
      {"Sec. II.C", "T, uniform cylinder to (r + π, r + 2)", "1.229",
       transit_time(cases["check_uniform_half_arch"]), "s",
       "Closed form π √(3/2g) = 1.228459939 s at g = 9.81 m/s^2. The paper "
       "claims 0.05 %, and is 0.04 % above."},
  };
}

std::vector<Comparison> lengths_and_forces(const Cases& cases) {
  const Case& reference = cases["fig04_reference_case"];
  const auto diagnostic = [&](auto&& pick) {
    return reference.measure(
        [&](const Solution& s) { return pick(*s.diagnostics); });
  };
  using D = PathDiagnostics;
  return {
      {"Fig. 6", "length of the track, bead", "3.57",
       track_length(cases["fig06_bead"]), "", ""},
      {"Fig. 6", "length of the track, uniform cylinder", "3.66",
       track_length(cases["fig06_uniform_cylinder"]), "", ""},
      {"Fig. 6", "length of the track, off-centred cylinder", "3.66",
       track_length(reference), "", "Of another path, as its τ shows."},
      {"Fig. 5", "largest R_n, off-centred cylinder", "4.2",
       diagnostic([](const D& d) { return d.max_normal_force.value; }), "m g",
       "Differences on some 100 nodes smooth the peak, and the path is "
       "another."},
      {"Fig. 5", "where R_n is largest, x_b", "2.5",
       diagnostic([](const D& d) { return d.max_normal_force.x; }), "", ""},
      {"Sec. III.A", "least κ_b after the start", "−1.34",
       diagnostic([](const D& d) { return d.min_curvature.value; }), "",
       "At the start itself κ_b tends to −1/r = −3, which a mesh of 100 nodes "
       "does not show."},
      {"Sec. III.A", "largest κ_b", "1.52",
       diagnostic([](const D& d) { return d.max_curvature.value; }), "", ""},
  };
}

std::vector<Comparison> grid(const Findings& found) {
  const double exact = found.cases["fig04_reference_case"].tau().value;
  std::vector<Comparison> rows;
  for (const GridRow& row : found.grid) {
    const bool first = row.nodes == 25;
    rows.push_back(
        {"Sec. II.C",
         fmt::format("τ, off-centred cylinder, n = {}", row.nodes),
         first ? "4.97" : "4.99",
         {row.quintic, std::abs(row.quintic - exact)},
         "",
         fmt::format(
             "Degree 5, {} nodes. Degree 1, {} nodes: {:.6f}. Converged "
             "in the paper's digits from the first mesh on.",
             row.nodes + 1, row.nodes, row.linear)});
  }
  return rows;
}

}  // namespace

double Comparison::difference() const {
  std::string digits = paper;
  if (const std::size_t minus = digits.find("−"); minus == 0) {
    digits = "-" + digits.substr(std::string_view("−").size());
  }
  return ours.value - std::strtod(digits.c_str(), nullptr);
}

double Comparison::slack() const {
  return 0.5 * std::pow(10.0, -decimals(paper)) + ours.error;
}

bool Comparison::agrees() const {
  return std::abs(difference()) <= slack();
}

std::vector<Comparison> compare(const Findings& found) {
  std::vector<Comparison> rows = transit_times(found.cases);
  for (auto&& more : {lengths_and_forces(found.cases), grid(found)}) {
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

std::string with_error(const Measured& number) {
  constexpr int kMostDecimals = 12;
  constexpr double kRounding = 4e-16;
  const double error =
      std::max(number.error, kRounding * std::abs(number.value));
  const int places = std::clamp(static_cast<int>(std::ceil(-std::log10(error))),
                                1, kMostDecimals);
  return fmt::format("{:.{}f} ± {:.0e}", number.value, places, error);
}

bool bends_less_than_body(const Case& one) {
  const Body& body = one.scene().body;
  return !body.rolls() ||
         one.fine.diagnostics->max_curvature.value * body.radius < 1.0;
}

std::vector<const Case*> infeasible_cases(const Cases& cases) {
  std::vector<const Case*> found;
  for (const auto& [name, one] : cases.all()) {
    if (!one.scene().path && !one.fine.feasible()) found.push_back(&one);
  }
  return found;
}

}  // namespace brachisto::reproduction
