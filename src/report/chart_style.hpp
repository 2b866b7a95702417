// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How the curves of a chart are told apart, on the screen and on paper.

#pragma once

#include <span>
#include <string>
#include <string_view>

#include "report/chart.hpp"
#include "report/svg.hpp"

namespace brachisto::report {

/// Dashes and gaps in turn, in units of the width; empty for a solid line.
[[nodiscard]] std::span<const double> dashes(Stroke stroke);

/// Attributes of SVG of the line of a curve, escaped.
[[nodiscard]] std::string line_style(const Curve& curve);

/// A mark about 8 px wide; nothing for Mark::None.
/// \param colour  as it comes from a chart
void draw_mark(Svg& svg, Pixel at, Mark mark, std::string_view colour);

/// Radius of the masses of a sketch [px].
[[nodiscard]] double mass_radius(const Sketch& sketch);
/// Where words begin or end, on their baseline.
struct WordsPlace {
  Pixel at;
  bool ends;
};
/// The place of the name of a sketch that is drawn there: at its right, or at
/// its left where it would reach beyond `right`.
[[nodiscard]] WordsPlace beside(const Sketch& sketch, Pixel at, double right);

}  // namespace brachisto::report
