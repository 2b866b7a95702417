// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "comparison/measurement_text.hpp"

#include <fmt/format.h>

#include "comparison/statistics.hpp"
#include "report/text_table.hpp"

namespace brachisto::comparison {

using Json = nlohmann::ordered_json;

namespace {

Json spread_json(const std::vector<double>& seconds) {
  if (seconds.empty()) return nullptr;
  const Spread spread = spread_of(seconds);
  return {{"median", spread.median},
          {"least", spread.least},
          {"greatest", spread.greatest},
          {"all", seconds}};
}

}  // namespace

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

}  // namespace brachisto::comparison
