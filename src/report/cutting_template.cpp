// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/cutting_template.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "report/letters.hpp"
#include "report/path_frame.hpp"
#include "report/rich_text.hpp"
#include "trajectory/grip.hpp"

namespace brachisto::report::cutting {

namespace {

// Lengths in mm.
constexpr double kMillimetres = 1e3;  // in a metre
constexpr double kStrip = 40.0, kNarrowest = 15.0;
constexpr double kMargin = 10.0;  ///< at the edges of a sheet
constexpr double kChord = 0.01;   ///< from the track
constexpr double kPin = 3.0;      ///< radius of a hole
constexpr double kPinFromEnd = 12.0, kBetweenPins = 150.0;
constexpr double kLetter = 5.0;
constexpr double kLeastLetter = 2.0;

/// A place of the track, and the direction into the strip.
struct EdgePoint {
  double sigma;
  Point place;
  Point inwards;
  double along = 0.0;  ///< length of the track up to here

  [[nodiscard]] Point at_depth(double depth) const {
    return {place.x + depth * inwards.x, place.z + depth * inwards.z};
  }
};

EdgePoint edge_point(const TrajectoryPoint& at) {
  return {
      at.sigma,
      {kMillimetres * at.motion.contact.x, kMillimetres * at.motion.contact.z},
      {-std::sin(at.beta), std::cos(at.beta)}};
}

double distance(Point a, Point b) {
  return std::hypot(a.x - b.x, a.z - b.z);
}

/// How far the middle of an arc is from its chord, at either edge of a strip.
double sagitta(const EdgePoint& a, const EdgePoint& middle, const EdgePoint& b,
               double depth) {
  const auto at = [&](double d) {
    const Point p = a.at_depth(d), q = b.at_depth(d), m = middle.at_depth(d);
    const double length = distance(p, q);
    if (length == 0.0) return distance(p, m);
    return std::abs((q.x - p.x) * (m.z - p.z) - (q.z - p.z) * (m.x - p.x)) /
           length;
  };
  return std::max(at(0.0), at(depth));
}

/// The track as chords near enough to it.
class Edge {
 public:
  Edge(const Motion& motion, double strip) : motion_(motion), strip_(strip) {
    // No feature is shorter than these.
    constexpr int kLeast = 100;
    const std::vector<TrajectoryPoint> rows = motion.fine_sample(kLeast);
    points_.push_back(edge_point(rows.front()));
    for (std::size_t i = 1; i < rows.size(); ++i)
      refine(edge_point(rows[i]), 0);
    for (std::size_t i = 1; i < points_.size(); ++i) {
      points_[i].along = points_[i - 1].along +
                         distance(points_[i].place, points_[i - 1].place);
    }
  }

  [[nodiscard]] const std::vector<EdgePoint>& points() const { return points_; }

 private:
  /// Adds what leads from the last point to `next`.
  void refine(const EdgePoint& next, int depth) {
    constexpr int kDeepest = 20;
    const EdgePoint last = points_.back();
    const EdgePoint middle =
        edge_point(motion_.at(0.5 * (last.sigma + next.sigma)));
    if (depth < kDeepest && sagitta(last, middle, next, strip_) > kChord) {
      refine(middle, depth + 1);
      refine(next, depth + 1);
    } else {
      points_.push_back(next);
    }
  }

  const Motion& motion_;
  double strip_;
  std::vector<EdgePoint> points_;
};

/// How wide a strip may be that does not fold on its other side.
double strip_width(const Solution& solution) {
  constexpr double kOfRadius = 0.8;
  const double sharpest =
      solution.diagnostics ? solution.diagnostics->max_curvature.value : 0.0;
  const double width =
      std::min(kStrip, kOfRadius * kMillimetres / std::max(sharpest, 1e-9));
  if (width < kNarrowest) {
    throw TemplateError(fmt::format(
        "a hump of the track has a radius of {:.3g} mm, and a strip below it "
        "less than {:.3g} mm of width; a larger scene, or "
        "scene.limits.curvature.hump, makes room",
        kMillimetres / sharpest, kNarrowest));
  }
  return width;
}

void mark_cross(Drawing& out, Point at, double arm) {
  out.polylines.push_back(
      {Line::Mark, {{at.x - arm, at.z}, {at.x + arm, at.z}}});
  out.polylines.push_back(
      {Line::Mark, {{at.x, at.z - arm}, {at.x, at.z + arm}}});
}

/// The piece between two points of the edge.
Drawing piece(std::span<const EdgePoint> edge, double strip,
              const Sheet& sheet) {
  Drawing out;
  out.width = sheet.width;
  out.height = sheet.height;
  Box box{edge.front().place, edge.front().place};
  Polyline outline{Line::Cut, {}, true};
  for (const EdgePoint& p : edge) outline.points.push_back(p.place);
  for (auto p = edge.rbegin(); p != edge.rend(); ++p) {
    outline.points.push_back(p->at_depth(strip));
  }
  for (const Point p : outline.points) box.include(p, 0.0);
  const Point shift{kMargin - box.low.x, kMargin - box.low.z};
  const auto moved = [&](Point p) {
    return Point{p.x + shift.x, p.z + shift.z};
  };
  for (Point& p : outline.points) p = moved(p);
  out.polylines.push_back(std::move(outline));

  const double length = edge.back().along - edge.front().along;
  const auto hole_at = [&](double along) {
    const auto next = std::ranges::lower_bound(edge, edge.front().along + along,
                                               {}, &EdgePoint::along);
    const EdgePoint& p = next == edge.end() ? edge.back() : *next;
    out.circles.push_back({Line::Cut, moved(p.at_depth(0.5 * strip)), kPin});
  };
  const double between = length - 2.0 * kPinFromEnd;
  if (between < 4.0 * kPin) {
    hole_at(0.5 * length);
  } else {
    const int gaps = static_cast<int>(std::ceil(between / kBetweenPins));
    for (int i = 0; i <= gaps; ++i) {
      hole_at(kPinFromEnd + between * i / gaps);
    }
  }
  return out;
}

/// Pieces as long as the sheet allows.
std::vector<Drawing> pieces(const std::vector<EdgePoint>& edge, double strip,
                            const Sheet& sheet) {
  const auto fits = [&](const Box& box) {
    return box.width() <= sheet.width - 2.0 * kMargin &&
           box.height() <= sheet.height - 2.0 * kMargin;
  };
  std::vector<Drawing> out;
  for (std::size_t first = 0; first + 1 < edge.size();) {
    Box box{edge[first].place, edge[first].place};
    std::size_t last = first;
    for (std::size_t i = first; i < edge.size(); ++i) {
      box.include(edge[i].place, 0.0);
      box.include(edge[i].at_depth(strip), 0.0);
      if (!fits(box)) break;
      last = i;
    }
    if (last == first) {
      throw TemplateError(fmt::format(
          "no piece of a strip of {:.3g} mm fits on a sheet of {:.6g} × {:.6g} "
          "mm with {:.3g} mm of margin",
          strip, sheet.width, sheet.height, kMargin));
    }
    out.push_back(
        piece(std::span(edge).subspan(first, last - first + 1), strip, sheet));
    first = last;
  }
  return out;
}

Drawing body_drawing(const Motion& motion, std::span<const MassPart> parts) {
  const Body& body = motion.scene().body;
  const double r = kMillimetres * body.radius;
  Drawing out;
  out.name = "body";
  out.width = out.height = 2.0 * (r + kMargin);
  const Point axis{r + kMargin, r + kMargin};
  const auto placed = [&](Point from_axis) {
    return Point{axis.x + from_axis.x, axis.z + from_axis.z};
  };
  out.circles.push_back({Line::Cut, axis, r});
  if (r > 2.0 * kPin) out.circles.push_back({Line::Cut, axis, kPin});
  const double beta = motion.start_angle();
  out.polylines.push_back(
      {Line::Mark, {axis, placed({-r * std::sin(beta), r * std::cos(beta)})}});
  const double arm = std::min(0.1 * r, kLetter);
  const double r_m = r * body.eta_m;
  mark_cross(
      out, placed({r_m * std::cos(body.theta_m), r_m * std::sin(body.theta_m)}),
      arm);
  for (const MassPart& part : parts) {
    const Point at =
        placed({kMillimetres * part.centre.x, kMillimetres * part.centre.z});
    out.circles.push_back({Line::Mark, at, arm});
    out.labels.push_back({{at.x + 1.5 * arm, at.z}, arm, part.name});
  }
  return out;
}

/// A line above what is drawn, as large as there is room for; where that is
/// less than the least size the sheet is wider.
void add_line_above(Drawing& out, const std::string& text, double least) {
  const double room = out.width - 2.0 * kMargin;
  const std::size_t count = letters(text);
  const double size =
      std::clamp(kLetter * room / width_of(count, kLetter), least, kLetter);
  out.labels.push_back(
      {{kMargin, 0.5 * (kMargin + kLetter) - 1.0}, size, text});
  if (size <= least) {
    out.width = std::max(out.width, 2.0 * kMargin + width_of(count, size));
  }
}

/// In letters that DXF has; empty for a bead.
std::string grip_label(const Solution& solution) {
  if (!solution.scene.body.rolls()) return {};
  return "Grip: least friction coefficient " +
         grip_in_words(solution.diagnostics->least_grip);
}

/// Class in SVG, layer and colour number in DXF.
struct Pen {
  const char* name;
  const char* layer;
  int colour;
};
Pen pen_of(Line line) {
  return line == Line::Cut ? Pen{"cut", "CUT", 1} : Pen{"mark", "MARK", 5};
}

/// DXF: group codes and values, each on a line of its own.
class Groups {
 public:
  void add(int code, std::string_view value) {
    fmt::format_to(std::back_inserter(text_), "{}\n{}\n", code, value);
  }
  void add(int code, double value) { add(code, fmt::format("{:.4f}", value)); }
  void add(int code, int value) { add(code, fmt::format("{}", value)); }
  void entity(const char* kind, Line line) {
    add(0, kind);
    add(8, pen_of(line).layer);
  }
  void place(double x, double y) {
    add(10, x);
    add(20, y);
    add(30, 0.0);
  }
  [[nodiscard]] std::string text() && { return std::move(text_); }

 private:
  std::string text_;
};

}  // namespace

std::string as_svg(const Drawing& drawing) {
  std::string out = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.6g}mm\" "
      "height=\"{1:.6g}mm\" viewBox=\"0 0 {0:.6g} {1:.6g}\">\n"
      "<title>{2}</title>\n"
      "<style>path, circle {{ fill: none; stroke-width: 0.1 }} "
      ".cut {{ stroke: #ff0000 }} .mark {{ stroke: #0000ff }} "
      "text {{ fill: #0000ff; font-family: sans-serif }}</style>\n",
      drawing.width, drawing.height, xml_escaped(drawing.title));
  const auto to = std::back_inserter(out);
  for (const Polyline& polyline : drawing.polylines) {
    fmt::format_to(to, "<path class=\"{}\" d=\"", pen_of(polyline.line).name);
    char command = 'M';
    for (const Point p : polyline.points) {
      fmt::format_to(to, "{}{:.4f} {:.4f}", command, p.x, p.z);
      command = 'L';
    }
    out += polyline.closed ? "Z\"/>\n" : "\"/>\n";
  }
  for (const Circle& circle : drawing.circles) {
    fmt::format_to(
        to, "<circle class=\"{}\" cx=\"{:.4f}\" cy=\"{:.4f}\" r=\"{:.4f}\"/>\n",
        pen_of(circle.line).name, circle.centre.x, circle.centre.z,
        circle.radius);
  }
  for (const Label& label : drawing.labels) {
    fmt::format_to(to,
                   "<text x=\"{:.4f}\" y=\"{:.4f}\" font-size=\"{:.6g}\">{}"
                   "</text>\n",
                   label.at.x, label.at.z, label.size, xml_escaped(label.text));
  }
  return out + "</svg>\n";
}

std::string as_dxf(const Drawing& drawing) {
  const auto up = [&](double z) { return drawing.height - z; };
  Groups out;
  out.add(999, drawing.title);
  out.add(0, "SECTION");
  out.add(2, "HEADER");
  out.add(9, "$ACADVER");
  out.add(1, "AC1009");
  out.add(9, "$EXTMIN");
  out.place(0.0, 0.0);
  out.add(9, "$EXTMAX");
  out.place(drawing.width, drawing.height);
  out.add(0, "ENDSEC");
  out.add(0, "SECTION");
  out.add(2, "TABLES");
  out.add(0, "TABLE");
  out.add(2, "LAYER");
  out.add(70, 2);
  for (const Line line : {Line::Cut, Line::Mark}) {
    out.add(0, "LAYER");
    out.add(2, pen_of(line).layer);
    out.add(70, 0);
    out.add(62, pen_of(line).colour);
    out.add(6, "CONTINUOUS");
  }
  out.add(0, "ENDTAB");
  out.add(0, "ENDSEC");
  out.add(0, "SECTION");
  out.add(2, "ENTITIES");
  for (const Polyline& polyline : drawing.polylines) {
    out.entity("POLYLINE", polyline.line);
    out.add(66, 1);
    out.place(0.0, 0.0);
    out.add(70, polyline.closed ? 1 : 0);
    for (const Point p : polyline.points) {
      out.entity("VERTEX", polyline.line);
      out.place(p.x, up(p.z));
    }
    out.entity("SEQEND", polyline.line);
  }
  for (const Circle& circle : drawing.circles) {
    out.entity("CIRCLE", circle.line);
    out.place(circle.centre.x, up(circle.centre.z));
    out.add(40, circle.radius);
  }
  for (const Label& label : drawing.labels) {
    out.entity("TEXT", Line::Mark);
    out.place(label.at.x, up(label.at.z));
    out.add(40, label.size);
    out.add(1, label.text);
  }
  out.add(0, "ENDSEC");
  out.add(0, "EOF");
  return std::move(out).text();
}

std::vector<Drawing> cutting_template(const Solution& solution,
                                      std::span<const MassPart> parts,
                                      const Sheet& sheet) {
  if (!solution.verified()) {
    throw TemplateError("there is no verified track to be cut");
  }
  for (const std::string& reason : solution.infeasible_because()) {
    throw TemplateError("the track cannot be rolled on: " + reason);
  }
  const Motion& motion = *solution.motion();
  const double strip = strip_width(solution);
  std::vector<Drawing> out = pieces(Edge(motion, strip).points(), strip, sheet);
  const std::size_t count = out.size();
  const std::string grip = grip_label(solution);
  for (std::size_t i = 0; i < count; ++i) {
    Drawing& drawing = out[i];
    drawing.name = fmt::format("track-{:02}", i + 1);
    drawing.title = fmt::format("Track, piece {} of {} from A", i + 1, count);
    drawing.labels.push_back(
        {{kMargin, sheet.height - 0.5 * (kMargin - kLetter) - 1.0},
         kLetter,
         drawing.title});
    if (!grip.empty()) add_line_above(drawing, grip, 0.0);
  }
  if (motion.scene().body.rolls()) {
    out.push_back(body_drawing(motion, parts));
    out.back().title = "Body at the start, its mark on the track at A";
    add_line_above(out.back(), grip, kLeastLetter);
  }
  return out;
}

}  // namespace brachisto::report::cutting
