// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <algorithm>

#include "brachisto/model/body.hpp"
#include "report/sweep_plots.hpp"
#include "report/track_kind.hpp"
#include "reproduction/figures.hpp"

namespace brachisto::reproduction {

namespace {

using report::Chart;
using report::Datum;
using enum report::Stroke;

/// A place for each of some rows.
std::vector<Datum> points_of(const auto& rows, const auto& place) {
  std::vector<Datum> points;
  for (const auto& row : rows) points.push_back(place(row));
  return points;
}

/// τ against θ_m for some of the offsets of the map.
Figure map_as_curves(const std::vector<MapRow>& rows) {
  constexpr std::size_t kEvery = 4;
  Chart chart =
      chart_of("fig13_curves", "Transit time against initial orientation",
               "θ_m [°]", "τ = T √(2g/H)");
  chart.x.scale = report::Scale::Degrees;
  const std::vector<std::string> colours =
      report::family_colours((rows.size() + kEvery - 1) / kEvery);
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const auto& [eta_m, points] = rows[i * kEvery];
    chart.curves.push_back(
        {.name = fmt::format("η_m = {:.3f}", eta_m),
         .points = points_of(points,
                             [](const MapPoint& at) {
                               return Datum{at.theta_m * kDegrees, at.tau};
                             }),
         .stroke = report::stroke_of(i),
         .colour = colours[i],
         .id = fmt::format("eta_m = {:.6f}", eta_m)});
  }
  return figure(chart,
                "Fig. 13. Transit times over the place of the centre of mass",
                fmt::format("k = 1/2, r = 1/3, L = 3. Without offset the "
                            "orientation does not matter: τ = {:.4f}.",
                            rows.front().points.front().tau));
}

Figure map_as_colours(const SweepTable& table) {
  const report::Scenes scenes = report::all_scenes(table);
  const report::SweepDigest found = report::digest(table, scenes);
  const report::SweepMap map{.name = "fig13_map",
                             .first = column_of(table, kEtaKey),
                             .second = column_of(table, kThetaKey),
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
  Chart chart = chart_of("fastest_orientation",
                         "The initial orientation of the smallest τ", "η_m",
                         "θ_m of the smallest τ [°]");
  chart.curves = {
      {.name = "found",
       .points =
           points_of(found.orientations,
                     [](const OrientationRow& row) -> Datum {
                       return {row.eta_m, row.fastest.theta_m.value * kDegrees};
                     }),
       .colour = kBlue,
       .mark = report::Mark::Disc},
      {.name = "paper: −π/6 for every η_m",
       .points = {{0.0, -30.0}, {found.orientations.back().eta_m, -30.0}},
       .stroke = Dashed,
       .colour = kGrey,
       .id = "paper"}};
  return figure(
      chart, chart.title,
      fmt::format("k = 1/2, r = 1/3, L = 3; each point by minimisation "
                  "over θ_m, known to {:.0e}°.",
                  largest_error(found.orientations) * kDegrees));
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
  const auto place = [](const auto& body) -> Datum {
    return {body.eta_m, body.k};
  };
  Chart chart = chart_of(
      "fig14_region",
      "Possible bodies, and those that are faster than the bead", "η_m", "k");
  chart.x.low = -0.07;
  chart.x.high = 1.05;
  chart.y.low = -0.09;
  chart.y.high = 1.1;
  chart.areas = {
      {"possible bodies, k ≤ 1 − η_m^2", possible_bodies(), "#eeeeee"}};
  chart.curves = {{.name = "as fast as the bead, θ_m = −π/6",
                   .points = points_of(found.boundary, place),
                   .colour = kBlue,
                   .width = 2.0,
                   .id = "theta_m = -pi/6"},
                  {.name = "as fast as the bead, best θ_m",
                   .points = points_of(found.best_boundary, place),
                   .stroke = Dashed,
                   .colour = kBrown,
                   .width = 2.0,
                   .id = "fastest theta_m"}};
  const auto mark = [&](const char* name, std::string text) {
    chart.notes.push_back({place(found.cases[name].scene().body),
                           std::move(text), report::Mark::Disc, -9.0, 14.0});
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

/// The third trap as a picture: V(φ), and tracks with an arc for the kink.
Figure slope_at_b(const Results& found) {
  const auto place = [](const BentTrack& track) -> Datum {
    return {track.phi * kDegrees, track.tau};
  };
  const std::vector<Datum> kinked = points_of(found.kinked, place);
  const Motion& reference = found.cases["fig04_reference_case"].motion();
  const Datum smooth{reference.end_angle() * kDegrees, reference.tau()};
  const Datum least = *std::ranges::min_element(kinked, {}, &Datum::y);
  const bool feasible = std::ranges::all_of(found.arched, &BentTrack::feasible);
  const double radius = found.arched.front().radius;
  Chart chart = chart_of(
      "slope_at_b",
      "The third trap: the time has no minimum at the smooth contact",
      "φ, slope of the track at B [°], negative upwards", "τ = T √(2g/H)");
  chart.x.scale = report::Scale::Degrees;
  chart.x.high = 22.0;
  chart.y.low = 4.5;
  chart.subtitle =
      report::in_words(found.cases["fig04_reference_case"].scene());
  chart.curves = {
      {.name = "least time to C_B(φ), V(φ): with a kink at B, so no track",
       .points = kinked,
       .stroke = Dashed,
       .colour = kBlue,
       .id = "kink"},
      {.name = fmt::format("the kink rounded by an arc of radius {:g} H{}",
                           radius, feasible ? ": feasible tracks" : ""),
       .points = points_of(found.arched, place),
       .colour = kBrown,
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
          "The reference case. Along the axis the end of the centre's path "
          "moves on a circle about B, and the least time to it rises through "
          "the smooth contact, the only place of the curve without a kink at "
          "B. Another slope at B needs a bend next to B; the dots have one "
          "of radius {:g} H, and the sharper it is, the nearer they are to "
          "the curve, whose least is τ = {:.4f}; {} "
          "(docs/theory.md, section 3, third trap).",
          radius, least.y,
          feasible
              ? "the dots are tracks that the body can follow"
              : "not all of the dots are tracks that the body can follow"));
}

}  // namespace

std::vector<Figure> parameter_figures(const Results& found) {
  return {map_as_curves(rows_of(found.map)), map_as_colours(found.map),
          fastest_orientation_figure(found), region(found), slope_at_b(found)};
}

}  // namespace brachisto::reproduction
