// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <utility>

#include "brachisto/model/inertia.hpp"
#include "reproduction/figures.hpp"
#include "reproduction/printed_numbers.hpp"

namespace brachisto::reproduction {

namespace {

using report::Chart;
using report::Curve;
using report::Datum;
using report::Stroke;

constexpr int kSamples = 600;

using Quantity = std::function<double(const TrajectoryPoint&)>;

std::vector<Datum> sampled(const Motion& motion, const Quantity& x,
                           const Quantity& y) {
  std::vector<Datum> points;
  for (const TrajectoryPoint& at : motion.fine_sample(kSamples)) {
    points.push_back({x(at), y(at)});
  }
  return points;
}

Chart chart_of(std::string name, std::string title, std::string x,
               std::string y) {
  Chart chart;
  chart.name = std::move(name);
  chart.title = std::move(title);
  chart.x.label = std::move(x);
  chart.y.label = std::move(y);
  return chart;
}

constexpr const char* kBlack = "#000000";
constexpr const char* kBlue = "#1a3f8f";
constexpr const char* kBrown = "#b5651d";
constexpr const char* kGrey = "#888888";

/// Time in units of √(H/2g), that of τ.
Quantity time_of(const Motion& motion) {
  const double unit = motion.transit_time() / motion.tau();
  return [unit](const TrajectoryPoint& at) { return at.t / unit; };
}

double x_of_contact(const TrajectoryPoint& at) {
  return at.motion.contact.x;
}

/// Why the body could not follow its track, as sentences.
std::string reasons(const Case& one) {
  std::string out;
  for (const std::string& reason : one.fine.infeasible_because()) {
    out += fmt::format(" Infeasible: {}.", reason);
  }
  return out;
}

Figure incline(const Cases& cases) {
  const Case& one = cases["fig03_incline"];
  const Motion& motion = one.motion();
  const Body& body = one.scene().body;
  const auto time = [](const TrajectoryPoint& at) { return at.t; };
  Chart chart =
      chart_of("fig03_incline", "Off-centred cylinder on an incline: speeds",
               "t [s]", "speed [m/s]");
  chart.curves.push_back(
      {.name = "centre of mass, v_{cm}",
       .points = sampled(
           motion, time,
           [&](const TrajectoryPoint& at) {
             const KineticEnergy energy = kinetic_energy(
                 body, one.scene().gravity, at.theta, at.beta, at.motion.v_c);
             return std::sqrt(2.0 * one.scene().gravity * energy.translation);
           }),
       .colour = kBlue,
       .id = "v_cm"});
  chart.curves.push_back({.name = "centre of the cylinder, v_c",
                          .points = sampled(motion, time,
                                            [](const TrajectoryPoint& at) {
                                              return at.motion.v_c;
                                            }),
                          .stroke = Stroke::Dashed,
                          .colour = kBlack,
                          .id = "v_c"});
  const Check* again = one.fine.certificate.find("reintegration_error");
  return figure(
      chart, "Fig. 3. A cylinder on an incline",
      fmt::format(
          "m = 1.195 kg, r = 0.077 m, k = 0.255, η_m = 0.6521, θ_m = −83.25°, "
          "L = 1.49 m, H = 0.18 m; nothing is optimised. T = {:.6f} s. The "
          "equation of motion, integrated in time on its own, gives the same "
          "motion to {:.0e}.{} The text of the paper names the centre of the "
          "cylinder, the caption the centre of mass: both are shown.",
          motion.transit_time(), again != nullptr ? again->value : 0.0,
          reasons(one)));
}

Figure forces(const Cases& cases) {
  const Case& one = cases["fig04_reference_case"];
  const Motion& motion = one.motion();
  Chart chart = chart_of("fig05_forces", "Forces along the extremal", "x_b / H",
                         "force / m g");
  chart.curves.push_back({.name = "normal force R_n",
                          .points = sampled(motion, x_of_contact,
                                            [](const TrajectoryPoint& at) {
                                              return at.motion.R_n;
                                            }),
                          .colour = kBlue,
                          .width = 2.0,
                          .id = "R_n"});
  chart.curves.push_back({.name = "tangential force R_t",
                          .points = sampled(motion, x_of_contact,
                                            [](const TrajectoryPoint& at) {
                                              return at.motion.R_t;
                                            }),
                          .stroke = Stroke::Dashed,
                          .colour = kBlack,
                          .id = "R_t"});
  const Extreme peak = one.fine.diagnostics->max_normal_force;
  chart.y.high = 1.12 * peak.value;
  chart.notes.push_back({{peak.x, peak.value},
                         fmt::format("{:.3f} at {:.3f}", peak.value, peak.x),
                         report::Mark::Disc,
                         -10.0,
                         -4.0});
  return figure(chart, "Fig. 5. Forces from the track",
                "The off-centred cylinder of Fig. 4. R_n is zero at the start, "
                "as on every extremal. Paper: largest R_n 4.2 m g at x = "
                "2.5.");
}

Figure friction(const Cases& cases) {
  const Case& one = cases["fig04_reference_case"];
  const Motion& motion = one.motion();
  const PathDiagnostics& diagnostics = *one.fine.diagnostics;
  Chart chart = chart_of("friction", "Friction coefficient needed", "t √(2g/H)",
                         "|R_t| / R_n");
  chart.y.scale = report::Scale::Logarithmic;
  chart.y.low = 1e-3;
  chart.y.high = 30.0;
  chart.curves.push_back({.name = "needed |R_t| / R_n",
                          .points = sampled(motion, time_of(motion),
                                            [](const TrajectoryPoint& at) {
                                              return std::abs(at.motion.R_t) /
                                                     at.motion.R_n;
                                            }),
                          .colour = kBlue,
                          .width = 2.0,
                          .id = "needed"});
  const std::vector<std::pair<double, double>> levels = {
      {0.3, diagnostics.friction_above_0_3},
      {0.5, diagnostics.friction_above_0_5},
      {1.0, diagnostics.friction_above_1}};
  const Stroke strokes[] = {Stroke::Dotted, Stroke::Dashed, Stroke::DashDotted};
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const auto [level, share] = levels[i];
    chart.curves.push_back(
        {.name = fmt::format("above {} for {:.1f} % of the time", level,
                             100.0 * share),
         .points = {{0.0, level}, {motion.tau(), level}},
         .stroke = strokes[i],
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
  const Case& one = cases["fig04_reference_case"];
  const Motion& motion = one.motion();
  const double r = one.scene().body.radius;
  Chart chart = chart_of("curvature", "Curvatures along the extremal",
                         "x_b / H", "κ_b H, κ_c H, 1 − r κ_c");
  chart.y.low = -3.5;
  chart.y.high = 3.5;
  chart.curves.push_back({.name = "track, κ_b",
                          .points = sampled(motion, x_of_contact,
                                            [](const TrajectoryPoint& at) {
                                              return at.motion.kappa_b;
                                            }),
                          .colour = kBlue,
                          .width = 2.0,
                          .id = "kappa_b"});
  chart.curves.push_back(
      {.name = "path of the centre, κ_c",
       .points = sampled(motion, x_of_contact,
                         [r](const TrajectoryPoint& at) {
                           return (1.0 - at.motion.fold_margin) / r;
                         }),
       .stroke = Stroke::Dashed,
       .colour = kBlack,
       .id = "kappa_c"});
  chart.curves.push_back({.name = "fold margin, 1 − r κ_c",
                          .points = sampled(motion, x_of_contact,
                                            [](const TrajectoryPoint& at) {
                                              return at.motion.fold_margin;
                                            }),
                          .stroke = Stroke::Dotted,
                          .colour = kBrown,
                          .id = "fold margin"});
  const PathDiagnostics& found = *one.fine.diagnostics;
  return figure(
      chart, "Curvature",
      with_minus_signs(fmt::format(
          "Eq. (23), positive where the path turns downwards. The track folds "
          "where 1 − r κ_c ≤ 0; the least value is {:.3f}. At the start κ_c → "
          "−∞ and κ_b → −1/r = {:.3g}. Paper: κ_b from −1.34 to 1.52; the "
          "least local minimum and the maximum found are {:.3f} and {:.3f}.",
          found.min_fold_margin.value, -1.0 / r,
          found.curvature_after_rise.value, found.max_curvature.value)));
}

/// Kinetic energy of three bodies over a coordinate; of the off-centred one
/// also its parts.
Chart energies(const Cases& cases, std::string name, std::string x,
               const std::function<Quantity(const Motion&)>& coordinate) {
  Chart chart = chart_of(std::move(name), "Kinetic energy", std::move(x),
                         "kinetic energy / m g H");
  const auto add = [&](const char* file, std::string label, Stroke stroke,
                       const char* colour, double width,
                       double (*part)(const KineticEnergy&)) {
    const Case& one = cases[file];
    const Scene& scene = one.scene();
    chart.curves.push_back(
        {.name = label,
         .points = sampled(one.motion(), coordinate(one.motion()),
                           [&](const TrajectoryPoint& at) {
                             return part(kinetic_energy(
                                        scene.body, scene.gravity, at.theta,
                                        at.beta, at.motion.v_c)) /
                                    scene.H;
                           }),
         .stroke = stroke,
         .colour = colour,
         .width = width,
         .id = std::move(label)});
  };
  const auto total = [](const KineticEnergy& e) { return e.total(); };
  add("fig06_bead", "bead", Stroke::DashDotted, kBrown, 1.8, total);
  add("fig06_uniform_cylinder", "uniform cylinder", Stroke::Solid, kGrey, 1.8,
      total);
  add("fig04_reference_case", "off-centred cylinder", Stroke::Solid, kBlue, 2.4,
      total);
  add("fig04_reference_case", "off-centred, translation", Stroke::Dashed, kBlue,
      1.2, [](const KineticEnergy& e) { return e.translation; });
  add("fig04_reference_case", "off-centred, rotation", Stroke::Dotted, kBlue,
      1.2, [](const KineticEnergy& e) { return e.rotation; });
  return chart;
}

Figure speeds(const Cases& cases) {
  const Case& one = cases["fig04_reference_case"];
  const Motion& motion = one.motion();
  const Scene& scene = one.scene();
  const double unit = std::sqrt(2.0 * scene.gravity * scene.H);
  Chart chart = chart_of("speeds", "Speeds along the extremal", "t √(2g/H)",
                         "speed / √(2 g H)");
  chart.curves.push_back({.name = "centre of the cylinder, v_c = r ω",
                          .points = sampled(motion, time_of(motion),
                                            [unit](const TrajectoryPoint& at) {
                                              return at.motion.v_c / unit;
                                            }),
                          .colour = kBlack,
                          .id = "v_c"});
  chart.curves.push_back(
      {.name = "centre of mass, v_{cm}",
       .points = sampled(motion, time_of(motion),
                         [&](const TrajectoryPoint& at) {
                           const KineticEnergy energy =
                               kinetic_energy(scene.body, scene.gravity,
                                              at.theta, at.beta, at.motion.v_c);
                           return std::sqrt(energy.translation / scene.H);
                         }),
       .stroke = Stroke::Dashed,
       .colour = kBlue,
       .id = "v_cm"});
  return figure(chart, "Speeds",
                "The off-centred cylinder of Fig. 4. The centre moves fast "
                "where the centre of mass is near the track and the inertia A "
                "small.");
}

}  // namespace

std::vector<Figure> motion_figures(const Cases& cases) {
  std::vector<Figure> out;
  out.push_back(incline(cases));
  out.push_back(forces(cases));
  out.push_back(speeds(cases));
  out.push_back(friction(cases));
  out.push_back(curvature(cases));
  out.push_back(figure(
      energies(cases, "fig07_energy_x", "x_b / H",
               [](const Motion&) -> Quantity { return x_of_contact; }),
      "Fig. 7. Kinetic energy along the track",
      "Total kinetic energy of the three bodies of Fig. 6 and, thin, its parts "
      "for the off-centred one. The bead ends with m g H; the centres of the "
      "cylinders come down by less, since they start beside A and end above "
      "B."));
  out.push_back(figure(energies(cases, "fig07_energy_t", "t √(2g/H)", time_of),
                       "Fig. 7, against time", "The same over time."));
  return out;
}

}  // namespace brachisto::reproduction
