// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/rolling_time.hpp"

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "brachisto/math/stop_condition.hpp"
#include "math/index.hpp"
#include "model/inertia.hpp"
#include "model/start_angle.hpp"
#include "transcription/program_formulas.hpp"

namespace brachisto {

namespace {

using enum StateComponent;

}  // namespace

RollingTime::RollingTime(const Scene& scene, Mesh mesh, double phi)
    : Transcription(scene, mesh, {mesh.num_points(), scene.body.off_centred()},
                    {}, "collocation point"),
      scheme_(&collocation_scheme(mesh.degree)) {
  fix_start();
  set_end_angle(phi);

  for (auto* array : {&points_.w, &points_.cos_beta, &points_.sin_beta,
                      &points_.root, &points_.d_root, &points_.d2_root,
                      &points_.eta_cos_theta, &points_.eta_sin_theta}) {
    array->assign(at(layout().num_points()), 0.0);
  }
  if (scene.world.changes_rates()) {
    world_points_.resize(at(layout().num_points()));
  }

  build_patterns();
}

void RollingTime::move_to(const Scene& scene, Mesh mesh, double phi) {
  change_scene(scene);
  change_lengths(std::move(mesh));
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

void RollingTime::hold_sides(std::vector<SphereSide> sides) {
  sides_ = std::move(sides);
  forget_point();
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
  End out;
  out.state.w = x[at(layout().state(last, W))];
  out.by_x.push_back({layout().state(last, W), 0.0, 1.0, 0.0, 0.0});
  if (layout().has_theta()) {
    out.state.theta = x[at(layout().state(last, Theta))];
    out.by_x.push_back({layout().state(last, Theta), 1.0, 0.0, 0.0, 0.0});
  }
  const double b = scheme_->rule.weights.back();
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

bool RollingTime::evaluate() {
  const int p = mesh().degree;
  const double eta = scene().body.eta_m;
  const bool in_world = changes_rates();
  const double constant_root =
      std::sqrt(axisymmetric_inertia_factor(scene().body));

  if (!(x(layout().rolling_time()) > 0.0)) {
    return refuse(-1, "the rolling time U is not positive");
  }
  std::optional<Scene> on_side;
  if (!sides_.empty()) on_side = scene();
  const Scene& seen = on_side ? *on_side : scene();
  for (int e = 0; e < mesh().num_elements(); ++e) {
    check_stop(e);
    if (on_side) on_side->world.side = sides_[at(e)];
    for (int j = 0; j < p; ++j) {
      const int point = e * p + j;
      double w = 0.0;
      double theta = 0.0;
      for (int n = 0; n <= p; ++n) {
        const double weight = scheme_->interpolation(j, n);
        w += weight * x(layout().state(e * p + n, W));
        if (layout().has_theta()) {
          theta += weight * x(layout().state(e * p + n, Theta));
        }
      }
      const double beta = x(layout().beta(point));
      const std::size_t c = at(point);
      points_.w[c] = w;
      points_.cos_beta[c] = std::cos(beta);
      points_.sin_beta[c] = std::sin(beta);
      points_.root[c] = constant_root;
      if (layout().has_theta()) {
        const double A = inertia_factor(scene().body, theta, beta);
        if (!(A > 0.0)) {
          return refuse(point, "the inertia factor A is not positive");
        }
        const double root = std::sqrt(A);
        const double d = eta * std::cos(theta - beta) / root;
        points_.root[c] = root;
        points_.d_root[c] = d;
        points_.d2_root[c] = (eta * std::sin(theta - beta) - d * d) / root;
        points_.eta_cos_theta[c] = eta * std::cos(theta);
        points_.eta_sin_theta[c] = eta * std::sin(theta);
      }
      if (!(w > 0.0)) return refuse(point, "the speed w is not positive");
      if (!std::isfinite(points_.cos_beta[c])) {
        return refuse(point, "the slope angle is not finite");
      }
      if (in_world) evaluate_world(seen, point, theta, beta);
    }
  }
  return true;
}

double RollingTime::do_eval_f() const {
  double sum = 0.0;
  for (int e = 0; e < mesh().num_elements(); ++e) {
    double element = 0.0;
    for (int j = 0; j < mesh().degree; ++j) {
      element += scheme_->rule.weights[at(j)] *
                 points_.root[at(e * mesh().degree + j)];
    }
    sum += mesh().length(e) * element;
  }
  return x(layout().rolling_time()) * sum;
}

void RollingTime::do_eval_g(std::span<double> g) const {
  const int p = mesh().degree;
  const Body& body = scene().body;
  const bool in_world = changes_rates();
  for (int e = 0; e < mesh().num_elements(); ++e) {
    const double hU = mesh().length(e) * x(layout().rolling_time());
    for (int j = 0; j < p; ++j) {
      const int point = e * p + j;
      const std::size_t c = at(point);
      const auto difference = [&](StateComponent component) {
        double sum = 0.0;
        for (int n = 0; n <= p; ++n) {
          sum += scheme_->derivative(j, n) *
                 x(layout().state(e * p + n, component));
        }
        return sum;
      };
      const double w = points_.w[c];
      g[at(layout().defect(point, X))] =
          place_defect(difference(X), hU, w, points_.cos_beta[c]);
      g[at(layout().defect(point, Z))] =
          place_defect(difference(Z), hU, w, points_.sin_beta[c]);
      if (layout().has_theta()) {
        g[at(layout().defect(point, Theta))] =
            turning_defect(difference(Theta), hU, w, body.radius);
      }
      g[at(layout().defect(point, W))] =
          in_world
              ? speed_defect(difference(W), hU, 1.0,
                             world_points_[c].gain.value)
              : speed_defect(difference(W), hU, scene().gravity,
                             points_.sin_beta[c] + points_.eta_cos_theta[c]);
    }
  }
}

}  // namespace brachisto
