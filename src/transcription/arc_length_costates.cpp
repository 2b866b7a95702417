// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Costates of an arc_length problem, and multipliers from them.

#include <cmath>
#include <cstddef>
#include <optional>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/index.hpp"
#include "transcription/arc_length.hpp"

namespace brachisto {

namespace {

using enum StateComponent;

}  // namespace

Costates ArcLength::end_costates(std::span<const double> lambda) const {
  const int last = num_intervals();
  const Piece& piece = pieces_[at(last)];
  const double stiff =
      lambda[at(layout().no_slip(last))] / reference_length(last);
  const Five d = time_slopes(last);
  return {.p_x = -(d.x + stiff * piece.dx),
          .p_z = -(d.z + d.w * speeds_[at(last)].by()[1] + stiff * piece.dz)};
}

std::optional<Transcription::End> ArcLength::end(
    std::span<const double> x, std::span<const double> lambda) {
  if (!set_point(x)) return std::nullopt;
  const int last = num_intervals();
  const int row = layout().no_slip(last);
  const Piece& piece = pieces_[at(last)];
  const Speed& speed = speeds_[at(last)];
  End out;
  out.state = {scene().body.theta_m, speed.w};
  if (layout().has_theta())
    out.state.theta += x[at(layout().state(last, Theta))];
  out.p = end_costates(lambda);
  out.last_slope = std::atan2(piece.dz, piece.dx);
  const double inverse = 1.0 / reference_length(last);
  out.by_lambda = {{row, 0.0, 0.0, -piece.dx * inverse, -piece.dz * inverse}};
  // The costates are −∂/∂x_N and −∂/∂z_N of the Lagrangian.
  const Second H = second(last, 1.0);
  const Influence own = influence(last, last);
  const auto [H_x, H_z, H_theta] = own.of(H);
  const double f_w = by_sum_of_w(last, 1.0);
  const double stiff = lambda[at(row)] * inverse;
  const std::array<double, 3> w_by = speed.by();
  const std::array<double, 6> w_by_by = speed.by_by();
  for (const int node : {last, last - 1}) {
    const Influence by = influence(last, node);
    const auto p_x = by.of(H_x);
    const auto p_z = by.of(H_z);
    const double sign = by.sign;
    for (int i = 0; i < layout().num_states(); ++i) {
      End::Rate rate{layout().state(node, X) + i, 0.0, 0.0, -p_x[at(i)],
                     -p_z[at(i)]};
      if (i < 2) (i == 0 ? rate.p_x : rate.p_z) -= sign * stiff;
      if (node == last) {
        rate.w = w_by[at(i)];
        rate.theta = i == 2 ? 1.0 : 0.0;
        if (i > 0) rate.p_z -= f_w * w_by_by[i == 1 ? 2 : 4];
      }
      out.by_x.push_back(rate);
    }
  }
  const double by_S = length_by_S(last);
  out.by_x.push_back({layout().arc_length(), 0.0, 0.0, -by_S * H_x.length,
                      -by_S * H_z.length});
  return out;
}

ArcLength::PieceState ArcLength::piece_state(int node,
                                             std::span<const double> lambda,
                                             const Costates& end) const {
  const Piece& piece = pieces_[at(node)];
  const Five d = time_slopes(node);
  const double w = 1.0 / piece.inverse_speed;
  const double dx = piece.dx;
  const double dz = piece.dz;
  // ∂/∂Δz of the Lagrangian is −(p_z + p_w g / w): what z and, with it, w are
  // worth from here on.
  const double momentum_z =
      d.z + lambda[at(layout().no_slip(node))] * dz / reference_length(node);
  return {scene().body.theta_m + turned(node),
          w,
          std::atan2(dz, dx),
          {.p_x = end.p_x,
           .p_z = end.p_z,
           .p_w = -(momentum_z + end.p_z) * w / scene().gravity}};
}

std::vector<double> ArcLength::multipliers(double p_x, double p_z) const {
  std::vector<double> lambda(at(num_constraints()));
  const double r = scene().body.radius;
  // (x, z) derivatives of the Lagrangian by the end of the piece, but for the
  // no-slip term; that by x is the same all along, that by z changes with w.
  double momentum_z = -p_z;
  // What the piece after a node adds to its stationarity in θ.
  double from_after = 0.0;
  for (int node = num_intervals(); node >= 1; --node) {
    check_stop(node);
    const Piece& piece = pieces_[at(node)];
    const std::array<double, 3> own = speeds_[at(node)].by();
    const std::array<double, 3> before = speeds_[at(node - 1)].by();
    const Five d = time_slopes(node);
    momentum_z -= d.w * own[1];
    // momentum − ∂f/∂(Δx, Δz) = λ (Δx, Δz) / reference length
    const double dx = piece.dx;
    const double dz = piece.dz;
    const double reference = reference_length(node);
    const double multiplier = reference *
                              ((-p_x - d.x) * dx + (momentum_z - d.z) * dz) /
                              (dx * dx + dz * dz);
    lambda[at(layout().no_slip(node))] = multiplier;
    // The node before has −momentum_z from here, + w's share.
    momentum_z -= d.w * before[1];
    if (!layout().has_theta()) continue;
    const double by_turning =
        r * (d.length - multiplier * piece.length / reference);
    const double share = middle(node);
    const double here =
        by_turning + share * d.theta + d.w * own[2] + from_after;
    lambda[at(layout().place(node))] = -here / r;
    from_after = -by_turning + (1.0 - share) * d.theta + d.w * before[2];
  }
  return lambda;
}

}  // namespace brachisto
