// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/limit_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brachisto {

namespace {

using Kind = PathInequality::Kind;
using Inequalities = std::vector<PathInequality>;
using Of = CurvatureLimit::Of;
using Number = std::optional<double>;

constexpr double kNoBound = std::numeric_limits<double>::infinity();

/// The factor by which loosened bounds grow.
double looser(double by) {
  constexpr double kTimes = 20.0;
  return std::pow(kTimes, by);
}

constexpr double kWeights = 2.0;  // by which loosened least loads differ

const char* kappa(const PathLimits& limits) {
  return limits.curvature.of == Of::Track ? "κ_b" : "κ_c";
}

double curvature(const Scene& scene, const Kinematics& motion) {
  return scene.limits.curvature.of == Of::Centre
             ? curvature_of_centre(scene.body, motion)
             : motion.kappa_b;
}

/// Whether the fold margin is sharper than the bound on the hump.
bool folds_first(const Scene& scene) {
  PathLimits unfolded = scene.limits;
  unfolded.fold_margin.reset();
  return hump_of_centre(scene.body, scene.limits) <
         hump_of_centre(scene.body, unfolded);
}

constexpr const char* kStraight = "for with 0 only straight tracks are left";

constexpr LimitEntry kFrictionEntry{
    .key = "scene.limits.friction",
    .meaning =
        "μ, coefficient of friction: R_t from −μ R_n to μ R_n; of a ball "
        "R_n R/r_e, which its walls press in sum, stands for R_n",
    .allowed = Allowed::Positive,
    .reason = "for it is friction that turns the body",
    .bound_in = [](PathLimits& l) -> Number& { return l.friction; },
    .words =
        [](const PathLimits&, double mu) {
          return BoundInWords{"|R_t|", "≤", mu, "R_n"};
        },
    .slack =
        [](const Scene& scene, double mu, Point, const Kinematics& motion) {
          return mu * scene.body.wall_ratio * motion.R_n - std::abs(motion.R_t);
        },
    .is = [](const Scene&, Kind kind,
             bool) { return kind <= Kind::FrictionBackward; },
    .loosened = [](const Scene&, double mu,
                   double by) { return mu * looser(by); },
    .pose =
        [](const Body& body, const PathLimits& limits, Inequalities& all) {
          if (!limits.friction) return;
          for (const Kind kind :
               {Kind::FrictionForward, Kind::FrictionBackward}) {
            all.push_back(
                {.kind = kind, .number = *limits.friction * body.wall_ratio});
          }
        },
    .widen =
        [](const Scene&, const FreePath& free, PathInequality& limit) {
          constexpr double kGreatFriction = 20.0;
          limit.number = std::max(limit.number, kGreatFriction);
          // Where the free extremal lifts off no friction is enough.
          limit.lower =
              std::min(limit.lower, limit.scale() * limit.number *
                                        (std::min(0.0, free.min_normal) * 1.2));
          return true;
        },
    .looser = "a larger friction"};

constexpr LimitEntry kLeastForceEntry{
    .key = "scene.limits.normal_force.min",
    .meaning = "R_n ≥ this",
    .unit = "m g",
    .allowed = Allowed::Any,
    .bound_in = [](PathLimits& l) -> Number& { return l.normal_min; },
    .words =
        [](const PathLimits&, double least) {
          return BoundInWords{"R_n", "≥", least, "m g"};
        },
    .slack = [](const Scene&, double least, Point,
                const Kinematics& motion) { return motion.R_n - least; },
    .is = [](const Scene&, Kind kind,
             bool lower) { return kind == Kind::NormalForce && lower; },
    .loosened =
        [](const Scene&, double asked, double by) {
          // A body that must not lift off does not.
          const double least = asked - kWeights * by;
          return asked >= 0.0 ? std::max(0.0, least) : least;
        },
    .pose =
        [](const Body&, const PathLimits& limits, Inequalities& all) {
          if (!limits.normal_min && !limits.normal_max) return;
          all.push_back({.kind = Kind::NormalForce,
                         .lower = limits.normal_min.value_or(-kNoBound),
                         .upper = limits.normal_max.value_or(kNoBound)});
        },
    .widen =
        [](const Scene&, const FreePath& free, PathInequality& limit) {
          limit.lower = std::min(limit.lower, free.min_normal - 0.5);
          limit.upper = std::max(limit.upper, free.max_normal + 0.5);
          return false;
        },
    .looser = "a smaller normal_force.min"};

constexpr LimitEntry kGreatestForceEntry{
    .key = "scene.limits.normal_force.max",
    .meaning = "R_n ≤ this",
    .unit = "m g",
    .allowed = Allowed::Positive,
    .reason = "for the track has to carry the body",
    .bound_in = [](PathLimits& l) -> Number& { return l.normal_max; },
    .words =
        [](const PathLimits&, double most) {
          return BoundInWords{"R_n", "≤", most, "m g"};
        },
    .slack = [](const Scene&, double most, Point,
                const Kinematics& motion) { return most - motion.R_n; },
    .is = [](const Scene&, Kind kind,
             bool lower) { return kind == Kind::NormalForce && !lower; },
    .loosened = [](const Scene&, double most,
                   double by) { return most * looser(by); },
    .pose = nullptr,
    .widen = nullptr,
    .looser = "a larger normal_force.max"};

constexpr LimitEntry kHumpEntry{
    .key = "scene.limits.curvature.hump",
    .meaning = "downwards: κ ≤ this",
    .unit = "1/m",
    .dimension = {-1, 0},
    .allowed = Allowed::Positive,
    .reason = kStraight,
    .bound_in = [](PathLimits& l) -> Number& { return l.curvature.hump; },
    .words =
        [](const PathLimits& limits, double K) {
          return BoundInWords{kappa(limits), "≤", K, "1/m"};
        },
    .slack =
        [](const Scene& scene, double K, Point, const Kinematics& motion) {
          return K - curvature(scene, motion);
        },
    .is = [](const Scene& scene, Kind kind,
             bool) { return kind == Kind::Hump && !folds_first(scene); },
    .loosened =
        [](const Scene& scene, double K, double by) {
          return scene.contact == Contact::Optimal ? K : K * looser(by);
        },
    .pose =
        [](const Body& body, const PathLimits& limits, Inequalities& all) {
          const double hump = hump_of_centre(body, limits);
          if (hump < kNoBound)
            all.push_back({.kind = Kind::Hump, .number = hump});
        },
    .widen =
        [](const Scene& scene, const FreePath& free, PathInequality& limit) {
          if (scene.contact == Contact::Optimal) return false;
          limit.number =
              std::max({limit.number, 2.0 * free.max_hump, 1.0 / scene.H});
          return true;
        },
    .looser = "a larger curvature.hump"};

constexpr LimitEntry kValleyEntry{
    .key = "scene.limits.curvature.valley",
    .meaning = "upwards: −κ ≤ this",
    .unit = "1/m",
    .dimension = {-1, 0},
    .allowed = Allowed::Positive,
    .reason = kStraight,
    .bound_in = [](PathLimits& l) -> Number& { return l.curvature.valley; },
    .words =
        [](const PathLimits& limits, double K) {
          return BoundInWords{kappa(limits), "≥", -K, "1/m"};
        },
    .slack =
        [](const Scene& scene, double K, Point, const Kinematics& motion) {
          return K + curvature(scene, motion);
        },
    .is = [](const Scene&, Kind kind, bool) { return kind == Kind::Valley; },
    .loosened =
        [](const Scene& scene, double K, double by) {
          // One of the track that is as sharp as the body bounds nothing.
          constexpr double kSharpest = 0.99;
          const double wide = looser(by) * K;
          return scene.limits.curvature.of == Of::Track && scene.body.rolls()
                     ? std::max(K,
                                std::min(wide, kSharpest / scene.body.radius))
                     : wide;
        },
    .pose =
        [](const Body& body, const PathLimits& limits, Inequalities& all) {
          const double valley = valley_of_centre(body, limits);
          if (valley == kNoBound) return;
          all.push_back({.kind = Kind::Valley, .number = valley});
        },
    .widen =
        [](const Scene& scene, const FreePath&, PathInequality& limit) {
          constexpr double kSharpValley = 60.0;  // per H
          limit.number = std::max(limit.number, kSharpValley / scene.H);
          return true;
        },
    .looser = "a larger curvature.valley"};

constexpr LimitEntry kFoldMarginEntry{
    .key = "scene.limits.fold_margin",
    .meaning = "1 − r κ_c ≥ this, which is 0 where the track folds",
    .allowed = Allowed::Fraction,
    .reason = "for m = 1 − r κ_c is 1 on a straight track and 0 where it folds",
    .bound_in = [](PathLimits& l) -> Number& { return l.fold_margin; },
    .words =
        [](const PathLimits&, double m) {
          return BoundInWords{"1 − r κ_c", "≥", m, ""};
        },
    .slack = [](const Scene&, double m, Point,
                const Kinematics& motion) { return motion.fold_margin - m; },
    .is = [](const Scene& scene, Kind kind,
             bool) { return kind == Kind::Hump && folds_first(scene); },
    .loosened =
        [](const Scene& scene, double m, double by) {
          return scene.contact == Contact::Optimal ? m : m * (1.0 - by);
        },
    .pose = nullptr,
    .widen = nullptr,
    .looser = "a smaller fold_margin"};

constexpr LimitEntry kFloorEntry{
    .key = "scene.limits.floor",
    .meaning = "D: no part of the body below z = D",
    .unit = "m",
    .dimension = {1, 0},
    .allowed = Allowed::Any,
    .bound_in = [](PathLimits& l) -> Number& { return l.floor; },
    .words =
        [](const PathLimits&, double D) {
          return BoundInWords{"floor at z", "=", D, "m"};
        },
    .slack =
        [](const Scene& scene, double D, Point centre, const Kinematics&) {
          return D - scene.body.outer_radius() - centre.z;
        },
    .is = [](const Scene&, Kind kind, bool) { return kind == Kind::Floor; },
    .loosened = [](const Scene& scene, double D,
                   double by) { return D + by * scene.H; },
    .pose =
        [](const Body& body, const PathLimits& limits, Inequalities& all) {
          if (!limits.floor) return;
          all.push_back({.kind = Kind::Floor,
                         .number = *limits.floor - body.outer_radius()});
        },
    .widen =
        [](const Scene& scene, const FreePath& free, PathInequality& limit) {
          limit.number = std::max(limit.number, free.deepest + 0.1 * scene.H);
          return false;
        },
    .forbids =
        [](double D) {
          return HalfPlane{{0.0, D}, -0.5 * std::numbers::pi};
        },
    .looser = "a lower floor"};

constexpr LimitEntry kEntries[] = {
    kFrictionEntry, kLeastForceEntry, kGreatestForceEntry, kHumpEntry,
    kValleyEntry,   kFoldMarginEntry, kFloorEntry};

}  // namespace

std::string_view LimitEntry::name() const {
  constexpr std::string_view kParent = "scene.limits.";
  return std::string_view(key).substr(kParent.size());
}

std::span<const LimitEntry> limit_table() {
  return kEntries;
}

}  // namespace brachisto
