// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/cutting_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "io/visible_text.hpp"
#include "report/letters.hpp"

namespace brachisto::report::cutting {

namespace {

constexpr double kLargestLetter = 5.0, kLeastLetter = 2.0;  // [mm]

/// Depths of the plates that lap joints, and of tabs, in the strip.
constexpr double kPlateTop = 0.25, kPlateBottom = 0.75;
constexpr double kTab = 1.0 / 3.0;

/// Of words beside a number, to its letters.
constexpr double kSmall = 0.7;

double letter_of(const Edge& edge) {
  return std::min(kLargestLetter, edge.strip() / 7.0);
}

void add_line(Shapes& out, Point from, Point to) {
  out.polylines.push_back({Line::Engrave, {from, to}});
}

void add_holes(Shapes& out, const Edge& edge, const std::vector<double>& at,
               const Build& build) {
  for (const double along : at) {
    out.circles.push_back({Line::Cut,
                           edge.at(along).at_depth(0.5 * edge.strip()),
                           0.5 * build.hole});
  }
}

/// Where a tab of a spacer goes through.
void add_slot(Shapes& out, const EdgePoint& at, double strip,
              const Build& build) {
  const double half = 0.5 * build.thickness;
  const double top = 0.5 * (1.0 - kTab) * strip;
  const double bottom = 0.5 * (1.0 + kTab) * strip;
  out.polylines.push_back({Line::Cut,
                           {at.beside(top, -half), at.beside(top, half),
                            at.beside(bottom, half), at.beside(bottom, -half)},
                           true});
}

/// Level and plumb through the middle of the strip, as far as there is room.
void add_level(Shapes& out, const Edge& edge, const Piece& piece) {
  const double clear = piece.clear_to - piece.clear_from;
  const EdgePoint on = edge.at(piece.clear_from + 0.25 * clear);
  const Point at = on.at_depth(0.5 * edge.strip());
  const auto arm = [&](double across, double along) {
    constexpr double kDeep = 0.3, kOn = 0.15;
    return std::min(kDeep * edge.strip() / std::max(std::abs(across), 1e-9),
                    kOn * clear / std::max(std::abs(along), 1e-9));
  };
  const double c = std::cos(on.beta), s = std::sin(on.beta);
  const double level = arm(s, c), plumb = arm(c, s);
  add_line(out, {at.x - level, at.z}, {at.x + level, at.z});
  add_line(out, {at.x, at.z - plumb}, {at.x, at.z + plumb});
  const double size = std::min(kSmall * letter_of(edge), level / 4.0);
  out.labels.push_back({{at.x + 0.4 * size, at.z - 0.4 * size}, size, "level"});
}

/// What an outline encloses.
Part cut_out(std::string name, std::vector<Point> corners) {
  Part out{.name = std::move(name), .box = box_of(corners)};
  out.shapes.polylines.push_back({Line::Cut, std::move(corners), true});
  return out;
}

/// \param side  of two strips "L" or "R", of one ""
Part piece_part(const Edge& edge, const std::vector<Piece>& pieces,
                std::size_t index, const char* side, const Build& build) {
  const Piece& piece = pieces[index];
  const double strip = edge.strip();
  Part out = cut_out(fmt::format("{}{}", index + 1, side),
                     outline(edge, piece.from, piece.to, 0.0, strip));
  out.turns = turns_of(edge, piece.from, piece.to);
  add_holes(out.shapes, edge, piece.holes, build);
  for (const double slot : piece.slots) {
    add_slot(out.shapes, edge.at(slot), strip, build);
  }

  // Beside the edge that is rolled on, as far as a flange reaches.
  const double flange = flange_of(build);
  Polyline rolled{Line::Engrave, {}};
  for (const EdgePoint& p : edge.between(piece.from, piece.to)) {
    rolled.points.push_back(p.at_depth(flange));
  }
  out.shapes.polylines.push_back(std::move(rolled));
  add_level(out.shapes, edge, piece);

  const double clear = piece.clear_to - piece.clear_from;
  const EdgePoint words = edge.at(piece.clear_from + 0.72 * clear);
  const std::string number =
      fmt::format("{} of {} -> B", out.name, pieces.size());
  const auto fitting = [&](const std::string& text, double size) {
    return std::min(size, 0.5 * clear / width_of(letters(text), 1.0));
  };
  const double size = fitting(number, letter_of(edge));
  out.shapes.labels.push_back({words.at_depth(0.5 * strip + 0.6 * size), size,
                               number, words.beta, true});
  const std::string rolls = "rolling edge";
  const double small = fitting(rolls, kSmall * letter_of(edge));
  out.shapes.labels.push_back(
      {words.at_depth(flange + 1.3 * small), small, rolls, words.beta, true});
  const auto add_end = [&](double along, const char* name) {
    const EdgePoint end = edge.at(along);
    out.shapes.labels.push_back({end.at_depth(flange + 1.3 * letter_of(edge)),
                                 letter_of(edge), name, end.beta, true});
  };
  const double from_end = 0.8 * letter_of(edge);
  if (index == 0) add_end(piece.from + from_end, "A");
  if (index + 1 == pieces.size()) add_end(piece.to - from_end, "B");
  return out;
}

/// Of the joint between two pieces.
Part plate_part(const Edge& edge, const std::vector<Piece>& pieces,
                std::size_t index, const char* side, const Build& build) {
  const double at = pieces[index].to;
  const Joint joint = joint_of(build);
  Part out =
      cut_out(fmt::format("{}-{}{}", index + 1, index + 2, side),
              outline(edge, at - joint.end, at + joint.end,
                      kPlateTop * edge.strip(), kPlateBottom * edge.strip()));
  out.turns = turns_of(edge, at - joint.end, at + joint.end);
  add_holes(out.shapes, edge,
            {at - joint.far, at - joint.near, at + joint.near, at + joint.far},
            build);
  const EdgePoint middle = edge.at(at);
  // Between two holes.
  const double size =
      std::min(letter_of(edge), 0.7 * (2.0 * joint.near - build.hole) /
                                    width_of(letters(out.name), 1.0));
  out.shapes.labels.push_back({middle.at_depth(0.5 * edge.strip() + 0.4 * size),
                               size, out.name, middle.beta, true});
  return out;
}

/// Between the strips, with a tab through the slot of either.
Part spacer_part(double strip, const Build& build) {
  const double gauge = *build.gauge, t = build.thickness;
  const double height = (kPlateBottom - kPlateTop) * strip;
  const double shoulder = 0.5 * (height - kTab * strip);
  const double low = height - shoulder;
  Part out = cut_out("spacer", {{t, 0.0},
                                {t + gauge, 0.0},
                                {t + gauge, shoulder},
                                {2.0 * t + gauge, shoulder},
                                {2.0 * t + gauge, low},
                                {t + gauge, low},
                                {t + gauge, height},
                                {t, height},
                                {t, low},
                                {0.0, low},
                                {0.0, shoulder},
                                {t, shoulder}});
  const double size =
      std::min({kLargestLetter, 0.5 * height,
                0.9 * gauge / width_of(letters(out.name), 1.0)});
  out.shapes.labels.push_back({{t + 0.5 * gauge, 0.5 * height + 0.4 * size},
                               size,
                               out.name,
                               0.0,
                               true});
  return out;
}

void add_cross(Shapes& out, Point at, double arm) {
  add_line(out, {at.x - arm, at.z}, {at.x + arm, at.z});
  add_line(out, {at.x, at.z - arm}, {at.x, at.z + arm});
}

/// Of a disc that rolls or of its flange, with the axis at the origin.
Part disc_part(const char* name, double radius, const Build& build) {
  Part out{.name = name};
  out.box = {{-radius, -radius}, {radius, radius}};
  out.shapes.circles.push_back({Line::Cut, {0.0, 0.0}, radius});
  if (radius > build.hole) {
    out.shapes.circles.push_back({Line::Cut, {0.0, 0.0}, 0.5 * build.hole});
  }
  return out;
}

/// A sign on a disc, with its middle there, or so far to the right that it
/// covers no other.
void add_sign(Part& disc, Point at, double letter, const std::string& sign) {
  const double down = 0.35 * letter;
  const auto covered = [&](const Label& other) {
    return std::abs(other.at.x - at.x) < 1.1 * letter &&
           std::abs(other.at.z - down - at.z) < 1.1 * letter;
  };
  while (std::ranges::any_of(disc.shapes.labels, covered)) at.x += 0.5 * letter;
  disc.shapes.labels.push_back({{at.x, at.z + down}, letter, sign, 0.0, true});
}

/// Half a radius from the axis, where it is farthest from all marks.
void add_name(Part& disc, double radius, double letter) {
  constexpr int kPlaces = 8;
  std::vector<Point> marks;
  for (const Label& sign : disc.shapes.labels) marks.push_back(sign.at);
  for (const Circle& circle : disc.shapes.circles) {
    if (circle.line == Line::Engrave) marks.push_back(circle.centre);
  }
  Point best{};
  double farthest = -1.0;
  for (int i = 0; i < kPlaces; ++i) {
    const Point at =
        turned({0.0, -0.5 * radius}, 2.0 * std::numbers::pi * i / kPlaces);
    double nearest = radius;
    for (const Point mark : marks) {
      nearest = std::min(nearest, std::hypot(mark.x - at.x, mark.z - at.z));
    }
    if (nearest > farthest) {
      farthest = nearest;
      best = at;
    }
  }
  disc.shapes.labels.push_back({best, letter, disc.name, 0.0, true});
}

/// The parts of a body where they are on its disc, by numbers, and their names
/// to the right of it, for they would cross its rim.
void add_parts(Part& disc, std::span<const MassPart> made_of, double letter,
               const Build& build) {
  constexpr std::size_t kLongest = 40;
  Point next{disc.box.high.x + letter, disc.box.low.z + letter};
  int number = 0;
  for (const MassPart& part : made_of) {
    const Point at{build.per_metre() * part.centre.x,
                   build.per_metre() * part.centre.z};
    const std::string sign = fmt::format("{}", ++number);
    disc.shapes.circles.push_back({Line::Engrave, at, letter});
    add_sign(disc, {at.x + 1.6 * letter, at.z}, letter, sign);
    const std::string words =
        shortened(fmt::format("{} {}", sign, io::visible(part.name)), kLongest);
    disc.shapes.labels.push_back({next, letter, words});
    disc.box.include({next.x + width_of(letters(words), letter), next.z}, 0.0);
    next.z += 1.5 * letter;
  }
}

}  // namespace

Part Part::turned(double angle) const {
  if (angle == 0.0) return *this;
  Part out{.name = name, .shapes = shapes.turned(angle)};
  out.box = box_of(out.shapes.polylines.front().points);
  return out;
}

double flange_of(const Build& build) {
  return 0.5 * kPlateTop * build.strip;
}

std::vector<Part> track_parts(const Edge& edge,
                              const std::vector<Piece>& pieces,
                              const Build& build) {
  const std::vector<const char*> sides =
      build.gauge ? std::vector{"L", "R"} : std::vector{""};
  std::vector<Part> out;
  std::size_t spacers = 0;
  for (const char* side : sides) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      out.push_back(piece_part(edge, pieces, i, side, build));
      if (side == sides.front()) spacers += pieces[i].slots.size();
    }
  }
  for (const char* side : sides) {
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
      out.push_back(plate_part(edge, pieces, i, side, build));
    }
  }
  for (std::size_t i = 0; i < spacers; ++i) {
    out.push_back(spacer_part(edge.strip(), build));
  }
  return out;
}

std::vector<Part> body_parts(const Body& body, double start_angle,
                             std::span<const MassPart> made_of,
                             const Build& build) {
  if (!body.rolls() || body.ball) return {};
  const double r = build.per_metre() * body.radius;
  const double letter = std::clamp(r / 8.0, kLeastLetter, kLargestLetter);
  Part disc = disc_part("disc", r, build);
  add_line(disc.shapes, {0.0, 0.0},
           {-r * std::sin(start_angle), r * std::cos(start_angle)});
  // Beside the end of its radius.
  const EdgePoint axis{.sigma = 0.0, .place = {0.0, 0.0}, .beta = start_angle};
  add_sign(disc, axis.beside(r - 2.5 * letter, letter), letter, "A");
  if (body.off_centred()) {
    const Point at{r * body.eta_m * std::cos(body.theta_m),
                   r * body.eta_m * std::sin(body.theta_m)};
    add_cross(disc.shapes, at, letter);
    add_sign(disc, {at.x + 1.6 * letter, at.z}, letter, "G");
  }
  add_parts(disc, made_of, letter, build);
  add_name(disc, r, letter);
  const double rim = r + flange_of(build);
  Part flange = disc_part("flange", rim, build);
  add_name(flange, rim, letter);
  return {disc, disc, flange, flange};
}

double k_of_discs(const Body& body, const Build& build) {
  const double r = build.per_metre() * body.radius;
  const double flange = 1.0 + flange_of(build) / r;
  // Masses as squares of radii, each disc with k = ½ about its own radius.
  const double f2 = flange * flange;
  return 0.5 * (1.0 + f2 * f2) / (1.0 + f2);
}

}  // namespace brachisto::report::cutting
