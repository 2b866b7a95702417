// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "reproduction/printed_numbers.hpp"
#include "report/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace brachisto::reproduction {

namespace {

/// What the indirect method and the paper's own equations say.
std::string other_methods(const Results& found, const std::string& name) {
  std::string out;
  if (const auto& cross_check = found.cases[name].fine.extremal) {
    out = fmt::format("The indirect method differs by {:.0e}. ",
                      cross_check->difference);
  }
  const auto equations = found.equations.find(name);
  if (equations == found.equations.end()) return out;
  const auto tau = [](const std::optional<double>& value) {
    return value ? fmt::format("{:.4f}", *value)
                 : std::string("no solution from the cycloid");
  };
  return out + fmt::format(
                   "The paper's own equations with n = 100 give {} (v = 0 at "
                   "node 1) or {} (energy from node 1).",
                   tau(equations->second.rest), tau(equations->second.release));
}

/// With the other usual value of g.
std::string half_arch(const Case& one) {
  constexpr double kOtherGravity = 9.8;
  const Scene& scene = one.scene();
  return fmt::format(
      "π √(3/2g) in closed form; the paper does not state g. Here g = {:g} "
      "m/s^2; with {:g} it is {:.6f} s.",
      scene.gravity, kOtherGravity,
      one.motion().transit_time() * std::sqrt(scene.gravity / kOtherGravity));
}

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

std::vector<PrintedNumber> transit_times(const Results& found) {
  const auto row = [&](const char* place, const char* quantity,
                       const char* paper, const char* name) {
    return PrintedNumber{place, quantity,
                         paper, found.cases[name].tau(),
                         "",    other_methods(found, name)};
  };
  const Case& arch = found.cases["check_uniform_half_arch"];
  return {
      row("Fig. 6", "τ, bead, L = 3", printed::kBead, "fig06_bead"),
      row("Fig. 6", "τ, uniform cylinder, L = 3", printed::kUniform,
          "fig06_uniform_cylinder"),
      row("Fig. 4", "τ, off-centred cylinder, L = 3", printed::kOffCentred,
          "fig04_reference_case"),
      row("Fig. 12", "τ, off-centred cylinder, L = 2", printed::kShort,
          "fig12_L_2"),
      row("Fig. 12", "τ, off-centred cylinder, L = 4", printed::kLong,
          "fig12_L_4"),
      row("Sec. III.H", "τ, k = 0.1, η_m = 4/5, θ_m = −π/6", printed::kFast,
          "fig13_faster_than_bead"),
      {"Sec. II.C", "T, uniform cylinder to (r + π, r + 2)", "1.229",
       transit_time(arch), "s", half_arch(arch)},
  };
}

std::vector<PrintedNumber> lengths_and_forces(const Cases& cases) {
  const Case& reference = cases["fig04_reference_case"];
  const auto diagnostic = [&](auto&& pick) {
    return reference.measure(
        [&](const Solution& s) { return pick(*s.diagnostics); });
  };
  using D = PathDiagnostics;
  return {
      {"Fig. 6", "length of the track, bead", "3.57",
       track_length(cases["fig06_bead"])},
      {"Fig. 6", "length of the track, uniform cylinder", "3.66",
       track_length(cases["fig06_uniform_cylinder"])},
      {"Fig. 6", "length of the track, off-centred cylinder", "3.66",
       track_length(reference)},
      {"Fig. 5", "largest R_n, off-centred cylinder", "4.2",
       diagnostic([](const D& d) { return d.max_normal_force.value; }), "m g"},
      {"Fig. 5", "where R_n is largest, x_b / H", "2.5",
       diagnostic([](const D& d) { return d.max_normal_force.x; })},
      {"Sec. III.A", "least local minimum of κ_b", "−1.34",
       diagnostic([](const D& d) { return d.curvature_after_rise.value; }),
       "1/H", "The rise from the start, where κ_b tends to −1/r, is left out."},
      {"Sec. III.A", "largest κ_b", "1.52",
       diagnostic([](const D& d) { return d.max_curvature.value; }), "1/H"},
  };
}

std::vector<PrintedNumber> grid(const Results& found) {
  const double exact = found.cases["fig04_reference_case"].tau().value;
  std::vector<PrintedNumber> rows;
  const auto tau = [](const std::optional<double>& value) {
    return value ? fmt::format("{:.4f}", *value) : std::string("nothing");
  };
  for (const GridRow& row : found.grid) {
    rows.push_back(
        {"Sec. II.C",
         fmt::format("τ, off-centred cylinder, n = {}", row.nodes),
         row.nodes == 25 ? printed::kOffCentredCoarse : printed::kOffCentred,
         {row.quintic, std::abs(row.quintic - exact)},
         "",
         fmt::format("Degree 5, {} nodes, its true error; {:.6f} by degree 1 "
                     "and {} nodes. The paper's own equations give {} or {}.",
                     row.nodes + 1, row.linear, row.nodes,
                     tau(row.equations.rest), tau(row.equations.release))});
  }
  return rows;
}

}  // namespace

double PrintedNumber::difference() const {
  return ours.value - number_in(paper);
}

double PrintedNumber::slack() const {
  return 0.5 * std::pow(10.0, -decimals(paper)) + ours.error;
}

bool PrintedNumber::agrees() const {
  return std::abs(difference()) <= slack();
}

std::vector<PrintedNumber> printed_numbers(const Results& found) {
  std::vector<PrintedNumber> rows = transit_times(found);
  for (auto&& more : {lengths_and_forces(found.cases), grid(found)}) {
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

std::string with_error(const Measured& number) {
  constexpr double kRounding = 4e-16;
  const double error =
      std::max(number.error, kRounding * std::abs(number.value));
  return with_minus_signs(report::with_error(number.value, error));
}

bool bends_less_than_body(const Case& one) {
  const Body& body = one.scene().body;
  return !body.rolls() ||
         one.fine.diagnostics->max_curvature.value * body.radius < 1.0;
}

double number_in(const std::string& printed) {
  constexpr std::string_view kMinus = "−";
  const bool negative = printed.starts_with(kMinus);
  const std::string digits = negative ? printed.substr(kMinus.size()) : printed;
  const double value = std::strtod(digits.c_str(), nullptr);
  return negative ? -value : value;
}

}  // namespace brachisto::reproduction
