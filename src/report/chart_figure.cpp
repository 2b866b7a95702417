// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <string_view>

#include "math/enum_table.hpp"
#include "report/chart.hpp"
#include "report/csv.hpp"
#include "report/letters.hpp"
#include "report/note_places.hpp"
#include "report/rich_text.hpp"

namespace brachisto::report {

namespace {

// Lengths on the picture [px].
constexpr double kWidth = 720.0, kHeight = 380.0;   // the latter of the plot
constexpr double kLeast = 180.0, kLargest = 620.0;  // height at equal scales
constexpr double kLeft = 96.0, kRight = 24.0;
constexpr double kPlotWidth = kWidth - kLeft - kRight;

/// In units of the width of the line, for the terminals of a Figure.
constexpr auto kDashes =
    table_by<Stroke>("solid", "(5,3)", "(1.2,2.2)", "(6.5,2.5,1.2,2.5)");

/// Of a Mark in the terminals.
constexpr auto kPointTypes = table_by<Mark>(0, 7, 6, 5, 9, 12, 2);

bool look_the_same(const Curve& a, const Curve& b) {
  return a.name == b.name && a.stroke == b.stroke && a.colour == b.colour &&
         a.width == b.width && a.mark == b.mark;
}

/// A chart as table and commands.
class Drawing {
 public:
  explicit Drawing(const Chart& chart) : chart_(chart) {
    equal_ = chart.equal_scale && chart.x.scale == Scale::Linear &&
             chart.y.scale == Scale::Linear;
    set_ranges();
    count_names();
  }

  [[nodiscard]] Figure figure() {
    constexpr double kSlanted = 60.0;  // room for words
    canvas_.open({.left = kLeft,
                  .right = kRight,
                  .height = plot_height_,
                  .above = 18.0,
                  .title_left = 20.0,
                  .to_key = 66.0 + (chart_.x.slanted() ? kSlanted : 0.0),
                  .key_at = kLeft + 0.5 * kPlotWidth,
                  .key_side = "center",
                  .sample = 3},
                 chart_.title, chart_.subtitle, rows_);
    canvas_.axis('x', chart_.x, x_);
    canvas_.axis('y', chart_.y, y_, chart_.y_down);
    canvas_.put(
        "set grid lt 1 lw 1 lc rgb '#e3e3e3'\nset pointintervalbox 0.7\n");
    rounds();
    sketches();
    notes();
    plot();
    SceneCells scenes{.per_row = chart_.scenes_per_curve};
    for (const auto& [scene, at] : chart_.scenes) {
      scenes.cells.push_back(canvas_.cell(scene, at.x, at.y));
    }
    Figure figure = std::move(canvas_).figure(chart_.name, std::move(table_));
    figure.scenes = std::move(scenes);
    return figure;
  }

 private:
  /// From the sides, else from what is drawn, with a little room.
  void set_ranges() {
    const auto include = [&](const std::vector<Datum>& points) {
      for (const Datum& p : points) {
        if (!std::isfinite(p.x) || !std::isfinite(p.y)) continue;
        x_.include(p.x);
        y_.include(p.y);
      }
    };
    for (const Area& area : chart_.areas) include(area.outline);
    for (const Curve& curve : chart_.curves) include(curve.points);
    for (const Round& round : chart_.rounds) {
      const auto [x, y] = round.centre;
      const double r = round.radius;
      include({{x - r, y - r}, {x + r, y + r}});
    }
    const auto settle = [](Extent& range, const Side& side) {
      constexpr double kRoom = 0.03;  // of the side
      if (!(range.low <= range.high)) range = {0.0, 1.0};
      const bool logarithmic = side.scale == Scale::Logarithmic;
      const double span =
          logarithmic ? std::log(range.high / range.low) : range.width();
      const double room =
          kRoom * (span > 0.0 ? span : std::max(1.0, std::abs(range.low)));
      range.low = side.low.value_or(logarithmic ? range.low * std::exp(-room)
                                                : range.low - room);
      range.high = side.high.value_or(logarithmic ? range.high * std::exp(room)
                                                  : range.high + room);
    };
    settle(x_, chart_.x);
    settle(y_, chart_.y);
    if (!equal_) return;
    // A range is widened about its middle rather than a scale changed.
    const auto widen = [](Extent& range, double span) {
      const double more = 0.5 * (span - range.width());
      range = {range.low - more, range.high + more};
    };
    const double ratio = y_.width() / x_.width();
    plot_height_ = std::clamp(kPlotWidth * ratio, kLeast, kLargest);
    if (kPlotWidth * ratio < kLeast) {
      widen(y_, x_.width() * kLeast / kPlotWidth);
    } else if (kPlotWidth * ratio > kLargest) {
      widen(x_, y_.width() * kPlotWidth / kLargest);
    }
  }

  /// Rows of the key.
  void count_names() {
    std::size_t longest = 0;
    int names = 0;
    const auto count = [&](const std::string& name) {
      if (name.empty()) return;
      longest = std::max(longest, letters(plain_words(name)));
      ++names;
    };
    for (const Curve& curve : chart_.curves) count(curve.name);
    for (const Area& area : chart_.areas) count(area.name);
    // One thing alone needs no name.
    if (names == 0 || chart_.curves.size() + chart_.areas.size() < 2) return;
    constexpr double kSample = 80.0, kSize = 13.0;  // [px]
    const int columns = std::clamp(
        static_cast<int>(kWidth / (kSample + width_of(longest, kSize))), 1,
        names);
    rows_ = (names + columns - 1) / columns;
  }

  void rounds() {
    for (const Round& round : chart_.rounds) {
      const Datum& c = round.centre;
      canvas_.put(
          "set object ellipse center {:.12g},{:.12g} size {:.12g},{:.12g} "
          "units xy fc rgb '#bbbbbb' fs transparent solid 0.3 "
          "border lc rgb '#777777'\n",
          c.x, c.y, 2.0 * round.radius, 2.0 * round.radius);
      if (!round.mass_centre) continue;
      canvas_.put(
          "set arrow from {:.12g},{:.12g} to {:.12g},{:.12g} nohead "
          "lc rgb '#1f5fa8'\n",
          c.x, c.y, round.mass_centre->x, round.mass_centre->y);
      canvas_.put(
          "set label '' at {:.12g},{:.12g} point pt 7 ps 0.8 "
          "lc rgb '#1f5fa8'\n",
          round.mass_centre->x, round.mass_centre->y);
    }
  }

  void sketches() {
    // Of one pixel, in units of the axes, which are linear.
    const double x_unit = x_.width() / kPlotWidth;
    const double y_unit =
        y_.width() / plot_height_ * (chart_.y_down ? 1.0 : -1.0);
    const auto circle = [&](Datum at, double radius, std::string_view style) {
      canvas_.put(
          "set object circle at {:.12g},{:.12g} size screen {:.5f} front {}\n",
          at.x, at.y, radius / kWidth, style);
    };
    for (const Sketch& sketch : chart_.sketches) {
      if (!shows(sketch.at)) continue;
      const double r = sketch.radius;
      circle(sketch.at, r,
             "fc rgb '#ffffff' fs solid border lc rgb '#333333' lw 1.2");
      for (const double ring : sketch.rings) {
        circle(sketch.at, ring * r, "fs empty border lc rgb '#777777' lw 3");
      }
      circle(sketch.at, 1.2, "fc rgb '#333333' fs solid noborder");
      for (const Datum& mass : sketch.masses) {
        circle({sketch.at.x + r * mass.x * x_unit,
                sketch.at.y + r * mass.y * y_unit},
               std::max(2.4, 0.15 * r), "fc rgb '#222222' fs solid noborder");
      }
      if (sketch.name.empty()) continue;
      constexpr double kGap = 7.0, kSize = 13.0;
      const double width = width_of(letters(plain_words(sketch.name)), kSize);
      const bool ends = sketch.at.x + (r + kGap + width) * x_unit > x_.high;
      canvas_.put("set label {} at {:.12g},{:.12g} {} front\n",
                  quoted_words(sketch.name),
                  sketch.at.x + (ends ? -1.0 : 1.0) * (r + kGap) * x_unit,
                  sketch.at.y, ends ? "right" : "left");
    }
  }

  void notes() {
    constexpr double kHalfHeight = 4.5;  // gnuplot centres upon the height
    for (const Note& note :
         chart_.notes_apart ? apart(chart_.notes, pixels()) : chart_.notes) {
      if (!shows(note.at)) continue;
      canvas_.put(
          "set label {} at {:.12g},{:.12g} {} offset screen {:.5f}, "
          "screen {:.5f} front",
          quoted_words(note.text), note.at.x, note.at.y,
          note.dx < 0.0 ? "right" : "left", note.dx / kWidth,
          (kHalfHeight - note.dy) / canvas_.height);
      if (note.mark != Mark::None) {
        canvas_.put(" point pt {} ps 0.8 lc rgb '#000000'",
                    kPointTypes[note.mark]);
      }
      canvas_.put("\n");
    }
  }

  [[nodiscard]] PlotPixels pixels() const {
    const auto axis = [](const Side& side, const Extent& range, double length) {
      return PixelScale{range.low, range.high, 0.0, length,
                        side.scale == Scale::Logarithmic};
    };
    PlotPixels out{axis(chart_.x, x_, kPlotWidth),
                   axis(chart_.y, y_, plot_height_)};
    if (!chart_.y_down) std::swap(out.y.from, out.y.to);
    return out;
  }

  void plot() {
    const auto add = [&](const std::string& item, const std::string& name) {
      canvas_.layer(item, rows_ == 0 ? "" : name);
    };
    for (const Area& area : chart_.areas) {
      add(part(plain_words(area.name), area.outline) +
              fmt::format(" with filledcurves closed fc rgb '{}' fs solid "
                          "noborder",
                          area.fill),
          area.name);
    }
    for (auto curve = chart_.curves.begin(); curve != chart_.curves.end();
         ++curve) {
      const bool line = curve->width > 0.0;
      const bool marked = curve->mark != Mark::None;
      std::string style = fmt::format(
          " with {} lc rgb '{}'",
          line ? (marked ? "linespoints" : "lines") : "points", curve->colour);
      if (line) {
        style += fmt::format(" lw {:.3g} dt {}", curve->width,
                             kDashes[curve->stroke]);
      }
      if (marked) {
        // No line within open marks.
        const bool open =
            curve->mark == Mark::Circle || curve->mark == Mark::Diamond;
        style += fmt::format(" pt {} ps {:g}{}", kPointTypes[curve->mark],
                             curve->mark_size, open && line ? " pi -1" : "");
      }
      const bool known = std::any_of(
          chart_.curves.begin(), curve,
          [&](const Curve& before) { return look_the_same(before, *curve); });
      add(part(curve->id.empty() ? plain_words(curve->name) : curve->id,
               curve->points) +
              style,
          known ? "" : curve->name);
    }
    canvas_.plot();
  }

  /// Adds the points to the table. \return the expression that picks them
  std::string part(std::string name, const std::vector<Datum>& points) {
    // Without what would have to be quoted, and each another one.
    std::erase_if(name, [](char c) {
      return c == ',' || c == '"' || c == '\'' || c == '\\' ||
             static_cast<unsigned char>(c) < ' ';
    });
    if (name.empty()) name = "curve";
    std::string id = name;
    for (int i = 2; !parts_.insert(id).second; ++i) {
      id = fmt::format("{} ({})", name, i);
    }
    const std::string field = csv_field(id);
    for (const Datum& p : points) {
      fmt::format_to(std::back_inserter(table_), "{},{:.12g},{:.12g}\n", field,
                     p.x, p.y);
    }
    return fmt::format("data using (part('{}', 'x')):(column('y'))",
                       field.starts_with('\'') ? "'" + field : field);
  }

  [[nodiscard]] bool shows(const Datum& at) const {
    return at.x >= x_.low && at.x <= x_.high && at.y >= y_.low &&
           at.y <= y_.high;
  }

  const Chart& chart_;
  bool equal_ = false;
  Extent x_, y_;
  double plot_height_ = kHeight;
  int rows_ = 0;  ///< of the key
  std::set<std::string> parts_{"part"};
  Canvas canvas_;
  std::string table_ = "part,x,y\n";
};

}  // namespace

Stroke stroke_of(std::size_t n) {
  constexpr Stroke kStrokes[] = {Stroke::Solid, Stroke::Dashed,
                                 Stroke::DashDotted, Stroke::Dotted};
  return kStrokes[n % std::size(kStrokes)];
}

Figure chart_figure(const Chart& chart) {
  return Drawing(chart).figure();
}

}  // namespace brachisto::report
