// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Derivatives of a rolling_time problem: the stencils, and from them both the
// sparsity patterns and the values.

#include <algorithm>
#include <array>
#include <cstddef>

#include "math/index.hpp"
#include "transcription/rolling_time.hpp"

namespace brachisto {

namespace {

using enum StateComponent;

}  // namespace

void RollingTime::put_jac_g(Entries& put) const {
  const int p = mesh().degree;
  const double U = x(layout().rolling_time());
  const double g = scene().gravity;
  const int col_U = layout().rolling_time();
  const bool in_world = changes_rates();
  put.each(0, mesh().num_elements(), [&](int e) {
    const double h = mesh().length(e);
    for (int j = 0; j < p; ++j) {
      const int point = e * p + j;
      const std::size_t c = at(point);
      const int col_beta = layout().beta(point);
      const double w = points_.w[c];
      const double cos_beta = points_.cos_beta[c];
      const double sin_beta = points_.sin_beta[c];

      const auto put_difference = [&](StateComponent component) {
        const int row = layout().defect(point, component);
        for (int n = 0; n <= p; ++n) {
          put(row, layout().state(e * p + n, component),
              scheme_->derivative(j, n));
        }
      };
      // The rate of `component` depends on the state `source` at the point,
      // with this slope.
      const auto put_rate = [&](StateComponent component, StateComponent source,
                                double slope) {
        const int row = layout().defect(point, component);
        for (int n = 0; n <= p; ++n) {
          put(row, layout().state(e * p + n, source),
              -h * U * slope * scheme_->interpolation(j, n));
        }
      };

      const int row_x = layout().defect(point, X);
      put_difference(X);
      put_rate(X, W, cos_beta);
      put(row_x, col_beta, h * U * w * sin_beta);
      put(row_x, col_U, -h * w * cos_beta);

      const int row_z = layout().defect(point, Z);
      put_difference(Z);
      put_rate(Z, W, sin_beta);
      put(row_z, col_beta, -h * U * w * cos_beta);
      put(row_z, col_U, -h * w * sin_beta);

      if (layout().has_theta()) {
        const double curvature = 1.0 / scene().body.radius;
        put_difference(Theta);
        put_rate(Theta, W, curvature);
        put(layout().defect(point, Theta), col_U, -h * w * curvature);
      }

      const int row_w = layout().defect(point, W);
      put_difference(W);
      if (in_world) {
        put_world_gain(point, put);
        continue;
      }
      if (layout().has_theta()) {
        put_rate(W, Theta, -g * points_.eta_sin_theta[c]);
      }
      put(row_w, col_beta, -h * U * g * cos_beta);
      put(row_w, col_U, -h * g * (sin_beta + points_.eta_cos_theta[c]));
    }
  });
}

void RollingTime::put_hess_lag(double objective_factor,
                               std::span<const double> lambda,
                               Entries& put) const {
  if (changes_rates()) return put_world_hess_lag(objective_factor, lambda, put);
  // The Lagrangian is a sum over collocation points of
  //   h U { s b √A(θ, β) − λ_x w cos β − λ_z w sin β − λ_θ w/r
  //         − λ_w g (sin β + η cos θ) }
  // plus terms linear in the nodal states, s being the objective factor. So all
  // second derivatives come from θ, w, β and U at the point; those in θ and w
  // are spread to the nodes by the interpolation.
  const int p = mesh().degree;
  const double U = x(layout().rolling_time());
  const double g = scene().gravity;
  const int row_U = layout().rolling_time();
  const bool has_theta = layout().has_theta();
  const math::SmallMatrix& I = scheme_->interpolation;

  struct Second {
    double theta_theta, theta_beta, w_beta, beta_beta, U_theta, U_w, U_beta;
  };
  std::array<Second, kLargestDegree> second;  // NOLINT: filled below

  put.each(0, mesh().num_elements(), [&](int e) {
    const double h = mesh().length(e);
    for (int j = 0; j < p; ++j) {
      const int point = e * p + j;
      const std::size_t c = at(point);
      const double weight = objective_factor * scheme_->rule.weights[at(j)];
      const double lambda_x = lambda[at(layout().defect(point, X))];
      const double lambda_z = lambda[at(layout().defect(point, Z))];
      const double lambda_w = g * lambda[at(layout().defect(point, W))];
      const double w = points_.w[c];
      const double along =
          lambda_x * points_.cos_beta[c] + lambda_z * points_.sin_beta[c];
      const double across =
          lambda_z * points_.cos_beta[c] - lambda_x * points_.sin_beta[c];
      Second& s = second[at(j)];
      s.w_beta = -h * U * across;
      s.beta_beta = h * U *
                    (weight * points_.d2_root[c] + w * along +
                     lambda_w * points_.sin_beta[c]);
      s.U_w = -h * along;
      s.U_beta = h * (weight * points_.d_root[c] - w * across -
                      lambda_w * points_.cos_beta[c]);
      if (!has_theta) continue;
      s.theta_theta =
          h * U *
          (weight * points_.d2_root[c] + lambda_w * points_.eta_cos_theta[c]);
      s.theta_beta = -h * U * weight * points_.d2_root[c];
      s.U_theta = h * (lambda_w * points_.eta_sin_theta[c] -
                       weight * points_.d_root[c]);
      s.U_w -=
          h * lambda[at(layout().defect(point, Theta))] / scene().body.radius;
    }

    const auto put_lower = [&](int a, int b, double value) {
      put(std::max(a, b), std::min(a, b), value);
    };
    const auto spread = [&](int n, double Second::*member) {
      double sum = 0.0;
      for (int j = 0; j < p; ++j) sum += I(j, n) * second[at(j)].*member;
      return sum;
    };
    for (int n = 0; n <= p; ++n) {
      const int w_n = layout().state(e * p + n, W);
      for (int j = 0; j < p; ++j) {
        put_lower(w_n, layout().beta(e * p + j),
                  I(j, n) * second[at(j)].w_beta);
      }
      put(row_U, w_n, spread(n, &Second::U_w));
      if (!has_theta) continue;

      const int theta_n = layout().state(e * p + n, Theta);
      for (int m = 0; m <= n; ++m) {
        double sum = 0.0;
        for (int j = 0; j < p; ++j) {
          sum += I(j, n) * I(j, m) * second[at(j)].theta_theta;
        }
        put(theta_n, layout().state(e * p + m, Theta), sum);
      }
      for (int j = 0; j < p; ++j) {
        put_lower(theta_n, layout().beta(e * p + j),
                  I(j, n) * second[at(j)].theta_beta);
      }
      put(row_U, theta_n, spread(n, &Second::U_theta));
    }
    for (int j = 0; j < p; ++j) {
      const int beta = layout().beta(e * p + j);
      put(beta, beta, second[at(j)].beta_beta);
      put(row_U, beta, second[at(j)].U_beta);
    }
  });
}

void RollingTime::do_eval_grad_f(std::span<double> grad_f) const {
  const int p = mesh().degree;
  const double U = x(layout().rolling_time());
  std::fill(grad_f.begin(), grad_f.end(), 0.0);
  double sum = 0.0;
  for (int e = 0; e < mesh().num_elements(); ++e) {
    for (int j = 0; j < p; ++j) {
      const int point = e * p + j;
      const double weight = mesh().length(e) * scheme_->rule.weights[at(j)];
      const double slope = U * weight * points_.d_root[at(point)];
      sum += weight * points_.root[at(point)];
      grad_f[at(layout().beta(point))] = slope;
      if (!layout().has_theta()) continue;
      for (int n = 0; n <= p; ++n) {
        grad_f[at(layout().state(e * p + n, Theta))] -=
            slope * scheme_->interpolation(j, n);
      }
    }
  }
  grad_f[at(layout().rolling_time())] = sum;
}

}  // namespace brachisto
