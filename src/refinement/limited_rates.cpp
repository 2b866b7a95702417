// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/limited_rates.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "brachisto/math/index.hpp"
#include "brachisto/math/polynomial_basis.hpp"
#include "math/central_difference.hpp"
#include "model/contact.hpp"
#include "model/start_under_limits.hpp"
#include "refinement/arc_elements.hpp"
#include "refinement/turn_meshes.hpp"
#include "transcription/held_control.hpp"

namespace brachisto {

namespace {

/// The path of a scene next to that of `path`, with the same arcs.
std::optional<FittedPath> found_again(const FittedPath& path,
                                      const Scene& scene,
                                      const TurnsResolved& turns = {}) {
  const LimitedTime& old = path.curve.problem();
  PathSetting setting{inequalities(scene.body, scene.limits), path.arcs,
                      path.ends};
  for (int i = 0; i < turns.halvings; ++i) {
    setting.arcs = halved(std::move(setting.arcs));
  }
  const LimitedTime problem(scene, setting.limits, old.mesh(), path.ends,
                            old.held());
  PrimalDual start = prolong(path.curve, problem);
  if (problem.layout().has_theta() && old.layout().has_theta()) {
    const double turn = scene.body.theta_m - old.scene().body.theta_m;
    for (int node = 0; node < problem.layout().num_nodes(); ++node) {
      start.x[at(problem.layout().state(node, StateComponent::Theta))] += turn;
    }
  }
  return fit_arcs(LimitedCurve(problem, std::move(start)), std::move(setting),
                  std::max(old.mesh().degree, turns.degree), {})
      .path;
}

/// Of the centre's path, along an element.
double longest_element(const LimitedCurve& curve) {
  const Mesh& mesh = curve.problem().mesh();
  const auto& rule = curve.problem().scheme().rule;
  double longest = 0.0;
  for (int e = 0; e < mesh.num_elements(); ++e) {
    double w = 0.0;
    for (std::size_t i = 0; i < rule.points.size(); ++i) {
      w += rule.weights[i] * curve.state_at(e, rule.points[i]).w;
    }
    longest = std::max(longest, mesh.length(e) * curve.rolling_time() * w);
  }
  return longest;
}

/// What T grows by for the last point of a path that keeps to a limit of the
/// place until it ends at B, as bounds move or B does: the place of B is given,
/// and the limit has no multiplier there. The density of the multipliers before
/// goes on to it.
double by_limits_at_B(const LimitedCurve& curve, const PathSetting& less,
                      const PathSetting& more, double width) {
  const LimitedTime& problem = curve.problem();
  const int last = problem.layout().num_points() - 1;
  const int e = problem.mesh().num_elements() - 1, p = problem.mesh().degree;
  if (p < 2) return 0.0;
  std::vector<double> points = problem.scheme().rule.points;
  points.pop_back();
  std::vector<double> basis(points.size());
  math::LagrangeBasis(points).evaluate(1.0, basis);
  const TurningPoint<double> last_state = curve.state_at(e, 1.0);
  double rate = 0.0;
  for (std::size_t i = 0; i < less.limits.size(); ++i) {
    const nlp::Held where = less.arcs.back().held[i];
    if (where == nlp::Held::No ||
        problem
            .constraint_range(problem.layout().limit(last, static_cast<int>(i)))
            .bounded()) {
      continue;
    }
    double density = 0.0;
    for (std::size_t c = 0; c < points.size(); ++c) {
      density += basis[c] * curve.at(e, points[c]).multipliers[i];
    }
    const double du = problem.mesh().length(e) * curve.rolling_time() *
                      problem.scheme().rule.weights.back();
    const auto slack = [&](const PathSetting& setting) {
      const Scene& scene = setting.scene ? *setting.scene : problem.scene();
      const Point centre = end_of_centre(scene, setting.ends.phi);
      TurningPoint<double> B = last_state;
      B.x = centre.x;
      B.z = centre.z;
      return value_of(setting.limits[i], scene, B) -
             bound_of(setting.limits[i], where);
    };
    rate += density * du * (slack(more) - slack(less)) / width;
  }
  return rate;
}

/// Whether a limit in which two settings of a path differ holds somewhere; of a
/// corner at A that is not asked.
bool may_hold_what_differs(const PathSetting& one, const PathSetting& other) {
  if (one.ends.corner) return true;
  for (std::size_t i = 0; i < one.limits.size(); ++i) {
    if (one.limits[i] == other.limits[i]) continue;
    for (const Arc& arc : one.arcs) {
      if (arc.held[i] != nlp::Held::No) return true;
      if (arc.touch && arc.touch->limit == i) return true;
    }
  }
  return false;
}

}  // namespace

std::unique_ptr<TimeRates> LimitedRates::make(FittedPath path) {
  const Scene& scene = path.curve.problem().scene();
  if (scene.body.rolls() && !scene.body.off_centred()) {
    const auto turns =
        resolve_turns(scene.body, longest_element(path.curve),
                      path.curve.problem().mesh().num_elements());
    if (!turns) return nullptr;
    std::optional<FittedPath> rolling =
        found_again(path, with_rotation(scene), *turns);
    if (!rolling) return nullptr;
    path = *std::move(rolling);
  }
  return std::unique_ptr<TimeRates>(new LimitedRates(std::move(path)));
}

LimitedRates::LimitedRates(FittedPath path)
    : path_(std::move(path)),
      system_(scene(), {path_.curve.problem().limits(), path_.arcs, path_.ends},
              path_.curve.problem().mesh().degree),
      regular_(system_.move_to(system_.setting(), path_.curve.point()) &&
               system_.linearise()) {
  if (regular()) unknowns_ = system_.to_unknowns(RatesOf::Time);
}

TimeRate LimitedRates::price(const std::vector<PathInequality>& less,
                             const std::vector<PathInequality>& more,
                             double width) {
  PathSetting before = system_.setting(), after = system_.setting();
  before.limits = less;
  after.limits = more;
  return along(std::move(before), std::move(after), width);
}

TimeRate LimitedRates::by(SceneCoordinate coordinate) {
  const auto setting_of = [&](const Scene& other) {
    PathSetting setting = system_.setting();
    setting.limits = inequalities(other.body, other.limits);
    setting.scene = other;
    return setting;
  };
  TimeRate out;
  math::central_difference(
      difference_step(scene(), coordinate), [&](double step, double share) {
        const TimeRate rate =
            along(setting_of(moved(scene(), coordinate, -step)),
                  setting_of(moved(scene(), coordinate, step)), 2.0 * step);
        out.total += share * rate.total;
        out.at_fixed_contacts += share * rate.at_fixed_contacts;
      });
  return out;
}

TimeRate LimitedRates::along(PathSetting less, PathSetting more, double width) {
  TimeRate out;
  // Bounds alone move no variable that is fixed.
  const double of_fixed =
      more.scene ? system_.of_fixed(more) - system_.of_fixed(less) : 0.0;
  const LimitedEnds& ends = system_.setting().ends;
  if (ends.start_slope_fixed && ends.start && !system_.problem().pushed()) {
    // The static cone turns with the bound, and with the body.
    const auto start = [&](const PathSetting& changed) {
      return start_angle_under(changed.scene ? *changed.scene : scene(),
                               changed.limits);
    };
    const auto first = start(less), second = start(more);
    if (first && second) {
      less.ends.start = first;
      more.ends.start = second;
    }
  }
  if (!more.scene && less.ends.start == more.ends.start &&
      !may_hold_what_differs(less, more)) {
    return out;
  }
  // The slope at A is one of the values that are fixed.
  double lagrangian = 0.0;
  out.total = closed_rate(system_.to(less, more, width, lagrangian), unknowns_);
  out.at_fixed_contacts = lagrangian + of_fixed / width;
  const double at_B = by_limits_at_B(path_.curve, less, more, width);
  out.total += at_B;
  out.at_fixed_contacts += at_B;
  return out;
}

std::unique_ptr<TimeRates> LimitedRates::next(SceneCoordinate coordinate,
                                              double by) {
  std::optional<FittedPath> path =
      found_again(path_, moved(scene(), coordinate, by));
  return path ? make(*std::move(path)) : nullptr;
}

}  // namespace brachisto
