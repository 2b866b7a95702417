// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/cutting_template.hpp"

#include <fmt/format.h>

#include <iterator>

#include "report/rich_text.hpp"

namespace brachisto::report::cutting {

namespace {

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

}  // namespace brachisto::report::cutting
