// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Where a chart puts what it shows.

#pragma once

#include <string>
#include <vector>

#include "report/chart.hpp"
#include "report/plot_frame.hpp"

namespace brachisto::report {

inline constexpr double kChartWidth = 720.0;  // [px]

/// One side: its range in units of the axis, pixels and ticks.
struct ChartSide {
  double low, high;
  Axis axis;
  std::vector<Tick> ticks;
};

struct ChartLayout {
  PlotArea area;
  ChartSide x, y;
  double y_label_x;  ///< baseline of the vertical label [px]

  [[nodiscard]] Pixel at(Datum p) const { return {x.axis(p.x), y.axis(p.y)}; }
  /// Whether a point is within the frame, with half a pixel to spare.
  [[nodiscard]] bool shows(Datum p) const;
};

/// Whether scales are equal: logarithmic ones cannot be.
[[nodiscard]] bool scales_are_equal(const Chart& chart);

/// Ranges hold all finite points, with a little room, unless the sides say
/// otherwise. On axes of equal scale the height follows the data; if that were
/// too low, too high or too narrow, a range is widened about its middle.
[[nodiscard]] ChartLayout chart_layout(const Chart& chart);

/// One identifier per curve and per area for the CSV file, each different.
struct ChartIds {
  std::vector<std::string> curves, areas;
};
[[nodiscard]] ChartIds chart_ids(const Chart& chart);

}  // namespace brachisto::report
