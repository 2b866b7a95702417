// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Derivatives of a limited_time problem: the stencils, and from them both the
// sparsity patterns and the values.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "math/index.hpp"
#include "transcription/limited_time.hpp"

namespace brachisto {

namespace {

using enum StateComponent;

}  // namespace

LimitedTime::Density LimitedTime::density_at(
    int c, double weight, std::span<const double> lambda) const {
  const Point& at_c = points_[at(c)];
  const double l_x = lambda[at(layout().defect(c, X))];
  const double l_z = lambda[at(layout().defect(c, Z))];
  const double l_w = scene().gravity * lambda[at(layout().defect(c, W))];
  const double along = l_x * at_c.cos_beta + l_z * at_c.sin_beta;
  const double across = l_z * at_c.cos_beta - l_x * at_c.sin_beta;
  Density out{weight * at_c.root.value - at_c.w * along - l_w * at_c.sin_beta};
  out.gradient[3] = -along;
  out.gradient[4] =
      weight * at_c.root.gradient[4] - at_c.w * across - l_w * at_c.cos_beta;
  if (layout().has_theta()) {
    const double l_theta =
        lambda[at(layout().defect(c, Theta))] / scene().body.radius;
    const double eta = scene().body.eta_m;
    out.value -= l_theta * at_c.w + l_w * eta * at_c.cos_theta;
    out.gradient[2] =
        weight * at_c.root.gradient[2] + l_w * eta * at_c.sin_theta;
    out.gradient[3] -= l_theta;
  }
  return out;
}

void LimitedTime::add_rates_by_length(int element, double rate,
                                      std::span<const double> lambda,
                                      std::span<double> out) const {
  const double U = x(layout().rolling_time());
  const double h = mesh().length(element);
  const auto row = [&](int constraint) {
    return at(num_variables() + constraint);
  };
  for (int j = 0; j < mesh().degree; ++j) {
    const int c = element * mesh().degree + j;
    const Point& at_c = points_[at(c)];
    const double eta = layout().has_theta() ? scene().body.eta_m : 0.0;
    const auto put = [&](StateComponent component, double f) {
      out[row(layout().defect(c, component))] -= rate * U * f;
    };
    put(X, at_c.w * at_c.cos_beta);
    put(Z, at_c.w * at_c.sin_beta);
    if (layout().has_theta()) put(Theta, at_c.w / scene().body.radius);
    put(W, scene().gravity * (at_c.sin_beta + eta * at_c.cos_theta));
    // ∂L/∂h = U (b √A − λ·f) + Σ μ ∂c/∂h, and c depends on h by q = (h q)/h.
    const Density density = density_at(c, scheme_->rule.weights[at(j)], lambda);
    out[at(layout().rolling_time())] += rate * density.value;
    for (int a = 2; a < kControl; ++a) {
      if (has_local(a))
        out[at(local(c, a))] += rate * U * density.gradient[at(a)];
    }
    const double slope = -x(layout().control(c)) / h;
    for (int i = 0; i < layout().num_limits(); ++i) {
      const Jet& value = limit_at(c, i);
      const double mu = rate * lambda[at(layout().limit(c, i))];
      out[row(layout().limit(c, i))] += rate * slope * value.gradient[kControl];
      for (int a = 0; a < kLocals; ++a) {
        if (!has_local(a)) continue;
        out[at(local(c, a))] +=
            mu * slope * value.hessian[Jet::pair(kControl, a)];
      }
      out[at(layout().control(c))] -= mu * value.gradient[kControl] / h;
    }
  }
}

void LimitedTime::put_jac_g(Entries& put) const {
  const int p = mesh().degree;
  const double U = x(layout().rolling_time());
  const double g = scene().gravity;
  const double r = scene().body.radius;
  const int col_U = layout().rolling_time();
  put.each(0, mesh().num_elements(), [&](int e) {
    const double h = mesh().length(e);
    for (int j = 0; j < p; ++j) {
      const int c = e * p + j;
      const Point& at_c = points_[at(c)];
      const auto put_defect = [&](StateComponent component, double rate) {
        const int row = layout().defect(c, component);
        for (int n = 0; n <= p; ++n) {
          put(row, layout().state(e * p + n, component),
              scheme_->derivative(j, n));
        }
        put(row, col_U, -h * rate);
      };
      const auto put_rate = [&](StateComponent component, int number,
                                double slope) {
        put(layout().defect(c, component), local(c, number), -h * U * slope);
      };
      put_defect(X, at_c.w * at_c.cos_beta);
      put_rate(X, 3, at_c.cos_beta);
      put_rate(X, 4, -at_c.w * at_c.sin_beta);
      put_defect(Z, at_c.w * at_c.sin_beta);
      put_rate(Z, 3, at_c.sin_beta);
      put_rate(Z, 4, at_c.w * at_c.cos_beta);
      if (layout().has_theta()) {
        put_defect(Theta, at_c.w / r);
        put_rate(Theta, 3, 1.0 / r);
      }
      const double eta = layout().has_theta() ? scene().body.eta_m : 0.0;
      put_defect(W, g * (at_c.sin_beta + eta * at_c.cos_theta));
      if (layout().has_theta()) put_rate(W, 2, -g * eta * at_c.sin_theta);
      put_rate(W, 4, g * at_c.cos_beta);
      put_defect(Beta, x(layout().control(c)) / h);
      put_rate(Beta, kControl, 1.0 / h);
      for (int i = 0; i < layout().num_limits(); ++i) {
        for (int k = 0; k < kLocals; ++k) {
          if (!depends_[at(i)].any[at(k)] || !has_local(k)) continue;
          put(layout().limit(c, i), local(c, k),
              limit_at(c, i).gradient[at(k)]);
        }
      }
    }
  });
  for (int i = 0; i < layout().num_start_rows(); ++i) {
    put(layout().start_row(i), layout().state(0, Beta),
        at_rest(i, x(layout().state(0, Beta))).gradient[0]);
  }
  if (!free_contacts()) return;
  const int last = layout().num_points();
  const int beta_A = layout().state(0, Beta);
  const int beta_B = layout().state(last, Beta);
  put(layout().contact_row(0), layout().state(0, X), 1.0);
  put(layout().contact_row(0), beta_A, -r * std::cos(x(beta_A)));
  put(layout().contact_row(1), layout().state(0, Z), 1.0);
  put(layout().contact_row(1), beta_A, -r * std::sin(x(beta_A)));
  put(layout().contact_row(2), layout().state(last, X), 1.0);
  put(layout().contact_row(2), beta_B, -r * std::cos(x(beta_B)));
  put(layout().contact_row(3), layout().state(last, Z), 1.0);
  put(layout().contact_row(3), beta_B, -r * std::sin(x(beta_B)));
}

void LimitedTime::put_hess_lag(double objective_factor,
                               std::span<const double> lambda,
                               Entries& put) const {
  // At each point the Lagrangian is
  //   h U { s b √A − λ·f } + Σ_i μ_i c_i
  // plus terms linear in the states.
  const int p = mesh().degree;
  const double U = x(layout().rolling_time());
  const double g = scene().gravity;
  const int row_U = layout().rolling_time();
  put.each(0, mesh().num_elements(), [&](int e) {
    const double h = mesh().length(e);
    for (int j = 0; j < p; ++j) {
      const int c = e * p + j;
      const Point& at_c = points_[at(c)];
      const double weight = objective_factor * scheme_->rule.weights[at(j)];
      const double l_x = lambda[at(layout().defect(c, X))];
      const double l_z = lambda[at(layout().defect(c, Z))];
      const double l_w = g * lambda[at(layout().defect(c, W))];
      const double eta = layout().has_theta() ? scene().body.eta_m : 0.0;
      const double along = l_x * at_c.cos_beta + l_z * at_c.sin_beta;
      const double across = l_z * at_c.cos_beta - l_x * at_c.sin_beta;

      std::array<double, Jet::kPairs> M{};
      for (std::size_t k = 0; k < M.size(); ++k) {
        M[k] = h * U * weight * at_c.root.hessian[k];
      }
      M[Jet::pair(4, 3)] -= h * U * across;
      M[Jet::pair(4, 4)] += h * U * (at_c.w * along + l_w * at_c.sin_beta);
      M[Jet::pair(2, 2)] += h * U * l_w * eta * at_c.cos_theta;
      for (int i = 0; i < layout().num_limits(); ++i) {
        const double mu = lambda[at(layout().limit(c, i))];
        for (std::size_t k = 0; k < M.size(); ++k) {
          M[k] += mu * limit_at(c, i).hessian[k];
        }
      }
      for (int a = places_matter_ ? 0 : 2; a < kLocals; ++a) {
        if (!has_local(a)) continue;
        for (int b = places_matter_ ? 0 : 2; b <= a; ++b) {
          if (!has_local(b) || (a == kControl && b == kControl)) continue;
          if ((a < 2) != (b < 2)) continue;
          const int row = local(c, a);
          const int col = local(c, b);
          put(std::max(row, col), std::min(row, col), M[Jet::pair(a, b)]);
        }
      }
      const Density density = density_at(c, weight, lambda);
      for (int a = 2; a < kControl; ++a) {
        if (has_local(a)) put(row_U, local(c, a), h * density.gradient[at(a)]);
      }
      put(row_U, local(c, kControl), -lambda[at(layout().defect(c, Beta))]);
    }
  });
  for (int i = 0; i < layout().num_start_rows(); ++i) {
    const int beta = layout().state(0, Beta);
    put(beta, beta,
        lambda[at(layout().start_row(i))] * at_rest(i, x(beta)).hessian[0]);
  }
  if (!free_contacts()) return;
  const double r = scene().body.radius;
  const int last = layout().num_points();
  for (const int end : {0, 1}) {
    const int beta = layout().state(end == 0 ? 0 : last, Beta);
    put(beta, beta,
        r * (lambda[at(layout().contact_row(2 * end))] * std::sin(x(beta)) -
             lambda[at(layout().contact_row(2 * end + 1))] *
                 std::cos(x(beta))));
  }
}

void LimitedTime::do_eval_grad_f(std::span<double> grad_f) const {
  std::fill(grad_f.begin(), grad_f.end(), 0.0);
  const double U = x(layout().rolling_time());
  double sum = 0.0;
  for (int e = 0; e < mesh().num_elements(); ++e) {
    for (int j = 0; j < mesh().degree; ++j) {
      const int c = e * mesh().degree + j;
      const double weight = mesh().length(e) * scheme_->rule.weights[at(j)];
      const Jet& root = points_[at(c)].root;
      sum += weight * root.value;
      for (const int i : {2, 4}) {
        if (has_local(i)) {
          grad_f[at(local(c, i))] += U * weight * root.gradient[at(i)];
        }
      }
    }
  }
  grad_f[at(layout().rolling_time())] = sum;
}

}  // namespace brachisto
