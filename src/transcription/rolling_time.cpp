// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/transcription/rolling_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "brachisto/model/inertia.hpp"

namespace brachisto {

namespace {

using enum StateComponent;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

nlp::SparsityPattern with_capacity(std::size_t entries) {
  nlp::SparsityPattern pattern;
  pattern.rows.reserve(entries);
  pattern.cols.reserve(entries);
  return pattern;
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

  const auto record = [](nlp::SparsityPattern& pattern) {
    return [&pattern](int row, int col, double) {
      pattern.rows.push_back(row);
      pattern.cols.push_back(col);
    };
  };
  std::size_t entries = 0;
  const auto count = [&entries](int, int, double) { ++entries; };
  visit_jac_g(count);
  jac_g_pattern_ = with_capacity(entries);
  visit_jac_g(record(jac_g_pattern_));
  const std::vector<double> no_lambda(at(num_constraints()));
  entries = 0;
  visit_hess_lag(0.0, no_lambda, count);
  hess_lag_pattern_ = with_capacity(entries);
  visit_hess_lag(0.0, no_lambda, record(hess_lag_pattern_));
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

void RollingTime::do_eval_grad_f(std::span<double> grad_f) const {
  const int p = mesh_.degree;
  const double U = x_[at(layout_.rolling_time())];
  std::fill(grad_f.begin(), grad_f.end(), 0.0);
  double sum = 0.0;
  for (int e = 0; e < mesh_.num_elements(); ++e) {
    for (int j = 0; j < p; ++j) {
      const int point = e * p + j;
      const double weight = mesh_.length(e) * scheme_->rule.weights[at(j)];
      const double slope = U * weight * points_.d_root[at(point)];
      sum += weight * points_.root[at(point)];
      grad_f[at(layout_.beta(point))] = slope;
      if (!layout_.has_theta()) continue;
      for (int n = 0; n <= p; ++n) {
        grad_f[at(layout_.state(e * p + n, Theta))] -=
            slope * scheme_->interpolation(j, n);
      }
    }
  }
  grad_f[at(layout_.rolling_time())] = sum;
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

template <class Put>
void RollingTime::visit_jac_g(Put&& put) const {
  const int p = mesh_.degree;
  const double U = x_[at(layout_.rolling_time())];
  const double g = scene_.gravity;
  const int col_U = layout_.rolling_time();
  for (int e = 0; e < mesh_.num_elements(); ++e) {
    const double h = mesh_.length(e);
    for (int j = 0; j < p; ++j) {
      const int point = e * p + j;
      const std::size_t c = at(point);
      const int col_beta = layout_.beta(point);
      const double w = points_.w[c];
      const double cos_beta = points_.cos_beta[c];
      const double sin_beta = points_.sin_beta[c];

      const auto put_difference = [&](StateComponent component) {
        const int row = layout_.defect(point, component);
        for (int n = 0; n <= p; ++n) {
          put(row, layout_.state(e * p + n, component),
              scheme_->derivative(j, n));
        }
      };
      // The rate of `component` depends on the state `source` at the point,
      // with this slope.
      const auto put_rate = [&](StateComponent component, StateComponent source,
                                double slope) {
        const int row = layout_.defect(point, component);
        for (int n = 0; n <= p; ++n) {
          put(row, layout_.state(e * p + n, source),
              -h * U * slope * scheme_->interpolation(j, n));
        }
      };

      const int row_x = layout_.defect(point, X);
      put_difference(X);
      put_rate(X, W, cos_beta);
      put(row_x, col_beta, h * U * w * sin_beta);
      put(row_x, col_U, -h * w * cos_beta);

      const int row_z = layout_.defect(point, Z);
      put_difference(Z);
      put_rate(Z, W, sin_beta);
      put(row_z, col_beta, -h * U * w * cos_beta);
      put(row_z, col_U, -h * w * sin_beta);

      if (layout_.has_theta()) {
        const double curvature = 1.0 / scene_.body.radius;
        put_difference(Theta);
        put_rate(Theta, W, curvature);
        put(layout_.defect(point, Theta), col_U, -h * w * curvature);
      }

      const int row_w = layout_.defect(point, W);
      put_difference(W);
      if (layout_.has_theta()) {
        put_rate(W, Theta, -g * points_.eta_sin_theta[c]);
      }
      put(row_w, col_beta, -h * U * g * cos_beta);
      put(row_w, col_U, -h * g * (sin_beta + points_.eta_cos_theta[c]));
    }
  }
}

template <class Put>
void RollingTime::visit_hess_lag(double objective_factor,
                                 std::span<const double> lambda,
                                 Put&& put) const {
  // The Lagrangian is a sum over collocation points of
  //   h U { s b √A(θ, β) − λ_x w cos β − λ_z w sin β − λ_θ w/r
  //         − λ_w g (sin β + η cos θ) }
  // plus terms linear in the nodal states, s being the objective factor. So all
  // second derivatives come from θ, w, β and U at the point; those in θ and w
  // are spread to the nodes by the interpolation.
  const int p = mesh_.degree;
  const double U = x_[at(layout_.rolling_time())];
  const double g = scene_.gravity;
  const int row_U = layout_.rolling_time();
  const bool has_theta = layout_.has_theta();
  const math::SmallMatrix& I = scheme_->interpolation;

  struct Second {
    double theta_theta, theta_beta, w_beta, beta_beta, U_theta, U_w, U_beta;
  };
  std::array<Second, kLargestDegree> second;  // NOLINT: filled below

  for (int e = 0; e < mesh_.num_elements(); ++e) {
    const double h = mesh_.length(e);
    for (int j = 0; j < p; ++j) {
      const int point = e * p + j;
      const std::size_t c = at(point);
      const double weight = objective_factor * scheme_->rule.weights[at(j)];
      const double lambda_x = lambda[at(layout_.defect(point, X))];
      const double lambda_z = lambda[at(layout_.defect(point, Z))];
      const double lambda_w = g * lambda[at(layout_.defect(point, W))];
      const double w = points_.w[c];
      const double along =
          lambda_x * points_.cos_beta[c] + lambda_z * points_.sin_beta[c];
      const double across =
          lambda_z * points_.cos_beta[c] - lambda_x * points_.sin_beta[c];
      Second& s = second[at(j)];
      s.w_beta = -h * U * across;
      s.beta_beta = h * U *
                    (weight * points_.d2_root[c] + w * along +
                     lambda_w * points_.sin_beta[c]);
      s.U_w = -h * along;
      s.U_beta = h * (weight * points_.d_root[c] - w * across -
                      lambda_w * points_.cos_beta[c]);
      if (!has_theta) continue;
      s.theta_theta =
          h * U *
          (weight * points_.d2_root[c] + lambda_w * points_.eta_cos_theta[c]);
      s.theta_beta = -h * U * weight * points_.d2_root[c];
      s.U_theta = h * (lambda_w * points_.eta_sin_theta[c] -
                       weight * points_.d_root[c]);
      s.U_w -=
          h * lambda[at(layout_.defect(point, Theta))] / scene_.body.radius;
    }

    const auto put_lower = [&](int a, int b, double value) {
      put(std::max(a, b), std::min(a, b), value);
    };
    const auto spread = [&](int n, double Second::*member) {
      double sum = 0.0;
      for (int j = 0; j < p; ++j) sum += I(j, n) * second[at(j)].*member;
      return sum;
    };
    for (int n = 0; n <= p; ++n) {
      const int w_n = layout_.state(e * p + n, W);
      for (int j = 0; j < p; ++j) {
        put_lower(w_n, layout_.beta(e * p + j), I(j, n) * second[at(j)].w_beta);
      }
      put(row_U, w_n, spread(n, &Second::U_w));
      if (!has_theta) continue;

      const int theta_n = layout_.state(e * p + n, Theta);
      for (int m = 0; m <= n; ++m) {
        double sum = 0.0;
        for (int j = 0; j < p; ++j) {
          sum += I(j, n) * I(j, m) * second[at(j)].theta_theta;
        }
        put(theta_n, layout_.state(e * p + m, Theta), sum);
      }
      for (int j = 0; j < p; ++j) {
        put_lower(theta_n, layout_.beta(e * p + j),
                  I(j, n) * second[at(j)].theta_beta);
      }
      put(row_U, theta_n, spread(n, &Second::U_theta));
    }
    for (int j = 0; j < p; ++j) {
      const int beta = layout_.beta(e * p + j);
      put(beta, beta, second[at(j)].beta_beta);
      put(row_U, beta, second[at(j)].U_beta);
    }
  }
}

void RollingTime::do_eval_jac_g(std::span<double> values) const {
  std::size_t entry = 0;
  visit_jac_g([&](int, int, double value) { values[entry++] = value; });
}

void RollingTime::do_eval_hess_lag(double objective_factor,
                                   std::span<const double> lambda,
                                   std::span<double> values) const {
  std::size_t entry = 0;
  visit_hess_lag(objective_factor, lambda,
                 [&](int, int, double value) { values[entry++] = value; });
}

}  // namespace brachisto
