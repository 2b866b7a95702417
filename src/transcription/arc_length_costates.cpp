// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Costates of an arc_length problem, and multipliers from them.

#include <cmath>
#include <cstddef>

#include "brachisto/math/stop_condition.hpp"
#include "brachisto/transcription/arc_length.hpp"

namespace brachisto {

namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

ArcLength::EndCostates ArcLength::end_costates(
    std::span<const double> lambda) const {
  const int last = num_intervals();
  const std::size_t j = at(last);
  const double multiplier = lambda[at(layout_.no_slip(last))];
  const double inverse = 1.0 / reference_length(last);
  const Slopes d = slopes(last);
  EndCostates p;
  p.x.value = -(d.x + multiplier * pieces_.dx[j] * inverse);
  p.z.value =
      -(d.z + d.w * nodes_.by_z[j] + multiplier * pieces_.dz[j] * inverse);
  p.x.by_no_slip = -pieces_.dx[j] * inverse;
  p.z.by_no_slip = -pieces_.dz[j] * inverse;
  if (layout_.has_theta()) {
    const Block h = block(last, 1.0, multiplier);
    p.x.by_last = {-h.own[0], -h.own[1], -h.own[3]};
    p.z.by_last = {-h.own[1], -h.own[2], -h.own[4]};
    p.x.by_before = {-h.between[0], -h.between[1], -h.between[2]};
    p.z.by_before = {-h.between[3], -h.between[4], -h.between[5]};
    return p;
  }
  const double stiff = multiplier * inverse;
  const auto [w_w, S_w] = axisymmetric_curvature(last);
  p.x.by_last = {-stiff, 0.0, 0.0};
  p.x.by_before = {stiff, 0.0, 0.0};
  p.z.by_last = {
      0.0,
      -(stiff + w_w * nodes_.by_z[j] * nodes_.by_z[j] + d.w * nodes_.by_z_z[j]),
      0.0};
  p.z.by_before = {0.0, stiff - w_w * nodes_.by_z[j] * nodes_.by_z[j - 1], 0.0};
  p.z.by_S = -S_w * nodes_.by_z[j];
  return p;
}

std::vector<ArcLength::PieceState> ArcLength::piece_states(
    std::span<const double> lambda) const {
  const EndCostates end = end_costates(lambda);
  const double p_x = end.x.value;
  const double p_z = end.z.value;
  std::vector<PieceState> states;
  states.reserve(at(num_intervals()));
  for (int node = 1; node <= num_intervals(); ++node) {
    check_stop(node);
    const std::size_t j = at(node);
    const Slopes d = slopes(node);
    const double w = 1.0 / pieces_.inverse_speed[j];
    const double dx = pieces_.dx[j];
    const double dz = pieces_.dz[j];
    // ∂/∂Δz of the Lagrangian is −(p_z + p_w g / w): what z and, with it, w
    // are worth from here on.
    const double momentum_z =
        d.z + lambda[at(layout_.no_slip(node))] * dz / reference_length(node);
    const double theta = layout_.has_theta() ? std::atan2(pieces_.sin_theta[j],
                                                          pieces_.cos_theta[j])
                                             : scene_.body.theta_m;
    states.push_back({node,
                      theta,
                      w,
                      std::atan2(dz, dx),
                      {.p_x = p_x,
                       .p_z = p_z,
                       .p_w = -(momentum_z + p_z) * w / scene_.gravity}});
  }
  return states;
}

std::vector<double> ArcLength::multipliers(double p_x, double p_z) const {
  std::vector<double> lambda(at(num_constraints()));
  const double r = scene_.body.radius;
  // (x, z) derivatives of the Lagrangian by the end of the piece, but for the
  // no-slip term; that by x is the same all along, that by z changes with w.
  double momentum_z = -p_z;
  // What the piece after a node adds to its stationarity in θ.
  double from_after = 0.0;
  for (int node = num_intervals(); node >= 1; --node) {
    check_stop(node);
    const std::size_t j = at(node);
    const Slopes d = slopes(node);
    momentum_z -= d.w * nodes_.by_z[j];
    // momentum − ∂f/∂(Δx, Δz) = λ (Δx, Δz) / reference length
    const double dx = pieces_.dx[j];
    const double dz = pieces_.dz[j];
    const double reference = reference_length(node);
    const double multiplier = reference *
                              ((-p_x - d.x) * dx + (momentum_z - d.z) * dz) /
                              (dx * dx + dz * dz);
    lambda[at(layout_.no_slip(node))] = multiplier;
    // The node before has −momentum_z from here, + w's share.
    momentum_z -= d.w * nodes_.by_z[j - 1];
    if (!layout_.has_theta()) continue;
    const double by_turning =
        r * (d.length - multiplier * pieces_.length[j] / reference);
    const double share = middle(node);
    const double here =
        by_turning + share * d.theta + d.w * nodes_.by_theta[j] + from_after;
    lambda[at(layout_.place(node))] = -here / r;
    from_after =
        -by_turning + (1.0 - share) * d.theta + d.w * nodes_.by_theta[j - 1];
  }
  return lambda;
}

}  // namespace brachisto
