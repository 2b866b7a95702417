// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/lists.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "io/item_reader.hpp"
#include "math/enum_table.hpp"

namespace brachisto::io {

namespace {

KeySpec required_number(std::string_view name, KeyType type,
                        std::string_view unit, Interval interval = {}) {
  return number_item(
      name, type,
      {.presence = Presence::Required, .unit = unit, .interval = interval});
}

KeySpec obstacle(std::string_view name, KeySpec size) {
  return map_item(
      name, {required_number("x", KeyType::Number, "m"),
             required_number("z", KeyType::Number, "m"), std::move(size)});
}

Objection put_obstacles(Draft& problem, const Json& list, Binding::Row) {
  PathLimits& limits = problem.scene.limits;
  limits.discs.clear();
  limits.half_planes.clear();
  for (const Json& item : list) {
    const Json& numbers = item.front();
    const Point place{numbers.at("x"), numbers.at("z")};
    if (item.contains("disc")) {
      limits.discs.push_back({place, numbers.at("radius")});
    } else {
      limits.half_planes.push_back({place, numbers.at("normal")});
    }
  }
  return {};
}

Json obstacles_json(const Draft& problem, Binding::Row) {
  Json list;
  const auto add = [&](const char* name, const char* last, const auto& all) {
    for (const auto& [place, size] : all) {
      list.push_back({{name, {{"x", place.x}, {"z", place.z}, {last, size}}}});
    }
  };
  add("disc", "radius", problem.scene.limits.discs);
  add("half_plane", "normal", problem.scene.limits.half_planes);
  return list;
}

}  // namespace

Binding clear_of_list() {
  KeySpec kinds = map_item(
      "", {obstacle("disc",
                    required_number("radius", KeyType::Number, "m", kPositive)),
           obstacle("half_plane",
                    required_number("normal", KeyType::Angle, "rad"))});
  kinds.value.one_of = true;
  return {.type = KeyType::List,
          .echo = obstacles_json,
          .silent = true,
          .put_list = put_obstacles,
          .items = {std::move(kinds)}};
}

namespace {

Objection put_free(Draft& problem, const Json& list, Binding::Row) {
  DesignPlan& plan = problem.design;
  plan.free.clear();
  plan.free_parts.clear();
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Json& item = list[i];
    if (item.is_string()) {
      const auto is_named = [&](BodyKey key) { return item == name(key); };
      plan.free.push_back(*std::ranges::find_if(kBodyKeys, is_named));
      continue;
    }
    FreePart free{
        item.at("part").get<std::size_t>() - 1, FreePart::Key::At, {}};
    const bool bounded = item.contains("bounds");
    if (item.value("key", "at") == "mass") {
      free.key = FreePart::Key::Mass;
      if (!bounded || !(item["bounds"][0] < item["bounds"][1])) {
        return {"a mass that is free has bounds, the greater one last", i};
      }
      free.bounds = {item["bounds"][0], item["bounds"][1]};
    } else if (bounded) {
      return {"the place of a part has no bounds but the cylinder", i};
    }
    if (std::ranges::any_of(plan.free_parts, [&](const FreePart& other) {
          return other.part == free.part && other.key == free.key;
        })) {
      return {"this key of the part is free already", i};
    }
    plan.free_parts.push_back(free);
  }
  return {};
}

Json free_json(const Draft& problem, Binding::Row) {
  if (problem.design.empty()) return {};
  Json list = Json::array();
  for (const BodyKey key : problem.design.free) list.push_back(name(key));
  for (const auto& [part, key, bounds] : problem.design.free_parts) {
    Json item = {{"part", part + 1},
                 {"key", key == FreePart::Key::At ? "at" : "mass"}};
    if (key == FreePart::Key::Mass) {
      item["bounds"] = {bounds.lower, bounds.upper};
    }
    list.push_back(std::move(item));
  }
  return list;
}

/// What a body may have, for the bounds of a design.
Interval allowed(BodyKey key) {
  switch (key) {
    case BodyKey::EtaM:
      return {.lower = 0.0, .upper = 1.0, .upper_allowed = false};
    case BodyKey::ThetaM:
      return {-2.0 * std::numbers::pi, 2.0 * std::numbers::pi};
    case BodyKey::K:
      return {0.0, 1.0};
    case BodyKey::Radius:
      return kPositive;
  }
  return {};
}

Objection put_bounds(Draft& problem, const Json& list, Binding::Row row) {
  const double lower = list[0], upper = list[1];
  if (!(lower < upper)) {
    return {
        fmt::format("from {:g} to {:g} is no room: the greater one stands "
                    "last, and what has one value belongs in scene.body "
                    "and is not free",
                    lower, upper)};
  }
  problem.design.bounds[row] = {lower, upper};
  return {};
}

}  // namespace

Binding free_list() {
  constexpr double kMostParts = 1000;
  std::vector<std::string_view> names;
  for (const BodyKey key : kBodyKeys) names.push_back(name(key));
  KeySpec bounds = list_item(
      "bounds", number_item("", KeyType::Number, {.interval = kPositive}),
      {.bounds = "two numbers > 0, the greater one last"});
  bounds.value.count = 2;
  return {.type = KeyType::List,
          .echo = free_json,
          .put_list = put_free,
          .items = {word_item("", std::move(names)),
                    map_item("", {required_number("part", KeyType::Integer, "",
                                                  {1, kMostParts}),
                                  word_item("key", {"at", "mass"}), bounds})},
          .once = true};
}

Binding bounds_list(BodyKey key) {
  const KeyType type =
      key == BodyKey::ThetaM ? KeyType::Angle : KeyType::Number;
  return {.type = KeyType::List,
          .echo =
              [](const Draft& p, Binding::Row row) {
                const auto& bounds = p.design.bounds[row];
                return bounds ? Json::array({bounds->lower, bounds->upper})
                              : Json();
              },
          .put_list = put_bounds,
          .items = {number_item("", type, {.interval = allowed(key)})},
          .count = 2,
          .row = static_cast<Binding::Row>(key)};
}

namespace {

using Method = ComparedMethod::Kind;
using Methods = std::vector<ComparedMethod>;

constexpr EnumTable<Method, std::string_view, 5> kNames{
    {"rolling_time", "adaptive", "arc_length", "extremal", "fsolve"}};
constexpr EnumTable<DiscreteArm, std::string_view, 4> kArms{
    {"rest", "release", "newton", "lifted"}};

DiscreteArm arm_named(std::string_view name) {
  const auto found = std::ranges::find(kArms.values, name);
  return static_cast<DiscreteArm>(found - kArms.values.begin());
}

/// What an item stands for; a name alone for its defaults.
Methods methods_of(const Json& item) {
  Methods methods;
  if (item.is_string()) {
    methods = WorkPrecisionPlan{}.methods;
    std::erase_if(methods, [&](const ComparedMethod& method) {
      return kNames[method.kind] != item.get<std::string>();
    });
    return methods;
  }
  for (const Json& one : item.front()) {
    methods.push_back(one.is_number()
                          ? rolling_time(one.get<int>())
                          : discrete_system(arm_named(one.get<std::string>())));
  }
  return methods;
}

Objection put_methods(Draft& problem, const Json& list, Binding::Row) {
  Methods methods;
  for (std::size_t i = 0; i < list.size(); ++i) {
    for (const ComparedMethod& method : methods_of(list[i])) {
      // A line would be drawn over itself.
      if (std::ranges::count(methods, method) > 0) {
        return {"a method is repeated", i};
      }
      methods.push_back(method);
    }
  }
  problem.work_precision.methods = std::move(methods);
  return {};
}

/// Neighbours of one name share its list.
Json methods_json(const Draft& problem, Binding::Row) {
  Json list = Json::array();
  for (const ComparedMethod& method : problem.work_precision.methods) {
    const auto name = kNames[method.kind];
    const bool of_degrees = method.kind == Method::RollingTime;
    if (!of_degrees && method.kind != Method::DiscreteSystem) {
      list.push_back(name);
      continue;
    }
    const bool shared = !list.empty() && list.back().contains(name);
    if (!shared) list.push_back({{name, Json::array()}});
    list.back()[name].push_back(of_degrees ? Json(method.degree)
                                           : Json(kArms[method.arm]));
  }
  return list;
}

/// Numbers of a plan, each once, from coarse to fine.
template <auto member, class Finer>
Binding numbers_list(Interval allowed) {
  using Value = typename std::remove_reference_t<
      decltype(std::declval<WorkPrecisionPlan&>().*member)>::value_type;
  return {
      .type = KeyType::List,
      .echo = [](const Draft& p,
                 Binding::Row) { return Json(p.work_precision.*member); },
      .put_list =
          [](Draft& problem, const Json& list, Binding::Row) {
            auto& numbers = problem.work_precision.*member;
            numbers = list.get<std::vector<Value>>();
            std::ranges::sort(numbers, Finer());
            return Objection();
          },
      .items = {number_item(
          "", std::is_integral_v<Value> ? KeyType::Integer : KeyType::Number,
          {.interval = allowed})},
      .once = true};
}

}  // namespace

Binding methods_list() {
  KeySpec lists = map_item(
      "", {list_item(kNames[Method::RollingTime],
                     number_item("", KeyType::Integer,
                                 {.interval = {kMinDegree, kMaxDegree}}),
                     {.bounds = "a list of degrees, integers from 1 to 8"}),
           list_item(kNames[Method::DiscreteSystem],
                     word_item("", {kArms.values.begin(), kArms.values.end()}),
                     {.bounds = "a list of rest, release, newton, lifted"})});
  lists.value.one_of = true;
  for (KeySpec& list : lists.value.items) list.value.once = true;
  return {.type = KeyType::List,
          .echo = methods_json,
          .put_list = put_methods,
          .items = {word_item("", {kNames.values.begin(), kNames.values.end()}),
                    std::move(lists)},
          .once = true};
}

Binding meshes_list() {
  return numbers_list<&WorkPrecisionPlan::meshes, std::less<>>({2, 1'000'000});
}

Binding tolerances_list() {
  return numbers_list<&WorkPrecisionPlan::tolerances, std::greater<>>(
      {kSmallestTolerance, kLargestTolerance});
}

}  // namespace brachisto::io
