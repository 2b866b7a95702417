// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <iterator>
#include <numbers>
#include <string_view>
#include <utility>

#include "io/visible_text.hpp"
#include "report/cutting_drawing.hpp"

namespace brachisto::report::cutting {

namespace {

constexpr int kUnitMillimetre = 4;  ///< $INSUNITS
constexpr int kMetric = 1;          ///< $MEASUREMENT

/// Layer and colour number.
struct Pen {
  const char* layer;
  int colour;
};
Pen pen_of(Line line) {
  return line == Line::Cut ? Pen{"CUT", 1} : Pen{"ENGRAVE", 5};
}

/// The code of a character of UTF-8 of two bytes or three.
unsigned code_of(std::string_view character) {
  constexpr unsigned kOfFirst[] = {0, 0x7F, 0x1F, 0x0F};
  unsigned code = static_cast<unsigned char>(character.front()) &
                  kOfFirst[character.size()];
  for (const char c : character.substr(1)) {
    code = code << 6U | (static_cast<unsigned char>(c) & 0x3FU);
  }
  return code;
}

/// Words as a value of DXF: one line of ASCII, in which ^ and %% would control.
std::string in_ascii(std::string_view words) {
  std::string out;
  while (!words.empty()) {
    const std::size_t length = io::character_length(words);
    const char c = words.front();
    if (length > 3) {
      out += '?';  // has no such code
    } else if (length > 1) {
      fmt::format_to(std::back_inserter(out), "\\U+{:04X}",
                     code_of(words.substr(0, length)));
    } else if (length == 0 || c < ' ' || c > '~') {
      out += ' ';
    } else {
      out += c;
      if (c == '^' || words.starts_with("%%")) out += ' ';
    }
    words.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return out;
}

/// Group codes and values, each on a line of its own.
class Groups {
 public:
  void add(int code, std::string_view value) {
    fmt::format_to(std::back_inserter(text_), "{}\n{}\n", code, value);
  }
  void add(int code, double value) { add(code, fmt::format("{:.4f}", value)); }
  void add(int code, int value) { add(code, fmt::format("{}", value)); }
  void variable(const char* name, int code, auto value) {
    add(9, name);
    add(code, value);
  }
  void entity(const char* kind, Line line) {
    add(0, kind);
    add(8, pen_of(line).layer);
  }
  /// \param first  code of its first coordinate
  void place(Point at, int first = 10) {
    add(first, at.x);
    add(first + 10, at.z);
    add(first + 20, 0.0);
  }
  [[nodiscard]] std::string text() && { return std::move(text_); }

 private:
  std::string text_;
};

void add_header(Groups& out, const Drawing& drawing) {
  out.add(0, "SECTION");
  out.add(2, "HEADER");
  out.variable("$ACADVER", 1, "AC1009");
  out.variable("$INSUNITS", 70, kUnitMillimetre);
  out.variable("$MEASUREMENT", 70, kMetric);
  out.add(9, "$EXTMIN");
  out.place({0.0, 0.0});
  out.add(9, "$EXTMAX");
  out.place({drawing.width, drawing.height});
  out.add(0, "ENDSEC");
}

void add_layers(Groups& out) {
  out.add(0, "SECTION");
  out.add(2, "TABLES");
  out.add(0, "TABLE");
  out.add(2, "LAYER");
  out.add(70, 2);
  for (const Line line : {Line::Cut, Line::Engrave}) {
    out.add(0, "LAYER");
    out.add(2, pen_of(line).layer);
    out.add(70, 0);
    out.add(62, pen_of(line).colour);
    out.add(6, "CONTINUOUS");
  }
  out.add(0, "ENDTAB");
  out.add(0, "ENDSEC");
}

}  // namespace

std::string as_dxf(const Drawing& drawing) {
  const auto up = [&](Point p) { return Point{p.x, drawing.height - p.z}; };
  Groups out;
  out.add(999, in_ascii(drawing.title));
  add_header(out, drawing);
  add_layers(out);
  out.add(0, "SECTION");
  out.add(2, "ENTITIES");
  for (const Polyline& polyline : drawing.shapes.polylines) {
    out.entity("POLYLINE", polyline.line);
    out.add(66, 1);
    out.place({0.0, 0.0});
    out.add(70, polyline.closed ? 1 : 0);
    for (const Point p : polyline.points) {
      out.entity("VERTEX", polyline.line);
      out.place(up(p));
    }
    out.entity("SEQEND", polyline.line);
  }
  for (const Circle& circle : drawing.shapes.circles) {
    out.entity("CIRCLE", circle.line);
    out.place(up(circle.centre));
    out.add(40, circle.radius);
  }
  for (const Label& label : drawing.shapes.labels) {
    out.entity("TEXT", Line::Engrave);
    out.place(up(label.at));
    out.add(40, label.size);
    out.add(1, in_ascii(label.text));
    out.add(50, -label.angle * 180.0 / std::numbers::pi);
    if (label.centred) {
      out.add(72, 1);
      out.place(up(label.at), 11);
    }
  }
  out.add(0, "ENDSEC");
  out.add(0, "EOF");
  return std::move(out).text();
}

}  // namespace brachisto::report::cutting
