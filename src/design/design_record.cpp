// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "design/design_record.hpp"

#include <nlohmann/json.hpp>

namespace brachisto {

using Json = nlohmann::ordered_json;

Json numbers_json(const NamedNumbers& numbers) {
  Json json = Json::object();
  for (const auto& [name, value] : numbers) json[name] = value;
  return json;
}

namespace {

NamedNumbers numbers_from(const Json& json) {
  NamedNumbers numbers;
  for (const auto& [name, value] : json.items()) {
    numbers.push_back({name, value.get<double>()});
  }
  return numbers;
}

Json minimum_json(const DesignMinimum& minimum) {
  Json bounds = Json::array();
  for (const auto& [name, bound, multiplier] : minimum.bounds_active) {
    bounds.push_back(
        {{"name", name}, {"bound", bound}, {"multiplier", multiplier}});
  }
  const Body& body = minimum.body;
  return {{"body", {body.radius, body.eta_m, body.theta_m, body.k}},
          {"values", numbers_json(minimum.values)},
          {"tau", minimum.tau},
          {"stationary", minimum.stationary},
          {"feasible", minimum.feasible},
          {"verified", minimum.verified},
          {"remarks", minimum.remarks},
          {"gradient", numbers_json(minimum.gradient)},
          {"bounds_active", std::move(bounds)},
          {"curvatures", minimum.curvatures}};
}

DesignMinimum minimum_from(const Json& json) {
  DesignMinimum minimum;
  const auto body = json.at("body").get<std::array<double, 4>>();
  minimum.body = Body::cylinder(body[0], body[1], body[2], body[3]);
  minimum.values = numbers_from(json.at("values"));
  minimum.tau = json.at("tau");
  minimum.stationary = json.at("stationary");
  minimum.feasible = json.at("feasible");
  minimum.verified = json.at("verified");
  json.at("remarks").get_to(minimum.remarks);
  minimum.gradient = numbers_from(json.at("gradient"));
  for (const Json& bound : json.at("bounds_active")) {
    minimum.bounds_active.push_back(
        {bound.at("name"), bound.at("bound"), bound.at("multiplier")});
  }
  json.at("curvatures").get_to(minimum.curvatures);
  return minimum;
}

}  // namespace

Json to_json(const DesignSearch& search) {
  Json minima = Json::array(), paths = Json::array();
  for (const DesignMinimum& minimum : search.minima) {
    minima.push_back(minimum_json(minimum));
  }
  for (const DesignPath& path : search.paths) {
    Json& steps = paths.emplace_back(Json::array());
    for (const auto& [values, tau] : path) {
      steps.push_back({{"values", numbers_json(values)}, {"tau", tau}});
    }
  }
  return {{"minima", std::move(minima)},
          {"paths", std::move(paths)},
          {"stopped", search.stopped},
          {"reached", search.reached ? minimum_json(*search.reached) : Json()},
          {"lost", search.lost},
          {"message", search.message},
          {"number", search.number},
          {"starts", search.starts},
          {"solves", search.solves},
          {"cpu_seconds", search.cpu_seconds}};
}

DesignSearch design_search_from_json(const Json& json) {
  DesignSearch search;
  for (const Json& minimum : json.at("minima")) {
    search.minima.push_back(minimum_from(minimum));
  }
  for (const Json& steps : json.at("paths")) {
    DesignPath& path = search.paths.emplace_back();
    for (const Json& step : steps) {
      path.push_back(
          {numbers_from(step.at("values")), step.at("tau").get<double>()});
    }
  }
  json.at("lost").get_to(search.lost);
  search.message = json.at("message");
  search.stopped = json.at("stopped");
  if (!json.at("reached").is_null()) {
    search.reached = minimum_from(json.at("reached"));
  }
  search.number = json.at("number");
  search.starts = json.at("starts");
  search.solves = json.at("solves");
  search.cpu_seconds = json.at("cpu_seconds");
  return search;
}

}  // namespace brachisto
