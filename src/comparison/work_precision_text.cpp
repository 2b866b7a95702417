// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <algorithm>

#include "brachisto/report/result.hpp"
#include "comparison/comparison.hpp"
#include "comparison/methods.hpp"
#include "comparison/work_precision.hpp"
#include "report/letters.hpp"
#include "report/text_table.hpp"

namespace brachisto::comparison {

using report::memory_text;
using report::or_dash;
using report::Rows;
using report::seconds_text;

namespace {

using Json = nlohmann::ordered_json;

std::string remark(const PrecisionPoint& point) {
  if (point.run.solved()) return "";
  constexpr std::size_t kLetters = 72;  // the document has it in full
  return report::shortened(
      fmt::format("{}: {}", name(point.run.outcome), point.run.cause),
      kLetters);
}

std::string order_text(const std::optional<ObservedOrder>& order) {
  if (!order) return "—";
  return order->uncertainty
             ? fmt::format("{:.2f} ± {:.2f}", order->order, *order->uncertainty)
             : fmt::format("{:.2f}", order->order);
}

Rows point_rows(const WorkPrecision& found) {
  Rows rows{{"method", "mesh or wanted", "unknowns", "CPU [s]",
             "least – greatest", "iterations", "memory", "error", "remark"}};
  for (const PrecisionLine& line : found.lines) {
    for (const PrecisionPoint& point : line.points) {
      const Measurement& run = point.run;
      std::vector<std::string> times{"—", "—"};
      if (!run.cpu.empty()) {
        const Spread spread = spread_of(run.cpu);
        times = {seconds_text(spread.median),
                 fmt::format("{} – {}", seconds_text(spread.least),
                             seconds_text(spread.greatest))};
      }
      rows.push_back(
          {label(line.method),
           text(point.fineness).empty() ? "—" : text(point.fineness),
           or_dash(run.unknowns), times[0], times[1], iterations_text(run),
           memory_text(run.peak_memory),
           point.error ? error_text(*point.error, found.reference) : "—",
           remark(point)});
    }
  }
  return rows;
}

Rows order_rows(const WorkPrecision& found) {
  Rows rows{{"method", "promised", "observed order", "finest two", "points"}};
  for (const PrecisionLine& line : found.lines) {
    if (!has_meshes(line.method)) continue;
    rows.push_back(
        {label(line.method),
         or_dash(promised_order(line.method, found.subject.limited())),
         order_text(line.order),
         line.order ? fmt::format("{:.2f}", line.order->finest) : "—",
         fmt::format("{} of {}", line.order ? line.order->points : 0,
                     line.points.size())});
  }
  return rows;
}

Json order_json(const std::optional<ObservedOrder>& order) {
  if (!order) return nullptr;
  return {{"order", order->order},
          {"uncertainty",
           order->uncertainty ? Json(*order->uncertainty) : Json(nullptr)},
          {"finest_two", order->finest},
          {"points", order->points}};
}

Json line_json(const PrecisionLine& line) {
  Json points = Json::array();
  for (const PrecisionPoint& point : line.points) {
    const Fineness& fineness = point.fineness;
    Json json = {{"mesh", fineness.mesh > 0 ? Json(fineness.mesh) : Json()},
                 {"wanted_error", or_null(fineness.tolerance)},
                 {"error", or_null(point.error)},
                 {"path_error", or_null(point.path_error)},
                 {"energy_drift", or_null(point.run.energy_drift)}};
    json.update(to_json(point.run));
    points.push_back(std::move(json));
  }
  return {{"method", label(line.method)},
          {"id", identifier(line.method)},
          {"observed_order", order_json(line.order)},
          {"points", points}};
}

}  // namespace

std::string summary(const WorkPrecision& found, report::TableForm form) {
  return fmt::format(
      "{}\n{}\nerror: relative, of τ, against {}\n"
      "orders: from errors above {:.1e}, ten times what {} and the reference "
      "leave open\n",
      report::table(point_rows(found), form),
      report::table(order_rows(found), form), reference_text(found.reference),
      found.floor(),
      found.polished()
          ? "rounding, down to which solutions are polished,"
          : fmt::format("the KKT tolerance {:.0e}", found.tolerance()));
}

std::string to_json(const WorkPrecision& found) {
  Json methods = Json::array(), lines = Json::array();
  for (const ComparedMethod& method : found.plan.methods) {
    methods.push_back(identifier(method));
  }
  for (const PrecisionLine& line : found.lines) {
    lines.push_back(line_json(line));
  }
  Json document = {{"schema_version", report::kSchemaVersion},
                   {"verified", true},
                   {"reference", to_json(std::optional(found.reference))},
                   {"options",
                    {{"methods", methods},
                     {"meshes", found.plan.meshes},
                     {"tolerances", found.plan.tolerances},
                     {"repetitions", found.plan.repetitions},
                     {"seconds_per_point", found.plan.seconds_per_point},
                     {"kkt_tolerance", found.tolerance()},
                     {"polish", found.polished()}}},
                   {"floor", found.floor()},
                   {"lines", lines}};
  add_origin(document, found.subject);
  return document.dump(2) + "\n";
}

}  // namespace brachisto::comparison
