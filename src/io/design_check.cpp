// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/design_check.hpp"

#include <fmt/format.h>

#include <numbers>
#include <string>
#include <utility>

#include "brachisto/model/mass_distribution.hpp"
#include "io/body_parts.hpp"

namespace brachisto::io {

namespace {

constexpr double kLeastRoom = 1e-3;  // of the radius

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
void check_which_are_free(const YamlValue& root, const Draft& problem,
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
}

/// More than all directions mean nothing, and offsets within more than half of
/// them are no convex set.
void check_directions(const YamlValue& root, const Draft& problem,
                      Findings& findings) {
  constexpr double kPi = std::numbers::pi;
  const DesignPlan& plan = problem.design;
  const auto& angle = plan.bounds[static_cast<std::size_t>(BodyKey::ThetaM)];
  if (!angle) return;
  const double width = angle->upper - angle->lower;
  const std::string key = "design.bounds.theta_m";
  if (plan.is_free(BodyKey::EtaM) && width > kPi) {
    findings.add(position_of(root, key), key,
                 "more than half a turn is not allowed where eta_m is free "
                 "too: the offsets within are no convex set. Without bounds "
                 "all directions are allowed");
  } else if (width > 2.0 * kPi) {
    findings.add(position_of(root, key), key,
                 "more than a turn is not allowed: it has directions twice. "
                 "Without bounds all directions are allowed");
  }
}

/// A body has k ≤ 1 − η_m².
void check_rim(const YamlValue& root, const Draft& problem,
               Findings& findings) {
  const DesignPlan& plan = problem.design;
  const auto least = [&](BodyKey key, double of_body) {
    return plan.is_free(key) ? plan.bounds_of(key).lower : of_body;
  };
  const Body& body = problem.scene.body;
  const double eta_m = least(BodyKey::EtaM, body.eta_m);
  const double k = least(BodyKey::K, body.k);
  const auto stated = [&](BodyKey key) {
    return plan.is_free(key) &&
           plan.bounds[static_cast<std::size_t>(key)].has_value();
  };
  if (!stated(BodyKey::EtaM) && !stated(BodyKey::K)) return;
  if (k <= largest_k(eta_m) + kBoundSlack) return;
  const std::string key =
      stated(BodyKey::EtaM) ? "design.bounds.eta_m" : "design.bounds.k";
  findings.add(
      position_of(root, key), key,
      fmt::format("no body has η_m {} {:g} and k {} {:g}: k ≤ 1 − η_m² "
                  "= {:.6g}, reached when all mass sits on the rim",
                  plan.is_free(BodyKey::EtaM) ? "≥" : "=", eta_m,
                  plan.is_free(BodyKey::K) ? "≥" : "=", k, largest_k(eta_m)));
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
  if (plan.max_grip && !plan.require_feasible) {
    findings.add(position_of(root, "design.max_grip"), "design.max_grip",
                 "not allowed beside require_feasible: false, which takes "
                 "bodies that cannot run on their tracks");
  }
  check_which_are_free(root, problem, findings);
  check_directions(root, problem, findings);
  check_rim(root, problem, findings);
  check_radius(root, problem, findings);
}

}  // namespace brachisto::io
