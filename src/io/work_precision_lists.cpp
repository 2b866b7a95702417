// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/work_precision_lists.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "io/field_reader.hpp"
#include "io/visible_text.hpp"
#include "io/yaml_tree.hpp"
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

constexpr EnumTable<Kind, std::string_view, 5> kNamed{
    {"rolling_time", "adaptive", "arc_length", "extremal", "fsolve"}};
constexpr const auto& kNames = kNamed.values;
using Arm = std::pair<std::string_view, DiscreteArm>;
constexpr std::array<Arm, 4> kArms{{{"rest", DiscreteArm::Rest},
                                    {"release", DiscreteArm::Release},
                                    {"newton", DiscreteArm::Newton},
                                    {"lifted", DiscreteArm::Lifted}}};

/// What a name alone stands for.
Methods methods_of(std::string_view name) {
  Methods methods;
  for (const ComparedMethod& method : WorkPrecisionPlan{}.methods) {
    if (kNamed[method.kind] == name) {
      methods.push_back(method);
    }
  }
  return methods;
}

template <class Value>
constexpr KeyType kTypeOf =
    std::is_integral_v<Value> ? KeyType::Integer : KeyType::Number;

/// An item that is a number within an interval; otherwise nothing, and
/// reported.
template <class Value>
std::optional<Value> number_in(const YamlValue& item, const Interval& interval,
                               const std::string& key,
                               std::string_view expected, Findings& findings) {
  if (item.kind != YamlValue::Kind::Scalar) {
    refuse_kind(item, key, expected, findings);
    return std::nullopt;
  }
  const auto value =
      read_number(item, key, kTypeOf<Value>, interval, expected, findings);
  return value ? std::optional(static_cast<Value>(*value)) : std::nullopt;
}

class MethodsReader {
 public:
  MethodsReader(const KeySpec& spec, Findings& findings)
      : key_(spec.path), expected_(expected(spec)), findings_(findings) {}

  [[nodiscard]] Methods read(const YamlValue& list) {
    for_each_item(list, key_, expected_, findings_,
                  [&](const YamlValue& item) { read_item(item); });
    return std::move(methods_);
  }

 private:
  void read_item(const YamlValue& item) {
    const bool named_list =
        item.kind == YamlValue::Kind::Map && item.entries.size() == 1;
    if (named_list) return read_named(item.entries.front());
    if (item.kind != YamlValue::Kind::Scalar) {
      return refuse_kind(item, key_, expected_, findings_);
    }
    if (!is_name(item.text, item.position)) return;
    add(methods_of(item.text), item, key_, expected_);
  }

  [[nodiscard]] bool is_name(const std::string& word, Position position) const {
    if (std::ranges::count(kNames, word) > 0) return true;
    findings_.add(position, key_, unknown_word(word, expected_, kNames));
    return false;
  }

  void read_named(const Entry& entry) {
    if (!is_name(entry.key, entry.position)) return;
    const std::string key = fmt::format("{}.{}", key_, entry.key);
    if (entry.key == "rolling_time") {
      for_each_item(entry.value, key, kExpectedDegrees, findings_,
                    [&](const YamlValue& item) {
                      const auto degree = number_in<int>(
                          item, kDegrees, key, kExpectedDegrees, findings_);
                      if (degree) {
                        add({rolling_time(*degree)}, item, key,
                            kExpectedDegrees);
                      }
                    });
    } else if (entry.key == "fsolve") {
      read_arms(entry.value, key);
    } else {
      findings_.add(entry.position, key,
                    fmt::format("{} has no list; expected {} alone", entry.key,
                                entry.key));
    }
  }

  void read_arms(const YamlValue& list, const std::string& key) {
    std::vector<std::string_view> names;
    for (const auto& [name, arm] : kArms) names.push_back(name);
    const std::string expected =
        fmt::format("a list of {}", fmt::join(names, ", "));
    for_each_item(list, key, expected, findings_, [&](const YamlValue& item) {
      const auto found = std::ranges::find(kArms, item.text, &Arm::first);
      if (item.kind != YamlValue::Kind::Scalar) {
        refuse_kind(item, key, expected, findings_);
      } else if (found == kArms.end()) {
        findings_.add(item.position, key,
                      unknown_word(item.text, expected, names));
      } else {
        add({discrete_system(found->second)}, item, key, expected);
      }
    });
  }

  /// A line would be drawn over itself.
  void add(const Methods& methods, const YamlValue& item,
           const std::string& key, std::string_view expected) {
    const bool repeated = std::ranges::any_of(methods, [&](const auto& method) {
      return std::ranges::count(methods_, method) > 0;
    });
    if (repeated) {
      findings_.add(item.position, key,
                    fmt::format("{} is repeated; expected {}, each once",
                                in_quotes(item.text), expected));
    } else {
      methods_.insert(methods_.end(), methods.begin(), methods.end());
    }
  }

  std::string key_, expected_;
  Findings& findings_;
  Methods methods_;
};

void read_methods(Draft& problem, const KeySpec& spec, const YamlValue& list,
                  Findings& findings) {
  Methods methods = MethodsReader(spec, findings).read(list);
  if (!methods.empty()) problem.work_precision.methods = std::move(methods);
}

/// Numbers of a plan, each once, from coarse to fine.
template <auto kMember, const Interval& kAllowed, class Finer>
struct NumbersOf {
  using Value = typename std::remove_cvref_t<decltype(WorkPrecisionPlan{}.*
                                                      kMember)>::value_type;

  static void read(Draft& problem, const KeySpec& spec, const YamlValue& list,
                   Findings& findings) {
    std::vector<Value> numbers;
    const std::string key(spec.path), wanted = expected(spec);
    for_each_item(list, key, wanted, findings, [&](const YamlValue& item) {
      const auto number =
          number_in<Value>(item, kAllowed, key, wanted, findings);
      if (number && std::ranges::count(numbers, *number) > 0) {
        findings.add(item.position, key,
                     fmt::format("{} is repeated; expected {}, each once",
                                 *number, wanted));
      } else if (number) {
        numbers.push_back(*number);
      }
    });
    std::ranges::sort(numbers, Finer{});
    problem.work_precision.*kMember = std::move(numbers);
  }

  /// Readers of YAML 1.1 take 1e-4 for a text.
  static Json schema() {
    return {
        {"type", std::is_integral_v<Value> ? Json("integer")
                                           : Json::array({"number", "string"})},
        {"minimum", kAllowed.lower},
        {"maximum", kAllowed.upper}};
  }

  [[nodiscard]] static Binding list() {
    return {
        .type = KeyType::List,
        .get = [](const Draft& p) { return Json(p.work_precision.*kMember); },
        .read_list = read,
        .items = schema};
  }
};

/// Neighbours of one name share its list.
Json methods_json(const Draft& problem) {
  Json list = Json::array();
  const auto add = [&](const char* name, const Json& item) {
    const bool shared = !list.empty() && list.back().contains(name);
    if (!shared) list.push_back({{name, Json::array()}});
    list.back()[name].push_back(item);
  };
  for (const ComparedMethod& method : problem.work_precision.methods) {
    const auto name = kNamed[method.kind];
    if (method.kind == Kind::RollingTime) {
      add("rolling_time", method.degree);
    } else if (method.kind == Kind::DiscreteSystem) {
      add("fsolve", std::ranges::find(kArms, method.arm, &Arm::second)->first);
    } else {
      list.push_back(name);
    }
  }
  return list;
}

Json methods_schema() {
  Json arms = Json::array();
  for (const auto& [name, arm] : kArms) arms.push_back(name);
  const auto list = [](const char* name, const Json& items) {
    const Json of = {{"type", "array"}, {"items", items}, {"minItems", 1}};
    return Json{{"type", "object"},
                {"properties", {{name, of}}},
                {"required", {name}},
                {"additionalProperties", false}};
  };
  return {{"anyOf",
           {{{"enum", kNames}},
            list("rolling_time", {{"type", "integer"},
                                  {"minimum", kDegrees.lower},
                                  {"maximum", kDegrees.upper}}),
            list("fsolve", {{"enum", arms}})}}};
}

}  // namespace

Binding methods_list() {
  return {.type = KeyType::List,
          .get = methods_json,
          .read_list = read_methods,
          .items = methods_schema};
}

Binding meshes_list() {
  return NumbersOf<&WorkPrecisionPlan::meshes, kMeshes, std::less<>>::list();
}

Binding tolerances_list() {
  return NumbersOf<&WorkPrecisionPlan::tolerances, kTolerances,
                   std::greater<>>::list();
}

}  // namespace brachisto::io
