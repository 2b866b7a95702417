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

bool LimitedTime::has_pair(int a, int b) const {
  if (!has_local(a) || !has_local(b)) return false;
  if (a == kControl && b == kControl) return false;
  if (std::max(a, b) < 2) return curved_places_;
  return scene().world.sphere || std::min(a, b) >= 2;
}

LimitedTime::Jet LimitedTime::density_at(int c, double weight,
                                         std::span<const double> lambda) const {
  const auto& [cost, rates] = points_[at(c)];
  Jet out = cost * weight;
  for (int s = 0; s + 1 < kControl; ++s) {
    if (!has_local(s)) continue;
    out = out - rates[at(s)] * lambda[at(layout().defect(c, kStates[at(s)]))];
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
    for (int s = 0; s + 1 < kControl; ++s) {
      if (!has_local(s)) continue;
      out[row(layout().defect(c, kStates[at(s)]))] -=
          rate * U * points_[at(c)].states[at(s)].value;
    }
    // ∂L/∂h = U (b √A − λ·f) + Σ μ ∂c/∂h, and c depends on h by q = (h q)/h.
    const Jet density = density_at(c, scheme_->rule.weights[at(j)], lambda);
    out[at(layout().rolling_time())] += rate * density.value;
    for (int a = 0; a < kControl; ++a) {
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
  put.each(0, mesh().num_elements(), [&](int e) {
    const double h = mesh().length(e);
    for (int j = 0; j < p; ++j) {
      const int c = e * p + j;
      for (int s = 0; s < kControl; ++s) {
        if (!has_local(s)) continue;
        const Jet& rate = points_[at(c)].states[at(s)];
        const int row = layout().defect(c, kStates[at(s)]);
        for (int n = 0; n <= p; ++n) {
          put(row, layout().state(e * p + n, kStates[at(s)]),
              scheme_->derivative(j, n));
        }
        put(row, layout().rolling_time(), -h * rate.value);
        for (int k = 0; k < kLocals; ++k) {
          if (!rates_on_.states[at(s)].any[at(k)] || !has_local(k)) continue;
          put(row, local(c, k), -h * U * rate.gradient[at(k)]);
        }
      }
      for (int i = 0; i < layout().num_limits(); ++i) {
        for (int k = 0; k < kLocals; ++k) {
          if (!limits_on_[at(i)].any[at(k)] || !has_local(k)) continue;
          put(layout().limit(c, i), local(c, k),
              limit_at(c, i).gradient[at(k)]);
        }
      }
    }
  });
  const int beta_A = layout().state(0, Beta);
  for (int i = 0; i < layout().num_start_rows(); ++i) {
    put(layout().start_row(i), beta_A, at_rest(i, x(beta_A)).gradient[0]);
  }
  if (!free_contacts()) return;
  const double r = scene().body.radius;
  const auto put_contact = [&](int row, int node) {
    const double beta = x(layout().state(node, Beta));
    const auto put_row = [&](StateComponent component, double slope) {
      put(layout().contact_row(row), layout().state(node, component), 1.0);
      put(layout().contact_row(row), layout().state(node, Beta), -r * slope);
      ++row;
    };
    put_row(X, std::cos(beta));
    put_row(Z, std::sin(beta));
  };
  put_contact(0, 0);
  put_contact(2, layout().num_points());
  if (!pushed()) return;
  put(layout().contact_row(4), layout().state(0, W), 1.0);
  put(layout().contact_row(4), beta_A, -push_at(x(beta_A)).gradient[0]);
}

void LimitedTime::put_hess_lag(double objective_factor,
                               std::span<const double> lambda,
                               Entries& put) const {
  // At each point the Lagrangian is
  //   h U { s b √A − λ·f } + Σ_i μ_i c_i
  // plus terms linear in the states.
  const int p = mesh().degree;
  const double U = x(layout().rolling_time());
  const int row_U = layout().rolling_time();
  put.each(0, mesh().num_elements(), [&](int e) {
    const double h = mesh().length(e);
    for (int j = 0; j < p; ++j) {
      const int c = e * p + j;
      const double weight = objective_factor * scheme_->rule.weights[at(j)];
      const Jet density = density_at(c, weight, lambda);
      std::array<double, Jet::kPairs> M{};
      for (std::size_t k = 0; k < M.size(); ++k) {
        M[k] = h * U * density.hessian[k];
      }
      for (int i = 0; i < layout().num_limits(); ++i) {
        const double mu = lambda[at(layout().limit(c, i))];
        for (std::size_t k = 0; k < M.size(); ++k) {
          M[k] += mu * limit_at(c, i).hessian[k];
        }
      }
      for (int a = 0; a < kLocals; ++a) {
        for (int b = 0; b <= a; ++b) {
          if (!has_pair(a, b)) continue;
          const int row = local(c, a);
          const int col = local(c, b);
          put(std::max(row, col), std::min(row, col), M[Jet::pair(a, b)]);
        }
      }
      for (int a = scene().world.sphere ? 0 : 2; a < kControl; ++a) {
        if (has_local(a)) put(row_U, local(c, a), h * density.gradient[at(a)]);
      }
      put(row_U, local(c, kControl), -lambda[at(layout().defect(c, Beta))]);
    }
  });
  const int beta_A = layout().state(0, Beta);
  for (int i = 0; i < layout().num_start_rows(); ++i) {
    put(beta_A, beta_A,
        lambda[at(layout().start_row(i))] * at_rest(i, x(beta_A)).hessian[0]);
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
  if (!pushed()) return;
  put(beta_A, beta_A,
      -lambda[at(layout().contact_row(4))] * push_at(x(beta_A)).hessian[0]);
}

void LimitedTime::do_eval_grad_f(std::span<double> grad_f) const {
  std::fill(grad_f.begin(), grad_f.end(), 0.0);
  const double U = x(layout().rolling_time());
  double sum = 0.0;
  for (int e = 0; e < mesh().num_elements(); ++e) {
    for (int j = 0; j < mesh().degree; ++j) {
      const int c = e * mesh().degree + j;
      const double weight = mesh().length(e) * scheme_->rule.weights[at(j)];
      const Jet& root = points_[at(c)].cost;
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
