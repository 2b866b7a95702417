// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/design_lists.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "brachisto/model/mass_distribution.hpp"
#include "io/field_reader.hpp"
#include "io/mass_part_text.hpp"
#include "io/visible_text.hpp"

namespace brachisto::io {

namespace {

constexpr double kMostOfADirection = std::numbers::pi;
constexpr double kLeastRoom = 1e-3;  // of the radius

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

constexpr const char* kPartsKey = "scene.body.parts";

/// Texts, which stand for parts until the radius is known.
void read_parts(Draft& problem, const KeySpec& spec, const YamlValue& list,
                Findings& findings) {
  const std::string key(spec.path), wanted = expected(spec);
  problem.design.parts.clear();
  for_each_item(list, key, wanted, findings, [&](const YamlValue& item) {
    if (item.kind != YamlValue::Kind::Scalar) {
      return refuse_kind(item, key, wanted, findings);
    }
    problem.design.parts.emplace_back().name = item.text;
  });
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

void check_ways(const YamlValue& root, const Draft& problem,
                Findings& findings) {
  if (!problem.scene.body.rolls()) {
    findings.add(position_of(root, "scene.body.shape"), "scene.body.shape",
                 "a bead has nothing to design; take a cylinder");
  }
  if (problem.scene.path) {
    findings.add(position_of(root, "scene.path"), "scene.path",
                 "not allowed beside design: each body has the track that is "
                 "its fastest");
  }
  const auto refuse = [&](std::string_view key, std::string_view reason) {
    findings.add(position_of(root, key), std::string(key),
                 fmt::format("not allowed beside design: {}", reason));
  };
  if (!problem.poses_the_program()) {
    return refuse("solver.method",
                  "a design needs the derivatives of the nonlinear program; "
                  "take method: ipopt");
  }
  if (problem.of_pieces()) {
    refuse("discretisation.formulation",
           "a design needs more digits than straight pieces have");
  }
  if (problem.program.search == Search::Global) {
    refuse("solver.search",
           "a design follows the principal branch; the search that global "
           "makes for one body can be made for the best one");
  }
}

/// Free parts are parts that can move, and nothing else is free beside them.
void check_free_parts(const YamlValue& root, const Draft& problem,
                      Findings& findings) {
  const DesignPlan& plan = problem.design;
  const auto refuse = [&](std::string message) {
    findings.add(position_of(root, "design.free"), "design.free",
                 std::move(message));
  };
  if (plan.free_parts.empty()) {
    if (!plan.parts.empty()) {
      refuse("of a body of parts, parts are free, as in {part: 2, key: at}");
    }
    return;
  }
  if (!plan.free.empty()) {
    refuse(
        fmt::format("{} follows from the parts and cannot be free beside "
                    "them",
                    name(plan.free.front())));
  }
  for (const FreePart& free : plan.free_parts) {
    if (free.part >= plan.parts.size()) {
      refuse(fmt::format("there is no part {}; scene.body.parts has {}",
                         free.part + 1, plan.parts.size()));
      continue;
    }
    if (free.key != FreePart::Key::At) continue;
    const MassPart& part = plan.parts[free.part];
    if (part.name.starts_with("rod")) {
      refuse(fmt::format("part {} is a rod, whose place is not one point",
                         free.part + 1));
    } else if (!(problem.scene.body.radius - part.extent() >
                 kLeastRoom * problem.scene.body.radius)) {
      refuse(fmt::format("part {} fills the cylinder and cannot move",
                         free.part + 1));
    }
  }
}

/// Bounds of keys that are not free, and free keys that need some.
void check_bounds(const YamlValue& root, const Draft& problem,
                  Findings& findings) {
  const DesignPlan& plan = problem.design;
  for (const BodyKey key : kBodyKeys) {
    const std::string path = fmt::format("design.bounds.{}", name(key));
    if (plan.bounds[static_cast<std::size_t>(key)] && !plan.is_free(key)) {
      findings.add(position_of(root, path), path,
                   fmt::format("{} is not free; add it to design.free, or "
                               "leave its bounds out",
                               name(key)));
    }
  }
  const auto& angle = plan.bounds[static_cast<std::size_t>(BodyKey::ThetaM)];
  if (angle && plan.is_free(BodyKey::EtaM) &&
      angle->upper - angle->lower > kMostOfADirection) {
    findings.add(position_of(root, "design.bounds.theta_m"),
                 "design.bounds.theta_m",
                 "more than half a turn is not allowed where eta_m is free "
                 "too: the offsets within are no convex set. Without bounds "
                 "all directions are allowed");
  }
}

/// τ → 0 as B comes to lie on the body at its start.
void check_radius(const YamlValue& root, const Draft& problem,
                  Findings& findings) {
  const DesignPlan& plan = problem.design;
  if (!plan.is_free(BodyKey::Radius)) return;
  const Scene& scene = problem.scene;
  const double largest =
      (scene.L * scene.L + scene.H * scene.H) / (2.0 * scene.L);
  const auto& stated = plan.bounds[static_cast<std::size_t>(BodyKey::Radius)];
  if (stated && !(stated->upper >= largest)) return;
  const std::string path = "design.bounds.r";
  findings.add(
      position_of(root, path), path,
      fmt::format("{}; a free radius needs an upper bound below (L² + H²)/(2L) "
                  "= {:.6g} m: as r grows to that, B comes to lie on the body "
                  "at its start and τ falls to 0, so that there is no quickest "
                  "body",
                  stated ? fmt::format("{:g} m is not allowed", stated->upper)
                         : "missing",
                  largest));
}

}  // namespace

Binding free_list() {
  return {.type = KeyType::List,
          .get = free_json,
          .read_list = read_free,
          .items = free_schema};
}

Binding parts_list() {
  // Not echoed: eta_m, theta_m and k say what matters of them.
  return {.type = KeyType::List, .read_list = read_parts, .items = [] {
            return Json{{"type", "string"}};
          }};
}

void read_body_parts(const YamlValue& root, Draft& problem,
                     Findings& findings) {
  const Entry* entry = find_entry(root, kPartsKey);
  if (entry == nullptr || findings.concern(kPartsKey)) return;
  const auto refuse = [&](std::string_view key, const std::string& message) {
    findings.add(position_of(root, key), std::string(key), message);
  };
  for (const KeySpec& spec : key_table()) {
    if (!follows_from_parts(spec) || find_entry(root, spec.path) == nullptr) {
      continue;
    }
    refuse(spec.path, "not allowed beside parts, from which it follows");
  }
  constexpr const char* kRadiusKey = "scene.body.radius";
  const Entry* radius = find_entry(root, kRadiusKey);
  if (radius == nullptr || findings.concern(kRadiusKey)) return;
  if (radius->value.kind == YamlValue::Kind::Refused) {
    return refuse(kPartsKey,
                  "a body of parts has one radius, which cannot "
                  "vary");
  }
  Body& body = problem.scene.body;
  std::vector<MassPart>& parts = problem.design.parts;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string text = parts[i].name;
    try {
      parts[i] = read_mass_part(text, body.radius);
    } catch (const std::invalid_argument& error) {
      findings.add(entry->value.items[i].position, kPartsKey,
                   fmt::format("{}: {}", text, error.what()));
    }
  }
  if (findings.concern(kPartsKey)) return;
  try {
    const MassProperties found = mass_properties(parts, body.radius);
    body.eta_m = found.eta_m;
    body.theta_m = found.theta_m;
    body.k = found.k;
  } catch (const std::invalid_argument& error) {
    refuse(kPartsKey, error.what());
  }
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

void check_design(const YamlValue& root, const Draft& problem,
                  Findings& findings) {
  if (find_entry(root, "design") == nullptr) return;
  if (problem.design.empty()) return;
  check_ways(root, problem, findings);
  if (!findings.concern(kPartsKey) && !findings.concern("scene.body.radius")) {
    check_free_parts(root, problem, findings);
  }
  const DesignPlan& plan = problem.design;
  if (plan.start && *plan.start > plan.starts) {
    findings.add(position_of(root, "design.start"), "design.start",
                 fmt::format("{} is not allowed; there are {} starts",
                             *plan.start, plan.starts));
  }
  check_bounds(root, problem, findings);
  check_radius(root, problem, findings);
}

}  // namespace brachisto::io
