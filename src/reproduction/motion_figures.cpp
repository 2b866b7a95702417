// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <cmath>
#include <tuple>
#include <utility>

#include "model/inertia.hpp"
#include "reproduction/figures.hpp"
#include "reproduction/printed_numbers.hpp"

namespace brachisto::reproduction {

namespace {

using enum report::Stroke;
using At = TrajectoryPoint;

constexpr const char* kOffCentred = "fig04_reference_case";

/// A number that changes along a path.
using Quantity = double (*)(const At& at, const Motion& motion);

/// A line of a figure.
struct Line {
  const char* name;  ///< rich text
  const char* id;    ///< as in report::Curve
  report::Stroke stroke;
  const char* colour;
  double width;
  Quantity of;
  const char* file = kOffCentred;
};

KineticEnergy energy(const At& at, const Motion& motion) {
  const Scene& scene = motion.scene();
  return kinetic_energy(scene.body, scene.gravity, at.theta, at.beta,
                        at.motion.v_c);
}

double x_b(const At& at, const Motion&) {
  return at.motion.contact.x;
}

/// In units of √(H/2g), that of τ.
double time(const At& at, const Motion& motion) {
  return at.t / (motion.transit_time() / motion.tau());
}

/// A chart of some lines over one coordinate.
report::Chart along(const Cases& cases, const char* name, const char* title,
                    const char* x, const char* y, Quantity coordinate,
                    const std::vector<Line>& lines) {
  constexpr int kSamples = 600;
  report::Chart chart = chart_of(name, title, x, y);
  for (const Line& line : lines) {
    const Motion& motion = cases[line.file].motion();
    std::vector<report::Datum> points;
    for (const At& at : motion.fine_sample(kSamples)) {
      points.push_back({coordinate(at, motion), line.of(at, motion)});
    }
    chart.curves.push_back({.name = line.name,
                            .points = std::move(points),
                            .stroke = line.stroke,
                            .colour = line.colour,
                            .width = line.width,
                            .id = line.id});
  }
  return chart;
}

Figure incline(const Cases& cases) {
  constexpr const char* kFile = "fig03_incline";
  const Case& one = cases[kFile];
  const auto v_cm = [](const At& at, const Motion& m) {
    return std::sqrt(2.0 * m.scene().gravity * energy(at, m).translation);
  };
  std::string reasons;
  for (const std::string& reason : one.fine.infeasible_because()) {
    reasons += fmt::format(" Infeasible: {}.", reason);
  }
  const Check* again = one.fine.certificate.find("reintegration_error");
  return figure(
      along(
          cases, kFile, "Off-centred cylinder on an incline: speeds", "t [s]",
          "speed [m/s]", [](const At& at, const Motion&) { return at.t; },
          {{"centre of mass, v_{cm}", "v_cm", Solid, kBlue, 1.8, v_cm, kFile},
           {"centre of the cylinder, v_c", "v_c", Dashed, kBlack, 1.8,
            [](const At& at, const Motion&) { return at.motion.v_c; }, kFile}}),
      "Fig. 3. A cylinder on an incline",
      fmt::format(
          "m = 1.195 kg, r = 0.077 m, k = 0.255, η_m = 0.6521, θ_m = −83.25°, "
          "L = 1.49 m, H = 0.18 m; nothing is optimised. T = {:.6f} s. The "
          "equation of motion, integrated in time on its own, gives the same "
          "motion to {:.0e}.{} The text of the paper names the centre of the "
          "cylinder, the caption the centre of mass: both are shown.",
          one.motion().transit_time(), again != nullptr ? again->value : 0.0,
          reasons));
}

Figure forces(const Cases& cases) {
  report::Chart chart =
      along(cases, "fig05_forces", "Forces along the extremal", "x_b / H",
            "force / m g", x_b,
            {{"normal force R_n", "R_n", Solid, kBlue, 2.0,
              [](const At& at, const Motion&) { return at.motion.R_n; }},
             {"tangential force R_t", "R_t", Dashed, kBlack, 1.8,
              [](const At& at, const Motion&) { return at.motion.R_t; }}});
  const Extreme peak = cases[kOffCentred].fine.diagnostics->max_normal_force;
  chart.y.high = 1.12 * peak.value;
  chart.notes = {{{peak.x, peak.value},
                  fmt::format("{:.3f} at {:.3f}", peak.value, peak.x),
                  report::Mark::Disc,
                  -10.0,
                  -4.0}};
  return figure(chart, "Fig. 5. Forces from the track",
                "The off-centred cylinder of Fig. 4. R_n is zero at the start, "
                "as on every extremal. Paper: largest R_n 4.2 m g at x = "
                "2.5.");
}

Figure friction(const Cases& cases) {
  const Case& one = cases[kOffCentred];
  const PathDiagnostics& found = *one.fine.diagnostics;
  report::Chart chart =
      along(cases, "friction", "Friction coefficient needed", "t √(2g/H)",
            "|R_t| / R_n", time,
            {{"needed |R_t| / R_n", "needed", Solid, kBlue, 2.0,
              [](const At& at, const Motion&) {
                return std::abs(at.motion.R_t) / at.motion.R_n;
              }}});
  chart.y.scale = report::Scale::Logarithmic;
  chart.y.low = 1e-3;
  chart.y.high = 30.0;
  for (const auto& [level, share, stroke] :
       {std::tuple{0.3, found.friction_above_0_3, Dotted},
        {0.5, found.friction_above_0_5, Dashed},
        {1.0, found.friction_above_1, DashDotted}}) {
    chart.curves.push_back(
        {.name = fmt::format("above {} for {:.1f} % of the time", level,
                             100.0 * share),
         .points = {{0.0, level}, {one.motion().tau(), level}},
         .stroke = stroke,
         .colour = kGrey,
         .width = 1.2,
         .id = fmt::format("level {}", level)});
  }
  return figure(chart, "Friction that rolling needs",
                "Not in the paper. At the start of an extremal R_n = 0 "
                "while R_t ≠ 0 for k > 0, so that the coefficient needed is "
                "unbounded there: whatever the track is made of, a real body "
                "slips for a moment.");
}

Figure curvature(const Cases& cases) {
  const Case& one = cases[kOffCentred];
  const PathDiagnostics& found = *one.fine.diagnostics;
  const auto kappa_c = [](const At& at, const Motion& m) {
    return curvature_of_centre(m.scene().body, at.motion);
  };
  report::Chart chart = along(
      cases, "curvature", "Curvatures along the extremal", "x_b / H",
      "κ_b H, κ_c H, 1 − r κ_c", x_b,
      {{"track, κ_b", "kappa_b", Solid, kBlue, 2.0,
        [](const At& at, const Motion&) { return at.motion.kappa_b; }},
       {"path of the centre, κ_c", "kappa_c", Dashed, kBlack, 1.8, kappa_c},
       {"fold margin, 1 − r κ_c", "fold margin", Dotted, kBrown, 1.8,
        [](const At& at, const Motion&) { return at.motion.fold_margin; }}});
  chart.y.low = -3.5;
  chart.y.high = 3.5;
  return figure(
      chart, "Curvature",
      with_minus_signs(fmt::format(
          "Eq. (23), positive where the path turns downwards. The track folds "
          "where 1 − r κ_c ≤ 0; the least value is {:.3f}. At the start κ_c → "
          "−∞ and κ_b → −1/r = {:.3g}. Paper: κ_b from −1.34 to 1.52; the "
          "least local minimum and the maximum found are {:.3f} and {:.3f}.",
          found.min_fold_margin.value, -1.0 / one.scene().body.radius,
          found.curvature_after_rise.value, found.max_curvature.value)));
}

/// Of three bodies; of the off-centred one also its parts.
report::Chart energies(const Cases& cases, const char* name, const char* x,
                       Quantity coordinate) {
  const auto total = [](const At& at, const Motion& m) {
    return energy(at, m).total() / m.scene().H;
  };
  const auto translation = [](const At& at, const Motion& m) {
    return energy(at, m).translation / m.scene().H;
  };
  const auto rotation = [](const At& at, const Motion& m) {
    return energy(at, m).rotation / m.scene().H;
  };
  // Their names serve as ids.
  const std::vector<Line> lines = {
      {"bead", "", DashDotted, kBrown, 1.8, total, "fig06_bead"},
      {"uniform cylinder", "", Solid, kGrey, 1.8, total,
       "fig06_uniform_cylinder"},
      {"off-centred cylinder", "", Solid, kBlue, 2.4, total},
      {"off-centred, translation", "", Dashed, kBlue, 1.2, translation},
      {"off-centred, rotation", "", Dotted, kBlue, 1.2, rotation}};
  return along(cases, name, "Kinetic energy", x, "kinetic energy / m g H",
               coordinate, lines);
}

Figure speeds(const Cases& cases) {
  const auto v_c = [](const At& at, const Motion& m) {
    return at.motion.v_c / std::sqrt(2.0 * m.scene().gravity * m.scene().H);
  };
  const auto v_cm = [](const At& at, const Motion& m) {
    return std::sqrt(energy(at, m).translation / m.scene().H);
  };
  return figure(
      along(cases, "speeds", "Speeds along the extremal", "t √(2g/H)",
            "speed / √(2 g H)", time,
            {{"centre of the cylinder, v_c = r ω", "v_c", Solid, kBlack, 1.8,
              v_c},
             {"centre of mass, v_{cm}", "v_cm", Dashed, kBlue, 1.8, v_cm}}),
      "Speeds",
      "The off-centred cylinder of Fig. 4. The centre moves fast where the "
      "centre of mass is near the track and the inertia A small.");
}

}  // namespace

std::vector<Figure> motion_figures(const Cases& cases) {
  return {
      incline(cases),
      forces(cases),
      speeds(cases),
      friction(cases),
      curvature(cases),
      figure(energies(cases, "fig07_energy_x", "x_b / H", x_b),
             "Fig. 7. Kinetic energy along the track",
             "Total kinetic energy of the three bodies of Fig. 6 and, thin, "
             "its parts for the off-centred one. The bead ends with m g H; the "
             "centres of the cylinders come down by less, since they start "
             "beside A and end above B."),
      figure(energies(cases, "fig07_energy_t", "t √(2g/H)", time),
             "Fig. 7, against time", "The same over time.")};
}

}  // namespace brachisto::reproduction
