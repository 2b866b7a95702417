// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "reproduction/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "reproduction/printed_numbers.hpp"

namespace brachisto::reproduction {

report::Chart chart_of(const char* name, const char* title, const char* x,
                       const char* y) {
  report::Chart chart;
  chart.name = name;
  chart.title = title;
  chart.x.label = x;
  chart.y.label = y;
  return chart;
}

Figure figure(const report::Chart& chart, std::string heading,
              std::string caption) {
  return {.heading = std::move(heading),
          .caption = std::move(caption),
          .drawing = report::chart_figure(chart)};
}

std::vector<Figure> all_figures(const Results& found) {
  std::vector<Figure> out = motion_figures(found.cases);
  for (std::vector<Figure> more :
       {path_figures(found.cases), parameter_figures(found)}) {
    std::move(more.begin(), more.end(), std::back_inserter(out));
  }
  // Those of the paper by number, "Fig. 3" before "Fig. 10"; then the others.
  constexpr int kLast = 1000;
  const auto number = [](const Figure& figure) {
    return figure.heading.starts_with("Fig. ")
               ? std::stoi(figure.heading.substr(5))
               : kLast;
  };
  std::ranges::stable_sort(out, {}, number);
  return out;
}

namespace {

using report::Chart;
using enum report::Stroke;

/// How a line looks.
struct Look {
  report::Stroke stroke;
  std::string colour;
  double width = 1.8;
};

Chart path_chart(const char* name, const char* title) {
  Chart chart = chart_of(name, title, "x / H", "z / H, down");
  chart.x.low = -0.2;
  chart.equal_scale = true;
  chart.y_down = true;
  return chart;
}

/// \param place  Kinematics::contact for the track
void add_path(Chart& chart, const Case& one, Point Kinematics::*place,
              std::string name, std::string id, const Look& look) {
  constexpr int kSamples = 400;
  std::vector<report::Datum> points;
  for (const TrajectoryPoint& at : one.motion().fine_sample(kSamples)) {
    const Point p = at.motion.*place;
    points.push_back({p.x, p.z});
  }
  chart.curves.push_back({.name = std::move(name),
                          .points = std::move(points),
                          .stroke = look.stroke,
                          .colour = look.colour,
                          .width = look.width,
                          .id = std::move(id)});
}

/// A and B, and the body at its start.
void add_scene(Chart& chart, const Motion& motion) {
  const Scene& scene = motion.scene();
  const TrajectoryPoint start = motion.at(0.0);
  const Point m = start.motion.mass_centre;
  chart.rounds = {{{start.centre.x, start.centre.z},
                   scene.body.radius,
                   report::Datum{m.x, m.z}}};
  chart.notes = {{{0.0, 0.0}, "A", report::Mark::Circle, -8.0, -6.0},
                 {{scene.L, scene.H}, "B", report::Mark::Circle, 8.0, -6.0}};
}

/// Tracks, told apart by their dashes in grey, and thin the paths of the centre
/// of mass in the same colour.
Figure family(const Cases& cases, const char* name, const char* title,
              Members members, std::string heading, std::string caption) {
  Chart chart = path_chart(name, title);
  const std::vector<std::string> colours =
      report::family_colours(members.size());
  for (std::size_t i = 0; i < members.size(); ++i) {
    const auto& [file, label] = members[i];
    const Case& one = cases[file];
    add_path(chart, one, &Kinematics::contact,
             fmt::format("{}: τ = {:.4f}", label, one.tau().value),
             fmt::format("{} track", file), {report::stroke_of(i), colours[i]});
    if (!one.scene().body.rolls()) continue;
    add_path(chart, one, &Kinematics::mass_centre, "",
             fmt::format("{} centre of mass", file), {Solid, colours[i], 0.8});
  }
  return figure(chart, std::move(heading), std::move(caption));
}

Figure standard_curves(const Cases& cases) {
  const std::vector<std::string> colours = report::family_colours(5);
  const std::vector<std::pair<Member, Look>> drawn = {
      {{"fig04_reference_case", "smooth-contact extremal"},
       {Solid, kBlack, 2.6}},
      {{"fig04_cycloid", "Cycloid*"}, {Dashed, colours[0], 1.6}},
      {{"fig04_circular_arc", "circular arc"}, {DashDotted, colours[1], 1.6}},
      {{"fig04_parabola", "parabola"}, {Dotted, colours[2], 1.6}},
      {{"fig04_straight", "straight line"}, {Solid, colours[3], 1.6}}};
  Chart chart =
      path_chart("fig04_standard_curves", "The extremal and standard curves");
  std::string caption =
      "The cylinder with r = 1/3, η_m = 2/3, θ_m = 0, k = 1/2 on five tracks "
      "from A to B; in grey at the start of the tracks that begin vertically. "
      "Cycloid* is the track on which the centre runs along a cycloid, that "
      "of a uniform cylinder.";
  for (const auto& [member, look] : drawn) {
    const Case& one = cases[member.file];
    for (const std::string& reason : one.fine.infeasible_because()) {
      caption += fmt::format(" {}: {}.", member.name, reason);
    }
    add_path(chart, one, &Kinematics::contact,
             fmt::format("{}: τ = {:.4f}", member.name, one.tau().value),
             member.name, look);
  }
  add_scene(chart, cases["fig04_reference_case"].motion());
  return figure(chart, "Fig. 4. Standard curves and the extremal",
                caption + " Paper: τ = " + printed::kOffCentred +
                    " for the brachistochrone.");
}

Figure three_bodies(const Cases& cases) {
  Chart chart = path_chart("fig06_three_bodies",
                           "Bead, uniform and off-centred cylinder");
  const std::vector<std::pair<Member, Look>> drawn = {
      {{"fig06_bead", "bead"}, {DashDotted, kBrown, 2.0}},
      {{"fig06_uniform_cylinder", "uniform cylinder"}, {Solid, "#777777", 2.0}},
      {{"fig04_reference_case", "off-centred cylinder"}, {Solid, kBlue, 2.0}}};
  for (const auto& [member, look] : drawn) {
    const Case& one = cases[member.file];
    add_path(chart, one, &Kinematics::contact,
             fmt::format("{}: τ = {:.4f}, track {:.4f}", member.name,
                         one.tau().value, one.motion().rail_length()),
             fmt::format("{} track", member.name), look);
    if (!one.scene().body.rolls()) continue;
    add_path(chart, one, &Kinematics::mass_centre, "",
             fmt::format("{} centre of mass", member.name),
             {Dashed, look.colour, 1.2});
  }
  add_scene(chart, cases["fig04_reference_case"].motion());
  return figure(
      chart, "Fig. 6. Three bodies",
      fmt::format(
          "A bead, a uniform and an off-centred cylinder (r = 1/3, k = 1/2; "
          "η_m = 2/3, θ_m = 0) on their extremals, and the trajectories of the "
          "centres of mass, dashed. Paper: τ = {}, {}, {}; lengths 3.57, 3.66, "
          "3.66.",
          printed::kBead, printed::kUniform, printed::kOffCentred));
}

Figure radii(const Cases& cases, const std::string& offset, Members members,
             const char* name) {
  return family(
      cases, name, "Tracks by radius", members,
      "Fig. 11. Radius of the cylinder, η_m = " + offset,
      "η_m = " + offset +
          ", θ_m = 0, k = 1/2, L = 3. The text of the paper has η_m = 1/3, the "
          "caption 2/3: both are shown. Thin: centre of mass.");
}

}  // namespace

std::vector<Figure> path_figures(const Cases& cases) {
  return {
      standard_curves(cases),
      three_bodies(cases),
      family(cases, "fig08_eta_m", "Tracks by offset", kByOffset,
             "Fig. 8. Offset of the centre of mass",
             "θ_m = 0, k = 1/2, r = 1/3, L = 3. Thin: centre of mass."),
      family(cases, "fig09_theta_m", "Tracks by initial orientation",
             kByOrientation, "Fig. 9. Initial orientation",
             "η_m = 2/3, k = 1/2, r = 1/3, L = 3. Thin: centre of mass. For "
             "θ_m < 0 the track starts backwards."),
      family(cases, "fig10_k", "Tracks by moment of inertia", kByInertia,
             "Fig. 10. Moment of inertia",
             "η_m = 2/3, θ_m = 0, r = 1/3, L = 3; k up to 1 − η_m^2 = 5/9. "
             "Thin: centre of mass."),
      radii(cases, "2/3", kByRadius, "fig11_r_eta_2_3"),
      radii(cases, "1/3", kByRadiusOfTheText, "fig11_r_eta_1_3"),
      family(
          cases, "fig12_L", "Tracks by length of the domain", kByLength,
          "Fig. 12. Length of the domain",
          fmt::format("η_m = 2/3, θ_m = 0, k = 1/2, r = 1/3. Thin: centre "
                      "of mass. Paper: τ = {}, {}, {}.",
                      printed::kShort, printed::kOffCentred, printed::kLong))};
}

}  // namespace brachisto::reproduction
