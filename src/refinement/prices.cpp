// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/prices.hpp"

#include <Eigen/LU>
#include <utility>

#include "model/start_under_limits.hpp"

namespace brachisto {

Sensitivity::Sensitivity(const FittedPath& path)
    : scene_(path.curve.problem().scene()),
      system_(scene_, {path.curve.problem().limits(), path.arcs, path.ends},
              path.curve.problem().mesh().degree),
      regular_(system_.move_to(system_.setting(), path.curve.point()) &&
               system_.linearise()) {
  if (regular()) unknowns_ = system_.to_unknowns();
}

TimeRate Sensitivity::price(const std::vector<PathInequality>& less,
                            const std::vector<PathInequality>& more,
                            double width) {
  PathSetting before = system_.setting(), after = system_.setting();
  before.limits = less;
  after.limits = more;
  return along(std::move(before), std::move(after), width);
}

TimeRate Sensitivity::along(PathSetting less, PathSetting more, double width) {
  TimeRate out;
  double change = system_.lagrangian(more) - system_.lagrangian(less);
  // Bounds alone move no variable that is fixed.
  if (more.scene) change += system_.of_fixed(more) - system_.of_fixed(less);
  out.at_fixed_contacts = change / width;
  const LimitedEnds& ends = system_.setting().ends;
  if (ends.start_slope_fixed && ends.start && !system_.problem().pushed()) {
    // The static cone turns with the bound, and with the body.
    const auto start = [&](const PathSetting& changed) {
      const Scene& scene = changed.scene ? *changed.scene : scene_;
      return start_angle_under(scene, changed.limits);
    };
    const auto first = start(less), second = start(more);
    if (first && second) {
      less.ends.start = first;
      more.ends.start = second;
    }
  }
  const PathRates direct = system_.to(less, more, width);
  out.total = direct.time;
  if (unknowns_.empty()) return out;
  // The open conditions go on to hold.
  const Eigen::VectorXd follow =
      jacobian_of(unknowns_).partialPivLu().solve(-direct.open);
  for (std::size_t i = 0; i < unknowns_.size(); ++i) {
    out.total += follow[static_cast<Eigen::Index>(i)] * unknowns_[i].time;
  }
  return out;
}

}  // namespace brachisto
