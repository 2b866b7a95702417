// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/prices.hpp"

#include <Eigen/LU>

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

Price Sensitivity::price(const std::vector<PathInequality>& less,
                         const std::vector<PathInequality>& more,
                         double width) {
  PathSetting before = system_.setting(), after = system_.setting();
  before.limits = less;
  after.limits = more;
  Price out;
  out.at_fixed_contacts =
      (system_.lagrangian(after) - system_.lagrangian(before)) / width;
  const LimitedEnds& ends = system_.setting().ends;
  if (ends.start_slope_fixed && ends.start) {
    // The static cone turns with the bound.
    const auto first = start_angle_under(scene_.body, less);
    const auto second = start_angle_under(scene_.body, more);
    if (first && second) {
      before.ends.start = first;
      after.ends.start = second;
    }
  }
  const PathRates direct = system_.to(before, after, width);
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
