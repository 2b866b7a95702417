// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Derivatives of an arc_length problem. Each piece depends on five quantities,
// Δx, Δz, r Δθ, the rotation in its middle and the sum of w at its ends; the
// unknowns change these linearly, but for w.

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/index.hpp"
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

ArcLength::Influence ArcLength::influence(int piece, int node) const {
  const double sign = node == piece ? 1.0 : -1.0;
  const double share = node == piece ? middle(piece) : 1.0 - middle(piece);
  const auto [w_x, w_z, w_theta] = speeds_[at(node)].by();
  return {sign, sign * scene().body.radius, share, w_z, w_theta};
}

double ArcLength::length_by_S(int piece) const {
  return layout().has_theta() ? 0.0 : share(piece);
}

void ArcLength::do_eval_grad_f(std::span<double> grad_f) const {
  std::fill(grad_f.begin(), grad_f.end(), 0.0);
  const auto unknowns = at(layout().num_states());
  for (int piece = 1; piece <= num_intervals(); ++piece) {
    check_stop(piece);
    const Five slopes = time_slopes(piece);
    for (int node = std::max(1, piece - 1); node <= piece; ++node) {
      const auto by = influence(piece, node).of(slopes);
      const std::size_t first = at(layout().state(node, X));
      for (std::size_t i = 0; i < unknowns; ++i) grad_f[first + i] += by[i];
    }
    grad_f.back() += slopes.length * length_by_S(piece);
  }
}

void ArcLength::put_jac_g(Entries& put) const {
  const int S = layout().arc_length();
  put.each(1, num_intervals() + 1, [&](int piece) {
    const auto [dx, dz, length, sin_theta, cos_theta, root, inverse_speed] =
        pieces_[at(piece)];
    const double inverse = 1.0 / reference_length(piece);
    // By the node at the end of the piece; by the one before the opposite.
    const std::array<double, 3> by{dx * inverse, dz * inverse,
                                   -scene().body.radius * length * inverse};
    const int row = layout().no_slip(piece);
    for (int node = std::max(1, piece - 1); node <= piece; ++node) {
      for (int i = 0; i < layout().num_states(); ++i) {
        put(row, layout().state(node, X) + i,
            node == piece ? by[at(i)] : -by[at(i)]);
      }
    }
    if (!layout().has_theta()) {
      put(row, S, -length * inverse * share(piece));
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
  // Of a node, from the pieces on both sides of it.
  std::array<double, 6> diagonal{};  // lower triangle
  double f_w = 0.0;                  // by the sums of w
  double S_z = 0.0;
  double S_S = 0.0;
  const auto put_node = [&](int node) {
    const int first = layout().state(node, X);
    const std::array<double, 6> w_by_by = speeds_[at(node)].by_by();
    std::size_t entry = 0;
    for (std::size_t i = 0; i < unknowns; ++i) {
      for (std::size_t k = 0; k <= i; ++k, ++entry) {
        if (!all && i != k) continue;
        put(first + static_cast<int>(i), first + static_cast<int>(k),
            diagonal[entry] + f_w * w_by_by[entry]);
      }
    }
    if (!all) put(S, first + 1, S_z);
    diagonal = {};
    f_w = S_z = 0.0;
  };
  put.each(1, num_intervals() + 1, [&](int piece) {
    const Second H = second(piece, objective_factor);
    const double by_sum = by_sum_of_w(piece, objective_factor);
    // Of λ ((Δx)² + (Δz)² − ℓ²) / 2 reference lengths.
    const double stiff =
        lambda[at(layout().no_slip(piece))] / reference_length(piece);
    const std::array<double, 3> slip{stiff, stiff, -r * r * stiff};
    const double by_S = length_by_S(piece);
    const auto add = [&](const Influence& node,
                         const std::array<Five, 3>& by_node) {
      std::size_t entry = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const auto by_by = node.of(by_node[i]);
        for (std::size_t k = 0; k <= i; ++k, ++entry) {
          diagonal[entry] += i == k ? by_by[k] + slip[i] : by_by[k];
        }
      }
      f_w += by_sum;
      S_z += by_S * by_node[1].length;
    };
    const Influence own = influence(piece, piece);
    const std::array<Five, 3> by_own = own.of(H);
    if (piece > 1) {
      const Influence before = influence(piece, piece - 1);
      add(before, before.of(H));
      put_node(piece - 1);
      for (std::size_t i = 0; i < unknowns; ++i) {
        const auto by_both = before.of(by_own[i]);
        for (std::size_t k = 0; k < unknowns; ++k) {
          if (!all && i != k) continue;
          put(layout().state(piece, X) + static_cast<int>(i),
              layout().state(piece - 1, X) + static_cast<int>(k),
              i == k ? by_both[k] - slip[i] : by_both[k]);
        }
      }
    }
    add(own, by_own);
    S_S += by_S * by_S * (H[2].length - stiff);
  });
  put_node(num_intervals());
  if (!all) put(S, S, S_S);
}

}  // namespace brachisto
