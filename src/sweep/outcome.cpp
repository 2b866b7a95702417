// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/outcome.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "brachisto/report/result.hpp"

namespace brachisto::sweep {

namespace {

using Json = nlohmann::ordered_json;

std::string compact(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// "failed checks: second_order (1 exceeds 0), slope (…)", and what to try.
std::string failed_checks(const Solution& solution) {
  std::string text = "failed checks:";
  for (const Check& check : solution.certificate.checks) {
    if (check.passed) continue;
    text += fmt::format("{} {} ({:.3g} exceeds {:.3g})",
                        text.back() == ':' ? "" : ",", check.name, check.value,
                        check.threshold);
  }
  const std::string advice = solution.advice();
  return advice.empty() ? text : text + "; to try: " + advice;
}

}  // namespace

std::string outcome_json(const Solution& solution) {
  Json json = Json::parse(report::result_json(solution));
  json.erase("provenance");
  json.erase("scene");
  json.erase("input");
  // A table has one message per scene; let it be the one that matters.
  if (solution.status == Status::Solved && !solution.verified()) {
    json["status"] = "not_verified";
    json["message"] = failed_checks(solution);
  }
  return compact(json);
}

std::string failure_json(std::string_view status, std::string_view message) {
  return compact({{"schema_version", report::kSchemaVersion},
                  {"status", status},
                  {"message", message},
                  {"verified", false}});
}

bool is_outcome(const std::string& document) {
  if (document.size() > kLongestOutcome) return false;
  const std::optional<Json> read = parse_bounded_json(document);
  if (!read) return false;
  const Json& json = *read;
  const auto has = [&](const char* key, auto&& test) {
    return json.contains(key) && test(json[key]);
  };
  const auto is_text = [](const Json& j) { return j.is_string(); };
  const auto is_truth = [](const Json& j) { return j.is_boolean(); };
  const auto is_number = [](const Json& j) { return j.is_number(); };
  if (!json.is_object() || !has("status", is_text) ||
      !has("message", is_text) || !has("verified", is_truth)) {
    return false;
  }
  return !json["verified"] ||
         (has("feasible", is_truth) && has("tau", is_number) &&
          has("transit_time", is_number) && has("estimated_error", is_number) &&
          has("end_angle", is_number));
}

SweepOutcome read_outcome(const std::string& document) {
  const Json json = Json::parse(document);
  SweepOutcome outcome;
  outcome.status = json.at("status");
  outcome.message = json.at("message");
  if (!json.at("verified")) {
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

std::optional<nlohmann::ordered_json> parse_bounded_json(
    std::string_view text) {
  using Json = nlohmann::ordered_json;
  struct TooMuch {};
  std::size_t events = 0;  // at most two of a value and one of a key
  const auto check = [&](int depth, Json::parse_event_t, const Json&) {
    if (depth > kDeepestJson || ++events > 3 * kMostJsonValues) throw TooMuch{};
    return true;
  };
  try {
    Json json = Json::parse(text, check, false);
    if (json.is_discarded()) return std::nullopt;
    return json;
  } catch (const TooMuch&) {
    return std::nullopt;
  }
}

}  // namespace brachisto::sweep
