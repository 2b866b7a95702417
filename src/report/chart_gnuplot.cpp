// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <algorithm>
#include <string_view>

#include "report/chart.hpp"
#include "report/chart_key.hpp"
#include "report/chart_style.hpp"
#include "report/rich_text.hpp"

namespace brachisto::report {

namespace {

constexpr double kPixelsPerInch = 96.0;
/// pdfcairo sets letters in two thirds of their size, draws linewidth 1
/// half a point wide, and a dash of length 1 as 0.275 of the width of the line
/// (measured with gnuplot 5.4).
constexpr double kFontSize = 13.0 * 0.75 * 1.5;
constexpr double kLineWidthPerPixel = 0.75 / 0.5;
constexpr double kDashLength = 1.0 / 0.275;

/// Within single quotes.
std::string quoted(std::string_view text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'') out += '\'';
    out += c == '\n' ? ' ' : c;
  }
  return out + "'";
}

std::string quoted_words(std::string_view source) {
  return "'" + gnuplot_words(source) + "'";
}

/// Number of a mark in the terminals of Cairo.
int point_type(Mark mark) {
  switch (mark) {
    case Mark::None:
      break;
    case Mark::Disc:
      return 7;
    case Mark::Circle:
      return 6;
    case Mark::Square:
      return 5;
    case Mark::Triangle:
      return 9;
    case Mark::Diamond:
      return 12;
    case Mark::Cross:
      return 2;
  }
  return 0;
}

/// A script being written: the layout is that of the SVG document, pixel by
/// pixel, so that both show the same.
class Script {
 public:
  explicit Script(const Chart& chart)
      : chart_(chart),
        layout_(chart_layout(chart)),
        foot_(chart_foot(chart, layout_)),
        ids_(chart_ids(chart)) {}

  void page();
  void side(char name, const Side& side, const ChartSide& laid, bool reversed);
  void key();
  void rounds();
  void sketches();
  void notes();
  void plot();
  [[nodiscard]] const std::string& text() const { return out_; }

 private:
  template <class... Args>
  void put(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(out_), format,
                   std::forward<Args>(args)...);
  }
  /// A place of the SVG document on the page.
  [[nodiscard]] std::string screen(Pixel p) const {
    return fmt::format("screen {:.5f}, screen {:.5f}", p.x / kChartWidth,
                       1.0 - p.y / foot_.bottom);
  }
  /// Rows of the file with that identifier, and how they are drawn.
  void rows(const std::string& id, std::string_view style,
            std::string_view name);
  void words(Pixel at, std::string_view source, bool ends);

  const Chart& chart_;
  ChartLayout layout_;
  ChartFoot foot_;
  ChartIds ids_;
  std::string out_;
  bool first_ = true;
};

void Script::page() {
  const PlotArea& area = layout_.area;
  put("# gnuplot {0}.gp draws {0}.csv as {0}.pdf\n", chart_.name);
  put("set encoding utf8\n");
  put("set terminal pdfcairo enhanced color size {:.4f}in,{:.4f}in \\\n"
      "  font 'Sans,{:.4g}' dashlength {:.4g}\n",
      kChartWidth / kPixelsPerInch, foot_.bottom / kPixelsPerInch, kFontSize,
      kDashLength);
  put("set output {}\n", quoted(chart_.name + ".pdf"));
  put("set pointintervalbox 0.7\nset datafile separator comma\nset datafile "
      "commentschars ''\n");
  put("set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n",
      area.left / kChartWidth, area.right / kChartWidth);
  put("set tmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n",
      1.0 - area.top / foot_.bottom, 1.0 - area.bottom / foot_.bottom);
  put("set border 15 lw 1.5 lc rgb '#333333'\n");
  put("set grid xtics ytics mxtics mytics lt 1 lw 1.5 lc rgb '#e3e3e3', "
      "lt 1 lw 1.5 lc rgb '#f2f2f2'\n");
  if (scales_are_equal(chart_)) put("set size ratio -1\n");
}

void Script::side(char name, const Side& side, const ChartSide& laid,
                  bool reversed) {
  put("set {}label {} font ',{:.4g}'{}\n", name, quoted_words(side.label),
      14.0 / 13.0 * kFontSize, name == 'x' ? " offset 0,0.6" : "");
  if (side.scale == Scale::Logarithmic) put("set logscale {}\n", name);
  put("set {}range [{:.12g}:{:.12g}] noextend\n", name,
      reversed ? laid.high : laid.low, reversed ? laid.low : laid.high);
  put("set {}tics out nomirror{} (", name, name == 'x' ? " offset 0,0.3" : "");
  std::string_view before = "";
  for (const Tick& tick : laid.ticks) {
    put("{}{} {:.12g}{}", before, quoted_words(tick.words), tick.value,
        tick.words.empty() ? " 1" : "");
    before = ", ";
  }
  put(")\n");
}

void Script::key() {
  if (foot_.key.rows() == 0) return put("set key off\n");
  put("set key at {} left top Left reverse vertical maxrows {} "
      "samplen 3 spacing 1.3\n",
      screen(foot_.corner), foot_.key.rows());
}

void Script::rounds() {
  for (const Round& round : chart_.rounds) {
    const Datum& c = round.centre;
    put("set object ellipse center {:.12g},{:.12g} size {:.12g},{:.12g} "
        "units xy fc rgb '#cccccc' fs transparent solid 0.35 "
        "border lc rgb '#444444' lw 1.5\n",
        c.x, c.y, 2.0 * round.radius, 2.0 * round.radius);
    put("set label '' at {:.12g},{:.12g} point pt 7 ps 0.25 "
        "lc rgb '#444444'\n",
        c.x, c.y);
    if (!round.mass_centre) continue;
    put("set arrow from {:.12g},{:.12g} to {:.12g},{:.12g} nohead lw 1.2 "
        "lc rgb '#444444'\n",
        c.x, c.y, round.mass_centre->x, round.mass_centre->y);
    put("set label '' at {:.12g},{:.12g} point pt 7 ps 0.5 "
        "lc rgb '#222222'\n",
        round.mass_centre->x, round.mass_centre->y);
  }
}

void Script::words(Pixel at, std::string_view source, bool ends) {
  constexpr double kHalfHeight = 4.5;  // gnuplot centres upon the height
  put("set label {} at {} {} front\n", quoted_words(source),
      screen({at.x, at.y - kHalfHeight}), ends ? "right" : "left");
}

void Script::sketches() {
  const auto circle = [&](Pixel at, double radius, std::string_view style) {
    put("set object circle at {} size screen {:.5f} front {}\n", screen(at),
        radius / kChartWidth, style);
  };
  for (const Sketch& sketch : chart_.sketches) {
    if (!layout_.shows(sketch.at)) continue;
    const Pixel at = layout_.at(sketch.at);
    const double r = sketch.radius;
    circle(at, r, "fc rgb '#ffffff' fs solid border lc rgb '#333333' lw 1.8");
    for (const double ring : sketch.rings) {
      circle(at, ring * r, "fs empty border lc rgb '#777777' lw 4.5");
    }
    circle(at, 1.2, "fc rgb '#333333' fs solid noborder");
    for (const Datum& mass : sketch.masses) {
      circle({at.x + r * mass.x, at.y + r * mass.y}, mass_radius(sketch),
             "fc rgb '#222222' fs solid noborder");
    }
    if (!sketch.name.empty()) {
      const WordsPlace place = beside(sketch, at, layout_.area.right);
      words(place.at, sketch.name, place.ends);
    }
  }
}

void Script::notes() {
  for (const Note& note : chart_.notes) {
    if (!layout_.shows(note.at)) continue;
    const Pixel at = layout_.at(note.at);
    if (note.mark != Mark::None) {
      put("set label '' at {} point pt {} ps 0.9 lc rgb '#000000' front\n",
          screen(at), point_type(note.mark));
    }
    if (!note.text.empty()) {
      words({at.x + note.dx, at.y + note.dy}, note.text, note.dx < 0.0);
    }
  }
}

void Script::rows(const std::string& id, std::string_view style,
                  std::string_view name) {
  put("{} \\\n  data skip 1 using (strcol(1) eq {} ? $2 : NaN):3 {} {}",
      first_ ? "plot" : ",", quoted(id), style,
      name.empty() ? "notitle" : "title " + quoted_words(name));
  first_ = false;
}

void Script::plot() {
  const std::vector<KeyEntry> entries = key_entries(chart_);
  const auto name_of = [&](const void* item) -> std::string_view {
    for (const KeyEntry& entry : entries) {
      if (entry.curve == item || entry.area == item) return entry.name;
    }
    return {};
  };
  put("data = {}\n", quoted(chart_.name + ".csv"));
  for (std::size_t i = 0; i < chart_.areas.size(); ++i) {
    const Area& area = chart_.areas[i];
    rows(ids_.areas[i],
         fmt::format("with filledcurves closed fc rgb {} fs solid noborder",
                     quoted(area.fill)),
         name_of(&area));
  }
  for (std::size_t i = 0; i < chart_.curves.size(); ++i) {
    const Curve& curve = chart_.curves[i];
    std::string style;
    if (curve.width > 0.0) {
      std::string pattern;
      for (const double part : dashes(curve.stroke)) {
        pattern += fmt::format("{}{:.3g}", pattern.empty() ? "" : ",", part);
      }
      style = fmt::format("lw {:.3g} dt {}", kLineWidthPerPixel * curve.width,
                          pattern.empty() ? "solid" : "(" + pattern + ")");
    }
    const bool marked = curve.mark != Mark::None;
    if (marked) {
      // No line within open marks.
      const bool open =
          curve.mark == Mark::Circle || curve.mark == Mark::Diamond;
      style += fmt::format(" pt {} ps 0.9{}", point_type(curve.mark),
                           open && curve.width > 0.0 ? " pi -1" : "");
    }
    const std::string_view kind = curve.width > 0.0
                                      ? (marked ? "linespoints" : "lines")
                                      : (marked ? "points" : "dots");
    rows(ids_.curves[i],
         fmt::format("with {} lc rgb {} {}", kind, quoted(curve.colour), style),
         name_of(&curve));
  }
  // A frame without curves is drawn for an empty function.
  if (first_) put("plot NaN notitle");
  put("\n");
}

}  // namespace

std::string chart_gnuplot(const Chart& chart) {
  Script script(chart);
  const ChartLayout layout = chart_layout(chart);
  script.page();
  script.side('x', chart.x, layout.x, false);
  script.side('y', chart.y, layout.y, chart.y_down);
  script.key();
  script.rounds();
  script.sketches();
  script.notes();
  script.plot();
  return script.text();
}

}  // namespace brachisto::report
