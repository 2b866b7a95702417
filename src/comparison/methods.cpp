// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "comparison/methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "brachisto/report/result_json.hpp"
#include "brachisto/transcription/discretisation.hpp"
#include "io/key_spec.hpp"

namespace brachisto::comparison {

namespace {

using Json = nlohmann::ordered_json;
using Kind = ComparedMethod::Kind;

const char* name(FsolveArm arm) {
  switch (arm) {
    case FsolveArm::Rest:
      return "rest";
    case FsolveArm::Release:
      return "release";
    case FsolveArm::Newton:
      return "newton";
    case FsolveArm::Lifted:
      return "lifted";
  }
  return "";
}

bool hybrid(FsolveArm arm) {
  return arm == FsolveArm::Rest || arm == FsolveArm::Release;
}

Json mesh_of(const ComparedMethod& method, int mesh) {
  switch (method.kind) {
    case Kind::RollingTime:
      return {{"formulation", "rolling_time"},
              {"degree", method.degree},
              {"elements", mesh}};
    case Kind::ArcLength:
      return {{"formulation", "arc_length"}, {"elements", mesh}};
    case Kind::Fsolve:
      return {{"nodes", mesh}};
    case Kind::Extremal:
      break;
  }
  return Json::object();
}

/// \param stated  the section as it is in force
Json solver_of(const ComparedMethod& method, const Json& stated) {
  const Json seconds = {{"seconds", stated.at("limits").at("seconds")}};
  switch (method.kind) {
    case Kind::Extremal:
      return {{"method", "extremal"}, {"limits", seconds}};
    case Kind::Fsolve: {
      Json reading = stated.at("fsolve");
      reading["variant"] = hybrid(method.arm) ? "hybrid" : name(method.arm);
      if (hybrid(method.arm)) {
        reading["datum"] = name(method.arm);
      } else {
        reading.erase("epsilon");  // they have exact derivatives
      }
      return {{"method", "fsolve"},
              {"limits", stated.at("limits")},
              {"fsolve", reading}};
    }
    case Kind::RollingTime:
    case Kind::ArcLength:
      break;
  }
  return {{"method", "ipopt"},
          {"linear_solver", stated.at("linear_solver")},
          {"tolerance", stated.at("tolerance")},
          {"polish", stated.at("polish")},
          {"limits", stated.at("limits")}};
}

}  // namespace

std::string label(const ComparedMethod& method) {
  switch (method.kind) {
    case Kind::RollingTime:
      return fmt::format("rolling_time p = {}", method.degree);
    case Kind::ArcLength:
      return "arc_length";
    case Kind::Extremal:
      return "extremal";
    case Kind::Fsolve:
      return fmt::format("fsolve {}", name(method.arm));
  }
  return "";
}

std::string identifier(const ComparedMethod& method) {
  std::string id = label(method);
  if (method.kind == Kind::RollingTime) {
    id = fmt::format("rolling_time_{}", method.degree);
  }
  std::ranges::replace(id, ' ', '_');
  return id;
}

bool accepts(std::string_view key, std::string_view word) {
  const io::KeySpec* spec = io::find_key(key);
  return spec != nullptr && io::objection(*spec, word).empty();
}

bool available(const ComparedMethod& method) {
  return method.kind != Kind::ArcLength ||
         accepts("discretisation.formulation", "arc_length");
}

bool has_meshes(const ComparedMethod& method) {
  return method.kind != Kind::Extremal;
}

int smallest_mesh(const ComparedMethod& method) {
  switch (method.kind) {
    case Kind::ArcLength:
    case Kind::Fsolve:  // with fewer, too: chords that make no path
      return kFewestPieces;
    case Kind::RollingTime:
    case Kind::Extremal:
      break;
  }
  return 1;
}

std::optional<int> promised_order(const ComparedMethod& method) {
  switch (method.kind) {
    case Kind::RollingTime:
      return 2 * method.degree;
    case Kind::ArcLength:
      return 2;
    case Kind::Extremal:
    case Kind::Fsolve:
      break;
  }
  return std::nullopt;
}

std::vector<std::string> overrides(const ComparedMethod& method, int mesh,
                                   const io::ProblemFile& base) {
  const Json stated =
      Json::parse(report::input_json(base.scene, base.options)).at("solver");
  return {"discretisation=" + mesh_of(method, mesh).dump(),
          "solver=" + solver_of(method, stated).dump()};
}

}  // namespace brachisto::comparison
