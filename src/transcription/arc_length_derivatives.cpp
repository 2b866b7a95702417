// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Derivatives of an arc_length problem. Each piece depends on five quantities,
// Δx, Δz, r Δθ, the rotation in its middle and the sum of w at its ends; the
// unknowns change these linearly, but for w.

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "brachisto/math/stop_condition.hpp"
#include "math/index.hpp"
#include "transcription/arc_length.hpp"

namespace brachisto {

namespace {

using enum StateComponent;

}  // namespace

ArcLength::Five ArcLength::time_slopes(int node) const {
  const Piece& piece = pieces_[at(node)];
  // With P = ℓ² A = (1 + η² + k) ℓ² − 2 η ℓ (sin θ Δx − cos θ Δz) and ℓ = r Δθ
  // the time is y √P: half the derivatives of P, times y / √P.
  const Body& body = scene().body;
  const double eta_l = body.eta_m * piece.length;
  const double factor = piece.inverse_speed / piece.root;
  const double f = piece.root * piece.inverse_speed;
  return {-factor * eta_l * piece.sin_theta, factor * eta_l * piece.cos_theta,
          factor * ((1.0 + body.eta_m * body.eta_m + body.k) * piece.length -
                    body.eta_m * (piece.sin_theta * piece.dx -
                                  piece.cos_theta * piece.dz)),
          -factor * eta_l *
              (piece.cos_theta * piece.dx + piece.sin_theta * piece.dz),
          -0.5 * f * piece.inverse_speed};
}

double ArcLength::by_sum_of_w(int node, double objective_factor) const {
  const Piece& piece = pieces_[at(node)];
  const double s = objective_factor * piece.inverse_speed;
  return -0.5 * s * piece.inverse_speed * piece.root;
}

ArcLength::Second ArcLength::second(int node, double objective_factor) const {
  const Piece& piece = pieces_[at(node)];
  const double eta = scene().body.eta_m;
  const double y = piece.inverse_speed;
  const double length = piece.length;
  const double sin_theta = piece.sin_theta;
  const double cos_theta = piece.cos_theta;
  const double across = sin_theta * piece.dx - cos_theta * piece.dz;
  const double along = cos_theta * piece.dx + sin_theta * piece.dz;
  const double c = 1.0 + eta * eta + scene().body.k;

  // √P and its derivatives: (√P)_i = P_i / 2√P, (√P)_ij = (P_ij/2 − (√P)_i
  // (√P)_j) / √P; then times y, which depends on w alone.
  const double inverse = 1.0 / piece.root;
  const double R_x = -eta * length * sin_theta * inverse;
  const double R_z = eta * length * cos_theta * inverse;
  const double R_l = (c * length - eta * across) * inverse;
  const double R_t = -eta * length * along * inverse;
  const double s = objective_factor * y;
  const double q = s * inverse;
  const double xz = -q * R_x * R_z;
  const double xl = q * (-eta * sin_theta - R_x * R_l);
  const double xt = q * (-eta * length * cos_theta - R_x * R_t);
  const double zl = q * (eta * cos_theta - R_z * R_l);
  const double zt = q * (-eta * length * sin_theta - R_z * R_t);
  const double lt = q * (-eta * along - R_l * R_t);
  const double by_w = -0.5 * s * y;
  return {{{-q * R_x * R_x, xz, xl, xt, by_w * R_x},
           {xz, -q * R_z * R_z, zl, zt, by_w * R_z},
           {xl, zl, q * (c - R_l * R_l), lt, by_w * R_l},
           {xt, zt, lt, q * (eta * length * across - R_t * R_t), by_w * R_t},
           {by_w * R_x, by_w * R_z, by_w * R_l, by_w * R_t,
            -y * by_w * piece.root}}};
}

ArcLength::Five ArcLength::times(const Second& matrix, const Five& v) {
  return {dot(matrix[0], v), dot(matrix[1], v), dot(matrix[2], v),
          dot(matrix[3], v), dot(matrix[4], v)};
}

std::array<ArcLength::Five, 3> ArcLength::by_unknowns(int piece,
                                                      int node) const {
  const double sign = node == piece ? 1.0 : -1.0;
  const double share = node == piece ? middle(piece) : 1.0 - middle(piece);
  const std::array<double, 3>& w = speeds_[at(node)].by;
  return {{{sign, 0.0, 0.0, 0.0, 0.0},
           {0.0, sign, 0.0, 0.0, w[1]},
           {0.0, 0.0, sign * scene().body.radius, share, w[2]}}};
}

ArcLength::Five ArcLength::by_S(int piece) const {
  return {0.0, 0.0, layout().has_theta() ? 0.0 : share(piece), 0.0, 0.0};
}

void ArcLength::do_eval_grad_f(std::span<double> grad_f) const {
  std::fill(grad_f.begin(), grad_f.end(), 0.0);
  const auto unknowns = at(layout().num_states());
  for (int piece = 1; piece <= num_intervals(); ++piece) {
    check_stop(piece);
    const Five slopes = time_slopes(piece);
    for (int node = std::max(1, piece - 1); node <= piece; ++node) {
      const auto by = by_unknowns(piece, node);
      const std::size_t first = at(layout().state(node, X));
      for (std::size_t i = 0; i < unknowns; ++i) {
        grad_f[first + i] += dot(slopes, by[i]);
      }
    }
    grad_f.back() += dot(slopes, by_S(piece));
  }
}

void ArcLength::put_jac_g(Entries& put) const {
  const int S = layout().arc_length();
  put.each(1, num_intervals() + 1, [&](int piece) {
    const auto [dx, dz, length, sin_theta, cos_theta, root, inverse_speed] =
        pieces_[at(piece)];
    const double inverse = 1.0 / reference_length(piece);
    const Five slip{dx * inverse, dz * inverse, -length * inverse, 0.0, 0.0};
    const int row = layout().no_slip(piece);
    for (int node = std::max(1, piece - 1); node <= piece; ++node) {
      const auto by = by_unknowns(piece, node);
      for (int i = 0; i < layout().num_states(); ++i) {
        put(row, layout().state(node, X) + i, dot(slip, by[at(i)]));
      }
    }
    if (!layout().has_theta()) {
      put(row, S, dot(slip, by_S(piece)));
      return;
    }
    put(layout().place(piece), layout().state(piece, Theta),
        scene().body.radius);
    put(layout().place(piece), S, -sigma(piece) * sigma(piece));
  });
}

void ArcLength::put_hess_lag(double objective_factor,
                             std::span<const double> lambda,
                             Entries& put) const {
  const int S = layout().arc_length();
  const double r = scene().body.radius;
  const std::size_t unknowns = at(layout().num_states());
  // Without θ, x and z meet nowhere but in w, and both with S.
  const bool all = layout().has_theta();
  std::array<double, 6> diagonal{};  // lower triangle of a node
  double S_z = 0.0, S_S = 0.0;
  const auto put_node = [&](int node) {
    const int first = layout().state(node, X);
    std::size_t entry = 0;
    for (std::size_t i = 0; i < unknowns; ++i) {
      for (std::size_t k = 0; k <= i; ++k, ++entry) {
        if (!all && i != k) continue;
        put(first + static_cast<int>(i), first + static_cast<int>(k),
            diagonal[entry]);
      }
    }
    if (!all) put(S, first + 1, S_z);
    diagonal = {};
    S_z = 0.0;
  };
  put.each(1, num_intervals() + 1, [&](int piece) {
    const Second H = second(piece, objective_factor);
    const double f_w = by_sum_of_w(piece, objective_factor);
    // Of λ ((Δx)² + (Δz)² − ℓ²) / 2 reference lengths.
    const double stiff =
        lambda[at(layout().no_slip(piece))] / reference_length(piece);
    const std::array<double, 3> slip{stiff, stiff, -r * r * stiff};
    const Five with_S = by_S(piece);
    const auto add = [&](int node, const std::array<Five, 3>& by) {
      std::size_t entry = 0;
      for (std::size_t i = 0; i < unknowns; ++i) {
        const Five H_i = times(H, by[i]);
        for (std::size_t k = 0; k <= i; ++k, ++entry) {
          const double of_time =
              dot(H_i, by[k]) + f_w * speeds_[at(node)].by_by[entry];
          diagonal[entry] += i == k ? of_time + slip[i] : of_time;
        }
      }
      S_z += dot(with_S, times(H, by[1]));
    };
    const auto own = by_unknowns(piece, piece);
    if (piece > 1) {
      const auto before = by_unknowns(piece, piece - 1);
      add(piece - 1, before);
      put_node(piece - 1);
      for (std::size_t i = 0; i < unknowns; ++i) {
        for (std::size_t k = 0; k < unknowns; ++k) {
          if (!all && i != k) continue;
          const double of_time = dot(own[i], times(H, before[k]));
          put(layout().state(piece, X) + static_cast<int>(i),
              layout().state(piece - 1, X) + static_cast<int>(k),
              i == k ? of_time - slip[i] : of_time);
        }
      }
    }
    add(piece, own);
    S_S +=
        dot(with_S, times(H, with_S)) - stiff * with_S.length * with_S.length;
  });
  put_node(num_intervals());
  if (!all) put(S, S, S_S);
}

}  // namespace brachisto
