// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/extended_residual.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include "brachisto/math/stop_condition.hpp"
#include "math/index.hpp"
#include "math/jet1.hpp"
#include "model/energy.hpp"
#include "model/field.hpp"
#include "model/inertia.hpp"

namespace brachisto {

namespace {

using enum StateComponent;
using Real = long double;
// Derivatives with respect to θ, w, β and U at a collocation point, and where
// they matter to x and z.
using OrdinaryJet = math::Jet1<Real, 4>;
using WorldJet = math::Jet1<Real, 6>;

/// Keeps the largest absolute value and its index; a NaN stays.
struct Worst {
  long double value = 0.0L;
  int index = -1;

  void see(long double candidate, int i) {
    if (std::isnan(value) || std::abs(candidate) <= value) return;
    value = std::abs(candidate);
    index = i;
  }
};

/// \param gradient  of the Lagrangian at `point`; free variables have to make
///                  it zero, fixed ones have to have their value
/// \param defect    the worst constraint
ExtendedResidual summarise(const nlp::Problem& problem, const PrimalDual& point,
                           std::span<const long double> gradient,
                           const Worst& defect) {
  Worst stationarity;
  Worst fixed_value;
  for (int i = 0; i < problem.num_variables(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double value = problem.lower()[k];
    if (value == problem.upper()[k]) {
      fixed_value.see(static_cast<long double>(point.x[k]) - value, i);
    } else {
      stationarity.see(gradient[k], i);
    }
  }
  ExtendedResidual out{static_cast<double>(stationarity.value),
                       static_cast<double>(defect.value),
                       static_cast<double>(fixed_value.value),
                       {},
                       {}};
  if (stationarity.index >= 0) {
    out.worst_variable = problem.variable_name(stationarity.index);
  }
  if (defect.index >= 0) {
    out.worst_constraint = problem.constraint_name(defect.index);
  }
  return out;
}

/// Where a collocation point is.
struct PointState {
  Real x, z, theta, w, beta, U;
};

/// Rates of the states and of time at a collocation point.
template <class Jet>
struct Rates {
  Jet x, z, theta, w, time;
};

template <class Jet>
Rates<Jet> rates(const Scene& scene, bool has_theta, const PointState& at) {
  const auto& [x, z, theta, w, beta, U] = at;
  const Body& body = scene.body;
  const Jet jet_theta = Jet::variable(theta, 0);
  const Jet jet_w = Jet::variable(w, 1);
  const Jet jet_beta = Jet::variable(beta, 2);
  const Jet jet_U = Jet::variable(U, 3);
  Rates<Jet> out;
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
  if constexpr (std::is_same_v<Jet, WorldJet>) {
    out.w = jet_U * speed_gain(scene, Jet::variable(x, 4), Jet::variable(z, 5),
                               jet_theta, jet_w, jet_beta, out.time / jet_U);
  }
  return out;
}

// Derivatives with respect to x, z and the rotation of the node before a piece,
// of its own one, and S.
using NodeJet = math::Jet1<Real, 7>;

/// Place, rotation and √(2 g E) of a node.
struct Node {
  Real x = 0.0L, z = 0.0L, turned = 0.0L;
  /// By the place z and the rotation alone; 0 at the start, where it is given.
  math::Jet1<Real, 2> w;
};

/// w as a function of all, z being number `z` of them and the rotation the
/// next.
NodeJet speed(const Node& node, std::size_t z) {
  NodeJet out(node.w.value);
  out.gradient[z] = node.w.gradient[0];
  out.gradient[z + 1] = node.w.gradient[1];
  return out;
}

template <class Jet>
ExtendedResidual collocation_residual(const RollingTime& problem,
                                      const PrimalDual& point) {
  constexpr bool kPlaceMatters = std::is_same_v<Jet, WorldJet>;
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
      PointState at_c{
          0.0L, 0.0L, 0.0L, 0.0L, x(layout.beta(c)), x(layout.rolling_time())};
      for (int n = 0; n <= p; ++n) {
        const Real weight = scheme.interpolation(j, n);
        at_c.w += weight * x(layout.state(e * p + n, W));
        if (has_theta) at_c.theta += weight * x(layout.state(e * p + n, Theta));
        if constexpr (kPlaceMatters) {
          at_c.x += weight * x(layout.state(e * p + n, X));
          at_c.z += weight * x(layout.state(e * p + n, Z));
        }
      }
      const Rates f = rates<Jet>(problem.scene(), has_theta, at_c);

      // Lagrangian of the point: h (b U √A − Σ λ_i U f_i) + λᵀ D X.
      Jet lagrangian =
          f.time * Jet(static_cast<Real>(scheme.rule.weights[at(j)]));
      const auto constrain = [&](StateComponent component, const Jet& rate) {
        const int row = layout.defect(c, component);
        const Real lambda = point.lambda[at(row)];
        lagrangian += -(rate * Jet(lambda));
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
        if constexpr (kPlaceMatters) {
          gradient[at(layout.state(e * p + n, X))] +=
              weight * lagrangian.gradient[4];
          gradient[at(layout.state(e * p + n, Z))] +=
              weight * lagrangian.gradient[5];
        }
      }
      gradient[at(layout.beta(c))] += h * lagrangian.gradient[2];
      gradient[at(layout.rolling_time())] += h * lagrangian.gradient[3];
    }
  }

  return summarise(problem, point, gradient, defect);
}

}  // namespace

ExtendedResidual extended_residual(const RollingTime& problem,
                                   const PrimalDual& point) {
  return problem.scene().world.changes_rates()
             ? collocation_residual<WorldJet>(problem, point)
             : collocation_residual<OrdinaryJet>(problem, point);
}

ExtendedResidual extended_residual(const ArcLength& problem,
                                   const PrimalDual& point) {
  const VariableLayout& layout = problem.layout();
  const Scene& scene = problem.scene();
  const Body& body = scene.body;
  const bool has_theta = layout.has_theta();
  const int stride = layout.num_states();
  const auto x = [&](int i) { return static_cast<Real>(point.x[at(i)]); };
  const auto node_at = [&](int node) {
    using Jet = math::Jet1<Real, 2>;
    Node out;
    out.x = x(layout.state(node, X));
    out.z = x(layout.state(node, Z));
    if (has_theta) out.turned = x(layout.state(node, Theta));
    out.w = sqrt(energy_height_after(body, Jet::variable(out.z, 0),
                                     Jet::variable(out.turned, 1)) *
                 Jet(static_cast<Real>(2.0 * scene.gravity)));
    return out;
  };
  const NodeJet S = NodeJet::variable(x(layout.arc_length()), 6);
  const Real n = problem.num_intervals();
  std::vector<Real> gradient(point.x.size());
  Worst defect;

  // The start is given.
  Node before;
  for (int j = 1; j <= problem.num_intervals(); ++j) {
    check_stop(j);
    const Node own = node_at(j);
    const NodeJet dx =
        NodeJet::variable(own.x, 3) - NodeJet::variable(before.x, 0);
    const NodeJet dz =
        NodeJet::variable(own.z, 4) - NodeJet::variable(before.z, 1);
    const NodeJet own_turned = NodeJet::variable(own.turned, 5);
    const NodeJet turned_before = NodeJet::variable(before.turned, 2);
    const Real share = (2.0L * j - 1.0L) / (n * n);
    NodeJet length = S * NodeJet(share);
    NodeJet turn;
    if (has_theta) {
      turn = own_turned - turned_before;
      length = turn * NodeJet(static_cast<Real>(body.radius));
    }
    const Real middle = (j - 0.75L) / (2.0L * j - 1.0L);
    const NodeJet theta = NodeJet(static_cast<Real>(body.theta_m)) +
                          turned_before + turn * NodeJet(middle);
    // The direction is (Δx, Δz)/(r Δθ), of modulus one at a solution only.
    const Real eta = body.eta_m;
    const NodeJet A =
        NodeJet(1.0L + eta * eta + body.k) -
        (sin(theta) * dx - cos(theta) * dz) / length * NodeJet(2.0L * eta);
    const NodeJet root = sqrt(A);
    NodeJet sum = speed(own, 4);
    if (j > 1) sum += speed(before, 1);
    NodeJet lagrangian = length * root * NodeJet(2.0L) / sum;
    const int row = layout.no_slip(j);
    const NodeJet slip = (dx * dx + dz * dz - length * length) /
                         NodeJet(2.0L * problem.reference_length(j));
    defect.see(slip.value, row);
    lagrangian += slip * NodeJet(static_cast<Real>(point.lambda[at(row)]));
    if (has_theta) {
      const int place_row = layout.place(j);
      const Real sigma = j / n;
      const NodeJet place =
          own_turned * NodeJet(static_cast<Real>(body.radius)) -
          S * NodeJet(sigma * sigma);
      defect.see(place.value, place_row);
      lagrangian +=
          place * NodeJet(static_cast<Real>(point.lambda[at(place_row)]));
    }
    for (int i = 0; i < stride; ++i) {
      if (j > 1)
        gradient[at(layout.state(j - 1, X) + i)] += lagrangian.gradient[at(i)];
      gradient[at(layout.state(j, X) + i)] += lagrangian.gradient[at(3 + i)];
    }
    gradient[at(layout.arc_length())] += lagrangian.gradient[6];
    before = own;
  }

  return summarise(problem, point, gradient, defect);
}

}  // namespace brachisto
