// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/arc_following.hpp"

#include <algorithm>
#include <utility>

#include "brachisto/math/clock.hpp"

namespace brachisto {

namespace {

/// The path that is solved for next to another one.
std::optional<FittedPath> fit_beside(const FittedPath& path, Stage stage,
                                     int degree, ArcSearch& arcs) {
  PathSetting setting{std::move(stage.limits), path.arcs, path.ends};
  if (!stage.scene) {
    return arcs.fit_corrected(path.curve, std::move(setting), degree,
                              kExceeded);
  }
  PathSystem there(*stage.scene, setting, degree);
  if (!there.move_to(setting, prolong(path.curve, there.problem()))) {
    return std::nullopt;
  }
  return arcs.fit_corrected(there.curve(), std::move(setting), degree,
                            kExceeded);
}

}  // namespace

Followed follow(std::optional<FittedPath> path,
                const std::function<Stage(double share)>& stage_at,
                WaySteps steps, int degree, int most, ArcSearch& arcs,
                PassProtocol& protocol) {
  const PhaseTimer timer(Phase::Start);
  Followed reached{std::move(path)};
  double step = steps.first;
  most += protocol.newton_steps();
  while (reached.path && reached.share < 1.0) {
    if (protocol.newton_steps() > most) {
      protocol.fail(Status::NotConverged,
                    "arcs were not followed to the limits in many steps");
      break;
    }
    const double share = std::min(1.0, reached.share + step);
    auto next = fit_beside(*reached.path, stage_at(share), degree, arcs);
    if (protocol.stopped()) break;
    if (next) {
      reached = {std::move(next), share};
      step = std::min(steps.largest, 1.5 * step);
    } else {
      step *= 0.4;
      if (step < steps.smallest) {
        protocol.fail(Status::NotConverged,
                      "arcs were lost on the way to the limits");
        break;
      }
    }
  }
  return reached;
}

}  // namespace brachisto
