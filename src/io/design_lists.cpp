// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/design_lists.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "io/field_reader.hpp"
#include "io/visible_text.hpp"

namespace brachisto::io {

namespace {

constexpr double kMostOfADirection = std::numbers::pi;

std::vector<std::string_view> free_names() {
  std::vector<std::string_view> names;
  for (const BodyKey key : kBodyKeys) names.push_back(name(key));
  return names;
}

void read_free(Draft& problem, const KeySpec& spec, const YamlValue& list,
               Findings& findings) {
  std::vector<BodyKey> free;
  const std::string key(spec.path), wanted = expected(spec);
  for_each_item(list, key, wanted, findings, [&](const YamlValue& item) {
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
  problem.design.free = std::move(free);
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
          .get =
              [](const Draft& p) {
                Json list = Json::array();
                for (const BodyKey key : p.design.free) {
                  list.push_back(name(key));
                }
                return list;
              },
          .read_list = read_free,
          .items =
              [] {
                return Json{{"enum", free_names()}};
              }};
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
  if (problem.design.free.empty() && !findings.concern("design.free")) return;
  check_ways(root, problem, findings);
  check_bounds(root, problem, findings);
  check_radius(root, problem, findings);
}

}  // namespace brachisto::io
