// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/transcription/rolling_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "brachisto/math/stop_condition.hpp"
#include "brachisto/model/inertia.hpp"

namespace brachisto {

namespace {

using enum StateComponent;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

RollingTime::RollingTime(const Scene& scene, Mesh mesh, double phi)
    : scene_(scene),
      mesh_(std::move(mesh)),
      layout_(mesh_.num_points(), scene.body.off_centred()),
      scheme_(&collocation_scheme(mesh_.degree)),
      lower_(at(layout_.num_variables()),
             -std::numeric_limits<double>::infinity()),
      upper_(at(layout_.num_variables()),
             std::numeric_limits<double>::infinity()),
      x_(at(layout_.num_variables())) {
  const Point start = start_of_centre(scene_);
  fix(layout_.state(0, X), start.x);
  fix(layout_.state(0, Z), start.z);
  if (layout_.has_theta()) fix(layout_.state(0, Theta), scene_.body.theta_m);
  fix(layout_.state(0, W), 0.0);
  set_end_angle(phi);

  for (auto* array : {&points_.w, &points_.cos_beta, &points_.sin_beta,
                      &points_.root, &points_.d_root, &points_.d2_root,
                      &points_.eta_cos_theta, &points_.eta_sin_theta}) {
    array->assign(at(mesh_.num_points()), 0.0);
  }

  build_patterns();
}

void RollingTime::fix(int variable, double value) {
  lower_[at(variable)] = value;
  upper_[at(variable)] = value;
}

void RollingTime::set_end_angle(double phi) {
  const Point end = end_of_centre(scene_, phi);
  fix(layout_.state(mesh_.num_points(), X), end.x);
  fix(layout_.state(mesh_.num_points(), Z), end.z);
}

bool RollingTime::refuse(int point, const char* reason) {
  refused_point_ = point;
  refused_because_ = reason;
  return false;
}

nlp::EliminationOrder RollingTime::elimination_order() const {
  nlp::EliminationOrder order;
  const int n = num_variables();
  const auto put = [&](int column, int row) {
    order.columns.push_back(column);
    order.rows.push_back(row);
  };
  const int states = layout_.num_states();
  const int first_state = layout_.state(0, X);
  for (int s = 0; s < states; ++s) put(first_state + s, first_state + s);
  for (int c = 0; c < mesh_.num_points(); ++c) {
    put(layout_.beta(c), layout_.beta(c));
    const int state = layout_.state(c + 1, X);
    const int defect = n + layout_.defect(c, X);
    for (int s = 0; s < states; ++s) put(state + s, defect + s);
    for (int s = 0; s < states; ++s) put(defect + s, state + s);
  }
  put(layout_.rolling_time(), layout_.rolling_time());
  order.border = 1;
  return order;
}

nlp::ChainStructure RollingTime::chain_structure() const {
  nlp::ChainStructure chain;
  chain.num_links = mesh_.num_elements();
  chain.block.resize(at(num_variables() + num_constraints()));
  const int p = mesh_.degree;
  const int states = layout_.num_states();
  // The block of a node, and of the multipliers that lead to it.
  const auto block_of_node = [&](int node) {
    return 2 * (node / p) + (node % p == 0 ? 0 : 1);
  };
  for (int node = 0; node < layout_.num_nodes(); ++node) {
    const int first = layout_.state(node, X);
    for (int s = 0; s < states; ++s) {
      chain.block[at(first + s)] = block_of_node(node);
    }
  }
  for (int c = 0; c < mesh_.num_points(); ++c) {
    chain.block[at(layout_.beta(c))] = 2 * (c / p) + 1;
    const int first = num_variables() + layout_.defect(c, X);
    for (int s = 0; s < states; ++s) {
      chain.block[at(first + s)] = block_of_node(c + 1);
    }
  }
  chain.block[at(layout_.rolling_time())] = nlp::ChainStructure::kBorder;
  return chain;
}

std::string RollingTime::refusal() const {
  if (refused_point_ < 0) return refused_because_;
  return fmt::format("{} at collocation point {} of {}", refused_because_,
                     refused_point_, mesh_.num_points());
}

bool RollingTime::do_set_point(std::span<const double> x) {
  x_.assign(x.begin(), x.end());
  const int p = mesh_.degree;
  const double eta = scene_.body.eta_m;
  const double constant_root =
      std::sqrt(axisymmetric_inertia_factor(scene_.body));

  if (!(x_[at(layout_.rolling_time())] > 0.0)) {
    return refuse(-1, "the rolling time U is not positive");
  }
  for (int e = 0; e < mesh_.num_elements(); ++e) {
    check_stop(e);
    for (int j = 0; j < p; ++j) {
      const int point = e * p + j;
      double w = 0.0;
      double theta = 0.0;
      for (int n = 0; n <= p; ++n) {
        const double weight = scheme_->interpolation(j, n);
        w += weight * x_[at(layout_.state(e * p + n, W))];
        if (layout_.has_theta()) {
          theta += weight * x_[at(layout_.state(e * p + n, Theta))];
        }
      }
      const double beta = x_[at(layout_.beta(point))];
      const std::size_t c = at(point);
      points_.w[c] = w;
      points_.cos_beta[c] = std::cos(beta);
      points_.sin_beta[c] = std::sin(beta);
      points_.root[c] = constant_root;
      if (layout_.has_theta()) {
        const double A = inertia_factor(scene_.body, theta, beta);
        if (!(A > 0.0)) {
          return refuse(point, "the inertia factor A is not positive");
        }
        const double root = std::sqrt(A);
        const double d = eta * std::cos(theta - beta) / root;
        points_.root[c] = root;
        points_.d_root[c] = d;
        points_.d2_root[c] = (eta * std::sin(theta - beta) - d * d) / root;
        points_.eta_cos_theta[c] = eta * std::cos(theta);
        points_.eta_sin_theta[c] = eta * std::sin(theta);
      }
      if (!(w > 0.0)) return refuse(point, "the speed w is not positive");
      if (!std::isfinite(points_.cos_beta[c])) {
        return refuse(point, "the slope angle is not finite");
      }
    }
  }
  return true;
}

double RollingTime::do_eval_f() const {
  double sum = 0.0;
  for (int e = 0; e < mesh_.num_elements(); ++e) {
    double element = 0.0;
    for (int j = 0; j < mesh_.degree; ++j) {
      element +=
          scheme_->rule.weights[at(j)] * points_.root[at(e * mesh_.degree + j)];
    }
    sum += mesh_.length(e) * element;
  }
  return x_[at(layout_.rolling_time())] * sum;
}

void RollingTime::do_eval_g(std::span<double> g) const {
  const int p = mesh_.degree;
  const Body& body = scene_.body;
  for (int e = 0; e < mesh_.num_elements(); ++e) {
    const double hU = mesh_.length(e) * x_[at(layout_.rolling_time())];
    for (int j = 0; j < p; ++j) {
      const int point = e * p + j;
      const std::size_t c = at(point);
      const auto difference = [&](StateComponent component) {
        double sum = 0.0;
        for (int n = 0; n <= p; ++n) {
          sum += scheme_->derivative(j, n) *
                 x_[at(layout_.state(e * p + n, component))];
        }
        return sum;
      };
      const double w = points_.w[c];
      g[at(layout_.defect(point, X))] =
          difference(X) - hU * w * points_.cos_beta[c];
      g[at(layout_.defect(point, Z))] =
          difference(Z) - hU * w * points_.sin_beta[c];
      if (layout_.has_theta()) {
        g[at(layout_.defect(point, Theta))] =
            difference(Theta) - hU * w / body.radius;
      }
      g[at(layout_.defect(point, W))] =
          difference(W) - hU * scene_.gravity *
                              (points_.sin_beta[c] + points_.eta_cos_theta[c]);
    }
  }
}

}  // namespace brachisto
