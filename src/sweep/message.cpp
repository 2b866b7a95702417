// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/message.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "brachisto/model/units.hpp"
#include "brachisto/transcription/rolling_time.hpp"
#include "sweep/outcome.hpp"

namespace brachisto::sweep {

namespace {

using Json = nlohmann::ordered_json;

std::string line_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string to_line(const Request& request) {
  return line_of({{"first", request.first},
                  {"last", request.last},
                  {"state", request.state}});
}

Request request_from_line(std::string_view line) {
  const Json json = Json::parse(line);
  return {json.at("first"), json.at("last"), json.at("state")};
}

std::string to_line(const Answer& answer) {
  return line_of({{"scene", answer.scene},
                  {"result", Json::parse(answer.result)},
                  {"state", answer.state}});
}

std::optional<Answer> answer_from_line(std::string_view line) {
  const Json json = Json::parse(line, nullptr, false);
  const auto is = [&](const char* key, auto&& test) {
    return json.contains(key) && test(json[key]);
  };
  const bool good =
      json.is_object() &&
      is("scene", [](const Json& j) { return j.is_number_unsigned(); }) &&
      is("state", [](const Json& j) { return j.is_string(); }) &&
      is("result", [](const Json& j) { return j.is_object(); });
  if (!good) return std::nullopt;
  Answer answer{json["scene"], json["result"].dump(), json["state"]};
  // Whatever is stored can be read again.
  if (!is_outcome(answer.result)) return std::nullopt;
  if (!answer.state.empty() && !Json::accept(answer.state)) return std::nullopt;
  return answer;
}

std::string to_state(const Neighbour& neighbour) {
  return Json{{"degree", neighbour.mesh.degree},
              {"boundaries", neighbour.mesh.boundaries},
              {"x", neighbour.point.x},
              {"lambda", neighbour.point.lambda},
              {"phi", neighbour.phi}}
      .dump();
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
  const RollingTime problem(in_natural_units(scene), neighbour.mesh,
                            neighbour.phi);
  const auto size = [](const std::vector<double>& v) {
    return static_cast<int>(v.size());
  };
  if (size(neighbour.point.x) != problem.num_variables() ||
      size(neighbour.point.lambda) != problem.num_constraints()) {
    throw std::invalid_argument("the state of another scene");
  }
  return neighbour;
}

}  // namespace brachisto::sweep
