// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <algorithm>
#include <cctype>
#include <cmath>

#include "report/chart.hpp"
#include "report/chart_key.hpp"
#include "report/chart_layout.hpp"
#include "report/chart_lines.hpp"
#include "report/chart_style.hpp"
#include "report/rich_text.hpp"

namespace brachisto::report {

namespace {

/// Words that are read across a line of the drawing.
constexpr std::string_view kHalo =
    "font-size=\"13\" stroke=\"#ffffff\" stroke-width=\"3.5\" "
    "stroke-linejoin=\"round\" paint-order=\"stroke\"";

/// A chart being drawn, layer by layer.
class Drawing {
 public:
  explicit Drawing(const Chart& chart)
      : chart_(chart), layout_(chart_layout(chart)) {}

  void areas();
  void grid();
  void rounds();
  void lines();
  void marks();
  void sketches();
  void notes();
  void frame();
  [[nodiscard]] std::string document();

  /// What `draw` draws is seen within the frame only.
  template <class Draw>
  void clipped(Draw draw) {
    std::string id = "clip-" + chart_.name;
    std::replace_if(
        id.begin(), id.end(),
        [](unsigned char c) { return std::isalnum(c) == 0; }, '-');
    begin_clip(svg_, layout_.area, id);
    draw();
    end_clip(svg_);
  }

 private:
  void sketch(const Sketch& sketch);
  void words(Pixel at, std::string_view source, bool ends,
             std::string_view kind);

  const Chart& chart_;
  ChartLayout layout_;
  Svg svg_;
};

void Drawing::areas() {
  for (const Area& area : chart_.areas) {
    std::vector<Pixel> outline;
    for (const Datum& p : area.outline) {
      const Pixel q = layout_.at(p);
      if (std::isfinite(q.x) && std::isfinite(q.y)) outline.push_back(q);
    }
    svg_.polygon(outline, fmt::format("class=\"area\" fill=\"{}\"",
                                      xml_escaped(area.fill)));
  }
}

void Drawing::grid() {
  const PlotArea& area = layout_.area;
  // Seen on white and on areas alike.
  const auto style = [](const Tick& tick) {
    return fmt::format("stroke=\"#000000\" stroke-opacity=\"{}\"",
                       tick.words.empty() ? 0.05 : 0.11);
  };
  for (const Tick& tick : layout_.x.ticks) {
    const double x = layout_.x.axis(tick.value);
    svg_.line({x, area.top}, {x, area.bottom}, style(tick));
  }
  for (const Tick& tick : layout_.y.ticks) {
    const double y = layout_.y.axis(tick.value);
    svg_.line({area.left, y}, {area.right, y}, style(tick));
  }
}

void Drawing::rounds() {
  for (const Round& round : chart_.rounds) {
    const Pixel centre = layout_.at(round.centre);
    const Pixel reach = layout_.at(
        {round.centre.x + round.radius, round.centre.y + round.radius});
    svg_.put(
        "<ellipse class=\"round\" cx=\"{:.2f}\" cy=\"{:.2f}\" rx=\"{:.2f}\" "
        "ry=\"{:.2f}\" fill=\"#cccccc\" fill-opacity=\"0.35\" "
        "stroke=\"#444444\" stroke-width=\"1\"/>\n",
        centre.x, centre.y, std::abs(reach.x - centre.x),
        std::abs(reach.y - centre.y));
    if (round.mass_centre) {
      const Pixel mass = layout_.at(*round.mass_centre);
      svg_.line(centre, mass, "stroke=\"#444444\" stroke-width=\"0.8\"");
      svg_.circle(mass, 3.2, "fill=\"#222222\"");
    }
    svg_.circle(centre, 1.6, "fill=\"#444444\"");
  }
}

void Drawing::lines() {
  for (const Curve& curve : chart_.curves) {
    if (!(curve.width > 0.0)) continue;
    for (const std::vector<Pixel>& line :
         visible_lines(curve.points, layout_)) {
      svg_.polyline(line, "class=\"curve\" " + line_style(curve));
    }
  }
}

void Drawing::marks() {
  // On a line there is no need for more marks than can be told apart.
  constexpr double kNearest = 5.0;
  for (const Curve& curve : chart_.curves) {
    if (curve.mark == Mark::None) continue;
    Pixel last{-1e9, -1e9};
    for (const Datum& p : curve.points) {
      if (!layout_.shows(p)) continue;
      const Pixel at = layout_.at(p);
      if (curve.width > 0.0 &&
          std::hypot(at.x - last.x, at.y - last.y) < kNearest) {
        continue;
      }
      draw_mark(svg_, at, curve.mark, curve.colour);
      last = at;
    }
  }
}

void Drawing::words(Pixel at, std::string_view source, bool ends,
                    std::string_view kind) {
  svg_.text(at,
            fmt::format("class=\"{}\" {}{}", kind, kHalo,
                        ends ? " text-anchor=\"end\"" : ""),
            svg_words(source));
}

void Drawing::sketch(const Sketch& sketch) {
  const Pixel centre = layout_.at(sketch.at);
  const double r = sketch.radius;
  svg_.circle(centre, r,
              "class=\"sketch\" fill=\"#ffffff\" stroke=\"#333333\" "
              "stroke-width=\"1.2\"");
  for (const double ring : sketch.rings) {
    svg_.circle(centre, ring * r,
                "fill=\"none\" stroke=\"#777777\" stroke-width=\"3\"");
  }
  svg_.circle(centre, 1.2, "fill=\"#333333\"");
  for (const Datum& mass : sketch.masses) {
    svg_.circle({centre.x + mass.x * r, centre.y + mass.y * r},
                mass_radius(sketch), "fill=\"#222222\"");
  }
  if (sketch.name.empty()) return;
  const WordsPlace place = beside(sketch, centre, layout_.area.right);
  words(place.at, sketch.name, place.ends, "sketch-name");
}

void Drawing::sketches() {
  for (const Sketch& each : chart_.sketches) {
    if (layout_.shows(each.at)) sketch(each);
  }
}

void Drawing::notes() {
  for (const Note& note : chart_.notes) {
    if (!layout_.shows(note.at)) continue;
    const Pixel at = layout_.at(note.at);
    draw_mark(svg_, at, note.mark, "#000000");
    if (note.text.empty()) continue;
    words({at.x + note.dx, at.y + note.dy}, note.text, note.dx < 0.0, "note");
  }
}

void Drawing::frame() {
  draw_frame(svg_, layout_.area);
  draw_x_axis(svg_, layout_.area, layout_.x.axis, layout_.x.ticks,
              svg_words(chart_.x.label));
  draw_y_axis(svg_, layout_.area, layout_.y.axis, layout_.y.ticks,
              svg_words(chart_.y.label), layout_.y_label_x);
}

std::string Drawing::document() {
  const ChartFoot foot = chart_foot(chart_, layout_);
  foot.key.draw(svg_, foot.corner);
  return svg_.document(kChartWidth, foot.bottom, chart_.title);
}

}  // namespace

std::string chart_svg(const Chart& chart) {
  Drawing drawing(chart);
  drawing.clipped([&] {
    drawing.areas();
    drawing.grid();
    drawing.rounds();
    drawing.lines();
  });
  drawing.frame();
  drawing.marks();
  drawing.sketches();
  drawing.notes();
  return drawing.document();
}

}  // namespace brachisto::report
