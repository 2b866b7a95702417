// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/transcription/arc_length.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "brachisto/math/stop_condition.hpp"
#include "brachisto/model/energy.hpp"
#include "brachisto/model/inertia.hpp"

namespace brachisto {

namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

ArcLength::ArcLength(const Scene& scene, int num_intervals, double phi)
    : scene_(scene),
      start_(start_of_centre(scene)),
      layout_(num_intervals, scene.body.off_centred()),
      reference_length_(std::hypot(scene.L, scene.H)),
      constant_root_(std::sqrt(axisymmetric_inertia_factor(scene.body))),
      lower_(at(layout_.num_variables()),
             -std::numeric_limits<double>::infinity()),
      upper_(at(layout_.num_variables()),
             std::numeric_limits<double>::infinity()),
      x_(at(layout_.num_variables())) {
  set_end_angle(phi);
  for (auto* array :
       {&nodes_.w, &nodes_.by_z, &nodes_.by_theta, &nodes_.by_z_z,
        &nodes_.by_z_theta, &nodes_.by_theta_theta, &pieces_.dx, &pieces_.dz,
        &pieces_.length, &pieces_.sin_theta, &pieces_.cos_theta, &pieces_.root,
        &pieces_.inverse_speed}) {
    array->assign(at(layout_.num_nodes()), 0.0);
  }
  build_patterns();
}

void ArcLength::set_end_angle(double phi) {
  const Point end = end_of_centre(scene_, phi);
  const int x = layout_.x(num_intervals());
  const int z = layout_.z(num_intervals());
  lower_[at(x)] = upper_[at(x)] = end.x - start_.x;
  lower_[at(z)] = upper_[at(z)] = end.z - start_.z;
}

bool ArcLength::refuse(int node, const char* reason) {
  refused_node_ = node;
  refused_because_ = reason;
  return false;
}

std::string ArcLength::refusal() const {
  if (refused_node_ < 0) return refused_because_;
  return fmt::format("{} at node {} of {}", refused_because_, refused_node_,
                     num_intervals());
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
    if (layout_.has_theta()) {
      put(layout_.theta(node), n + layout_.place(node));
      put(n + layout_.place(node), layout_.theta(node));
    }
    put(layout_.x(node), layout_.x(node));
    put(layout_.z(node), layout_.z(node));
    put(n + layout_.no_slip(node), n + layout_.no_slip(node));
  }
  put(layout_.arc_length(), layout_.arc_length());
  order.border = 1;
  return order;
}

nlp::ChainStructure ArcLength::chain_structure() const {
  nlp::ChainStructure chain;
  const auto size =
      static_cast<std::size_t>(num_variables() + num_constraints());
  chain.num_links = num_intervals();
  chain.block.assign(size, nlp::ChainStructure::kBorder);
  chain.scale.assign(size, 1.0);
  const int n = num_variables();
  const double pieces = num_intervals();
  for (int node = 1; node <= num_intervals(); ++node) {
    check_stop(node);
    // Second derivatives of T grow like N³/j² towards the start, first ones of
    // the constraints are of order one.
    const double of_place =
        std::exp2(std::round(std::log2(node / (pieces * std::sqrt(pieces)))));
    const auto put = [&](int unknown, double scale) {
      chain.block[static_cast<std::size_t>(unknown)] = 2 * node;
      chain.scale[static_cast<std::size_t>(unknown)] = scale;
    };
    put(layout_.x(node), of_place);
    put(layout_.z(node), of_place);
    put(n + layout_.no_slip(node), 1.0 / of_place);
    if (!layout_.has_theta()) continue;
    put(layout_.theta(node), of_place);
    put(n + layout_.place(node), 1.0 / of_place);
  }
  // Place rows have the entries σ², scaled by 1/of_place: up to √N.
  chain.scale[static_cast<std::size_t>(layout_.arc_length())] =
      std::exp2(std::round(-0.5 * std::log2(pieces)));
  return chain;
}

bool ArcLength::do_set_point(std::span<const double> x) {
  x_.assign(x.begin(), x.end());
  return set_nodes() && set_pieces();
}

bool ArcLength::set_nodes() {
  const Body& body = scene_.body;
  const double g = scene_.gravity;
  const double arm = body.radius * body.eta_m;
  for (int node = 1; node <= num_intervals(); ++node) {
    check_stop(node);
    const double drop = x_[at(layout_.z(node))];
    double E = drop;
    double E_theta = 0.0;
    double E_theta_theta = 0.0;
    if (layout_.has_theta()) {
      const double turned = x_[at(layout_.theta(node))];
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
  const Body& body = scene_.body;
  const double eta = body.eta_m;
  const double S = x_[at(layout_.arc_length())];
  if (!(S > 0.0)) return refuse(-1, "the arc length S is not positive");
  double x = 0.0, z = 0.0, theta = 0.0;
  for (int node = 1; node <= num_intervals(); ++node) {
    check_stop(node);
    const std::size_t j = at(node);
    const double next_x = x_[at(layout_.x(node))];
    const double next_z = x_[at(layout_.z(node))];
    const double dx = pieces_.dx[j] = next_x - x;
    const double dz = pieces_.dz[j] = next_z - z;
    x = next_x;
    z = next_z;
    pieces_.inverse_speed[j] = 2.0 / (nodes_.w[j - 1] + nodes_.w[j]);
    if (!layout_.has_theta()) {
      pieces_.length[j] = S * share(node);
      pieces_.root[j] = pieces_.length[j] * constant_root_;
      continue;
    }
    const double next_theta = x_[at(layout_.theta(node))];
    const double turned = theta + middle(node) * (next_theta - theta);
    const double length = body.radius * (next_theta - theta);
    theta = next_theta;
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
  const double r = scene_.body.radius;
  const double S = x_[at(layout_.arc_length())];
  for (int node = 1; node <= num_intervals(); ++node) {
    check_stop(node);
    const std::size_t j = at(node);
    const double dx = pieces_.dx[j];
    const double dz = pieces_.dz[j];
    const double length = pieces_.length[j];
    g[at(layout_.no_slip(node))] =
        0.5 * (dx * dx + dz * dz - length * length) / reference_length(node);
    if (!layout_.has_theta()) continue;
    g[at(layout_.place(node))] =
        r * x_[at(layout_.theta(node))] - S * sigma(node) * sigma(node);
  }
}

}  // namespace brachisto
