// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/limited_rates.hpp"

#include <optional>
#include <utility>

#include "brachisto/math/index.hpp"
#include "math/central_difference.hpp"

namespace brachisto {

namespace {

/// The path of a scene next to that of `path`, with the same arcs.
std::optional<FittedPath> found_again(const FittedPath& path,
                                      const Scene& scene) {
  const LimitedTime& old = path.curve.problem();
  PathSetting setting{inequalities(scene.body, scene.limits), path.arcs,
                      path.ends};
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
                  old.mesh().degree, {})
      .path;
}

}  // namespace

std::unique_ptr<TimeRates> LimitedRates::make(FittedPath path) {
  const Scene& scene = path.curve.problem().scene();
  if (scene.body.rolls() && !scene.body.off_centred()) {
    std::optional<FittedPath> rolling = found_again(path, with_rotation(scene));
    if (!rolling) return nullptr;
    path = *std::move(rolling);
  }
  return std::unique_ptr<TimeRates>(new LimitedRates(std::move(path)));
}

LimitedRates::LimitedRates(FittedPath path)
    : path_(std::move(path)), sensitivity_(path_) {}

PathSetting LimitedRates::setting_of(const Scene& scene) const {
  PathSetting setting = sensitivity_.setting();
  setting.limits = inequalities(scene.body, scene.limits);
  setting.scene = scene;
  return setting;
}

TimeRate LimitedRates::by(SceneCoordinate coordinate) {
  TimeRate out;
  math::central_difference(
      difference_step(scene(), coordinate), [&](double step, double share) {
        const TimeRate rate = sensitivity_.along(
            setting_of(moved(scene(), coordinate, -step)),
            setting_of(moved(scene(), coordinate, step)), 2.0 * step);
        out.total += share * rate.total;
        out.at_fixed_contacts += share * rate.at_fixed_contacts;
      });
  return out;
}

std::unique_ptr<TimeRates> LimitedRates::next(SceneCoordinate coordinate,
                                              double by) {
  std::optional<FittedPath> path =
      found_again(path_, moved(scene(), coordinate, by));
  return path ? make(*std::move(path)) : nullptr;
}

}  // namespace brachisto
