// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/arc_length.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/index.hpp"
#include "model/energy.hpp"
#include "transcription/program_formulas.hpp"

namespace brachisto {

namespace {

using enum StateComponent;

/// The one next to `value` > 0, by their ratio.
double power_of_two(double value) {
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);  // from ½ to 1
  return std::ldexp(mantissa < 0.5 * std::numbers::sqrt2 ? 0.5 : 1.0, exponent);
}

}  // namespace

ArcLength::ArcLength(const Scene& scene, int num_intervals, double phi)
    : Transcription(
          scene, uniform_mesh(1, num_intervals),
          VariableLayout::of_pieces(num_intervals, scene.body.off_centred()),
          start_of_centre(scene), "node"),
      reference_length_(std::hypot(scene.L, scene.H)),
      speeds_(at(num_intervals + 1)),
      pieces_(speeds_.size()) {
  set_end_angle(phi);
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
  chain.scale.resize(chain.block.size());
  const double pieces = num_intervals();
  const double root = std::sqrt(pieces);
  // Second derivatives of T grow like N³/j² towards the start, first ones of
  // the constraints are of order one.
  const double per_node = 1.0 / (pieces * root);
  const int states = layout().num_states();
  const int rows = layout().has_theta() ? 2 : 1;  // no slip, place
  const auto of_variables = chain.scale.begin();
  const auto of_rows = of_variables + num_variables();
  for (int node = 1; node <= num_intervals(); ++node) {
    check_stop(node);
    const double scale = power_of_two(node * per_node);
    std::fill_n(of_variables + layout().state(node, X), states, scale);
    std::fill_n(of_rows + layout().no_slip(node), rows, 1.0 / scale);
  }
  // Place rows have the entries σ², scaled by 1/per_node: up to √N.
  chain.scale[at(layout().last())] = power_of_two(1.0 / root);
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
  const double sin_start = std::sin(body.theta_m);
  const double cos_start = std::cos(body.theta_m);
  for (int node = 1; node <= num_intervals(); ++node) {
    check_stop(node);
    const double drop = x(layout().state(node, Z));
    const double half =
        layout().has_theta() ? 0.5 * x(layout().state(node, Theta)) : 0.0;
    // The only sines of the node; its rotation is half and half more.
    const double sin_half = std::sin(half);
    const double cos_half = std::cos(half);
    const double sin_there = sin_start * cos_half + cos_start * sin_half;
    const double cos_there = cos_start * cos_half - sin_start * sin_half;
    const double E = energy_height_halfway(body, drop, sin_half, cos_there);
    if (!(E > 0.0)) return refuse(node, "the energy E is not positive");
    const double w = fall_speed(g, E);
    speeds_[at(node)] = {w, g / w,
                         arm * (cos_there * cos_half - sin_there * sin_half),
                         -arm * (sin_there * cos_half + cos_there * sin_half)};
  }
  return true;
}

double ArcLength::turned(int node) const {
  if (!layout().has_theta()) return 0.0;
  const double after = x(layout().state(node, Theta));
  const double before = node > 1 ? x(layout().state(node - 1, Theta)) : 0.0;
  return before + middle(node) * (after - before);
}

bool ArcLength::set_pieces() {
  const Body& body = scene().body;
  const double S = x(layout().arc_length());
  if (!(S > 0.0)) return refuse(-1, "the arc length S is not positive");
  double last_x = 0.0, last_z = 0.0, last_theta = 0.0;
  for (int node = 1; node <= num_intervals(); ++node) {
    check_stop(node);
    Piece& piece = pieces_[at(node)];
    const double next_x = x(layout().state(node, X));
    const double next_z = x(layout().state(node, Z));
    piece.dx = next_x - last_x;
    piece.dz = next_z - last_z;
    last_x = next_x;
    last_z = next_z;
    piece.inverse_speed =
        inverse_mean_speed(speeds_[at(node - 1)].w, speeds_[at(node)].w);
    piece.length = S * share(node);
    if (layout().has_theta()) {
      const double next_theta = x(layout().state(node, Theta));
      piece.length = body.radius * (next_theta - last_theta);
      last_theta = next_theta;
    }
    if (!(piece.length > 0.0))
      return refuse(node, "the rotation does not grow");
    const double theta = body.theta_m + turned(node);
    piece.sin_theta = std::sin(theta);
    piece.cos_theta = std::cos(theta);
    const double square = piece_square(body, piece.dx, piece.dz, piece.length,
                                       piece.sin_theta, piece.cos_theta);
    if (!(square > 0.0)) {
      return refuse(node, "the inertia factor A is not positive");
    }
    piece.root = std::sqrt(square);
  }
  return true;
}

double ArcLength::do_eval_f() const {
  double sum = 0.0;
  for (int node = 1; node <= num_intervals(); ++node) {
    sum += pieces_[at(node)].root * pieces_[at(node)].inverse_speed;
  }
  return sum;
}

void ArcLength::do_eval_g(std::span<double> g) const {
  const double r = scene().body.radius;
  const double S = x(layout().arc_length());
  for (int node = 1; node <= num_intervals(); ++node) {
    check_stop(node);
    const auto [dx, dz, length, sin_theta, cos_theta, root, inverse_speed] =
        pieces_[at(node)];
    g[at(layout().no_slip(node))] =
        slip(dx, dz, length, reference_length(node));
    if (!layout().has_theta()) continue;
    g[at(layout().place(node))] =
        misplacement(r, x(layout().state(node, Theta)), S, sigma(node));
  }
}

}  // namespace brachisto
