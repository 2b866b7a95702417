// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "plot/motion_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <utility>

#include "brachisto/math/clock.hpp"
#include "math/angle.hpp"
#include "plot/result_values.hpp"
#include "report/canvas.hpp"
#include "report/page.hpp"
#include "report/rich_text.hpp"
#include "report/scale.hpp"
#include "report/track_kind.hpp"

namespace brachisto::plot {

namespace {

using report::Box;
using report::Json;

/// What the page has of each row; the rest follows from it.
constexpr std::array<std::string_view, 9> kKept{
    "t", "x_c", "z_c", "theta", "beta", "v_c", "R_n", "R_t", "kappa_b"};
/// And of these curves are drawn.
constexpr std::array<std::string_view, 4> kDrawn{"v_c", "R_n", "R_t",
                                                 "kappa_b"};
constexpr std::string_view kSlack = "slack_";

bool is_kept(const TableColumn& column) {
  return std::ranges::find(kKept, column.name) != kKept.end() ||
         column.name.starts_with(kSlack);
}
bool is_drawn(const TableColumn& column) {
  return std::ranges::find(kDrawn, column.name) != kDrawn.end() ||
         column.name.starts_with(kSlack);
}

std::string digits(double value) {
  return std::isfinite(value) ? fmt::format("{:.7g}", value) : "null";
}
std::string digits(const std::optional<double>& value) {
  return value ? digits(*value) : "null";
}

template <class Items, class Text>
std::string array(const Items& items, Text text) {
  std::string out = "[";
  for (const auto& item : items) {
    if (out.size() > 1) out += ',';
    out += text(item);
  }
  return out + "]";
}

std::string numbers(const std::vector<double>& values) {
  return array(values, [](double value) { return digits(value); });
}

std::string quoted(const std::string& text) {
  return report::page_json(Json(text));
}

std::string point(Point p) {
  return fmt::format("[{:.7g},{:.7g}]", p.x, p.z);
}

/// Where limits hold, from the result.
std::string active_arcs(const Json& result) {
  std::string out = "[";
  for (const Json& limit : at(result, "limits")) {
    for (const Json& arc : at(limit, "active")) {
      const Json& time = at(arc, "t");
      const double from = number(time, "from");
      const double to = number(time, "to");
      if (!(from < to)) continue;
      if (out.size() > 1) out += ',';
      out +=
          fmt::format("{{\"name\":{},\"from\":{},\"to\":{}}}",
                      quoted(text_of(limit, "name")), digits(from), digits(to));
    }
  }
  return out + "]";
}

}  // namespace

Box motion_box(const TrajectoryTable& table, const Body& body) {
  const std::vector<double>&x = table["x_c"], &z = table["z_c"];
  Box box{{x[0], z[0]}, {x[0], z[0]}};
  for (std::size_t i = 0; i < table.size(); ++i) {
    box.include({x[i], z[i]}, body.outer_radius());
  }
  constexpr double kMargin = 0.06;  // of the larger side, on each side
  const double more = 2.0 * kMargin * std::max(box.width(), box.height());
  return box.resized(box.width() + more, box.height() + more);
}

ThinnedTable rows_for_page(const TrajectoryTable& table, const Scene& scene,
                           std::size_t most) {
  std::vector<ShownCurve> curves;
  std::size_t kept = 0;
  for (const TableColumn& column : table.columns()) {
    if (is_kept(column)) ++kept;
    if (!is_drawn(column)) continue;
    curves.push_back({column.name, shown_range(table, column.values)});
  }
  return thinned(table, scene.body, curves, most / kept);
}

std::string motion_data(const TrajectoryTable& rows, const Scene& scene,
                        const Json& result, const Box& box) {
  const Body& body = scene.body;
  const PathLimits& limits = scene.limits;
  std::string out = fmt::format(
      "{{\"body\":{{\"rolls\":{},\"radius\":{},\"eta\":{},\"k\":{}{}}},\n",
      body.rolls(), digits(body.radius), digits(body.eta_m), digits(body.k),
      body.ball ? ",\"walls\":" + digits(body.wall_ratio) : "");
  // Where the energy is no sum that stays.
  const bool conserved = !scene.world.changes_rates();
  out += fmt::format(
      "\"gravity\":{},\"weight\":{},\n\"bounds\":{{\"friction\":{},\"least\":{}"
      ","
      "\"greatest\":{}}},\n\"box\":[{},{}],\n",
      conserved ? digits(scene.gravity) : "null", !scene.world.field_varies(),
      digits(limits.friction), digits(limits.normal_min),
      digits(limits.normal_max), point(box.low), point(box.high));
  out += "\"obstacles\":" +
         array(report::obstacles(limits, box.low, box.high),
               [](const report::Outline& area) { return array(area, point); }) +
         ",\n\"arcs\":" + active_arcs(result) + ",\n\"ranges\":{";
  std::string_view before = "";
  for (const TableColumn& column : rows.columns()) {
    if (!is_drawn(column)) continue;
    const report::Extent range = shown_range(rows, column.values);
    out += fmt::format("{}{}:[{},{}]", before, quoted(column.name),
                       digits(range.low), digits(range.high));
    before = ",";
  }
  out += "},\n\"rows\":{";
  before = "";
  for (const TableColumn& column : rows.columns()) {
    if (!is_kept(column)) continue;
    out += fmt::format("{}\n{}:{}", before, quoted(column.name),
                       numbers(column.values));
    before = ",";
  }
  return out + "}}";
}

namespace {

constexpr int kFrames = 60;      // and the one at t = 0
constexpr int kLastFrames = 12;  // on which the body rests at B
constexpr int kDelay = 5;        // [1/100 s]
constexpr int kTrackPoints = 600;

}  // namespace

report::Figure moving_figure(const Scene& scene, const TrajectoryTable& table) {
  const Body& body = scene.body;
  const double T = table.time().back();
  std::string rows = "part,frame,t,x_b,z_b,x_c,z_c,x_cm,z_cm,theta\n";
  const auto add = [&](std::string_view part, int frame, double t) {
    check_stop();
    const Pose pose = table.pose(t);
    const Point b = pose.contact(body), m = pose.mass_centre(body);
    fmt::format_to(std::back_inserter(rows),
                   "{},{},{:.7g},{:.7g},{:.7g},{:.7g},{:.7g},{:.7g},{:.7g},"
                   "{:.7g}\n",
                   part, frame, t, b.x, b.z, pose.centre.x, pose.centre.z, m.x,
                   m.z, math::in_degrees(pose.theta));
  };
  for (int i = 0; i <= kTrackPoints; ++i) {
    add("track", 0, T * i / kTrackPoints);
  }
  for (int i = 0; i <= kFrames; ++i) add("body", i, T * i / kFrames);
  const report::Box box = motion_box(table, body);
  int areas = 0;
  for (const report::Outline& area :
       report::obstacles(scene.limits, box.low, box.high)) {
    ++areas;
    for (std::size_t i = 0; i <= area.size(); ++i) {
      const Point corner = area[i % area.size()];
      fmt::format_to(std::back_inserter(rows),
                     "obstacle {},0,,{:.7g},{:.7g},,,,,\n", areas, corner.x,
                     corner.z);
    }
  }

  constexpr double kWidth = 640.0, kLeft = 62.0, kRight = 14.0;
  constexpr double kTop = 44.0, kBottom = 44.0, kTallest = 640.0;
  const double scale = std::min((kWidth - kLeft - kRight) / box.width(),
                                kTallest / box.height());
  report::Canvas canvas;
  canvas.width = kLeft + scale * box.width() + kRight;
  canvas.height = kTop + scale * box.height() + kBottom;
  std::string kind = report::gnuplot_words(report::track_kind(scene));
  kind[0] = static_cast<char>(std::toupper(kind[0]));
  constexpr double kLasts = 0.01 * kDelay * kFrames;  // [s]
  const std::string pace =
      kLasts >= T
          ? fmt::format("{} times slower", report::printed(kLasts / T, 2))
          : fmt::format("{} times faster", report::printed(T / kLasts, 2));
  canvas.put(
      "set border 15 lw 1 lc rgb '#333333'\n"
      "set grid lt 1 lw 1 lc rgb '#e3e3e3'\n"
      "set tics out nomirror format '%g'\n"
      "set xlabel 'x [m]' offset 0,0.4\nset ylabel 'z [m], down' offset 1.5,0\n"
      "unset key\nset xrange [{:.9g}:{:.9g}]\nset yrange [{:.9g}:{:.9g}]\n",
      box.low.x, box.high.x, box.high.z, box.low.z);
  canvas.frame(kLeft, kTop, scale * box.width(), scale * box.height());
  canvas.put(
      "now(c) = strcol('part') eq 'body' && column('frame') == f ? column(c) "
      ": NaN\n"
      "do for [i=0:{}] {{\n"
      "  f = i < {} ? i : {}\n"
      "  set title sprintf('{}: t = %.4g s, {}', f * {:.9g})\n",
      kFrames + kLastFrames, kFrames, kFrames, kind, pace, T / kFrames);
  for (int i = 1; i <= areas; ++i) {
    canvas.layer(
        fmt::format("data using (part('obstacle {}', 'x_b')):(column('z_b')) "
                    "with filledcurves closed fc rgb '#d8d0c0'",
                    i));
  }
  canvas.layer(
      "data using (part('track', 'x_b')):(column('z_b')) with lines lw 2 lc "
      "rgb '#000000'");
  const auto body_layer = [&](std::string_view place, std::string_view style) {
    canvas.layer(fmt::format("data using (now('x_{0}')):(column('z_{0}')){1}",
                             place, style));
  };
  constexpr double kDot =
      3.0;  // [px]: bodies as small as this are drawn as one
  if (body.outer_radius() * scale < kDot) {
    body_layer("c", " with points pt 7 ps 1.2 lc rgb '#a80f0f'");
  } else {
    body_layer("c",
               fmt::format(":({:.9g}) with circles fc rgb '#d9d9d9' fs solid "
                           "border lc rgb '#333333'",
                           body.outer_radius()));
    // Two dark quadrants. On the picture angles grow the other way.
    for (const int from : {0, 180}) {
      body_layer("c", fmt::format(":({:.9g}):(-column('theta') - {}):"
                                  "(-column('theta') - {}) with circles fc rgb "
                                  "'#8c8c8c' fs solid noborder",
                                  0.97 * body.outer_radius(), from + 90, from));
    }
    if (body.off_centred()) {
      body_layer("cm", " with points pt 7 ps 1 lc rgb '#1f5fa8'");
    }
    body_layer("b", " with points pt 7 ps 0.7 lc rgb '#a80f0f'");
  }
  canvas.plot();
  canvas.put("}}\n");
  report::Figure figure = std::move(canvas).figure("motion", std::move(rows));
  figure.frame_delay = kDelay;
  figure.title = report::plain_words(report::in_words(scene));
  return figure;
}

}  // namespace brachisto::plot
