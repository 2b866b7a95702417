// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A track to be built: strips of sheet material whose upper edge is the track,
/// and the body that rolls on it.

#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "brachisto/model/body.hpp"
#include "brachisto/study/solution.hpp"

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

/// The sheets of material [mm].
struct Sheet {
  double width = 600.0, height = 400.0;
};

/// A track that cannot be cut from such sheets; what() says why.
class TemplateError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The track at true scale, a millimetre being one: between the track and a
/// parallel on its other side lies a strip, cut across into as many pieces as
/// the sheet asks for. Along its middle are holes for pins of 6 mm, two at the
/// least in each piece; numbers tell the order. Chords stay within 0.01 mm of
/// the track. Each piece, and the body, tells the grip that is needed. Where a
/// hump bends more sharply than the strip is wide, it is narrower. Then, of a
/// cylinder, its outline with the hole of its axis, the radius that touches the
/// track at A, the centre of mass, and its parts if they are known.
///
/// \param solution  verified
/// \param parts     of the body, in metres; may be empty
/// \throws TemplateError
[[nodiscard]] std::vector<Drawing> cutting_template(
    const Solution& solution, std::span<const MassPart> parts,
    const Sheet& sheet);

}  // namespace brachisto::report::cutting
