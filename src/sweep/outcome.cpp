// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/outcome.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "brachisto/report/result.hpp"
#include "design/design_record.hpp"
#include "plot/thinning.hpp"
#include "report/result_texts.hpp"
#include "study/answer_kinds.hpp"

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
    text += fmt::format("{} {} ({})", text.back() == ':' ? "" : ",", check.name,
                        std::isnan(check.value)
                            ? "not measured"
                            : fmt::format("{:.3g} exceeds {:.3g}", check.value,
                                          check.threshold));
  }
  const std::string advice = solution.advice();
  return advice.empty() ? text : text + "; to try: " + advice;
}

Json document_of(const Solution& solution) {
  Json json = report::outcome_document(solution);
  // A table has one message per scene; let it be the one that matters.
  if (solution.status == Status::Solved && !solution.verified()) {
    json["status"] = "not_verified";
    json["message"] = failed_checks(solution);
  }
  if (solution.options.or_default<Collocation>().in_lanes) {
    const bool lanes = answer_as<LaneAnswer>(solution.answer) != nullptr;
    json["engine"] = lanes ? "lanes" : "own";
    if (lanes) json["iterations"] = json["newton_steps"] = nullptr;
  }
  return json;
}

Json failure_document(std::string_view status, std::string_view message) {
  return {{"schema_version", report::kSchemaVersion},
          {"status", status},
          {"message", message},
          {"verified", false}};
}

/// Of the list `limits` of a result, which may be absent.
std::vector<SweepArc> arcs_of(const Json& result) {
  std::vector<SweepArc> arcs;
  if (!result.contains("limits")) return arcs;
  const double T = result.at("transit_time");
  for (const Json& limit : result.at("limits")) {
    for (const Json& arc : limit.at("active")) {
      const Json& t = arc.at("t");
      arcs.push_back({limit.at("name"), t.at("from").get<double>() / T,
                      t.at("to").get<double>() / T});
    }
  }
  std::ranges::stable_sort(arcs, {}, &SweepArc::from);
  return arcs;
}

/// \throws Json::exception  if something is missing or of another type
SweepOutcome outcome_of(const Json& json) {
  SweepOutcome outcome;
  outcome.status = json.at("status");
  outcome.message = json.at("message");
  if (!json.at("verified").get<bool>()) {
    outcome.state = SweepOutcome::State::Failed;
    return outcome;
  }
  outcome.state = SweepOutcome::State::Verified;
  outcome.feasible = json.at("feasible");
  outcome.tau = json.at("tau");
  outcome.transit_time = json.at("transit_time");
  outcome.estimated_error = json.at("estimated_error");
  outcome.end_angle = json.at("end_angle");
  outcome.arcs = arcs_of(json);
  const auto read = [&](const char* key, auto& list) {
    const Json value = json.value(key, Json());
    if (value.is_array()) value.get_to(list);
  };
  read("infeasible_because", outcome.infeasible_because);
  read("folds", outcome.folds);
  return outcome;
}

}  // namespace

std::string outcome_json(const Solution& solution, bool with_track) {
  Json json = document_of(solution);
  if (with_track && solution.verified()) {
    json["track"] = plot::kept_track(
        plot::TrajectoryTable::read(report::trajectory_csv(solution)),
        solution.scene.body);
  }
  return compact(json);
}

std::string outcome_json(const DesignSearch& search) {
  Json json =
      search.answer
          ? document_of(*search.answer)
          : failure_document(
                name(search.stopped ? Status::TimeLimit : Status::NotConverged),
                search.message);
  json["design"] = to_json(search);
  return compact(json);
}

DesignSearch read_design_search(const std::string& document) {
  return design_search_from_json(Json::parse(document).at("design"));
}

std::string failure_json(std::string_view status, std::string_view message) {
  return compact(failure_document(status, message));
}

bool is_outcome(const std::string& document) {
  if (document.size() > kLongestOutcome) return false;
  const std::optional<Json> json = parse_bounded_json(document);
  return json && find_outcome(*json);
}

std::optional<SweepOutcome> find_outcome(const nlohmann::ordered_json& json) {
  try {
    return outcome_of(json);
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

SweepOutcome read_outcome(const std::string& document) {
  return outcome_of(Json::parse(document));
}

std::optional<nlohmann::ordered_json> parse_bounded_json(
    std::string_view text) {
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
