// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "comparison/comparison_text.hpp"

#include <fmt/format.h>
#include <sys/utsname.h>

#include <algorithm>
#include <fstream>
#include <thread>

#include "brachisto/report/result.hpp"
#include "comparison/finding.hpp"
#include "comparison/methods.hpp"
#include "comparison/statistics.hpp"
#include "report/letters.hpp"
#include "report/provenance.hpp"
#include "report/result_field.hpp"

namespace brachisto::comparison {

using report::Json;
using report::memory_text;
using report::or_dash;
using report::or_null;
using report::Rows;
using report::seconds_text;

namespace {

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

Json spread_json(const std::vector<double>& seconds) {
  if (seconds.empty()) return nullptr;
  const Spread spread = spread_of(seconds);
  return {{"median", spread.median},
          {"least", spread.least},
          {"greatest", spread.greatest},
          {"all", seconds}};
}

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
  return {
      {"method", identifier(reference->method)},
      {"instead_of",
       reference->instead_of.empty() ? Json() : Json(reference->instead_of)},
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

/// The key `finding`.
Json finding_json(const std::vector<Party>& parties) {
  Json list = Json::array();
  for (const Party& party : parties) {
    const Trial* quickest = party.quickest_to(kSpokenError);
    const Trial* nearest = party.nearest();
    list.push_back(
        {{"name", party.name},
         {"refused", party.refused},
         {"cpu_seconds", quickest ? Json(quickest->seconds) : Json()},
         {"quickest", quickest ? Json(quickest->how) : Json()},
         {"least_error", nearest ? Json(nearest->error) : Json()}});
  }
  return {{"sentence", in_a_sentence(parties)},
          {"error", kSpokenError},
          {"parties", list}};
}

Json order_json(const std::optional<ObservedOrder>& order) {
  if (!order) return nullptr;
  return {{"order", order->order},
          {"uncertainty", or_null(order->uncertainty)},
          {"finest_two", order->finest},
          {"points", order->points},
          {"first_mesh", order->first},
          {"last_mesh", order->last}};
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
          {"observed_order", order_json(line.order.order)},
          {"no_order_because",
           line.order.why_not.empty() ? Json() : Json(line.order.why_not)},
          {"points", points}};
}

}  // namespace

std::string reference_text(const Reference& reference) {
  return fmt::format(
      "τ = {} by {}",
      report::with_error(reference.tau, reference.error * reference.tau),
      reference.by);
}

Rows point_rows(const WorkPrecision& found) {
  Rows rows{{"method", "mesh or wanted", "unknowns", "CPU [s]",
             "least – greatest", "of it the start", "iterations", "memory",
             "error", "remark"}};
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
           or_dash(run.unknowns), times[0], times[1],
           run.start.empty() ? "—" : seconds_text(spread_of(run.start).median),
           iterations_text(run), memory_text(run.peak_memory),
           point.error ? error_text(*point.error, found.reference) : "—",
           remark(point)});
    }
  }
  return rows;
}

Rows order_rows(const WorkPrecision& found) {
  Rows rows{{"method", "promised", "observed order", "finest two", "meshes",
             "why there is none"}};
  for (const PrecisionLine& line : found.lines) {
    if (!has_meshes(line.method)) continue;
    const std::optional<ObservedOrder>& order = line.order.order;
    rows.push_back(
        {label(line.method),
         or_dash(promised_order(line.method, found.subject.limited())),
         order_text(order), order ? fmt::format("{:.2f}", order->finest) : "—",
         order ? fmt::format("{} of {}, {} to {}", order->points,
                             line.points.size(), order->first, order->last)
               : fmt::format("0 of {}", line.points.size()),
         line.order.why_not});
  }
  return rows;
}

Rows method_rows(const MethodComparison& made) {
  constexpr std::size_t kVerdict = 72;  // letters; the document has it in full
  Rows rows{{"method", "unknowns", "CPU [s]", "iterations", "evaluations",
             "memory", "τ", "error", "verdict"}};
  for (const ComparisonRow& row : made.rows) {
    const Measurement& run = row.run;
    rows.push_back(
        {row.label, or_dash(run.unknowns),
         run.cpu.empty() ? "—" : seconds_text(spread_of(run.cpu).median),
         iterations_text(run), or_dash(run.evaluations),
         memory_text(run.peak_memory),
         run.solved() ? tau_text(row, made.reference) : "—",
         row.error ? error_text(*row.error, *made.reference) : "—",
         report::shortened(verdict(row), kVerdict)});
  }
  return rows;
}

Json document_of(const Measurement& run) {
  Json json = {{"outcome", name(run.outcome)},
               {"cause", run.cause.empty() ? Json() : Json(run.cause)},
               {"tau", run.solved() ? Json(run.tau) : Json()},
               {"verified", run.solved() && run.verified},
               {"estimated_error", or_null(run.estimated_error)}};
  json["cpu_seconds"] = spread_json(run.cpu);
  json["start_cpu_seconds"] = spread_json(run.start);
  json["mesh_cpu_seconds"] = spread_json(run.on_mesh());
  json["unknowns"] = or_null(run.unknowns);
  json["iterations"] = or_null(run.iterations);
  json["newton_steps"] = or_null(run.newton_steps);
  json["evaluations"] = or_null(run.evaluations);
  json["peak_memory_bytes"] = run.peak_memory;
  json["process_seconds"] = run.seconds;
  return json;
}

std::string iterations_text(const Measurement& run) {
  const int steps = run.newton_steps.value_or(0);
  if (steps == 0) return report::or_dash(run.iterations);
  if (run.iterations.value_or(0) == 0) return fmt::format("+ {}", steps);
  return fmt::format("{} + {}", *run.iterations, steps);
}

Machine this_machine() {
  return {cpu_model(), kernel(),
          static_cast<int>(std::thread::hardware_concurrency())};
}

std::string summary(const MethodComparison& comparison,
                    report::TableForm form) {
  return fmt::format(
      "{}\nerror: relative, against {}\n"
      "CPU: median of up to {} solves without their certificates, from the "
      "cycloid to residuals of {:.0e};\niterations: of the solver + Newton "
      "steps; memory: peak of the process, program and libraries "
      "included\n\n{}\n",
      report::table(method_rows(comparison), form),
      comparison.reference ? reference_text(*comparison.reference)
                           : "nothing: no method that could judge the others "
                             "has a verified answer",
      comparison.options.repetitions, comparison.options.residual,
      in_a_sentence(parties_of(comparison)));
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
                   {"methods", rows},
                   {"finding", finding_json(parties_of(comparison))}};
  add_origin(document, comparison.subject);
  return document.dump(2) + "\n";
}

std::string summary(const WorkPrecision& found, report::TableForm form) {
  std::string left_out;
  for (const LeftOut& one : found.left_out) {
    left_out +=
        fmt::format("left out: {}: {}\n", label(one.method), one.reason);
  }
  return fmt::format(
      "{}\n{}\nerror: relative, of τ, against {}\n"
      "orders: from errors above {:.1e}, ten times what {} and the reference "
      "leave open\n{}\n{}\n",
      report::table(point_rows(found), form),
      report::table(order_rows(found), form), reference_text(found.reference),
      found.floor(),
      found.polished()
          ? "rounding, down to which solutions are polished,"
          : fmt::format("the KKT tolerance {:.0e}", found.tolerance()),
      left_out, in_a_sentence(parties_of(found)));
}

std::string to_json(const WorkPrecision& found) {
  Json methods = Json::array(), lines = Json::array();
  Json left_out = Json::array();
  for (const LeftOut& one : found.left_out) {
    left_out.push_back({{"method", label(one.method)},
                        {"id", identifier(one.method)},
                        {"reason", one.reason}});
  }
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
                   {"lines", lines},
                   {"left_out", left_out},
                   {"finding", finding_json(parties_of(found))}};
  add_origin(document, found.subject);
  return document.dump(2) + "\n";
}

}  // namespace brachisto::comparison
