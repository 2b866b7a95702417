// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/work_precision_lists.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "io/expression.hpp"
#include "io/visible_text.hpp"
#include "io/yaml_tree.hpp"

namespace brachisto::io {

namespace {

using Kind = ComparedMethod::Kind;
using Methods = std::vector<ComparedMethod>;

constexpr Interval kDegrees{kMinDegree, kMaxDegree};
constexpr std::string_view kExpectedDegrees =
    "a list of degrees, integers from 1 to 8";
constexpr Interval kMeshes{2, 1'000'000};

constexpr std::array<std::string_view, 4> kNames{"rolling_time", "arc_length",
                                                 "extremal", "fsolve"};
using Arm = std::pair<std::string_view, DiscreteArm>;
constexpr std::array<Arm, 4> kArms{{{"rest", DiscreteArm::Rest},
                                    {"release", DiscreteArm::Release},
                                    {"newton", DiscreteArm::Newton},
                                    {"lifted", DiscreteArm::Lifted}}};

/// What a name alone stands for.
Methods methods_of(std::string_view name) {
  Methods methods;
  for (const ComparedMethod& method : WorkPrecisionPlan{}.methods) {
    if (kNames[static_cast<std::size_t>(method.kind)] == name) {
      methods.push_back(method);
    }
  }
  return methods;
}

/// Reads lists whose items are all of one sort.
class ListReader {
 public:
  ListReader(std::string key, std::string expected, Findings& findings)
      : key_(std::move(key)),
        expected_(std::move(expected)),
        findings_(findings) {}

  /// True if it is a list with an item at least.
  [[nodiscard]] bool accepts(const YamlValue& list) const {
    if (list.kind == YamlValue::Kind::Refused) return false;
    if (list.kind == YamlValue::Kind::List && !list.items.empty()) return true;
    refuse(list.position,
           fmt::format("{} was read", list.kind == YamlValue::Kind::List
                                          ? "an empty list"
                                          : kind_name(list.kind)));
    return false;
  }

  void refuse(Position position, std::string_view what,
              std::string_view hint = "") const {
    findings_.add(position, key_,
                  fmt::format("{}; expected {}{}", what, expected_, hint));
  }

  /// True if an item is one value; otherwise reported.
  [[nodiscard]] bool is_scalar(const YamlValue& item) const {
    if (item.kind == YamlValue::Kind::Scalar) return true;
    if (item.kind != YamlValue::Kind::Refused) {
      refuse(item.position, fmt::format("{} was read", kind_name(item.kind)));
    }
    return false;
  }

  /// An item that is an integer within an interval; otherwise nothing, and
  /// reported.
  [[nodiscard]] std::optional<int> integer(const YamlValue& item,
                                           Interval interval) const {
    if (!is_scalar(item)) return std::nullopt;
    try {
      const double value = evaluate(item.text);
      const bool integral = value == std::trunc(value);
      if (integral && interval.contains(value)) return static_cast<int>(value);
      refuse(item.position, fmt::format("{} is not {}", in_quotes(item.text),
                                        integral ? "allowed" : "an integer"));
    } catch (const ExpressionError& error) {
      refuse(item.position, fmt::format("{} is not a number: {}",
                                        in_quotes(item.text), error.what()));
    }
    return std::nullopt;
  }

 private:
  std::string key_, expected_;
  Findings& findings_;
};

class MethodsReader {
 public:
  MethodsReader(const KeySpec& spec, Findings& findings)
      : key_(spec.path),
        findings_(findings),
        list_(key_, expected(spec), findings) {}

  [[nodiscard]] Methods read(const YamlValue& list) {
    if (!list_.accepts(list)) return {};
    for (const YamlValue& item : list.items) read_item(item);
    return std::move(methods_);
  }

 private:
  void read_item(const YamlValue& item) {
    const bool named_list =
        item.kind == YamlValue::Kind::Map && item.entries.size() == 1;
    if (named_list) return read_named(item.entries.front());
    if (!list_.is_scalar(item) || !is_name(item.text, item.position)) return;
    for (const ComparedMethod& method : methods_of(item.text)) {
      add(method, item.position, item.text);
    }
  }

  [[nodiscard]] bool is_name(const std::string& word, Position position) const {
    if (std::ranges::count(kNames, word) > 0) return true;
    list_.refuse(position, fmt::format("{} was read", in_quotes(word)),
                 suggestion(word, kNames));
    return false;
  }

  void read_named(const Entry& entry) {
    if (!is_name(entry.key, entry.position)) return;
    if (entry.key == "rolling_time") return read_degrees(entry);
    if (entry.key == "fsolve") return read_arms(entry);
    findings_.add(
        entry.position, key_of(entry),
        fmt::format("{} has no list; expected {} alone", entry.key, entry.key));
  }

  void read_degrees(const Entry& entry) {
    const ListReader degrees(key_of(entry), std::string(kExpectedDegrees),
                             findings_);
    if (!degrees.accepts(entry.value)) return;
    for (const YamlValue& item : entry.value.items) {
      if (const auto degree = degrees.integer(item, kDegrees)) {
        add(rolling_time(*degree), item.position, item.text);
      }
    }
  }

  void read_arms(const Entry& entry) {
    std::vector<std::string_view> names;
    for (const auto& [name, arm] : kArms) names.push_back(name);
    const ListReader arms(key_of(entry),
                          fmt::format("a list of {}", fmt::join(names, ", ")),
                          findings_);
    if (!arms.accepts(entry.value)) return;
    for (const YamlValue& item : entry.value.items) {
      if (!arms.is_scalar(item)) continue;
      const auto found = std::ranges::find(names, item.text);
      if (found == names.end()) {
        arms.refuse(item.position,
                    fmt::format("{} was read", in_quotes(item.text)),
                    suggestion(item.text, names));
      } else {
        add(discrete_system(
                kArms[static_cast<std::size_t>(found - names.begin())].second),
            item.position, item.text);
      }
    }
  }

  /// A line would be drawn over itself.
  void add(const ComparedMethod& method, Position position,
           std::string_view text) {
    if (std::ranges::count(methods_, method) > 0) {
      findings_.add(position, key_,
                    fmt::format("{} is repeated", in_quotes(text)));
    } else {
      methods_.push_back(method);
    }
  }

  [[nodiscard]] std::string key_of(const Entry& entry) const {
    return fmt::format("{}.{}", key_, entry.key);
  }

  std::string key_;
  Findings& findings_;
  ListReader list_;
  Methods methods_;
};

void read_methods(Draft& problem, const KeySpec& spec, const YamlValue& list,
                  Findings& findings) {
  Methods methods = MethodsReader(spec, findings).read(list);
  if (!methods.empty()) problem.work_precision.methods = std::move(methods);
}

void read_meshes(Draft& problem, const KeySpec& spec, const YamlValue& list,
                 Findings& findings) {
  const ListReader reader(std::string(spec.path), expected(spec), findings);
  if (!reader.accepts(list)) return;
  std::vector<int> meshes;
  for (const YamlValue& item : list.items) {
    const std::optional<int> mesh = reader.integer(item, kMeshes);
    if (mesh && std::ranges::count(meshes, *mesh) > 0) {
      findings.add(item.position, std::string(spec.path),
                   fmt::format("{} is repeated", *mesh));
    } else if (mesh) {
      meshes.push_back(*mesh);
    }
  }
  std::ranges::sort(meshes);
  problem.work_precision.meshes = std::move(meshes);
}

/// Neighbours of one name share its list.
Json methods_json(const Draft& problem) {
  Json list = Json::array();
  const auto add = [&](const char* name, const Json& item) {
    const bool shared = !list.empty() && list.back().contains(name);
    if (!shared) list.push_back({{name, Json::array()}});
    list.back()[name].push_back(item);
  };
  for (const ComparedMethod& method : problem.work_precision.methods) {
    const auto name = kNames[static_cast<std::size_t>(method.kind)];
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
  return {.type = KeyType::List,
          .get = [](const Draft& p) { return Json(p.work_precision.meshes); },
          .read_list = read_meshes,
          .items =
              [] {
                return Json{{"type", "integer"},
                            {"minimum", kMeshes.lower},
                            {"maximum", kMeshes.upper}};
              }};
}

}  // namespace brachisto::io
