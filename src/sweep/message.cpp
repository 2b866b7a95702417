// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "brachisto/ocp/mesh.hpp"
#include "transcription/variable_layout.hpp"

namespace brachisto::sweep {

namespace {

using Json = nlohmann::ordered_json;

std::string line_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// True if the mesh is one and the point one of the problem on it.
bool is_of(const Scene& scene, const Neighbour& neighbour) {
  const auto& [degree, boundaries] = neighbour.mesh;
  const std::vector<double>& x = neighbour.point.x;
  const std::vector<double>& lambda = neighbour.point.lambda;
  const bool increasing =
      std::ranges::adjacent_find(boundaries, std::greater_equal<>{}) ==
      boundaries.end();
  if (degree < 1 || degree > kLargestDegree || boundaries.size() < 2 ||
      boundaries.front() != 0.0 || boundaries.back() != 1.0 || !increasing ||
      // There are several constraints per point; what follows is in range.
      (boundaries.size() - 1) * static_cast<std::size_t>(degree) >
          lambda.size()) {
    return false;
  }
  // Arcs tell their sizes themselves.
  if (!neighbour.arcs.empty()) return true;
  const VariableLayout layout(neighbour.mesh.num_points(),
                              scene.body.off_centred());
  return x.size() == static_cast<std::size_t>(layout.num_variables()) &&
         lambda.size() == static_cast<std::size_t>(layout.num_constraints());
}

nlp::Held held_from(const Json& json) {
  switch (const int value = json; value) {
    case static_cast<int>(nlp::Held::No):
    case static_cast<int>(nlp::Held::AtLower):
    case static_cast<int>(nlp::Held::AtUpper):
      return static_cast<nlp::Held>(value);
    default:
      throw std::invalid_argument("the state of no arc");
  }
}

Arc arc_from(const Json& json) {
  Arc arc;
  for (const Json& where : json.at("held")) {
    arc.held.push_back(held_from(where));
  }
  arc.end = json.at("end");
  json.at("cuts").get_to(arc.cuts);
  const Json& touch = json.at("touch");
  if (!touch.is_null()) {
    arc.touch = {touch.at("limit"), held_from(touch.at("at")),
                 touch.at("multiplier")};
  }
  return arc;
}

}  // namespace

std::string to_line(const Request& request) {
  Json json{{"first", request.first},
            {"last", request.last},
            {"state", request.state}};
  if (request.seconds) json["seconds"] = *request.seconds;
  return line_of(json);
}

Request request_from_line(std::string_view line) {
  const Json json = Json::parse(line);
  Request request{json.at("first"), json.at("last"), json.at("state")};
  if (json.contains("seconds")) request.seconds = json["seconds"];
  return request;
}

std::string to_line(const Answer& answer) {
  return fmt::format(R"({{"scene":{},"result":{},"state":{}}})"
                     "\n",
                     answer.scene, answer.result,
                     Json(answer.state.value_or("")).dump());
}

std::optional<Answer> answer_from_line(std::string_view line) {
  // As to_line() has them, so that the result need not be written anew. In a
  // text of JSON quotation marks are escaped: the last key is the state's.
  constexpr std::string_view kScene = R"({"scene":)", kResult = R"(,"result":)",
                             kState = R"(,"state":)";
  const std::size_t result = line.find(kResult), state = line.rfind(kState);
  if (!line.starts_with(kScene) || !line.ends_with('}') ||
      state == std::string_view::npos || result > state) {
    return std::nullopt;
  }
  const auto between = [&](std::size_t begin, std::size_t end) {
    return line.substr(begin, end - begin);
  };
  const std::string_view text = between(result + kResult.size(), state);
  if (text.size() > kLongestOutcome || !text.starts_with('{') ||
      !text.ends_with('}')) {
    return std::nullopt;
  }
  const auto first = parse_bounded_json(between(kScene.size(), result));
  const auto second = parse_bounded_json(text);
  const auto third =
      parse_bounded_json(between(state + kState.size(), line.size() - 1));
  if (!first || !first->is_number_unsigned() || !second || !third ||
      !third->is_string()) {
    return std::nullopt;
  }
  std::optional<SweepOutcome> outcome = find_outcome(*second);
  if (!outcome) return std::nullopt;
  Answer answer{*first, std::string(text), third->get<std::string>(),
                *std::move(outcome)};
  // Whatever is stored can be read again.
  if (!answer.state->empty() && !Json::accept(*answer.state)) {
    return std::nullopt;
  }
  return answer;
}

std::string to_state(const Neighbour& neighbour) {
  Json json{{"degree", neighbour.mesh.degree},
            {"boundaries", neighbour.mesh.boundaries},
            {"x", neighbour.point.x},
            {"lambda", neighbour.point.lambda},
            {"phi", neighbour.phi}};
  if (neighbour.arcs.empty()) return json.dump();
  const LimitedEnds& ends = neighbour.ends;
  json["ends"] = {{"free_contacts", ends.free_contacts},
                  {"start", ends.start ? Json(*ends.start) : Json()},
                  {"start_slope_fixed", ends.start_slope_fixed}};
  if (ends.corner) {
    json["ends"]["corner"] = {{"limit", ends.corner->limit},
                              {"at", static_cast<int>(ends.corner->at)}};
  }
  for (const Arc& arc : neighbour.arcs) {
    Json touch;
    if (arc.touch) {
      touch = {{"limit", arc.touch->limit},
               {"at", static_cast<int>(arc.touch->at)},
               {"multiplier", arc.touch->multiplier}};
    }
    Json held = Json::array();
    for (const nlp::Held where : arc.held) {
      held.push_back(static_cast<int>(where));
    }
    json["arcs"].push_back({{"held", std::move(held)},
                            {"end", arc.end},
                            {"cuts", arc.cuts},
                            {"touch", std::move(touch)}});
  }
  return json.dump();
}

Neighbour neighbour_from_state(const std::string& state, const Scene& scene) {
  const Json json = Json::parse(state);
  Neighbour neighbour;
  neighbour.scene = scene;
  neighbour.mesh.degree = json.at("degree");
  json.at("boundaries").get_to(neighbour.mesh.boundaries);
  json.at("x").get_to(neighbour.point.x);
  json.at("lambda").get_to(neighbour.point.lambda);
  neighbour.phi = json.at("phi");
  if (json.contains("arcs")) {
    const Json& ends = json.at("ends");
    neighbour.ends = {.free_contacts = ends.at("free_contacts"),
                      .phi = neighbour.phi,
                      .start_slope_fixed = ends.at("start_slope_fixed")};
    if (!ends.at("start").is_null()) neighbour.ends.start = ends.at("start");
    if (ends.contains("corner")) {
      const Json& corner = ends.at("corner");
      neighbour.ends.corner =
          StartCorner{corner.at("limit"), held_from(corner.at("at"))};
    }
    for (const Json& one : json.at("arcs")) {
      neighbour.arcs.push_back(arc_from(one));
    }
  }
  if (!is_of(scene, neighbour)) {
    throw std::invalid_argument("the state of another scene");
  }
  return neighbour;
}

}  // namespace brachisto::sweep
