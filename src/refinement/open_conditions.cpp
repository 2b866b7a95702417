// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/open_conditions.hpp"

#include <algorithm>
#include <cmath>

#include "brachisto/math/index.hpp"
#include "model/start_angle.hpp"
#include "model/start_under_limits.hpp"

namespace brachisto {

double ContactMismatch::largest() const {
  return std::isnan(at_A + at_B) ? at_A + at_B
                                 : std::max(std::abs(at_A), std::abs(at_B));
}

bool end_is_sought(const Scene& scene) {
  return scene.contact == Contact::Smooth;
}

bool start_is_sought(const Scene& scene, const LimitedEnds& ends) {
  if (ends.free_contacts || !ends.start) return false;
  return scene.world.start_speed > 0.0 || !ends.start_slope_fixed;
}

std::optional<LimitedEnds> with_start(LimitedEnds ends, const Scene& scene,
                                      const std::vector<PathInequality>& limits,
                                      bool held_at_A) {
  const bool pushed = scene.world.start_speed > 0.0;
  if (!held_at_A ||
      (ends.corner && !pushed && !limits[ends.corner->limit].bounds_force())) {
    ends.corner.reset();
  }
  if (ends.free_contacts) return ends;
  if (pushed) {
    ends.start_slope_fixed = !held_at_A || ends.corner;
    if (!ends.start) ends.start = start_angle(scene);
    return ends;
  }
  ends.start_slope_fixed = !(bound_valleys(limits) && held_at_A);
  if (ends.start_slope_fixed) ends.corner.reset();
  if (!ends.start_slope_fixed && scene.contact == Contact::Centre) {
    // Where the centre starts does not depend on its direction there.
    ends.start.reset();
    return ends;
  }
  if (ends.start_slope_fixed || !ends.start) {
    ends.start = start_angle_under(scene, limits);
    if (!ends.start) return std::nullopt;
  }
  return ends;
}

double end_slope(LimitedCurve& curve) {
  const VariableLayout& layout = curve.problem().layout();
  const int last = layout.num_points() - 1;
  const double slope =
      curve.point().x[at(layout.state(last + 1, StateComponent::Beta))];
  return curve.holds_control(last) ? slope : curve.transverse_slope();
}

ContactMismatch mismatch_of(LimitedCurve& curve, const LimitedEnds& ends) {
  const Scene& scene = curve.problem().scene();
  ContactMismatch out;
  if (end_is_sought(scene)) out.at_B = end_slope(curve) - ends.phi;
  if (start_is_sought(scene, ends)) {
    out.at_A = ends.corner && scene.world.start_speed > 0.0
                   ? curve.off_corner()
                   : curve.start_slope() - *ends.start;
  }
  return out;
}

Eigen::VectorXd open_conditions(LimitedCurve& curve,
                                const std::vector<Arc>& arcs,
                                const LimitedEnds& ends) {
  const Scene& scene = curve.problem().scene();
  const bool end = end_is_sought(scene);
  const bool start = start_is_sought(scene, ends);
  const auto m = static_cast<Eigen::Index>(arcs.size()) - 1;
  const Eigen::Index size = m + (end ? 1 : 0) + (start ? 1 : 0);
  Eigen::VectorXd out(size);
  for (Eigen::Index i = 0; i < m; ++i) {
    out[i] = junction_residual(curve, arcs, static_cast<std::size_t>(i));
  }
  const ContactMismatch open = mismatch_of(curve, ends);
  if (end) out[m] = open.at_B;
  if (start) out[size - 1] = open.at_A;
  return out;
}

}  // namespace brachisto
