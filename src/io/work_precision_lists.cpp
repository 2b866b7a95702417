// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "io/list_reader.hpp"
#include "io/lists.hpp"
#include "math/enum_table.hpp"

namespace brachisto::io {

namespace {

using Kind = ComparedMethod::Kind;
using Methods = std::vector<ComparedMethod>;

constexpr Interval kDegrees{kMinDegree, kMaxDegree};
constexpr std::string_view kExpectedDegrees =
    "a list of degrees, integers from 1 to 8";
constexpr Interval kMeshes{2, 1'000'000};
constexpr Interval kTolerances{kSmallestTolerance, kLargestTolerance};

constexpr EnumTable<Kind, std::string_view, 5> kNames{
    {"rolling_time", "adaptive", "arc_length", "extremal", "fsolve"}};
constexpr EnumTable<DiscreteArm, std::string_view, 4> kArms{
    {"rest", "release", "newton", "lifted"}};

/// What a name alone stands for.
Methods methods_of(Kind kind) {
  Methods methods = WorkPrecisionPlan{}.methods;
  std::erase_if(methods,
                [&](const auto& method) { return method.kind != kind; });
  return methods;
}

void read_methods(Draft& problem, const KeySpec& spec, const YamlValue& list,
                  Findings& findings) {
  Methods methods;
  // A line would be drawn over itself.
  const auto add = [&](const ListReader& reader, const YamlValue& item,
                       const Methods& found) {
    reader.add_once(methods, found, item, in_quotes(item.text));
  };
  const ListReader reader(spec, findings);
  const auto read_named = [&](const Entry& entry) {
    const auto name = reader.word(entry.key, entry.position, kNames.values);
    if (!name) return;
    const std::string key = fmt::format("{}.{}", reader.key, entry.key);
    if (Kind(*name) == Kind::RollingTime) {
      const ListReader degrees(key, std::string(kExpectedDegrees), findings);
      degrees.each(entry.value, [&](const YamlValue& item) {
        const auto p = degrees.number(item, KeyType::Integer, kDegrees);
        if (p) add(degrees, item, {rolling_time(static_cast<int>(*p))});
      });
    } else if (Kind(*name) == Kind::DiscreteSystem) {
      const ListReader arms(
          key, fmt::format("a list of {}", fmt::join(kArms.values, ", ")),
          findings);
      arms.each(entry.value, [&](const YamlValue& item) {
        const auto arm = arms.word(item, kArms.values);
        if (arm) add(arms, item, {discrete_system(DiscreteArm(*arm))});
      });
    } else {
      findings.add(entry.position, key,
                   fmt::format("{} has no list; expected {} alone", entry.key,
                               entry.key));
    }
  };
  reader.each(list, [&](const YamlValue& item) {
    if (item.kind == YamlValue::Kind::Map && item.entries.size() == 1) {
      read_named(item.entries.front());
    } else if (const auto name = reader.word(item, kNames.values)) {
      add(reader, item, methods_of(Kind(*name)));
    }
  });
  if (!methods.empty()) problem.work_precision.methods = std::move(methods);
}

/// Numbers of a plan, each once, from coarse to fine.
template <auto member, const Interval& allowed, class Finer>
Binding numbers_list() {
  using Value = typename std::remove_reference_t<
      decltype(std::declval<WorkPrecisionPlan&>().*member)>::value_type;
  constexpr bool kIntegral = std::is_integral_v<Value>;
  constexpr KeyType kType = kIntegral ? KeyType::Integer : KeyType::Number;
  return {.type = KeyType::List,
          .echo = [](const Draft& p,
                     Binding::Row) { return Json(p.work_precision.*member); },
          .read_list =
              [](Draft& problem, const KeySpec& spec, const YamlValue& list,
                 Findings& findings) {
                const ListReader reader(spec, findings);
                std::vector<Value> numbers;
                reader.each(list, [&](const YamlValue& item) {
                  if (const auto read = reader.number(item, kType, allowed)) {
                    const auto value = static_cast<Value>(*read);
                    reader.add_once(numbers, {value}, item,
                                    fmt::format("{}", value));
                  }
                });
                std::ranges::sort(numbers, Finer());
                problem.work_precision.*member = std::move(numbers);
              },
          .items =
              [] {
                Json schema = number_or_text_schema();
                if (kIntegral) schema = {{"type", "integer"}};
                schema["minimum"] = allowed.lower;
                schema["maximum"] = allowed.upper;
                return schema;
              }};
}

/// Neighbours of one name share its list.
Json methods_json(const Draft& problem, Binding::Row) {
  Json list = Json::array();
  const auto add = [&](const char* name, const Json& item) {
    const bool shared = !list.empty() && list.back().contains(name);
    if (!shared) list.push_back({{name, Json::array()}});
    list.back()[name].push_back(item);
  };
  for (const ComparedMethod& method : problem.work_precision.methods) {
    const auto name = kNames[method.kind];
    if (method.kind == Kind::RollingTime) {
      add("rolling_time", method.degree);
    } else if (method.kind == Kind::DiscreteSystem) {
      add("fsolve", kArms[method.arm]);
    } else {
      list.push_back(name);
    }
  }
  return list;
}

Json methods_schema() {
  const auto list = [](std::string_view name, const Json& items) {
    return map_schema({{name, list_schema(items)}}, std::array{name});
  };
  return {{"anyOf",
           {{{"enum", kNames.values}},
            list("rolling_time", {{"type", "integer"},
                                  {"minimum", kDegrees.lower},
                                  {"maximum", kDegrees.upper}}),
            list("fsolve", {{"enum", kArms.values}})}}};
}

}  // namespace

Binding methods_list() {
  return {.type = KeyType::List,
          .echo = methods_json,
          .read_list = read_methods,
          .items = methods_schema};
}

Binding meshes_list() {
  return numbers_list<&WorkPrecisionPlan::meshes, kMeshes, std::less<>>();
}

Binding tolerances_list() {
  return numbers_list<&WorkPrecisionPlan::tolerances, kTolerances,
                      std::greater<>>();
}

}  // namespace brachisto::io
