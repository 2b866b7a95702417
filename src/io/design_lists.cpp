// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/design_lists.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "io/field_reader.hpp"
#include "io/visible_text.hpp"

namespace brachisto::io {

namespace {

std::vector<std::string_view> free_names() {
  std::vector<std::string_view> names;
  for (const BodyKey key : kBodyKeys) names.push_back(name(key));
  return names;
}

/// An item {part: 2, key: at}.
class FreePartReader {
 public:
  FreePartReader(Draft& problem, const KeySpec& spec, Findings& findings)
      : problem_(problem), key_(spec.path), findings_(findings) {}

  void read(const YamlValue& item) {
    const FieldReader fields(item, key_, item.position, findings_);
    fields.allow_only({"part", "key", "bounds"});
    const auto part = fields.integer("part", kParts, kExpectedPart);
    const std::string_view word = fields.word("key", {"at", "mass"});
    if (!part) return;
    FreePart free{static_cast<std::size_t>(*part) - 1, FreePart::Key::At, {}};
    if (word == "mass") free.key = FreePart::Key::Mass;
    const bool known =
        std::ranges::any_of(problem_.design.free_parts, [&](const auto& other) {
          return other.part == free.part && other.key == free.key;
        });
    if (known) fields.refuse("part", "this key of the part is free already");
    const Entry* bounds = item.find("bounds");
    if (free.key == FreePart::Key::At && bounds != nullptr) {
      fields.refuse("bounds",
                    "the place of a part has no bounds but the cylinder");
    } else if (free.key == FreePart::Key::Mass) {
      free.bounds = masses(bounds, item);
    }
    problem_.design.free_parts.push_back(free);
  }

 private:
  static constexpr Interval kParts{1, 1000};
  static constexpr std::string_view kExpectedPart =
      "the number of a part in scene.body.parts, from 1 on";
  static constexpr std::string_view kExpectedMasses =
      "bounds of the mass, two numbers > 0, the greater one last";

  [[nodiscard]] DesignBounds masses(const Entry* entry,
                                    const YamlValue& item) const {
    constexpr Interval kPositive{.lower = 0.0, .lower_allowed = false};
    const std::string key = key_ + ".bounds";
    std::vector<double> ends;
    if (entry != nullptr && entry->value.kind == YamlValue::Kind::List) {
      for (const YamlValue& end : entry->value.items) {
        if (end.kind != YamlValue::Kind::Scalar) continue;
        const auto value = read_number(end, key, KeyType::Number, kPositive,
                                       kExpectedMasses, findings_);
        if (value) ends.push_back(*value);
      }
    }
    if (ends.size() == 2 && ends[0] < ends[1]) return {ends[0], ends[1]};
    findings_.add(entry == nullptr ? item.position : entry->value.position, key,
                  fmt::format("expected {}", kExpectedMasses));
    return {};
  }

  Draft& problem_;
  std::string key_;
  Findings& findings_;
};

void read_free(Draft& problem, const KeySpec& spec, const YamlValue& list,
               Findings& findings) {
  problem.design.free.clear();
  problem.design.free_parts.clear();
  std::vector<BodyKey>& free = problem.design.free;
  const std::string key(spec.path), wanted = expected(spec);
  for_each_item(list, key, wanted, findings, [&](const YamlValue& item) {
    if (item.kind == YamlValue::Kind::Map) {
      return FreePartReader(problem, spec, findings).read(item);
    }
    if (item.kind != YamlValue::Kind::Scalar) {
      return refuse_kind(item, key, wanted, findings);
    }
    const auto named = std::ranges::find_if(
        kBodyKeys, [&](BodyKey one) { return name(one) == item.text; });
    if (named == kBodyKeys.end()) {
      findings.add(item.position, key,
                   unknown_word(item.text, wanted, free_names()));
    } else if (std::ranges::count(free, *named) > 0) {
      findings.add(item.position, key,
                   fmt::format("{} is repeated; expected {}",
                               in_quotes(item.text), wanted));
    } else {
      free.push_back(*named);
    }
  });
}

Json free_json(const Draft& problem) {
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

Json free_schema() {
  const Json number = {{"type", {"number", "string"}}};
  return {{"anyOf",
           {{{"enum", free_names()}},
            {{"type", "object"},
             {"properties",
              {{"part", {{"type", "integer"}, {"minimum", 1}}},
               {"key", {{"enum", {"at", "mass"}}}},
               {"bounds",
                {{"type", "array"},
                 {"items", number},
                 {"minItems", 2},
                 {"maxItems", 2}}}}},
             {"required", {"part"}},
             {"additionalProperties", false}}}}};
}

/// What a body may have, for the bounds of a design.
Interval allowed(BodyKey key) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  switch (key) {
    case BodyKey::EtaM:
      return {.lower = 0.0, .upper = 1.0, .upper_allowed = false};
    case BodyKey::ThetaM:
      return {-2.0 * std::numbers::pi, 2.0 * std::numbers::pi};
    case BodyKey::K:
      return {0.0, 1.0};
    case BodyKey::Radius:
      return {.lower = 0.0, .upper = kInfinity, .lower_allowed = false};
  }
  return {};
}

template <BodyKey key>
void read_bounds(Draft& problem, const KeySpec& spec, const YamlValue& list,
                 Findings& findings) {
  const std::string path(spec.path), wanted = expected(spec);
  const bool angle = key == BodyKey::ThetaM;
  std::vector<double> ends;
  for_each_item(list, path, wanted, findings, [&](const YamlValue& item) {
    if (item.kind != YamlValue::Kind::Scalar) {
      return refuse_kind(item, path, wanted, findings);
    }
    const auto value = read_number(
        item, path, angle ? KeyType::Angle : KeyType::Number, allowed(key),
        wanted, findings, [&](const std::string& text) {
          return evaluate(text, angle ? Unit::Angle : Unit::None);
        });
    if (value) ends.push_back(*value);
  });
  if (list.kind != YamlValue::Kind::List || findings.concern(path)) return;
  if (list.items.size() != 2) {
    findings.add(list.position, path,
                 fmt::format("{} values were read; expected {}",
                             list.items.size(), wanted));
  } else if (!(ends[0] < ends[1])) {
    findings.add(list.position, path,
                 fmt::format("from {:g} to {:g} is no room; expected {}, the "
                             "greater one last. What has one value belongs in "
                             "scene.body and is not free",
                             ends[0], ends[1], wanted));
  } else {
    problem.design.bounds[static_cast<std::size_t>(key)] = {ends[0], ends[1]};
  }
}

template <BodyKey key>
Binding bounds_of() {
  return {.type = KeyType::List,
          .get =
              [](const Draft& p) {
                const auto& bounds =
                    p.design.bounds[static_cast<std::size_t>(key)];
                return bounds ? Json::array({bounds->lower, bounds->upper})
                              : Json();
              },
          .read_list = read_bounds<key>,
          .items =
              [] {
                // Readers of YAML 1.1 take 1e-4 for a text, and expressions
                // are.
                return Json{{"type", {"number", "string"}}};
              }};
}

}  // namespace

Binding free_list() {
  return {.type = KeyType::List,
          .get = free_json,
          .read_list = read_free,
          .items = free_schema};
}

Binding bounds_list(BodyKey key) {
  switch (key) {
    case BodyKey::EtaM:
      return bounds_of<BodyKey::EtaM>();
    case BodyKey::ThetaM:
      return bounds_of<BodyKey::ThetaM>();
    case BodyKey::K:
      return bounds_of<BodyKey::K>();
    case BodyKey::Radius:
      return bounds_of<BodyKey::Radius>();
  }
  return {};
}

}  // namespace brachisto::io
