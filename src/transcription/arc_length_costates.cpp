// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Costates of an arc_length problem, and multipliers from them.

#include <cmath>
#include <cstddef>
#include <optional>

#include "brachisto/math/stop_condition.hpp"
#include "brachisto/transcription/arc_length.hpp"

namespace brachisto {

namespace {

using enum StateComponent;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

Costates ArcLength::end_costates(std::span<const double> lambda) const {
  const int last = num_intervals();
  const std::size_t j = at(last);
  const double multiplier = lambda[at(layout().no_slip(last))];
  const double inverse = 1.0 / reference_length(last);
  const Slopes d = slopes(last);
  return {.p_x = -(d.x + multiplier * pieces_.dx[j] * inverse),
          .p_z = -(d.z + d.w * nodes_.by_z[j] +
                   multiplier * pieces_.dz[j] * inverse)};
}

std::optional<Transcription::End> ArcLength::end(
    std::span<const double> x, std::span<const double> lambda) {
  if (!set_point(x)) return std::nullopt;
  const int last = num_intervals();
  const std::size_t j = at(last);
  const double multiplier = lambda[at(layout().no_slip(last))];
  const double inverse = 1.0 / reference_length(last);
  const int own = layout().state(last, X);
  const int before = layout().state(last - 1, X);
  End out;
  out.state = {scene().body.theta_m, nodes_.w[j]};
  out.p = end_costates(lambda);
  out.last_slope = std::atan2(pieces_.dz[j], pieces_.dx[j]);
  out.by_lambda = {{layout().no_slip(last), 0.0, 0.0, -pieces_.dx[j] * inverse,
                    -pieces_.dz[j] * inverse}};
  if (layout().has_theta()) {
    out.state.theta += x[at(layout().state(last, Theta))];
    const Block h = block(last, 1.0, multiplier);
    out.by_x = {
        {own, 0.0, 0.0, -h.own[0], -h.own[1]},
        {own + 1, 0.0, nodes_.by_z[j], -h.own[1], -h.own[2]},
        {own + 2, 1.0, nodes_.by_theta[j], -h.own[3], -h.own[4]},
        {before, 0.0, 0.0, -h.between[0], -h.between[3]},
        {before + 1, 0.0, 0.0, -h.between[1], -h.between[4]},
        {before + 2, 0.0, 0.0, -h.between[2], -h.between[5]},
    };
    return out;
  }
  const double stiff = multiplier * inverse;
  const auto [w_w, S_w] = axisymmetric_curvature(last);
  const double by_z = nodes_.by_z[j];
  out.by_x = {
      {own, 0.0, 0.0, -stiff, 0.0},
      {own + 1, 0.0, by_z, 0.0,
       -(stiff + w_w * by_z * by_z + slopes(last).w * nodes_.by_z_z[j])},
      {before, 0.0, 0.0, stiff, 0.0},
      {before + 1, 0.0, 0.0, 0.0, stiff - w_w * by_z * nodes_.by_z[j - 1]},
      {layout().arc_length(), 0.0, 0.0, 0.0, -S_w * by_z},
  };
  return out;
}

std::vector<ArcLength::PieceState> ArcLength::piece_states(
    std::span<const double> lambda) const {
  const auto [p_x, p_z, p_theta, p_w] = end_costates(lambda);
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
        d.z + lambda[at(layout().no_slip(node))] * dz / reference_length(node);
    const double theta = layout().has_theta() ? std::atan2(pieces_.sin_theta[j],
                                                           pieces_.cos_theta[j])
                                              : scene().body.theta_m;
    states.push_back({node,
                      theta,
                      w,
                      std::atan2(dz, dx),
                      {.p_x = p_x,
                       .p_z = p_z,
                       .p_w = -(momentum_z + p_z) * w / scene().gravity}});
  }
  return states;
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
    lambda[at(layout().no_slip(node))] = multiplier;
    // The node before has −momentum_z from here, + w's share.
    momentum_z -= d.w * nodes_.by_z[j - 1];
    if (!layout().has_theta()) continue;
    const double by_turning =
        r * (d.length - multiplier * pieces_.length[j] / reference);
    const double share = middle(node);
    const double here =
        by_turning + share * d.theta + d.w * nodes_.by_theta[j] + from_after;
    lambda[at(layout().place(node))] = -here / r;
    from_after =
        -by_turning + (1.0 - share) * d.theta + d.w * nodes_.by_theta[j - 1];
  }
  return lambda;
}

}  // namespace brachisto
