// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "report/canvas.hpp"
#include "report/key_label.hpp"
#include "report/rich_text.hpp"
#include "report/sweep_plots.hpp"

namespace brachisto::report {

namespace {

using State = SweepOutcome::State;

constexpr Layout kLayout{.left = 80.0,
                         .right = 140.0,
                         .height = 390.0,
                         .above = 20.0,
                         .title_left = 21.6,
                         .to_key = 82.0,
                         .key_at = 65.6,
                         .key_side = "left",
                         .sample = 2};

/// A picture of scenes over two columns being put together. In its commands
/// `at(s)` is the place to the right of a scene in state s, else NaN.
class MapPicture {
 public:
  Canvas canvas;

  MapPicture(const SweepTable& table, const SweepMap& map, std::string what)
      : table_(table), map_(map), digest_(digest(table, map.scenes)) {
    x_ = map.first;
    y_ = map.second;
    const auto rank = [&](std::size_t column) {
      return key_label(table.columns[column].key).rank;
    };
    if (rank(y_) < rank(x_)) std::swap(x_, y_);
    // Some viewers drop a plain space behind a subscript.
    title_ = fmt::format("{} over {}\u00A0and {}", what, label(x_, false),
                         label(y_, false));
    for (std::size_t i = 0; i < map.scenes.size(); ++i) {
      // An empty line ends a row of the grid, as gnuplot wants it.
      if (i > 0 && map.n_second > 0 && i % map.n_second == 0) rows_ += '\n';
      add_row(map.scenes[i]);
    }
    canvas.put(
        "right = '{}'\nup = '{}'\n"
        "at(state) = strcol('state') eq state ? column(right) : NaN\n"
        "set tics front\n",
        column_name(x_), column_name(y_));
  }

  [[nodiscard]] const SweepDigest& found() const { return digest_; }

  /// One layer of the plot.
  void layer(std::string_view item, const std::string& name = {}) {
    canvas.layer(item, name);
    if (!name.empty()) ++names_;
  }

  /// What scenes that are not verified look like.
  void others(std::string_view style) {
    const auto layer_of = [&](std::string_view state, std::string_view mark,
                              std::string_view what, std::size_t count) {
      if (count == 0) return;
      layer(fmt::format("data using (at('{}')):(column(up)):(middle) with "
                        "points {} ps 0.9 lw 1.4{}",
                        state, mark, style),
            fmt::format("{} ({})", what, count));
    };
    layer_of(name(State::Failed), "pt 2 lc rgb '#000000'", "no verified result",
             digest_.failed);
    layer_of(name(State::Missing), "pt 6 lc rgb '#777777'", "not run yet",
             digest_.missing);
  }

  /// Lines from dot to dot, white where they start.
  void ways(std::string_view style) {
    const auto shown = [&](std::size_t column, double value) {
      return shown_number({table_.columns[column].key, {value}, {}}, 0);
    };
    for (std::size_t i = 0; i < map_.ways.size(); ++i) {
      if (map_.ways[i].empty()) continue;
      canvas.put("$way{} << END\n", i);
      for (const auto& [first, second] : map_.ways[i]) {
        double x = shown(map_.first, first), y = shown(map_.second, second);
        if (x_ != map_.first) std::swap(x, y);
        canvas.put("{:.12g},{:.12g}\n", x, y);
      }
      canvas.put("END\n");
      layer(
          fmt::format("$way{} using 1:2:(middle) with linespoints pt 7 ps 0.5 "
                      "lw 1.4 lc rgb '#d62728'{}",
                      i, style),
          i == 0 ? "ways of the searches" : "");
      layer(
          fmt::format("$way{} every ::0::0 using 1:2:(middle) with points pt "
                      "7 ps 0.9 lc rgb '#ffffff'{}",
                      i, style));
    }
  }

  void minima(std::string_view style) {
    for (const MarkedScene& marked : marked_scenes(table_, map_.scenes)) {
      const double x = shown_number(table_.columns[x_], marked.scene);
      const double y = shown_number(table_.columns[y_], marked.scene);
      if (!std::isfinite(x) || !std::isfinite(y)) continue;
      const char* block = marked.feasible ? "$minimum" : "$infeasible";
      canvas.put("{} << END\n{:.12g},{:.12g}\nEND\n", block, x, y);
      // Black within white is seen on every colour.
      layer(
          fmt::format("{} using 1:2:(middle) with points pt 7 ps 2 "
                      "lc rgb '#ffffff'{}",
                      block, style));
      layer(fmt::format("{} using 1:2:(middle) with points pt {} ps 1.4 lw 2 "
                        "lc rgb '#000000'{}",
                        block, marked.feasible ? 7 : 6, style),
            marked.name);
    }
  }

  /// \param plot  "plot", "splot"
  [[nodiscard]] Figure figure(std::string_view plot, Extent range,
                              bool colour_bar) {
    canvas.open(kLayout, title_, what_is_fixed(table_, map_.scenes), names_);
    side('x', x_, xs_);
    side('y', y_, ys_);
    canvas.put(
        "middle = {:.12g}\nset cbrange [{:.12g}:{:.12g}]\nset cblabel '{}'\n{}",
        0.5 * (range.low + range.high), range.low, range.high, kTauLabel,
        colour_bar ? "" : "unset colorbox\n");
    // A frame of nothing is drawn for what lies outside of it.
    canvas.plot(plot, "data using (NaN):(NaN):(middle) with points");
    SceneCells scenes{.per_row = map_.n_second, .meet = map_.n_second > 0};
    for (const std::size_t scene : map_.scenes) {
      scenes.cells.push_back(
          canvas.cell(scene, shown_number(table_.columns[x_], scene),
                      shown_number(table_.columns[y_], scene)));
    }
    Figure figure = std::move(canvas).figure(
        map_.name, fmt::format("{},{},tau,state,feasible\n", column_name(x_),
                               column_name(y_)) +
                       rows_);
    figure.scenes = std::move(scenes);
    return figure;
  }

 private:
  /// "θm [°]", without what would have to be quoted in a table or a script.
  [[nodiscard]] std::string column_name(std::size_t column) const {
    const KeyLabel label = key_label(table_.columns[column].key);
    std::string name = plain_words(label.text(Markup::Rich, false));
    std::erase_if(name, [](char c) {
      return std::string_view(",\"'\\").find(c) != std::string_view::npos;
    });
    return label.unit.empty() ? name : fmt::format("{} [{}]", name, label.unit);
  }
  [[nodiscard]] std::string label(std::size_t column, bool with_unit) const {
    constexpr std::size_t kLetters = 40;
    const KeyLabel label =
        key_label(table_.columns[column].key).within(kLetters);
    return with_unit ? label.in_full(Markup::Rich, true)
                     : label.text(Markup::Rich, false);
  }

  void add_row(std::size_t scene) {
    const SweepOutcome& outcome = table_.outcomes[scene];
    const double x = shown_number(table_.columns[x_], scene);
    const double y = shown_number(table_.columns[y_], scene);
    xs_.include(x);
    ys_.include(y);
    fmt::format_to(std::back_inserter(rows_), "{:.12g},{:.12g},{:.12g},{},{}\n",
                   x, y, outcome.tau, name(outcome.state),
                   outcome.state == State::Verified
                       ? (outcome.feasible ? "1" : "0")
                       : "nan");
  }

  void side(char axis, std::size_t column, Extent range) {
    Side side;
    side.label = label(column, true);
    side.scale = scale_of(table_.columns[column], map_.scenes);
    if (!(range.high > range.low)) {
      const double middle = std::isfinite(range.low) ? range.low : 0.0;
      range = {middle - 0.5, middle + 0.5};
    } else if (map_.n_second == 0 && side.scale != Scale::Logarithmic) {
      // Dots are not cut by the frame.
      const double room = 0.02 * range.width();
      range = {range.low - room, range.high + room};
    }
    canvas.axis(axis, side, range);
  }

  const SweepTable& table_;
  const SweepMap& map_;
  SweepDigest digest_;
  std::size_t x_ = 0, y_ = 0;
  Extent xs_, ys_;
  std::string title_, rows_;
  int names_ = 0;
};

/// The grid as a surface seen from above, z from z(…) of gnuplot.
constexpr std::string_view kView =
    "set view map\nset style textbox opaque margins 0.6,0.4 fc rgb '#ffffff' "
    "noborder\n";

/// A coarse grid is drawn finer, linear between its scenes.
std::string interpolation(const SweepMap& map) {
  constexpr double kFine = 2500.0;  // quadrilaterals
  const auto cells =
      static_cast<double>((map.n_first - 1) * (map.n_second - 1));
  const int parts = std::max(1, static_cast<int>(std::sqrt(kFine / cells)));
  return fmt::format("set pm3d interpolate {0},{0}\n", parts);
}

/// A line around what is infeasible, at half between scenes. gnuplot writes
/// contours without commas.
void edge(MapPicture& picture) {
  const SweepDigest& found = picture.found();
  if (found.infeasible == 0 || found.infeasible == found.verified) return;
  picture.canvas.put(
      "set contour base\nset cntrparam levels discrete 0.5\nunset surface\n"
      "set table $edge\n"
      "splot data using (column(right)):(column(up)):(column('feasible'))\n"
      "unset table\nset surface\nunset contour\n"
      "edge(n) = real(word(strcol(1), n))\n");
  const auto line = [&](std::string_view look, const std::string& name) {
    picture.layer(fmt::format("$edge using (edge(1)):(edge(2)):(middle) with "
                              "lines {} nocontour",
                              look),
                  name);
  };
  line("lw 4 lc rgb '#ffffff'", "");
  line("lw 1.8 lc rgb '#000000'",
       fmt::format("edge of infeasible scenes ({})", found.infeasible));
}

}  // namespace

Figure map_figure(const SweepTable& table, const SweepMap& map, Extent range) {
  constexpr std::string_view kTau =
      "data using (column(right)):(column(up)):(column('tau'))";
  MapPicture picture(table, map, "τ");
  picture.canvas.put("{}{}set palette defined ({})\n", kView,
                     interpolation(map), palette());
  const bool any = picture.found().verified > 0;
  if (any) {
    picture.layer(fmt::format("{} with pm3d nocontour", kTau));
    picture.layer(
        fmt::format("{} with lines lw 0.9 lc rgb '#ffffff' nosurface", kTau));
    picture.layer(
        fmt::format("{} with labels boxed font ',10' nosurface", kTau));
  }
  edge(picture);
  if (any) {
    picture.canvas.put(
        "set zrange [{:.12g}:{:.12g}]\nset contour base\n"
        "set cntrparam levels auto 10\n"
        "set cntrlabel onecolor start 5 interval {} format '%.6g'\n",
        range.low, range.high,
        std::max<std::size_t>(20, map.n_first + map.n_second));
  }
  picture.others(" nocontour");
  picture.ways(" nocontour");
  picture.minima(" nocontour");
  return picture.figure("splot", range, any);
}

Figure feasibility_figure(const SweepTable& table, const SweepMap& map) {
  MapPicture picture(table, map, "Feasibility");
  const SweepDigest& found = picture.found();
  picture.canvas.put(
      "{}{}set palette defined (0 '#68788a', 1 '#e3e8ee') maxcolors 2\n", kView,
      interpolation(map));
  picture.layer(
      "data using (column(right)):(column(up)):(column('feasible')) "
      "with pm3d nocontour");
  const auto grey = [&](std::string_view colour, std::string_view what,
                        std::size_t count) {
    picture.layer(fmt::format("data using (NaN):(NaN):(middle) with points "
                              "pt 5 ps 2 lc rgb '{}' nocontour",
                              colour),
                  fmt::format("{} ({})", what, count));
  };
  grey("#e3e8ee", "feasible", found.verified - found.infeasible);
  grey("#68788a", "infeasible: the body could not follow the track",
       found.infeasible);
  edge(picture);
  picture.others(" nocontour");
  return picture.figure("splot", {0.0, 1.0}, false);
}

Figure scatter_figure(const SweepTable& table, const SweepMap& sample,
                      Extent range) {
  MapPicture picture(table, sample, "τ");
  picture.canvas.put("set palette defined ({})\n", palette());
  const bool any = picture.found().verified > 0;
  if (any) {
    picture.layer(
        "data using (at('verified')):(column(up)):(column('tau')) with points "
        "pt 7 ps 0.9 palette");
  }
  if (picture.found().infeasible > 0) {
    picture.layer(
        "data using (column('feasible') == 0 ? column(right) : NaN)"
        ":(column(up)) with points pt 6 ps 1.2 lc rgb '#000000'",
        fmt::format("infeasible ({})", picture.found().infeasible));
  }
  picture.others("");
  picture.minima("");
  return picture.figure("plot", range, any);
}

}  // namespace brachisto::report
