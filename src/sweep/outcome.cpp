// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/outcome.hpp"

#include <nlohmann/json.hpp>

#include "brachisto/report/result_json.hpp"

namespace brachisto::sweep {

namespace {

using Json = nlohmann::ordered_json;

std::string compact(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string outcome_json(const Solution& solution) {
  Json json = Json::parse(report::result_json(solution));
  json.erase("provenance");
  json.erase("scene");
  return compact(json);
}

std::string failure_json(std::string_view status, std::string_view message) {
  return compact({{"schema_version", report::kSchemaVersion},
                  {"status", status},
                  {"message", message},
                  {"verified", false}});
}

SweepOutcome read_outcome(const std::string& document) {
  const Json json = Json::parse(document);
  SweepOutcome outcome;
  outcome.status = json.value("status", "");
  outcome.message = json.value("message", "");
  if (!json.value("verified", false)) {
    outcome.state = SweepOutcome::State::Failed;
    return outcome;
  }
  outcome.state = SweepOutcome::State::Verified;
  outcome.feasible = json.at("feasible");
  outcome.tau = json.at("tau");
  outcome.transit_time = json.at("transit_time");
  outcome.estimated_error = json.at("estimated_error");
  outcome.end_angle = json.at("end_angle");
  return outcome;
}

}  // namespace brachisto::sweep
