// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/rolling_time.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "brachisto/math/index.hpp"
#include "model/start_angle.hpp"

namespace brachisto {

namespace {

using enum StateComponent;

/// Of a body without θ nothing is asked for it.
double rotation_per_length(const Scene& scene) {
  return scene.body.off_centred() ? 1.0 / scene.body.radius : 0.0;
}

using Falling = ocp::Collocation<rolling::SteeredFalling>;
using InWorld = ocp::Collocation<rolling::Steered>;

std::variant<Falling, InWorld> collocated(const Scene& scene,
                                          const CollocationScheme& scheme,
                                          const ocp::Layout& layout) {
  const double per_length = rotation_per_length(scene);
  if (scene.world.changes_rates()) {
    return InWorld(rolling::Steered(scene, {}, per_length), scheme, layout);
  }
  return Falling(rolling::SteeredFalling(scene, {}, per_length), scheme,
                 layout);
}

}  // namespace

RollingTime::RollingTime(const Scene& scene, Mesh mesh, double phi)
    : CollocatedTime(scene, mesh, {mesh.num_points(), scene.body.off_centred()},
                     [&](const ocp::Layout& on) {
                       return collocated(scene, gauss_scheme(mesh.degree), on);
                     }) {
  fix_start();
  set_end_angle(phi);
  build_patterns();
}

void RollingTime::move_to(const Scene& scene, Mesh mesh, double phi) {
  change_scene(scene);
  change_lengths(std::move(mesh));
  std::visit(
      [&]<class Description>(ocp::Collocation<Description>& collocation) {
        collocation.describe(
            Description(scene, {}, rotation_per_length(scene)));
      },
      collocation_);
  fix_start();
  set_end_angle(phi);
}

void RollingTime::fix_start() {
  if (layout().has_theta()) fix(layout().state(0, Theta), scene().body.theta_m);
  const Point start = start_of_centre(scene());
  fix(layout().state(0, X), start.x);
  fix(layout().state(0, Z), start.z);
  fix(layout().state(0, W), initial_w(scene()));
}

void RollingTime::set_start_slope(double alpha) {
  choose_start_slope(alpha);
  fix_start();
}

nlp::EliminationOrder RollingTime::elimination_order() const {
  nlp::EliminationOrder order;
  const int n = num_variables();
  const auto put = [&](int column, int row) {
    order.columns.push_back(column);
    order.rows.push_back(row);
  };
  const int states = layout().num_states();
  const int first_state = layout().state(0, X);
  for (int s = 0; s < states; ++s) put(first_state + s, first_state + s);
  for (int c = 0; c < mesh().num_points(); ++c) {
    put(layout().beta(c), layout().beta(c));
    const int state = layout().state(c + 1, X);
    const int defect = n + layout().defect(c, X);
    for (int s = 0; s < states; ++s) put(state + s, defect + s);
    for (int s = 0; s < states; ++s) put(defect + s, state + s);
  }
  put(layout().rolling_time(), layout().rolling_time());
  order.border = 1;
  return order;
}

std::optional<Transcription::End> RollingTime::end(
    std::span<const double> x, std::span<const double> lambda) {
  if (place_matters()) {
    if (!set_point(x)) return std::nullopt;
    return world_end(lambda);
  }
  const int last = layout().num_points();
  const int row_x = layout().defect(last - 1, X);
  const int row_z = layout().defect(last - 1, Z);
  End out = end_of_states(x);
  const double b = scheme().rule.weights.back();
  out.p.p_x = -lambda[at(row_x)] / b;
  out.p.p_z = -lambda[at(row_z)] / b;
  out.divisor = b;
  out.by_lambda = {{row_x, 0.0, 0.0, -1.0, 0.0}, {row_z, 0.0, 0.0, 0.0, -1.0}};
  // A solver may leave it a turn off.
  out.last_slope =
      std::remainder(x[at(layout().beta(last - 1))], 2.0 * std::numbers::pi);
  return out;
}

Costates RollingTime::end_costates(std::span<const double> lambda) const {
  if (place_matters()) return world_end(lambda).p;
  Costates p;
  for (int c = 0; c < layout().num_points(); ++c) {
    const double h = mesh().length(c / mesh().degree);
    p.p_x -= h * lambda[at(layout().defect(c, X))];
    p.p_z -= h * lambda[at(layout().defect(c, Z))];
  }
  return p;
}

ocp::Rates<RollingTime::Jet, 4> RollingTime::rates(std::span<const double> x,
                                                   int point) const {
  return visit([&](const auto& collocation) {
    return collocation.jets_at(collocation.locals(x, mesh(), point));
  });
}

// p = Σ_j b_j (p_j + c_j hU (λ_w/b)_j ∂w'/∂x), p_j = −(λ_x/b)_j, and likewise
// for z.
Transcription::End RollingTime::world_end(
    std::span<const double> lambda) const {
  const int p = mesh().degree;
  const auto& collocation = std::get<InWorld>(collocation_);
  const int e = mesh().num_elements() - 1;
  const int last = layout().num_points();
  const double h = mesh().length(e);
  const double U = rolling_time();
  End out = end_of_states(x());
  std::map<int, End::Rate> by_x;
  const auto by = [&](int index) -> End::Rate& {
    return by_x.try_emplace(index, End::Rate{index, 0.0, 0.0, 0.0, 0.0})
        .first->second;
  };
  for (const End::Rate& rate : std::exchange(out.by_x, {})) {
    by(rate.index) = rate;
  }
  for (int j = 0; j < p; ++j) {
    const int point = e * p + j;
    const int row_x = layout().defect(point, X);
    const int row_z = layout().defect(point, Z);
    const int row_w = layout().defect(point, W);
    const double c = scheme().rule.points[at(j)];
    const double lambda_w = lambda[at(row_w)];
    const Jet gain = collocation.second(point).states[rolling::kW];
    const double by_x_place = gain.gradient[0];
    const double by_z_place = gain.gradient[1];
    out.p.p_x += h * U * c * lambda_w * by_x_place - lambda[at(row_x)];
    out.p.p_z += h * U * c * lambda_w * by_z_place - lambda[at(row_z)];
    out.by_lambda.push_back({row_x, 0.0, 0.0, -1.0, 0.0});
    out.by_lambda.push_back({row_z, 0.0, 0.0, 0.0, -1.0});
    out.by_lambda.push_back(
        {row_w, 0.0, 0.0, h * U * c * by_x_place, h * U * c * by_z_place});
    const auto add = [&](int index, double share, int local) {
      End::Rate& rate = by(index);
      const double factor = h * U * c * lambda_w * share;
      rate.p_x += factor * gain.second(0, at(local));
      rate.p_z += factor * gain.second(1, at(local));
    };
    for (int a = 0; a < collocation.kLocals; ++a) {
      if (a == 2 && !layout().has_theta()) continue;
      collocation.spread(
          point, a, [&](int index, double share) { add(index, share, a); });
    }
    End::Rate& by_U = by(layout().rolling_time());
    by_U.p_x += h * c * lambda_w * by_x_place;
    by_U.p_z += h * c * lambda_w * by_z_place;
  }
  for (const auto& [index, rate] : by_x) out.by_x.push_back(rate);
  out.last_slope =
      std::remainder(x(layout().beta(last - 1)), 2.0 * std::numbers::pi);
  return out;
}

}  // namespace brachisto
