// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/transcription/arc_length.hpp"

#include <cmath>
#include <limits>

#include "brachisto/math/stop_condition.hpp"
#include "brachisto/model/energy.hpp"
#include "brachisto/model/inertia.hpp"

namespace brachisto {

namespace {

using enum StateComponent;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

ArcLength::ArcLength(const Scene& scene, int num_intervals, double phi)
    : Transcription(
          scene, uniform_mesh(1, num_intervals),
          VariableLayout::of_pieces(num_intervals, scene.body.off_centred()),
          start_of_centre(scene), "node"),
      reference_length_(std::hypot(scene.L, scene.H)),
      constant_root_(std::sqrt(axisymmetric_inertia_factor(scene.body))) {
  set_end_angle(phi);
  for (auto* array :
       {&nodes_.w, &nodes_.by_z, &nodes_.by_theta, &nodes_.by_z_z,
        &nodes_.by_z_theta, &nodes_.by_theta_theta, &pieces_.dx, &pieces_.dz,
        &pieces_.length, &pieces_.sin_theta, &pieces_.cos_theta, &pieces_.root,
        &pieces_.inverse_speed}) {
    array->assign(at(layout().num_nodes()), 0.0);
  }
  build_patterns();
}

nlp::EliminationOrder ArcLength::elimination_order() const {
  nlp::EliminationOrder order;
  const auto put = [&](int column, int row) {
    order.columns.push_back(column);
    order.rows.push_back(row);
  };
  const int n = num_variables();
  for (int node = 1; node <= num_intervals(); ++node) {
    check_stop(node);
    if (layout().has_theta()) {
      put(layout().state(node, Theta), n + layout().place(node));
      put(n + layout().place(node), layout().state(node, Theta));
    }
    put(layout().state(node, X), layout().state(node, X));
    put(layout().state(node, Z), layout().state(node, Z));
    put(n + layout().no_slip(node), n + layout().no_slip(node));
  }
  put(layout().arc_length(), layout().arc_length());
  order.border = 1;
  return order;
}

nlp::ChainStructure ArcLength::chain_structure() const {
  nlp::ChainStructure chain = Transcription::chain_structure();
  chain.scale.assign(chain.block.size(), 1.0);
  const double pieces = num_intervals();
  // Second derivatives of T grow like N³/j² towards the start, first ones of
  // the constraints are of order one.
  const auto of_place = [pieces](int node) {
    return std::exp2(
        std::round(std::log2(node / (pieces * std::sqrt(pieces)))));
  };
  for (int i = 0; i < layout().last(); ++i) {
    check_stop(i);
    chain.scale[at(i)] = of_place(layout().node_of(i));
  }
  for (int i = 0; i < num_constraints(); ++i) {
    check_stop(i);
    chain.scale[at(num_variables() + i)] =
        1.0 / of_place(layout().point_of(i) + 1);
  }
  // Place rows have the entries σ², scaled by 1/of_place: up to √N.
  chain.scale[at(layout().last())] =
      std::exp2(std::round(-0.5 * std::log2(pieces)));
  return chain;
}

double ArcLength::rounding(std::span<const double>) const {
  // A dozen terms, some with larger numbers.
  constexpr double kTerms = 20.0;
  return kTerms * std::numeric_limits<double>::epsilon() * num_intervals();
}

bool ArcLength::evaluate() {
  return set_nodes() && set_pieces();
}

bool ArcLength::set_nodes() {
  const Body& body = scene().body;
  const double g = scene().gravity;
  const double arm = body.radius * body.eta_m;
  for (int node = 1; node <= num_intervals(); ++node) {
    check_stop(node);
    const double drop = x(layout().state(node, Z));
    double E = drop;
    double E_theta = 0.0;
    double E_theta_theta = 0.0;
    if (layout().has_theta()) {
      const double turned = x(layout().state(node, Theta));
      const double theta = body.theta_m + turned;
      E = energy_height_after(body, drop, turned);
      E_theta = arm * std::cos(theta);
      E_theta_theta = -arm * std::sin(theta);
    }
    if (!(E > 0.0)) return refuse(node, "the energy E is not positive");
    const double w = fall_speed(g, E);
    const double by_E = g / w;
    const double by_E_E = -by_E * by_E / w;
    const std::size_t j = at(node);
    nodes_.w[j] = w;
    nodes_.by_z[j] = by_E;
    nodes_.by_theta[j] = by_E * E_theta;
    nodes_.by_z_z[j] = by_E_E;
    nodes_.by_z_theta[j] = by_E_E * E_theta;
    nodes_.by_theta_theta[j] =
        by_E_E * E_theta * E_theta + by_E * E_theta_theta;
  }
  return true;
}

bool ArcLength::set_pieces() {
  const Body& body = scene().body;
  const double eta = body.eta_m;
  const double S = x(layout().arc_length());
  if (!(S > 0.0)) return refuse(-1, "the arc length S is not positive");
  double last_x = 0.0, last_z = 0.0, last_theta = 0.0;
  for (int node = 1; node <= num_intervals(); ++node) {
    check_stop(node);
    const std::size_t j = at(node);
    const double next_x = x(layout().state(node, X));
    const double next_z = x(layout().state(node, Z));
    const double dx = pieces_.dx[j] = next_x - last_x;
    const double dz = pieces_.dz[j] = next_z - last_z;
    last_x = next_x;
    last_z = next_z;
    pieces_.inverse_speed[j] = 2.0 / (nodes_.w[j - 1] + nodes_.w[j]);
    if (!layout().has_theta()) {
      pieces_.length[j] = S * share(node);
      pieces_.root[j] = pieces_.length[j] * constant_root_;
      continue;
    }
    const double next_theta = x(layout().state(node, Theta));
    const double turned = last_theta + middle(node) * (next_theta - last_theta);
    const double length = body.radius * (next_theta - last_theta);
    last_theta = next_theta;
    const double sin_theta = std::sin(body.theta_m + turned);
    const double cos_theta = std::cos(body.theta_m + turned);
    // (r Δθ)² A with the slope's sine and cosine written out.
    const double square =
        length * ((1.0 + eta * eta + body.k) * length -
                  2.0 * eta * (sin_theta * dx - cos_theta * dz));
    if (!(length > 0.0)) return refuse(node, "the rotation does not grow");
    if (!(square > 0.0)) {
      return refuse(node, "the inertia factor A is not positive");
    }
    pieces_.length[j] = length;
    pieces_.sin_theta[j] = sin_theta;
    pieces_.cos_theta[j] = cos_theta;
    pieces_.root[j] = std::sqrt(square);
  }
  return true;
}

double ArcLength::do_eval_f() const {
  double sum = 0.0;
  for (std::size_t j = 1; j < pieces_.root.size(); ++j) {
    sum += pieces_.root[j] * pieces_.inverse_speed[j];
  }
  return sum;
}

void ArcLength::do_eval_g(std::span<double> g) const {
  const double r = scene().body.radius;
  const double S = x(layout().arc_length());
  for (int node = 1; node <= num_intervals(); ++node) {
    check_stop(node);
    const std::size_t j = at(node);
    const double dx = pieces_.dx[j];
    const double dz = pieces_.dz[j];
    const double length = pieces_.length[j];
    g[at(layout().no_slip(node))] =
        0.5 * (dx * dx + dz * dz - length * length) / reference_length(node);
    if (!layout().has_theta()) continue;
    g[at(layout().place(node))] =
        r * x(layout().state(node, Theta)) - S * sigma(node) * sigma(node);
  }
}

}  // namespace brachisto
