// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/trajectory/extended_residual.hpp"

#include <cmath>
#include <vector>

#include "brachisto/math/jet2.hpp"
#include "brachisto/math/stop_condition.hpp"
#include "brachisto/model/energy.hpp"
#include "brachisto/model/inertia.hpp"
#include "trajectory/residual_summary.hpp"

namespace brachisto {

namespace {

using enum StateComponent;
using Real = long double;
// Derivatives with respect to θ, w, β and U at a collocation point.
using Jet = math::Jet2<Real, 4>;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// Rates of the states and of time at a collocation point.
struct Rates {
  Jet x, z, theta, w, time;
};

Rates rates(const Scene& scene, bool has_theta, Real theta, Real w, Real beta,
            Real U) {
  const Body& body = scene.body;
  const Jet jet_theta = Jet::variable(theta, 0);
  const Jet jet_w = Jet::variable(w, 1);
  const Jet jet_beta = Jet::variable(beta, 2);
  const Jet jet_U = Jet::variable(U, 3);
  Rates out;
  out.x = jet_U * jet_w * cos(jet_beta);
  out.z = jet_U * jet_w * sin(jet_beta);
  const Jet g(static_cast<Real>(scene.gravity));
  if (has_theta) {
    out.theta = jet_U * jet_w / Jet(static_cast<Real>(body.radius));
    out.w = jet_U * g * energy_slope(body, jet_theta, jet_beta);
    out.time = jet_U * sqrt(inertia_factor(body, jet_theta, jet_beta));
  } else {
    out.w = jet_U * g * sin(jet_beta);
    out.time =
        jet_U *
        Jet(std::sqrt(static_cast<Real>(axisymmetric_inertia_factor(body))));
  }
  return out;
}

}  // namespace

ExtendedResidual extended_residual(const RollingTime& problem,
                                   const PrimalDual& point) {
  const VariableLayout& layout = problem.layout();
  const Mesh& mesh = problem.mesh();
  const CollocationScheme& scheme = problem.scheme();
  const int p = mesh.degree;
  const bool has_theta = layout.has_theta();
  const auto x = [&](int i) { return static_cast<Real>(point.x[at(i)]); };
  std::vector<Real> gradient(point.x.size());
  Worst defect;

  for (int e = 0; e < mesh.num_elements(); ++e) {
    check_stop(e);
    const Real h = static_cast<Real>(mesh.boundaries[at(e + 1)]) -
                   static_cast<Real>(mesh.boundaries[at(e)]);
    for (int j = 0; j < p; ++j) {
      const int c = e * p + j;
      Real theta = 0.0L;
      Real w = 0.0L;
      for (int n = 0; n <= p; ++n) {
        const Real weight = scheme.interpolation(j, n);
        w += weight * x(layout.state(e * p + n, W));
        if (has_theta) theta += weight * x(layout.state(e * p + n, Theta));
      }
      const Rates f = rates(problem.scene(), has_theta, theta, w,
                            x(layout.beta(c)), x(layout.rolling_time()));

      // Lagrangian of the point: h (b U √A − Σ λ_i U f_i) + λᵀ D X.
      Jet lagrangian =
          f.time * Jet(static_cast<Real>(scheme.rule.weights[at(j)]));
      const auto constrain = [&](StateComponent component, const Jet& rate) {
        const int row = layout.defect(c, component);
        const Real lambda = point.lambda[at(row)];
        lagrangian -= rate * Jet(lambda);
        Real difference = 0.0L;
        for (int n = 0; n <= p; ++n) {
          const int i = layout.state(e * p + n, component);
          const Real slope = scheme.derivative(j, n);
          difference += slope * x(i);
          gradient[at(i)] += lambda * slope;
        }
        defect.see(difference - h * rate.value, row);
      };
      constrain(X, f.x);
      constrain(Z, f.z);
      if (has_theta) constrain(Theta, f.theta);
      constrain(W, f.w);

      for (int n = 0; n <= p; ++n) {
        const Real weight = h * static_cast<Real>(scheme.interpolation(j, n));
        gradient[at(layout.state(e * p + n, W))] +=
            weight * lagrangian.gradient[1];
        if (has_theta) {
          gradient[at(layout.state(e * p + n, Theta))] +=
              weight * lagrangian.gradient[0];
        }
      }
      gradient[at(layout.beta(c))] += h * lagrangian.gradient[2];
      gradient[at(layout.rolling_time())] += h * lagrangian.gradient[3];
    }
  }

  return summarise(problem, point, gradient, defect);
}

}  // namespace brachisto
