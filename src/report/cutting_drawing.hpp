// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Drawings that a machine cuts by: what is on a sheet, and the two formats in
/// which it is written.

#pragma once

#include <string>
#include <vector>

#include "brachisto/model/body.hpp"

namespace brachisto::report::cutting {

/// What a machine does along a line.
enum class Line { Cut, Engrave };

struct Polyline {
  Line line;
  std::vector<Point> points;  ///< [mm], z down
  bool closed = false;
};
struct Circle {
  Line line;
  Point centre;   ///< [mm], z down
  double radius;  ///< [mm]
};
/// Words, which are engraved.
struct Label {
  Point at;     ///< on the base line, its left end or its middle [mm], z down
  double size;  ///< of its letters [mm]
  std::string text;
  double angle = 0.0;  ///< of the base line, downwards positive [rad]
  bool centred = false;
};

/// About the origin, from right to down positive [rad].
[[nodiscard]] Point turned(Point p, double angle);

/// Lines and words.
struct Shapes {
  std::vector<Polyline> polylines;
  std::vector<Circle> circles;
  std::vector<Label> labels;

  /// Adds others, moved by so much [mm].
  void add(Shapes others, Point by);
  /// About the origin, from right to down positive [rad].
  [[nodiscard]] Shapes turned(double angle) const;
};

/// One sheet of material with its upper left corner at the origin.
struct Drawing {
  std::string name;  ///< of its file, without the ending
  std::string title;
  double width = 0.0, height = 0.0;  ///< [mm]
  Shapes shapes;
};

/// As SVG, a user unit being a millimetre, with the layers "cut", red
/// hairlines, and "engrave", blue.
[[nodiscard]] std::string as_svg(const Drawing& drawing);

/// As DXF of release 12, which every such program reads, with the axis up, the
/// layers CUT and ENGRAVE, and millimetres as the unit in its header. Words are
/// in ASCII, with \U+ before four digits of the code of any other character; a
/// character of more digits is "?", one that controls a line a space.
[[nodiscard]] std::string as_dxf(const Drawing& drawing);

}  // namespace brachisto::report::cutting
