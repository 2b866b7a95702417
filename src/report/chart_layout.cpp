// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/chart_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "report/chart_ticks.hpp"
#include "report/csv.hpp"
#include "report/letters.hpp"
#include "report/rich_text.hpp"

namespace brachisto::report {

namespace {

constexpr double kTop = 16.0;
constexpr double kRight = 26.0;         // room for half a number
constexpr double kHeight = 360.0;       // of the area, unless scales are equal
constexpr double kLeastHeight = 150.0;  // if they are
constexpr double kMostHeight = 680.0;
constexpr double kLeastWidth = 220.0;
constexpr double kRoom = 0.03;  // share of a range beyond the data
constexpr double kTickSize = 13.0;

double room_of(const Side& side) {
  return side.scale == Scale::Degrees ? 0.0 : kRoom;
}

/// A limit that is given and that the axis has.
std::optional<double> limit(const Side& side, std::optional<double> value) {
  if (!value || !std::isfinite(Axis::laid_out(side.scale, *value))) return {};
  return value;
}

bool has(const Side& side, double value) {
  return std::isfinite(value) &&
         std::isfinite(Axis::laid_out(side.scale, value)) &&
         value >= limit(side, side.low).value_or(value) &&
         value <= limit(side, side.high).value_or(value);
}

/// Laid-out extents of what both sides have.
struct Box {
  Extent x, y;

  void include(const Chart& chart, Datum p) {
    if (!has(chart.x, p.x) || !has(chart.y, p.y)) return;
    x.include(Axis::laid_out(chart.x.scale, p.x));
    y.include(Axis::laid_out(chart.y.scale, p.y));
  }
};

Box box_of(const Chart& chart) {
  Box box;
  for (const Area& area : chart.areas) {
    for (const Datum& p : area.outline) box.include(chart, p);
  }
  for (const Curve& curve : chart.curves) {
    for (const Datum& p : curve.points) box.include(chart, p);
  }
  for (const Round& round : chart.rounds) {
    for (const double sign : {-1.0, 1.0}) {
      const double reach = sign * round.radius;
      box.include(chart, {round.centre.x + reach, round.centre.y});
      box.include(chart, {round.centre.x, round.centre.y + reach});
    }
  }
  for (const Sketch& sketch : chart.sketches) box.include(chart, sketch.at);
  for (const Note& note : chart.notes) box.include(chart, note.at);
  return box;
}

/// Laid-out ends of a side.
Extent range_of(const Side& side, Extent found) {
  const double room = room_of(side) * std::max(0.0, found.high - found.low);
  Extent range{found.low - room, found.high + room};
  if (const auto low = limit(side, side.low)) {
    range.low = Axis::laid_out(side.scale, *low);
  }
  if (const auto high = limit(side, side.high)) {
    range.high = Axis::laid_out(side.scale, *high);
  }
  if (!std::isfinite(range.low)) {
    range.low = std::isfinite(range.high) ? range.high - 1.0 : 0.0;
  }
  if (!std::isfinite(range.high)) range.high = range.low + 1.0;
  // A constant, be it with the noise of rounding, is a line in the middle.
  const double largest = std::max(std::abs(range.low), std::abs(range.high));
  if (range.high - range.low <= 1e-9 * largest || range.high == range.low) {
    const bool relative = largest > 0.0 && side.scale != Scale::Logarithmic;
    const double half = relative ? 0.05 * largest : 0.5;
    range.low -= half;
    range.high += half;
  }
  return range;
}

void widen(Extent& range, double span) {
  const double more = 0.5 * (span - (range.high - range.low));
  if (more <= 0.0) return;
  range.low -= more;
  range.high += more;
}

double widest(const std::vector<Tick>& ticks) {
  double width = 0.0;
  for (const Tick& tick : ticks) {
    width =
        std::max(width, width_of(letters(plain_words(tick.words)), kTickSize));
  }
  return width;
}

ChartSide side_of(const Side& side, Extent range, double from, double to) {
  const bool log = side.scale == Scale::Logarithmic;
  return {log ? std::pow(10.0, range.low) : range.low,
          log ? std::pow(10.0, range.high) : range.high,
          Axis(side.scale, range.low, range.high, from, to),
          {}};
}

/// As many numbers as stand apart from each other.
std::vector<Tick> ticks_across(const Side& side, const ChartSide& laid,
                               double width) {
  for (int count = std::clamp(static_cast<int>(width / 72.0), 2, 8);; --count) {
    std::vector<Tick> ticks =
        chart_ticks(side.scale, laid.low, laid.high, count);
    const double needed =
        static_cast<double>(ticks.size()) * (widest(ticks) + 10.0);
    if (count <= 2 || side.scale == Scale::Logarithmic || needed <= width) {
      return ticks;
    }
  }
}

std::vector<Tick> ticks_up(const Side& side, const ChartSide& laid,
                           double height) {
  const int count = std::clamp(static_cast<int>(height / 48.0), 2, 10);
  return chart_ticks(side.scale, laid.low, laid.high, count);
}

/// The layout with so much room at the left.
ChartLayout layout_from(const Chart& chart, double left) {
  const Box box = box_of(chart);
  Extent x = range_of(chart.x, box.x);
  Extent y = range_of(chart.y, box.y);
  PlotArea area{left, kChartWidth - kRight, kTop, kTop + kHeight};
  if (scales_are_equal(chart)) {
    const double room = area.right - area.left;
    const double scale =
        std::min(room / (x.high - x.low), kMostHeight / (y.high - y.low));
    widen(x, kLeastWidth / scale);
    widen(y, kLeastHeight / scale);
    const double width = scale * (x.high - x.low);
    area.left += 0.5 * (room - width);
    area.right = area.left + width;
    area.bottom = area.top + scale * (y.high - y.low);
  }
  ChartLayout layout{area, side_of(chart.x, x, area.left, area.right),
                     side_of(chart.y, y, chart.y_down ? area.top : area.bottom,
                             chart.y_down ? area.bottom : area.top),
                     18.0};
  layout.x.ticks = ticks_across(chart.x, layout.x, area.right - area.left);
  layout.y.ticks = ticks_up(chart.y, layout.y, area.bottom - area.top);
  return layout;
}

/// Fit for a field without quotes, as gnuplot reads them, that is no formula.
std::string field(std::string text) {
  if (begins_as_formula(text)) text.insert(0, 1, '\'');
  std::replace(text.begin(), text.end(), '"', '\'');
  std::replace(text.begin(), text.end(), ',', ';');
  std::replace_if(
      text.begin(), text.end(),
      [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  return text;
}

}  // namespace

bool ChartLayout::shows(Datum p) const {
  constexpr double kSpare = 0.5;
  const Pixel q = at(p);
  return q.x >= area.left - kSpare && q.x <= area.right + kSpare &&
         q.y >= area.top - kSpare && q.y <= area.bottom + kSpare;
}

bool scales_are_equal(const Chart& chart) {
  return chart.equal_scale && chart.x.scale != Scale::Logarithmic &&
         chart.y.scale != Scale::Logarithmic;
}

ChartLayout chart_layout(const Chart& chart) {
  constexpr double kAtTicks = 9.0, kBeforeNumbers = 10.0, kLabel = 18.0;
  // Numbers depend on the height, and that on the room they leave.
  const ChartLayout tried = layout_from(chart, 76.0);
  const double beside =
      kLabel + kBeforeNumbers + widest(tried.y.ticks) + kAtTicks;
  ChartLayout layout = layout_from(chart, std::clamp(beside, 56.0, 160.0));
  layout.y_label_x = layout.area.left - beside + kLabel;
  return layout;
}

ChartIds chart_ids(const Chart& chart) {
  std::set<std::string> taken{"curve"};  // the head of the column
  const auto unique = [&](std::string id, std::string_view kind,
                          std::size_t index) {
    id = field(std::move(id));
    if (id.find_first_not_of(' ') == std::string::npos) {
      id = fmt::format("{} {}", kind, index + 1);
    }
    std::string found = id;
    for (int i = 2; !taken.insert(found).second; ++i) {
      found = fmt::format("{} ({})", id, i);
    }
    return found;
  };
  ChartIds ids;
  for (std::size_t i = 0; i < chart.curves.size(); ++i) {
    const Curve& curve = chart.curves[i];
    ids.curves.push_back(unique(
        curve.id.empty() ? plain_words(curve.name) : curve.id, "curve", i));
  }
  for (std::size_t i = 0; i < chart.areas.size(); ++i) {
    ids.areas.push_back(unique(plain_words(chart.areas[i].name), "area", i));
  }
  return ids;
}

}  // namespace brachisto::report
