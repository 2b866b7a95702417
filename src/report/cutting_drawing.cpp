// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/cutting_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "report/rich_text.hpp"

namespace brachisto::report::cutting {

Point turned(Point p, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * p.x - s * p.z, s * p.x + c * p.z};
}

namespace {

/// Each point to where a function has it.
void move_points(Shapes& shapes, const auto& moved) {
  for (Polyline& polyline : shapes.polylines) {
    for (Point& p : polyline.points) p = moved(p);
  }
  for (Circle& circle : shapes.circles) circle.centre = moved(circle.centre);
  for (Label& label : shapes.labels) label.at = moved(label.at);
}

void add_lines(std::string& out, const Shapes& shapes, Line line) {
  const auto to = std::back_inserter(out);
  for (const Polyline& polyline : shapes.polylines) {
    if (polyline.line != line) continue;
    out += "<path d=\"";
    char command = 'M';
    for (const Point p : polyline.points) {
      fmt::format_to(to, "{}{:.4f} {:.4f}", command, p.x, p.z);
      command = 'L';
    }
    out += polyline.closed ? "Z\"/>\n" : "\"/>\n";
  }
  for (const Circle& circle : shapes.circles) {
    if (circle.line != line) continue;
    fmt::format_to(to, "<circle cx=\"{:.4f}\" cy=\"{:.4f}\" r=\"{:.4f}\"/>\n",
                   circle.centre.x, circle.centre.z, circle.radius);
  }
}

void add_words(std::string& out, const Label& label) {
  const auto to = std::back_inserter(out);
  fmt::format_to(to, "<text x=\"{:.4f}\" y=\"{:.4f}\" font-size=\"{:.6g}\"",
                 label.at.x, label.at.z, label.size);
  if (label.centred) out += " text-anchor=\"middle\"";
  if (label.angle != 0.0) {
    fmt::format_to(to, " transform=\"rotate({:.4f} {:.4f} {:.4f})\"",
                   label.angle * 180.0 / std::numbers::pi, label.at.x,
                   label.at.z);
  }
  fmt::format_to(to, ">{}</text>\n", xml_escaped(label.text));
}

/// Programs for drawing take a group with such a mark for a layer.
std::string layer(const char* name) {
  return fmt::format(
      "<g id=\"{0}\" class=\"{0}\" inkscape:groupmode=\"layer\" "
      "inkscape:label=\"{0}\">\n",
      name);
}

}  // namespace

Shapes Shapes::turned(double angle) const {
  Shapes out = *this;
  move_points(out, [&](Point p) { return cutting::turned(p, angle); });
  for (Label& label : out.labels) label.angle += angle;
  return out;
}

void Shapes::add(Shapes others, Point by) {
  move_points(others, [&](Point p) { return Point{p.x + by.x, p.z + by.z}; });
  std::ranges::move(others.polylines, std::back_inserter(polylines));
  std::ranges::move(others.circles, std::back_inserter(circles));
  std::ranges::move(others.labels, std::back_inserter(labels));
}

std::string as_svg(const Drawing& drawing) {
  std::string out = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" "
      "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" "
      "width=\"{0:.6g}mm\" height=\"{1:.6g}mm\" "
      "viewBox=\"0 0 {0:.6g} {1:.6g}\">\n"
      "<title>{2}</title>\n"
      "<style>path, circle {{ fill: none; stroke-width: 0.1 }} "
      ".cut {{ stroke: #ff0000 }} .engrave {{ stroke: #0000ff }} "
      "text {{ fill: #0000ff; stroke: none; font-family: sans-serif }}"
      "</style>\n",
      drawing.width, drawing.height, xml_escaped(drawing.title));
  out += layer("engrave");
  add_lines(out, drawing.shapes, Line::Engrave);
  for (const Label& label : drawing.shapes.labels) add_words(out, label);
  out += "</g>\n" + layer("cut");
  add_lines(out, drawing.shapes, Line::Cut);
  return out + "</g>\n</svg>\n";
}

}  // namespace brachisto::report::cutting
