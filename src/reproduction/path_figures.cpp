// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <utility>

#include "reproduction/figures.hpp"
#include "reproduction/members.hpp"
#include "reproduction/printed_numbers.hpp"

namespace brachisto::reproduction {

namespace {

using report::Chart;
using report::Curve;
using report::Datum;
using report::Stroke;

constexpr int kSamples = 400;

std::vector<Datum> along(const Motion& motion,
                         Point (*place)(const TrajectoryPoint&)) {
  std::vector<Datum> points;
  for (const TrajectoryPoint& at : motion.fine_sample(kSamples)) {
    const Point p = place(at);
    points.push_back({p.x, p.z});
  }
  return points;
}

Point track(const TrajectoryPoint& at) {
  return at.motion.contact;
}
Point mass_centre(const TrajectoryPoint& at) {
  return at.motion.mass_centre;
}

Chart path_chart(std::string name, std::string title) {
  Chart chart;
  chart.name = std::move(name);
  chart.title = std::move(title);
  chart.x.label = "x / H";
  chart.y.label = "z / H, down";
  chart.equal_scale = true;
  chart.x.low = -0.2;
  chart.y_down = true;
  return chart;
}

void add_ends(Chart& chart, const Scene& scene) {
  chart.notes.push_back({{0.0, 0.0}, "A", report::Mark::Circle, -8.0, -6.0});
  chart.notes.push_back(
      {{scene.L, scene.H}, "B", report::Mark::Circle, 8.0, -6.0});
}

void add_body(Chart& chart, const Motion& motion) {
  const Body& body = motion.scene().body;
  const TrajectoryPoint start = motion.at(0.0);
  const Point m = start.motion.mass_centre;
  chart.rounds.push_back(
      {{start.centre.x, start.centre.z}, body.radius, Datum{m.x, m.z}});
}

/// Tracks, told apart by their dashes in grey, and thin the paths of the centre
/// of mass in the same colour.
Chart family(const Cases& cases, std::string name, std::string title,
             const Members& members) {
  Chart chart = path_chart(std::move(name), std::move(title));
  const std::vector<std::string> colours =
      report::family_colours(members.size());
  for (std::size_t i = 0; i < members.size(); ++i) {
    const Case& one = cases[members[i].file];
    chart.curves.push_back(
        {.name =
             fmt::format("{}: τ = {:.4f}", members[i].name, one.tau().value),
         .points = along(one.motion(), track),
         .stroke = report::stroke_of(i),
         .colour = colours[i],
         .id = members[i].file + " track"});
    if (!one.scene().body.rolls()) continue;
    chart.curves.push_back({.name = "",
                            .points = along(one.motion(), mass_centre),
                            .colour = colours[i],
                            .width = 0.8,
                            .id = members[i].file + " centre of mass"});
  }
  return chart;
}

Figure standard_curves(const Cases& cases) {
  const std::vector<std::pair<Member, Stroke>> drawn = {
      {{"fig04_reference_case", "smooth-contact extremal"}, Stroke::Solid},
      {{"fig04_cycloid", "Cycloid*"}, Stroke::Dashed},
      {{"fig04_circular_arc", "circular arc"}, Stroke::DashDotted},
      {{"fig04_parabola", "parabola"}, Stroke::Dotted},
      {{"fig04_straight", "straight line"}, Stroke::Solid}};
  Chart chart =
      path_chart("fig04_standard_curves", "The extremal and standard curves");
  const std::vector<std::string> colours = report::family_colours(drawn.size());
  std::string caption =
      "The cylinder with r = 1/3, η_m = 2/3, θ_m = 0, k = 1/2 on five tracks "
      "from A to B; in grey at the start of the tracks that begin vertically. "
      "Cycloid* is the track on which the centre runs along a cycloid, that "
      "of a uniform cylinder.";
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const auto& [member, stroke] = drawn[i];
    const Case& one = cases[member.file];
    for (const std::string& reason : one.fine.infeasible_because()) {
      caption += fmt::format(" {}: {}.", member.name, reason);
    }
    chart.curves.push_back(
        {.name = fmt::format("{}: τ = {:.4f}", member.name, one.tau().value),
         .points = along(one.motion(), track),
         .stroke = stroke,
         .colour = i == 0 ? "#000000" : colours[i - 1],
         .width = i == 0 ? 2.6 : 1.6,
         .id = member.name});
  }
  const Motion& best = cases["fig04_reference_case"].motion();
  add_body(chart, best);
  add_ends(chart, best.scene());
  return figure(chart, "Fig. 4. Standard curves and the extremal",
                caption + " Paper: τ = " + printed::kOffCentred +
                    " for the brachistochrone.");
}

Figure three_bodies(const Cases& cases) {
  Chart chart = path_chart("fig06_three_bodies",
                           "Bead, uniform and off-centred cylinder");
  const std::vector<std::pair<Member, std::string>> drawn = {
      {{"fig06_bead", "bead"}, "#b5651d"},
      {{"fig06_uniform_cylinder", "uniform cylinder"}, "#777777"},
      {{"fig04_reference_case", "off-centred cylinder"}, "#1a3f8f"}};
  for (const auto& [member, colour] : drawn) {
    const Case& one = cases[member.file];
    const bool bead = !one.scene().body.rolls();
    chart.curves.push_back(
        {.name = fmt::format("{}: τ = {:.4f}, track {:.4f}", member.name,
                             one.tau().value, one.motion().rail_length()),
         .points = along(one.motion(), track),
         .stroke = bead ? Stroke::DashDotted : Stroke::Solid,
         .colour = colour,
         .width = 2.0,
         .id = member.name + " track"});
    if (bead) continue;
    chart.curves.push_back({.name = "",
                            .points = along(one.motion(), mass_centre),
                            .stroke = Stroke::Dashed,
                            .colour = colour,
                            .width = 1.2,
                            .id = member.name + " centre of mass"});
  }
  const Motion& best = cases["fig04_reference_case"].motion();
  add_body(chart, best);
  add_ends(chart, best.scene());
  return figure(
      chart, "Fig. 6. Three bodies",
      fmt::format(
          "A bead, a uniform and an off-centred cylinder (r = 1/3, k = 1/2; "
          "η_m = 2/3, θ_m = 0) on their extremals, and the trajectories of the "
          "centres of mass, dashed. Paper: τ = {}, {}, {}; lengths 3.57, 3.66, "
          "3.66.",
          printed::kBead, printed::kUniform, printed::kOffCentred));
}

Figure radii(const Cases& cases, const std::string& offset,
             const Members& members, const std::string& suffix) {
  return figure(
      family(cases, "fig11_r" + suffix, "Tracks by radius", members),
      "Fig. 11. Radius of the cylinder, η_m = " + offset,
      "η_m = " + offset +
          ", θ_m = 0, k = 1/2, L = 3. The text of the paper has η_m = 1/3, the "
          "caption 2/3: both are shown. Dashed: centre of mass.");
}

}  // namespace

std::vector<Figure> path_figures(const Cases& cases) {
  std::vector<Figure> out;
  out.push_back(standard_curves(cases));
  out.push_back(three_bodies(cases));
  out.push_back(figure(
      family(cases, "fig08_eta_m", "Tracks by offset", tracks_by_offset()),
      "Fig. 8. Offset of the centre of mass",
      "θ_m = 0, k = 1/2, r = 1/3, L = 3. Dashed: centre of mass."));
  out.push_back(
      figure(family(cases, "fig09_theta_m", "Tracks by initial orientation",
                    tracks_by_orientation()),
             "Fig. 9. Initial orientation",
             "η_m = 2/3, k = 1/2, r = 1/3, L = 3. Dashed: centre of "
             "mass. For θ_m < 0 the track starts backwards."));
  out.push_back(figure(
      family(cases, "fig10_k", "Tracks by moment of inertia",
             tracks_by_inertia()),
      "Fig. 10. Moment of inertia",
      "η_m = 2/3, θ_m = 0, r = 1/3, L = 3; k up to 1 − η_m^2 = 5/9. Dashed: "
      "centre of mass."));
  out.push_back(radii(cases, "2/3", tracks_by_radius(), "_eta_2_3"));
  out.push_back(
      radii(cases, "1/3", tracks_by_radius_of_the_text(), "_eta_1_3"));
  out.push_back(figure(
      family(cases, "fig12_L", "Tracks by length of the domain",
             tracks_by_length()),
      "Fig. 12. Length of the domain",
      fmt::format("η_m = 2/3, θ_m = 0, k = 1/2, r = 1/3. Dashed: centre of "
                  "mass. Paper: τ = {}, {}, {}.",
                  printed::kShort, printed::kOffCentred, printed::kLong)));
  return out;
}

}  // namespace brachisto::reproduction
