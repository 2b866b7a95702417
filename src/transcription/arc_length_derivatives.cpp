// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Derivatives of an arc_length problem: the stencils, and from them both the
// sparsity patterns and the values.

#include <algorithm>
#include <cstddef>

#include "brachisto/math/stop_condition.hpp"
#include "brachisto/transcription/arc_length.hpp"

namespace brachisto {

namespace {

using enum StateComponent;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// A vector of, or a row of second derivatives by, Δx, Δz, r Δθ, the rotation
/// in the middle and the sum of both w.
struct Five {
  double x, z, length, theta, w;

  [[nodiscard]] double dot(const Five& b) const {
    return x * b.x + z * b.z + length * b.length + theta * b.theta + w * b.w;
  }
};

/// Symmetric second derivatives of one piece.
struct Second {
  Five x, z, length, theta, w;

  [[nodiscard]] Five times(const Five& v) const {
    return {x.dot(v), z.dot(v), length.dot(v), theta.dot(v), w.dot(v)};
  }
};

}  // namespace

ArcLength::Slopes ArcLength::slopes(int node) const {
  const std::size_t j = at(node);
  const double y = pieces_.inverse_speed[j];
  const double f = pieces_.root[j] * y;
  Slopes d{0.0, 0.0, f / pieces_.length[j], 0.0, -0.5 * f * y};
  if (!layout().has_theta()) return d;
  // With P = ℓ² A = (1 + η² + k) ℓ² − 2 η ℓ (sin θ Δx − cos θ Δz) and ℓ = r Δθ
  // the time is y √P: half the derivatives of P, times y / √P.
  const Body& body = scene().body;
  const double eta_l = body.eta_m * pieces_.length[j];
  const double sin_theta = pieces_.sin_theta[j];
  const double cos_theta = pieces_.cos_theta[j];
  const double dx = pieces_.dx[j];
  const double dz = pieces_.dz[j];
  const double factor = y / pieces_.root[j];
  d.x = -factor * eta_l * sin_theta;
  d.z = factor * eta_l * cos_theta;
  d.length =
      factor * ((1.0 + body.eta_m * body.eta_m + body.k) * pieces_.length[j] -
                body.eta_m * (sin_theta * dx - cos_theta * dz));
  d.theta = -factor * eta_l * (cos_theta * dx + sin_theta * dz);
  return d;
}

ArcLength::Block ArcLength::block(int node, double objective_factor,
                                  double lambda) const {
  const std::size_t j = at(node);
  const Body& body = scene().body;
  const double r = body.radius;
  const double eta = body.eta_m;
  const double y = pieces_.inverse_speed[j];
  const double root = pieces_.root[j];
  const double length = pieces_.length[j];
  const double sin_theta = pieces_.sin_theta[j];
  const double cos_theta = pieces_.cos_theta[j];
  const double dx = pieces_.dx[j];
  const double dz = pieces_.dz[j];
  const double across = sin_theta * dx - cos_theta * dz;
  const double along = cos_theta * dx + sin_theta * dz;
  const double c = 1.0 + eta * eta + body.k;

  // √P and its derivatives: (√P)_i = P_i / 2√P, (√P)_ij = (P_ij/2 − (√P)_i
  // (√P)_j) / √P; then times y, which depends on w alone.
  const double inverse = 1.0 / root;
  const double R_x = -eta * length * sin_theta * inverse;
  const double R_z = eta * length * cos_theta * inverse;
  const double R_l = (c * length - eta * across) * inverse;
  const double R_t = -eta * length * along * inverse;
  const double s = objective_factor * y;
  const double q = s * inverse;
  const double xl = q * (-eta * sin_theta - R_x * R_l);
  const double xt = q * (-eta * length * cos_theta - R_x * R_t);
  const double zl = q * (eta * cos_theta - R_z * R_l);
  const double zt = q * (-eta * length * sin_theta - R_z * R_t);
  const double ll = q * (c - R_l * R_l);
  const double lt = q * (-eta * along - R_l * R_t);
  const double tt = q * (eta * length * across - R_t * R_t);
  const double xx = -q * R_x * R_x;
  const double xz = -q * R_x * R_z;
  const double zz = -q * R_z * R_z;
  const double by_w = -0.5 * s * y;
  const double f_w = by_w * root;
  const Second H{{xx, xz, xl, xt, by_w * R_x},
                 {xz, zz, zl, zt, by_w * R_z},
                 {xl, zl, ll, lt, by_w * R_l},
                 {xt, zt, lt, tt, by_w * R_t},
                 {by_w * R_x, by_w * R_z, by_w * R_l, by_w * R_t, -y * f_w}};

  // What the unknowns of either node change.
  const std::size_t a = j - 1;
  const double share = middle(node);
  const Five x_a{-1.0, 0.0, 0.0, 0.0, 0.0};
  const Five z_a{0.0, -1.0, 0.0, 0.0, nodes_.by_z[a]};
  const Five t_a{0.0, 0.0, -r, 1.0 - share, nodes_.by_theta[a]};
  const Five x_b{1.0, 0.0, 0.0, 0.0, 0.0};
  const Five z_b{0.0, 1.0, 0.0, 0.0, nodes_.by_z[j]};
  const Five t_b{0.0, 0.0, r, share, nodes_.by_theta[j]};
  const Five H_z_a = H.times(z_a);
  const Five H_t_a = H.times(t_a);
  const Five H_z_b = H.times(z_b);
  const Five H_t_b = H.times(t_b);

  const double stiff = lambda / reference_length(node);
  const double turn = r * r * stiff;
  Block out;
  out.before = {xx + stiff,
                x_a.dot(H_z_a),
                z_a.dot(H_z_a) + f_w * nodes_.by_z_z[a] + stiff,
                x_a.dot(H_t_a),
                z_a.dot(H_t_a) + f_w * nodes_.by_z_theta[a],
                t_a.dot(H_t_a) + f_w * nodes_.by_theta_theta[a] - turn};
  out.own = {xx + stiff,
             x_b.dot(H_z_b),
             z_b.dot(H_z_b) + f_w * nodes_.by_z_z[j] + stiff,
             x_b.dot(H_t_b),
             z_b.dot(H_t_b) + f_w * nodes_.by_z_theta[j],
             t_b.dot(H_t_b) + f_w * nodes_.by_theta_theta[j] - turn};
  out.between = {-xx - stiff,    x_b.dot(H_z_a),         x_b.dot(H_t_a),
                 x_a.dot(H_z_b), z_b.dot(H_z_a) - stiff, z_b.dot(H_t_a),
                 x_a.dot(H_t_b), z_a.dot(H_t_b),         t_b.dot(H_t_a) + turn};
  return out;
}

std::array<double, 2> ArcLength::axisymmetric_curvature(int node) const {
  const std::size_t j = at(node);
  const double y = pieces_.inverse_speed[j];
  const double f = pieces_.root[j] * y;
  return {0.5 * f * y * y, -0.5 * constant_root_ * share(node) * y * y};
}

void ArcLength::put_jac_g(Entries& put) const {
  const double r = scene().body.radius;
  const int col_S = layout().arc_length();
  for (int node = 1; node <= num_intervals(); ++node) {
    check_stop(node);
    const std::size_t j = at(node);
    const double inverse = 1.0 / reference_length(node);
    const double by_x = pieces_.dx[j] * inverse;
    const double by_z = pieces_.dz[j] * inverse;
    const double by_length = -pieces_.length[j] * inverse;
    const int row = layout().no_slip(node);
    const bool first = node == 1;
    if (!first) {
      put(row, layout().state(node - 1, X), -by_x);
      put(row, layout().state(node - 1, Z), -by_z);
      if (layout().has_theta()) {
        put(row, layout().state(node - 1, Theta), -r * by_length);
      }
    }
    put(row, layout().state(node, X), by_x);
    put(row, layout().state(node, Z), by_z);
    if (!layout().has_theta()) {
      put(row, col_S, by_length * share(node));
      continue;
    }
    put(row, layout().state(node, Theta), r * by_length);
    put(layout().place(node), layout().state(node, Theta), r);
    put(layout().place(node), col_S, -sigma(node) * sigma(node));
  }
}

void ArcLength::put_hess_lag(double objective_factor,
                             std::span<const double> lambda,
                             Entries& put) const {
  if (!layout().has_theta()) {
    put_axisymmetric_hess_lag(objective_factor, lambda, put);
    return;
  }
  const auto put_diagonal = [&](int node, const std::array<double, 6>& h) {
    const int x = layout().state(node, X);
    put(x, x, h[0]);
    put(x + 1, x, h[1]);
    put(x + 1, x + 1, h[2]);
    put(x + 2, x, h[3]);
    put(x + 2, x + 1, h[4]);
    put(x + 2, x + 2, h[5]);
  };
  std::array<double, 6> diagonal{};
  for (int node = 1; node <= num_intervals(); ++node) {
    check_stop(node);
    const Block h =
        block(node, objective_factor, lambda[at(layout().no_slip(node))]);
    if (node > 1) {
      for (std::size_t i = 0; i < diagonal.size(); ++i) {
        diagonal[i] += h.before[i];
      }
      put_diagonal(node - 1, diagonal);
      const int row = layout().state(node, X);
      const int col = layout().state(node - 1, X);
      for (int i = 0; i < 9; ++i) {
        put(row + i / 3, col + i % 3, h.between[at(i)]);
      }
    }
    diagonal = h.own;
  }
  put_diagonal(num_intervals(), diagonal);
}

void ArcLength::put_axisymmetric_hess_lag(double objective_factor,
                                          std::span<const double> lambda,
                                          Entries& put) const {
  // The time of a piece, S share √A y, depends on S and both w; its length, on
  // S, Δx and Δz.
  const int row_S = layout().arc_length();
  double x_x = 0.0, z_z = 0.0, S_z = 0.0, S_S = 0.0;
  const auto put_diagonal = [&](int node) {
    put(layout().state(node, X), layout().state(node, X), x_x);
    put(layout().state(node, Z), layout().state(node, Z), z_z);
    put(row_S, layout().state(node, Z), S_z);
  };
  for (int node = 1; node <= num_intervals(); ++node) {
    check_stop(node);
    const std::size_t j = at(node);
    const double multiplier = lambda[at(layout().no_slip(node))];
    const double stiff = multiplier / reference_length(node);
    const auto [w_w_one, S_w_one] = axisymmetric_curvature(node);
    const double w_w = objective_factor * w_w_one;
    const double S_w = objective_factor * S_w_one;
    const double by_w = -0.5 * objective_factor * pieces_.root[j] *
                        pieces_.inverse_speed[j] * pieces_.inverse_speed[j];
    const auto add = [&](std::size_t i) {
      x_x += stiff;
      z_z += stiff + w_w * nodes_.by_z[i] * nodes_.by_z[i] +
             by_w * nodes_.by_z_z[i];
      S_z += S_w * nodes_.by_z[i];
    };
    if (node > 1) {
      add(j - 1);
      put_diagonal(node - 1);
      put(layout().state(node, X), layout().state(node - 1, X), -stiff);
      put(layout().state(node, Z), layout().state(node - 1, Z),
          w_w * nodes_.by_z[j] * nodes_.by_z[j - 1] - stiff);
    }
    x_x = z_z = S_z = 0.0;
    add(j);
    S_S -= stiff * share(node) * share(node);
  }
  put_diagonal(num_intervals());
  put(row_S, row_S, S_S);
}

void ArcLength::do_eval_grad_f(std::span<double> grad_f) const {
  std::fill(grad_f.begin(), grad_f.end(), 0.0);
  const double r = scene().body.radius;
  double by_S = 0.0;
  for (int node = 1; node <= num_intervals(); ++node) {
    check_stop(node);
    const std::size_t j = at(node);
    const Slopes d = slopes(node);
    const auto add = [&](int n, double sign, double share_of_theta) {
      const std::size_t i = at(n);
      grad_f[at(layout().state(n, X))] += sign * d.x;
      grad_f[at(layout().state(n, Z))] += sign * d.z + d.w * nodes_.by_z[i];
      if (!layout().has_theta()) return;
      grad_f[at(layout().state(n, Theta))] += sign * r * d.length +
                                              share_of_theta * d.theta +
                                              d.w * nodes_.by_theta[i];
    };
    const double share_own = middle(node);
    if (node > 1) add(node - 1, -1.0, 1.0 - share_own);
    add(node, 1.0, share_own);
    by_S += pieces_.root[j] * pieces_.inverse_speed[j];
  }
  // Without θ the time is proportional to S.
  grad_f[at(layout().arc_length())] =
      layout().has_theta() ? 0.0 : by_S / x(layout().arc_length());
}

}  // namespace brachisto
