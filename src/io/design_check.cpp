// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/check.hpp"

#include <fmt/format.h>

#include <numbers>
#include <string_view>

#include "brachisto/model/body.hpp"
#include "io/body_parts.hpp"

namespace brachisto::io {

namespace {

constexpr double kLeastRoom = 1e-3;  // of the radius

void check_ways(const Check& check) {
  const Draft& problem = check.problem;
  if (!problem.scene.body.rolls()) {
    check.refuse("scene.body.shape",
                 "a bead has nothing to design; take a cylinder");
  } else if (problem.scene.body.shape == Shape::Ball) {
    check.refuse("scene.body.shape",
                 "a ball has the track that its rails fit, and nothing to "
                 "design; take a cylinder");
  }
  const auto refuse = [&](std::string_view key, std::string_view reason) {
    check.refuse(key, "not allowed beside design: {}", reason);
  };
  if (problem.scene.path) {
    refuse("scene.path", "each body has the track that is its fastest");
  }
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
  if (problem.program.certify == Certify::Proof) {
    refuse("solver.certify",
           "a proof is of one body; take `brachisto prove DIR` on the result");
  }
}

/// Free parts are parts that can move, and nothing else is free beside them.
void check_free_parts(const Check& check) {
  constexpr std::string_view kFree = "design.free";
  const DesignPlan& plan = check.problem.design;
  if (plan.free_parts.empty()) {
    if (plan.parts.empty()) return;
    return check.refuse(
        kFree,
        "of a body of parts, parts are free, as in {{part: 2, key: at}}");
  }
  if (!plan.free.empty()) {
    check.refuse(kFree,
                 "{} follows from the parts and cannot be free beside them",
                 name(plan.free.front()));
  }
  const double radius = check.problem.scene.body.radius;
  for (const FreePart& free : plan.free_parts) {
    const std::size_t number = free.part + 1;
    if (number > plan.parts.size()) {
      check.refuse(kFree, "there is no part {}; scene.body.parts has {}",
                   number, plan.parts.size());
      continue;
    }
    if (free.key != FreePart::Key::At) continue;
    const MassPart& part = plan.parts[free.part];
    if (part.name.starts_with("rod")) {
      check.refuse(kFree, "part {} is a rod, whose place is not one point",
                   number);
    } else if (!(radius - part.extent() > kLeastRoom * radius)) {
      check.refuse(kFree, "part {} fills the cylinder and cannot move", number);
    }
  }
}

/// Bounds of keys that are not free, and free keys that need some.
void check_which_are_free(const Check& check) {
  const DesignPlan& plan = check.problem.design;
  for (const BodyKey key : kBodyKeys) {
    if (plan.bounds[static_cast<std::size_t>(key)] && !plan.is_free(key)) {
      check.refuse(fmt::format("design.bounds.{}", name(key)),
                   "{} is not free; add it to design.free, or leave its bounds "
                   "out",
                   name(key));
    }
  }
}

/// More than all directions mean nothing, and offsets within more than half of
/// them are no convex set.
void check_directions(const Check& check) {
  constexpr double kPi = std::numbers::pi;
  const DesignPlan& plan = check.problem.design;
  const auto& angle = plan.bounds[static_cast<std::size_t>(BodyKey::ThetaM)];
  if (!angle) return;
  const double width = angle->upper - angle->lower;
  constexpr std::string_view kKey = "design.bounds.theta_m";
  if (plan.is_free(BodyKey::EtaM) && width > kPi) {
    check.refuse(kKey,
                 "more than half a turn is not allowed where eta_m is free "
                 "too: the offsets within are no convex set. Without bounds "
                 "all directions are allowed");
  } else if (width > 2.0 * kPi) {
    check.refuse(kKey,
                 "more than a turn is not allowed: it has directions twice. "
                 "Without bounds all directions are allowed");
  }
}

/// A body has k ≤ 1 − η_m², and more than one η_m or k has to be left.
void check_rim(const Check& check) {
  const DesignPlan& plan = check.problem.design;
  const bool any_eta = plan.is_free(BodyKey::EtaM);
  const bool any_k = plan.is_free(BodyKey::K);
  if (!any_eta && !any_k) return;
  const Body& body = check.problem.scene.body;
  const double eta_m =
      any_eta ? plan.bounds_of(BodyKey::EtaM).lower : body.eta_m;
  const double k = any_k ? plan.bounds_of(BodyKey::K).lower : body.k;
  const double room = largest_k(eta_m) - k;
  if (room > kBoundSlack) return;
  const auto stated = [&](BodyKey key) {
    return plan.is_free(key) &&
           plan.bounds[static_cast<std::size_t>(key)].has_value();
  };
  check.refuse(
      stated(BodyKey::EtaM) ? "design.bounds.eta_m"
      : stated(BodyKey::K)  ? "design.bounds.k"
                            : "design.free",
      "{} η_m {} {:g} and k {} {:g}: k ≤ 1 − η_m² = {:.6g}, reached "
      "when all mass sits on the rim{}",
      room < -kBoundSlack ? "no body has" : "one pair of both alone has",
      any_eta ? "≥" : "=", eta_m, any_k ? "≥" : "=", k, largest_k(eta_m),
      room < -kBoundSlack
          ? ""
          : "; leave them out of design.free, or give them room");
}

/// τ → 0 as B comes to lie on the body at its start.
void check_radius(const Check& check) {
  const DesignPlan& plan = check.problem.design;
  if (!plan.is_free(BodyKey::Radius)) return;
  const Scene& scene = check.problem.scene;
  const double largest =
      (scene.L * scene.L + scene.H * scene.H) / (2.0 * scene.L);
  const auto& stated = plan.bounds[static_cast<std::size_t>(BodyKey::Radius)];
  if (stated && !(stated->upper >= largest)) return;
  check.refuse(
      "design.bounds.r",
      "{}; a free radius needs an upper bound below (L² + H²)/(2L) = {:.6g} m: "
      "as r grows to that, B comes to lie on the body at its start and τ falls "
      "to 0, so that there is no quickest body",
      stated ? fmt::format("{:g} m is not allowed", stated->upper) : "missing",
      largest);
}

}  // namespace

void check_design(const Check& check) {
  const DesignPlan& plan = check.problem.design;
  if (check.entry("design") == nullptr || plan.empty()) return;
  check_ways(check);
  if (!check.findings.concern(kPartsKey) &&
      !check.findings.concern("scene.body.radius")) {
    check_free_parts(check);
  }
  if (plan.start && *plan.start > plan.starts) {
    check.refuse("design.start", "{} is not allowed; there are {} starts",
                 *plan.start, plan.starts);
  }
  if (plan.max_grip && !plan.require_feasible) {
    check.refuse("design.max_grip",
                 "not allowed beside require_feasible: false, which takes "
                 "bodies that cannot run on their tracks");
  }
  check_which_are_free(check);
  check_directions(check);
  check_rim(check);
  check_radius(check);
}

}  // namespace brachisto::io
