// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "comparison/comparison_rows.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "comparison/measurement_text.hpp"
#include "comparison/methods.hpp"
#include "comparison/statistics.hpp"
#include "report/letters.hpp"

namespace brachisto::comparison {

using report::memory_text;
using report::or_dash;
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

}  // namespace brachisto::comparison
