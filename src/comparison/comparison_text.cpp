// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>
#include <sys/utsname.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "brachisto/report/result.hpp"
#include "comparison/comparison.hpp"
#include "comparison/measurement_text.hpp"
#include "comparison/methods.hpp"
#include "comparison/statistics.hpp"
#include "comparison/work_precision.hpp"
#include "report/letters.hpp"
#include "report/provenance.hpp"
#include "report/text_table.hpp"

namespace brachisto::comparison {

using report::memory_text;
using report::or_dash;
using report::Rows;
using report::seconds_text;

using Json = nlohmann::ordered_json;

namespace {

std::string cpu_model() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) {
      return line.substr(colon + 2);
    }
  }
  return "unknown";
}

std::string kernel() {
  struct utsname system = {};
  if (::uname(&system) != 0) return "unknown";
  return fmt::format("{} {} {}", system.sysname, system.release,
                     system.machine);
}

Json to_json(const std::optional<Reference>& reference) {
  if (!reference) return nullptr;
  return {{"method", "extremal"},
          {"tau", reference->tau},
          {"error", reference->error}};
}

/// The keys `machine`, `provenance` and `scene`.
void add_origin(Json& document, const Subject& subject) {
  const Machine machine = this_machine();
  document["machine"] = {{"cpu", machine.cpu},
                         {"kernel", machine.kernel},
                         {"cores", machine.cores}};
  document["provenance"] = Json::parse(report::provenance_json());
  document["scene"] = Json::parse(report::input_json(subject.problem.scene,
                                                     subject.problem.options))
                          .at("scene");
}

/// "τ = 5.09344446661800(4) by the extremal method".
std::string reference_text(const Reference& reference) {
  return fmt::format(
      "τ = {} by {}",
      report::with_error(reference.tau, reference.error * reference.tau),
      reference.by);
}

/// "1.6e-06", or that it is less than the reference can tell.
std::string error_text(double error, const Reference& reference) {
  return error < reference.error ? fmt::format("< {:.1e}", reference.error)
                                 : fmt::format("{:.1e}", error);
}

/// As far as the reference tells; without one as the method itself sees its
/// error.
std::string tau_text(const ComparisonRow& row,
                     const std::optional<Reference>& reference) {
  const double tau = row.run.tau;
  const double error = row.error && reference
                           ? std::max(*row.error, reference->error)
                           : row.run.estimated_error.value_or(0.0);
  return report::within_error(tau, error * tau);
}

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
          {"uncertainty", or_null(order->uncertainty)},
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
    json.update(document_of(point.run));
    points.push_back(std::move(json));
  }
  return {{"method", label(line.method)},
          {"id", identifier(line.method)},
          {"observed_order", order_json(line.order)},
          {"points", points}};
}

}  // namespace

Machine this_machine() {
  return {cpu_model(), kernel(),
          static_cast<int>(std::thread::hardware_concurrency())};
}

std::string summary(const MethodComparison& comparison,
                    report::TableForm form) {
  constexpr std::size_t kVerdict = 72;  // letters; the document has it in full
  Rows rows{{"method", "unknowns", "CPU [s]", "iterations", "evaluations",
             "memory", "τ", "error", "verdict"}};
  for (const ComparisonRow& row : comparison.rows) {
    const Measurement& run = row.run;
    rows.push_back(
        {row.label, or_dash(run.unknowns),
         run.cpu.empty() ? "—" : seconds_text(spread_of(run.cpu).median),
         iterations_text(run), or_dash(run.evaluations),
         memory_text(run.peak_memory),
         run.solved() ? tau_text(row, comparison.reference) : "—",
         row.error ? error_text(*row.error, *comparison.reference) : "—",
         report::shortened(verdict(row), kVerdict)});
  }
  return fmt::format(
      "{}\nerror: relative, against {}\n"
      "CPU: median of up to {} solves without their certificates, from the "
      "cycloid to residuals of {:.0e};\niterations: of the solver + Newton "
      "steps; memory: peak of the process, program and libraries included\n",
      report::table(rows, form),
      comparison.reference ? reference_text(*comparison.reference)
                           : fmt::format("nothing: {} has no verified answer",
                                         referee_of(comparison.subject).name),
      comparison.options.repetitions, comparison.options.residual);
}

std::string to_json(const MethodComparison& comparison) {
  Json rows = Json::array();
  for (const ComparisonRow& row : comparison.rows) {
    Json json = {{"method", row.label}};
    json.update(document_of(row.run));
    json["error"] = or_null(row.error);
    json["verdict"] = verdict(row);
    rows.push_back(std::move(json));
  }
  Json document = {{"schema_version", report::kSchemaVersion},
                   {"verified", comparison.reference.has_value()},
                   {"reference", to_json(comparison.reference)},
                   {"options",
                    {{"nodes", comparison.options.nodes},
                     {"repetitions", comparison.options.repetitions},
                     {"seconds", comparison.options.seconds},
                     {"residual", comparison.options.residual}}},
                   {"methods", rows}};
  add_origin(document, comparison.subject);
  return document.dump(2) + "\n";
}

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
