// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "plot/motion_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <string_view>

#include "report/page.hpp"
#include "report/path_frame.hpp"

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

std::string number(double value) {
  return std::isfinite(value) ? fmt::format("{:.7g}", value) : "null";
}
std::string number(const std::optional<double>& value) {
  return value ? number(*value) : "null";
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
  return array(values, [](double value) { return number(value); });
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
  for (const Json& limit : result.value("limits", Json::array())) {
    for (const Json& arc : limit.value("active", Json::array())) {
      const Json time = arc.value("t", Json::object());
      const auto end = [&](const char* key) {
        const Json there = time.value(key, Json());
        return there.is_number() ? there.get<double>() : std::nan("");
      };
      const double from = end("from"), to = end("to");
      if (!(from < to)) continue;
      if (out.size() > 1) out += ',';
      out += fmt::format("{{\"name\":{},\"from\":{},\"to\":{}}}",
                         quoted(limit.value("name", "")), number(from),
                         number(to));
    }
  }
  return out + "]";
}

}  // namespace

Box motion_box(const TrajectoryTable& table, const Body& body) {
  const std::vector<double>&x = table["x_c"], &z = table["z_c"];
  Box box{{x[0], z[0]}, {x[0], z[0]}};
  for (std::size_t i = 0; i < table.size(); ++i) {
    box.include({x[i], z[i]}, body.radius);
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
      "{{\"body\":{{\"rolls\":{},\"radius\":{},\"eta\":{},\"k\":{}}},\n",
      body.rolls(), number(body.radius), number(body.eta_m), number(body.k));
  // Where the energy is no sum that stays.
  const bool conserved = !scene.world.changes_rates();
  out += fmt::format(
      "\"gravity\":{},\"weight\":{},\n\"bounds\":{{\"friction\":{},\"least\":{}"
      ","
      "\"greatest\":{}}},\n\"box\":[{},{}],\n",
      conserved ? number(scene.gravity) : "null", !scene.world.sphere,
      number(limits.friction), number(limits.normal_min),
      number(limits.normal_max), point(box.low), point(box.high));
  out += "\"obstacles\":" +
         array(report::obstacles(limits, box.low, box.high),
               [](const report::Outline& area) { return array(area, point); }) +
         ",\n\"arcs\":" + active_arcs(result) + ",\n\"ranges\":{";
  std::string_view before = "";
  for (const TableColumn& column : rows.columns()) {
    if (!is_drawn(column)) continue;
    const ShownRange range = shown_range(rows, column.values);
    out += fmt::format("{}{}:[{},{}]", before, quoted(column.name),
                       number(range.low), number(range.high));
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

}  // namespace brachisto::plot
