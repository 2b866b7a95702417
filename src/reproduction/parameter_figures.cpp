// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "brachisto/model/mass_distribution.hpp"
#include "report/sweep_plots.hpp"
#include "report/track_kind.hpp"
#include "reproduction/cases.hpp"
#include "reproduction/figures.hpp"

namespace brachisto::reproduction {

namespace {

using report::Chart;
using report::Curve;
using report::Datum;
using report::Stroke;

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr const char* kEtaKey = "scene.body.eta_m";
constexpr const char* kThetaKey = "scene.body.theta_m";

std::size_t column(const SweepTable& table, const char* key) {
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    if (table.columns[c].key == key) return c;
  }
  throw std::runtime_error(fmt::format("the map does not vary {}", key));
}

/// τ against θ_m for some of the offsets of the map.
Figure map_as_curves(const SweepTable& map) {
  constexpr std::size_t kEvery = 4;
  const std::size_t eta = column(map, kEtaKey);
  const std::size_t theta = column(map, kThetaKey);
  const std::size_t row = map.axes.back().count;
  Chart chart;
  chart.name = "fig13_curves";
  chart.title = "Transit time against initial orientation";
  chart.x.label = "θ_m [°]";
  chart.x.scale = report::Scale::Degrees;
  chart.y.label = "τ = T √(2g/H)";
  const std::size_t rows = map.outcomes.size() / row;
  const std::vector<std::string> colours =
      report::family_colours((rows + kEvery - 1) / kEvery);
  for (std::size_t r = 0; r < rows; r += kEvery) {
    Curve curve;
    const double offset = map.columns[eta].numbers[r * row];
    curve.name = fmt::format("η_m = {:.3f}", offset);
    curve.id = fmt::format("eta_m = {:.6f}", offset);
    curve.colour = colours[r / kEvery];
    curve.stroke = report::stroke_of(r / kEvery);
    for (std::size_t i = r * row; i < (r + 1) * row; ++i) {
      curve.points.push_back(
          {map.columns[theta].numbers[i] * kDegrees, map.outcomes[i].tau});
    }
    chart.curves.push_back(std::move(curve));
  }
  return figure(chart,
                "Fig. 13. Transit times over the place of the centre of "
                "mass",
                fmt::format("k = 1/2, r = 1/3, L = 3. Without offset the "
                            "orientation does not matter: τ = {:.4f}.",
                            map.outcomes.front().tau));
}

Figure map_as_colours(const SweepTable& table) {
  const report::Scenes scenes = report::all_scenes(table);
  const report::SweepDigest found = report::digest(table, scenes);
  const report::SweepMap map{.name = "fig13_map",
                             .first = column(table, kEtaKey),
                             .second = column(table, kThetaKey),
                             .n_first = table.axes.front().count,
                             .n_second = table.axes.back().count,
                             .scenes = scenes};
  const double least = table.outcomes[*found.fastest].tau;
  const double most = table.outcomes[*found.slowest].tau;
  return {.heading = "Fig. 13 as a map",
          .caption = fmt::format(
              "τ over η_m and θ_m for k = 1/2, r = 1/3, L = 3: {} scenes, all "
              "verified. The smallest value of the grid is {:.6f}.",
              table.outcomes.size(), least),
          .drawing = report::map_figure(table, map, {least, most})};
}

Figure fastest_orientation_figure(const Results& found) {
  Chart chart;
  chart.name = "fastest_orientation";
  chart.title = "The initial orientation of the smallest τ";
  chart.x.label = "η_m";
  chart.y.label = "θ_m of the smallest τ [°]";
  Curve curve{.name = "found", .points = {}, .colour = "#1a3f8f"};
  curve.mark = report::Mark::Disc;
  curve.id = "found";
  for (const OrientationRow& row : found.orientations) {
    curve.points.push_back({row.eta_m, row.fastest.theta_m.value * kDegrees});
  }
  const double last = found.orientations.back().eta_m;
  double error = 0.0;
  for (const OrientationRow& row : found.orientations) {
    error = std::max(error, row.fastest.theta_m.error);
  }
  chart.curves.push_back(std::move(curve));
  chart.curves.push_back({.name = "paper: −π/6 for every η_m",
                          .points = {{0.0, -30.0}, {last, -30.0}},
                          .stroke = Stroke::Dashed,
                          .colour = "#888888",
                          .id = "paper"});
  return figure(
      chart, "The initial orientation of the smallest τ",
      fmt::format("k = 1/2, r = 1/3, L = 3; each point by minimisation "
                  "over θ_m, known to {:.0e}°.",
                  error * kDegrees));
}

std::vector<Datum> boundary_points(const std::vector<BoundaryBody>& bodies) {
  std::vector<Datum> points;
  for (const BoundaryBody& body : bodies) {
    points.push_back({body.eta_m, body.k});
  }
  return points;
}

std::vector<Datum> possible_bodies() {
  constexpr int kPoints = 200;
  std::vector<Datum> outline{{0.0, 0.0}};
  for (int i = 0; i <= kPoints; ++i) {
    const double eta = static_cast<double>(i) / kPoints;
    outline.push_back({eta, largest_k(eta)});
  }
  return outline;
}

/// A point mass, or a thin ring if it has a radius; lengths in units of r.
struct Piece {
  double mass = 1.0;
  Point at;
  double radius = 0.0;
};

/// A body made of such pieces as an example.
report::Sketch example(const std::vector<Piece>& pieces, std::string text) {
  std::vector<MassPart> parts;
  report::Sketch sketch;
  for (const Piece& piece : pieces) {
    if (piece.radius > 0.0) {
      parts.push_back(MassPart::ring(piece.mass, piece.at, piece.radius));
      sketch.rings.push_back(piece.radius);
    } else {
      parts.push_back(MassPart::point(piece.mass, piece.at));
      sketch.masses.push_back({piece.at.x, piece.at.z});
    }
  }
  const MassProperties whole = mass_properties(parts, 1.0);
  sketch.at = {whole.eta_m, whole.k};
  sketch.name = std::move(text);
  return sketch;
}

std::vector<report::Sketch> examples() {
  const Point axis{0.0, 0.0};
  return {
      example({{1.0, axis, 1.0}}, "ring"),
      example({{1.0, axis}}, "rod on the axis"),
      example({{1.0, axis, 0.7}}, ""),
      example({{3.0, {0.0, 1.0}}, {1.0, {0.0, -1.0}}}, "masses on the rim"),
      example({{1.0, axis, 1.0}, {3.0, {0.0, 1.0}}}, ""),
      example({{1.0, axis, 0.9}, {1.0, {0.0, 0.6}}}, ""),
      example({{1.0, {-0.8, 0.2}}, {1.0, {0.8, 0.2}}}, ""),
  };
}

Figure region(const Results& found) {
  Chart chart;
  chart.name = "fig14_region";
  chart.title = "Possible bodies, and those that are faster than the bead";
  chart.x = {"η_m", report::Scale::Linear, -0.07, 1.05};
  chart.y = {"k", report::Scale::Linear, -0.09, 1.1};
  chart.areas.push_back(
      {"possible bodies, k ≤ 1 − η_m^2", possible_bodies(), "#eeeeee"});
  chart.curves.push_back({.name = "as fast as the bead, θ_m = −π/6",
                          .points = boundary_points(found.boundary),
                          .colour = "#1a3f8f",
                          .width = 2.0,
                          .id = "theta_m = -pi/6"});
  chart.curves.push_back({.name = "as fast as the bead, best θ_m",
                          .points = boundary_points(found.best_boundary),
                          .stroke = Stroke::Dashed,
                          .colour = "#b5651d",
                          .width = 2.0,
                          .id = "fastest theta_m"});
  const auto mark = [&](const char* name, std::string text) {
    const Body& body = found.cases[name].scene().body;
    chart.notes.push_back({{body.eta_m, body.k},
                           std::move(text),
                           report::Mark::Disc,
                           -9.0,
                           14.0});
  };
  mark("fig04_reference_case", "Figs. 4–7");
  mark("fig13_faster_than_bead",
       fmt::format("τ = {:.4f}",
                   found.cases["fig13_faster_than_bead"].tau().value));
  chart.sketches = examples();
  return figure(
      chart, "Fig. 14. Possible bodies (appendix A)",
      "All bodies of radius r lie between the axes and k = 1 − η_m^2, "
      "which those reach whose mass lies on the rim. Those below the "
      "lines get from A to B (L = 3, r = 1/3) faster than the bead. "
      "The command brachisto body tells where a body made of parts lies.");
}

/// The third trap as a picture.
Figure slope_at_b(const Results& found) {
  const auto points = [](const std::vector<BentTrack>& tracks) {
    std::vector<Datum> out;
    for (const BentTrack& track : tracks) {
      out.push_back({track.phi * kDegrees, track.tau});
    }
    return out;
  };
  const std::vector<Datum> kinked = points(found.kinked);
  const Datum smooth = kinked.front();
  const Datum least = *std::ranges::min_element(kinked, {}, &Datum::y);
  Chart chart;
  chart.name = "slope_at_b";
  chart.title = "The third trap: bending the track next to B makes it faster";
  chart.subtitle =
      report::in_words(found.cases["fig04_reference_case"].scene());
  chart.x.label = "slope of the track at B [°]";
  chart.x.scale = report::Scale::Degrees;
  chart.x.high = 22.0;
  chart.y.label = "τ = T √(2g/H)";
  chart.y.low = 4.5;
  chart.y.high = 5.17;
  chart.curves = {
      {.name = "extremal of the centre, then a kink at B: the limit, no track",
       .points = kinked,
       .stroke = Stroke::Dashed,
       .colour = "#1a3f8f",
       .id = "kink"},
      {.name = fmt::format("bent on an arc of radius {:g} H: a track, feasible",
                           found.bent.radius),
       .points = points(found.arched),
       .colour = "#b5651d",
       .width = 0.0,
       .mark = report::Mark::Disc,
       .id = "arc"}};
  chart.notes = {{smooth, fmt::format("smooth contact, τ = {:.4f}", smooth.y),
                  report::Mark::Square, -12.0, -10.0},
                 {least, fmt::format("τ = {:.3f}, not attained", least.y),
                  report::Mark::Circle, 8.0, 16.0}};
  return figure(
      chart, "The slope at B",
      fmt::format(
          "The reference case: the smooth contact is stationary between its "
          "own "
          "ends of the centre's path, but not when the slope at B may vary. "
          "The sharper the track bends next to B, the faster it is, down to "
          "τ = {:.4f}; the dots are tracks that the body can follow "
          "(docs/theory.md, section 3, third trap).",
          least.y));
}

}  // namespace

std::vector<Figure> parameter_figures(const Results& found) {
  return {map_as_curves(found.map), map_as_colours(found.map),
          fastest_orientation_figure(found), region(found), slope_at_b(found)};
}

}  // namespace brachisto::reproduction
