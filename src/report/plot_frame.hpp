// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What surrounds the drawing of a plot.

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "report/axis.hpp"
#include "report/svg.hpp"

namespace brachisto::report {

/// The rectangle that is drawn into [px].
struct PlotArea {
  double left, right, top, bottom;
};

/// Thin lines around the area.
void draw_frame(Svg& svg, const PlotArea& area);

/// What is put in between is seen within the area only.
/// \param id  unique within a page
void begin_clip(Svg& svg, const PlotArea& area, std::string_view id);
void end_clip(Svg& svg);

/// Letters of the names of the axes of an area that surely find room.
[[nodiscard]] std::size_t letters_of_x_label(const PlotArea& area);
[[nodiscard]] std::size_t letters_of_y_label(const PlotArea& area);

/// Ticks outside the area, their numbers and the name of the axis; `label` is
/// markup.
void draw_x_axis(Svg& svg, const PlotArea& area, const Axis& axis,
                 std::string_view label);
void draw_y_axis(Svg& svg, const PlotArea& area, const Axis& axis,
                 std::string_view label);

/// The same with given ticks.
/// \param label_x  where the baseline of the vertical label is [px]
void draw_x_axis(Svg& svg, const PlotArea& area, const Axis& axis,
                 const std::vector<Tick>& ticks, std::string_view label);
void draw_y_axis(Svg& svg, const PlotArea& area, const Axis& axis,
                 const std::vector<Tick>& ticks, std::string_view label,
                 double label_x);

/// How far a horizontal axis of numbers with its label reaches below the plot.
inline constexpr double kAxisDepth = 42.0;

/// Words at 0, 1, 2, … of the horizontal axis, slanted if they are many or
/// long.
void draw_categories(Svg& svg, const PlotArea& area, const Axis& axis,
                     const std::vector<std::string>& words,
                     std::string_view label);

/// How far those words and the label reach below the plot.
[[nodiscard]] double categories_depth(const PlotArea& area,
                                      const std::vector<std::string>& words);

}  // namespace brachisto::report
