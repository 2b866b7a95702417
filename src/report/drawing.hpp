// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Drawings at true scale, for machines that cut.

#pragma once

#include <string>
#include <vector>

#include "brachisto/model/point.hpp"

namespace brachisto::report::cutting {

/// What a machine does along a line.
enum class Line { Cut, Mark };

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
struct Label {
  Point at;     ///< left end of its base line [mm], z down
  double size;  ///< of its letters [mm]
  std::string text;
};

/// One sheet of material with its upper left corner at the origin.
struct Drawing {
  std::string name;  ///< of its file, without the ending
  std::string title;
  double width = 0.0, height = 0.0;  ///< [mm]
  std::vector<Polyline> polylines;
  std::vector<Circle> circles;
  std::vector<Label> labels;
};

/// As SVG, a user unit being a millimetre: cuts are red hairlines, marks blue.
[[nodiscard]] std::string as_svg(const Drawing& drawing);

/// As DXF of release 12, which every such program reads, in millimetres with
/// the axis up: layers CUT and MARK.
[[nodiscard]] std::string as_dxf(const Drawing& drawing);

}  // namespace brachisto::report::cutting
