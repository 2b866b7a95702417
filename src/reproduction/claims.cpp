// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "reproduction/claims.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "reproduction/members.hpp"
#include "reproduction/printed_numbers.hpp"

namespace brachisto::reproduction {

namespace {

double tau(const Results& found, const char* name) {
  return found.cases[name].tau().value;
}

/// The name of a case without what would be markup.
std::string words(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return name;
}

Claim about_standard_curves(const Results& found) {
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

Claim about_shortest_time(const Results& found) {
  const double extremal = tau(found, "fig04_reference_case");
  const BentTrack& bent = found.bent;
  return {"Fig. 4", "The brachistochrone is the path of shortest transit time.",
          bent.tau < extremal ? Verdict::Fails : Verdict::Holds,
          fmt::format(
              "It is a minimum between the fixed ends of its centre's path. A "
              "track between the same A and B that turns up next to B, "
              "in a groove {:.3g} H wider than the body, takes τ = "
              "{:.4f} against {:.4f}{}. The sharper the bend, the "
              "faster: without limits there is no fastest track.",
              bent.radius, bent.tau, extremal,
              bent.feasible ? ", and is feasible" : "")};
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
          converged ? Verdict::Holds : Verdict::HoldsInPart,
          fmt::format("The paper's own equations go from {} or from {}, as "
                      "their energy is read, between n = {} and {}. Degree 5 "
                      "moves by {:.0e} from {} nodes on.",
                      rest, release, coarse.nodes, fine.nodes, ours,
                      found.grid.front().nodes + 1)};
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
          bent.empty() ? Verdict::Holds : Verdict::Fails,
          fmt::format("{}The condition is sufficient, not necessary: a track "
                      "folds where 1 − r κ_c ≤ 0, and the least 1 − r κ_c of "
                      "all cases is {:.3f}.",
                      bent.empty()
                          ? std::string()
                          : fmt::format("Not in {}. ", fmt::join(bent, ", ")),
                      least_margin)};
}

Claim about_shortest_track(const Results& found) {
  const auto length = [&](const char* name) {
    return found.cases[name].motion().rail_length();
  };
  const double bead = length("fig06_bead");
  const double uniform = length("fig06_uniform_cylinder");
  const double off = length("fig04_reference_case");
  return {"Fig. 6", "The bead has the shortest track of the three.",
          bead < std::min(uniform, off) ? Verdict::Holds : Verdict::Fails,
          fmt::format("{:.4f}, {:.4f}, {:.4f}: bead, uniform, off-centred.",
                      bead, uniform, off)};
}

Claim about_lengths(const Results& found) {
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

Claim about_order(const Results& found) {
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

/// "4.8706 (r = 0.5), …".
std::string by_radius(const std::vector<RadiusRow>& rows) {
  std::vector<std::string> values;
  for (const RadiusRow& row : rows) {
    values.push_back(fmt::format("{:.4f} (r = {:.3g})", row.tau, row.radius));
  }
  return fmt::format("{}", fmt::join(values, ", "));
}

double spread(const std::vector<RadiusRow>& rows) {
  const auto [least, most] =
      std::ranges::minmax_element(rows, {}, &RadiusRow::tau);
  return most->tau - least->tau;
}

Claim about_radius(const Results& found) {
  constexpr double kNone = 0.005;  // half of the last digit that is printed
  std::vector<RadiusRow> off_centred;
  for (const Member& member : tracks_by_radius()) {
    off_centred.push_back({found.cases[member.file].scene().body.radius,
                           tau(found, member.file.c_str())});
  }
  const double k = found.cases["fig06_uniform_cylinder"].scene().body.k;
  const bool varies = spread(off_centred) > kNone;
  const bool constant = spread(found.uniform) < kNone;
  return {"Sec. III.F",
          "Transit times vary with r, unlike those of axisymmetric cylinders.",
          !varies    ? Verdict::Fails
          : constant ? Verdict::Holds
                     : Verdict::HoldsInPart,
          fmt::format("Off-centred, η_m = 2/3: τ = {}. Axisymmetric times do "
                      "not depend on r between fixed ends of the centre's "
                      "path; between fixed points A and B of the track they "
                      "do: τ = {}, and for r → 0 that of the bead times "
                      "√(1 + k), {:.4f}.",
                      by_radius(off_centred), by_radius(found.uniform),
                      tau(found, "fig06_bead") * std::sqrt(1.0 + k))};
}

Claim about_length_of_domain(const Results& found) {
  const double a = tau(found, "fig12_L_2");
  const double b = tau(found, "fig04_reference_case");
  const double c = tau(found, "fig12_L_4");
  std::vector<double> lengths;
  for (const Member& member : tracks_by_length()) {
    lengths.push_back(found.cases[member.file].motion().rail_length());
  }
  const bool longer = std::ranges::is_sorted(lengths);
  return {"Sec. III.G", "Longer domains have longer tracks and take longer.",
          a < b && b < c && longer ? Verdict::Holds : Verdict::Fails,
          fmt::format("τ = {:.4f}, {:.4f}, {:.4f} and lengths {:.4f} for L = "
                      "2, 3, 4.",
                      a, b, c, fmt::join(lengths, ", "))};
}

Claim about_beating_the_bead(const Results& found) {
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

Claim about_axisymmetric_bodies(const Results& found) {
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

std::vector<Claim> judge(const Results& found) {
  return {about_possible_bodies(),
          about_dependence_on_inertia(found),
          about_grid(found),
          about_shortest_time(found),
          about_standard_curves(found),
          about_normal_force(found),
          about_rise_of_normal_force(found),
          about_bulk_of_normal_force(found),
          about_curvature(found),
          about_cycloids(found),
          about_pull(found),
          about_depth(found),
          about_shortest_track(found),
          about_lengths(found),
          about_order(found),
          about_incline(found),
          about_angular_speed(found),
          about_effect_of_offset(found),
          about_place_of_peaks(found),
          about_effect_of_inertia(found),
          about_number_of_peaks(found),
          about_radius(found),
          about_length_of_domain(found),
          about_start(found),
          about_effect_of_orientation(found),
          about_minimum(found),
          about_orientation(found),
          about_beating_the_bead(found),
          about_axisymmetric_bodies(found)};
}

}  // namespace brachisto::reproduction
