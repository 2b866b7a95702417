// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// A rolling_time problem in another world: what its rates of w and its
// derivatives are, from one function of a collocation point.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "math/index.hpp"
#include "model/field.hpp"
#include "transcription/rolling_time.hpp"

namespace brachisto {

namespace {

using enum StateComponent;

constexpr int kW = 3;
constexpr int kBeta = 4;

}  // namespace

StateComponent RollingTime::component_of(int local) {
  constexpr std::array kStates{X, Z, Theta, W};
  return kStates.at(at(local));
}

double RollingTime::interpolated(int point, StateComponent component) const {
  const int p = mesh().degree;
  const int e = point / p;
  double sum = 0.0;
  for (int n = 0; n <= p; ++n) {
    sum += scheme_->interpolation(point % p, n) *
           x(layout().state(e * p + n, component));
  }
  return sum;
}

void RollingTime::evaluate_world(const Scene& seen, int point, double theta,
                                 double beta) {
  WorldPoint& out = world_points_[at(point)];
  const Jet angle = Jet::variable(theta, 2);
  const Jet slope = Jet::variable(beta, kBeta);
  Jet x_c, z_c;
  if (place_matters()) {
    x_c = Jet::variable(interpolated(point, X), 0);
    z_c = Jet::variable(interpolated(point, Z), 1);
  }
  out.root = root_of_inertia(seen.body, angle, slope);
  out.gain =
      speed_gain(seen, x_c, z_c, angle, Jet::variable(points_.w[at(point)], kW),
                 slope, out.root);
}

void RollingTime::put_world_gain(int point, Entries& put) const {
  const int p = mesh().degree;
  const int e = point / p;
  const double h = mesh().length(e);
  const double hU = h * x(layout().rolling_time());
  const int row = layout().defect(point, W);
  const Jet& gain = world_points_[at(point)].gain;
  for (int a = 0; a < kBeta; ++a) {
    if (!has_local(a)) continue;
    for (int n = 0; n <= p; ++n) {
      put(row, layout().state(e * p + n, component_of(a)),
          -hU * gain.gradient[at(a)] * scheme_->interpolation(point % p, n));
    }
  }
  put(row, layout().beta(point), -hU * gain.gradient[kBeta]);
  put(row, layout().rolling_time(), -h * gain.value);
}

void RollingTime::put_world_hess_lag(double objective_factor,
                                     std::span<const double> lambda,
                                     Entries& put) const {
  // The Lagrangian is a sum over collocation points of h U D,
  //   D = s b √A − w (λ_x cos β + λ_z sin β + λ_θ/r) − λ_w w',
  // plus terms linear in the nodal states.
  const int p = mesh().degree;
  const double U = x(layout().rolling_time());
  const int row_U = layout().rolling_time();
  const math::SmallMatrix& I = scheme_->interpolation;
  std::array<Jet, kLargestDegree> density;  // NOLINT: filled below

  put.each(0, mesh().num_elements(), [&](int e) {
    const double h = mesh().length(e);
    for (int j = 0; j < p; ++j) {
      const int point = e * p + j;
      const auto of = [&](StateComponent component) {
        return lambda[at(layout().defect(point, component))];
      };
      const Jet w = Jet::variable(points_.w[at(point)], kW);
      const Jet beta = Jet::variable(x(layout().beta(point)), kBeta);
      Jet along = cos(beta) * Jet(of(X)) + sin(beta) * Jet(of(Z));
      if (layout().has_theta()) along += Jet(of(Theta) / scene().body.radius);
      const WorldPoint& world = world_points_[at(point)];
      density[at(j)] =
          world.root * Jet(objective_factor * scheme_->rule.weights[at(j)]) -
          w * along - world.gain * Jet(of(W));
    }
    const auto put_lower = [&](int a, int b, double value) {
      put(std::max(a, b), std::min(a, b), value);
    };
    for (int a = 0; a < kBeta; ++a) {
      if (!has_local(a)) continue;
      for (int n = 0; n <= p; ++n) {
        const int of_a = layout().state(e * p + n, component_of(a));
        double by_U = 0.0;
        for (int j = 0; j < p; ++j) {
          const Jet& D = density[at(j)];
          by_U += I(j, n) * D.gradient[at(a)];
          put_lower(of_a, layout().beta(e * p + j),
                    h * U * I(j, n) * D.hessian[Jet::pair(kBeta, a)]);
        }
        put(row_U, of_a, h * by_U);
        for (int b = 0; b <= a; ++b) {
          if (!has_local(b)) continue;
          for (int m = 0; m <= (a == b ? n : p); ++m) {
            double sum = 0.0;
            for (int j = 0; j < p; ++j) {
              sum +=
                  I(j, n) * I(j, m) * density[at(j)].hessian[Jet::pair(a, b)];
            }
            put_lower(of_a, layout().state(e * p + m, component_of(b)),
                      h * U * sum);
          }
        }
      }
    }
    for (int j = 0; j < p; ++j) {
      const int beta = layout().beta(e * p + j);
      const Jet& D = density[at(j)];
      put(beta, beta, h * U * D.hessian[Jet::pair(kBeta, kBeta)]);
      put(row_U, beta, h * D.gradient[kBeta]);
    }
  });
}

// p = Σ_j b_j (p_j + c_j hU (λ_w/b)_j ∂w'/∂x), p_j = −(λ_x/b)_j, and likewise
// for z.
Transcription::End RollingTime::world_end(
    std::span<const double> lambda) const {
  const int p = mesh().degree;
  const int e = mesh().num_elements() - 1;
  const int last = layout().num_points();
  const double h = mesh().length(e);
  const double U = x(layout().rolling_time());
  End out;
  out.state.w = x(layout().state(last, W));
  if (layout().has_theta()) out.state.theta = x(layout().state(last, Theta));
  std::map<int, End::Rate> by_x;
  const auto by = [&](int index) -> End::Rate& {
    return by_x.try_emplace(index, End::Rate{index, 0.0, 0.0, 0.0, 0.0})
        .first->second;
  };
  by(layout().state(last, W)).w = 1.0;
  if (layout().has_theta()) by(layout().state(last, Theta)).theta = 1.0;
  for (int j = 0; j < p; ++j) {
    const int point = e * p + j;
    const int row_x = layout().defect(point, X);
    const int row_z = layout().defect(point, Z);
    const int row_w = layout().defect(point, W);
    const double c = scheme_->rule.points[at(j)];
    const double lambda_w = lambda[at(row_w)];
    const Jet& gain = world_points_[at(point)].gain;
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
      const auto second = [&](int place) {
        return gain
            .hessian[Jet::pair(std::max(place, local), std::min(place, local))];
      };
      rate.p_x += factor * second(0);
      rate.p_z += factor * second(1);
    };
    for (int a = 0; a < kBeta; ++a) {
      if (!has_local(a)) continue;
      for (int n = 0; n <= p; ++n) {
        add(layout().state(e * p + n, component_of(a)),
            scheme_->interpolation(j, n), a);
      }
    }
    add(layout().beta(point), 1.0, kBeta);
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
