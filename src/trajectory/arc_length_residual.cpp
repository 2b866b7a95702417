// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/trajectory/arc_length_residual.hpp"

#include <array>
#include <cmath>
#include <vector>

#include "brachisto/math/jet1.hpp"
#include "brachisto/math/stop_condition.hpp"
#include "brachisto/model/energy.hpp"
#include "brachisto/model/inertia.hpp"
#include "trajectory/residual_summary.hpp"

namespace brachisto {

namespace {

using enum StateComponent;
using Real = long double;
// x, z and the rotation of the node before and of the own one, and S.
using Jet = math::Jet1<Real, 7>;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// Place and rotation of a node.
struct Node {
  Jet x, z, turned;
};

Jet speed(const Scene& scene, bool has_theta, const Node& node) {
  const Jet E =
      has_theta ? energy_height_after(scene.body, node.z, node.turned) : node.z;
  return sqrt(E * Jet(static_cast<Real>(2.0 * scene.gravity)));
}

}  // namespace

ExtendedResidual extended_residual(const ArcLength& problem,
                                   const PrimalDual& point) {
  const VariableLayout& layout = problem.layout();
  const Scene& scene = problem.scene();
  const Body& body = scene.body;
  const bool has_theta = layout.has_theta();
  const int stride = layout.num_states();
  const auto x = [&](int i) { return static_cast<Real>(point.x[at(i)]); };
  const auto node_at = [&](int node, int first) {
    Node out;
    if (node == 0) return out;
    out.x = Jet::variable(x(layout.state(node, X)), first);
    out.z = Jet::variable(x(layout.state(node, Z)), first + 1);
    if (has_theta) {
      out.turned = Jet::variable(x(layout.state(node, Theta)), first + 2);
    }
    return out;
  };
  const Jet S = Jet::variable(x(layout.arc_length()), 6);
  const Real n = problem.num_intervals();
  std::vector<Real> gradient(point.x.size());
  Worst defect;

  for (int j = 1; j <= problem.num_intervals(); ++j) {
    check_stop(j);
    const Node before = node_at(j - 1, 0);
    const Node own = node_at(j, 3);
    const Jet dx = own.x - before.x;
    const Jet dz = own.z - before.z;
    const Real share = (2.0L * j - 1.0L) / (n * n);
    Jet length = S * Jet(share);
    Jet root;
    if (has_theta) {
      const Jet turn = own.turned - before.turned;
      length = turn * Jet(static_cast<Real>(body.radius));
      const Real middle = (j - 0.75L) / (2.0L * j - 1.0L);
      const Jet theta = Jet(static_cast<Real>(body.theta_m)) + before.turned +
                        turn * Jet(middle);
      // The direction is (Δx, Δz)/(r Δθ), of modulus one at a solution only.
      const Real eta = body.eta_m;
      const Jet A =
          Jet(1.0L + eta * eta + body.k) -
          (sin(theta) * dx - cos(theta) * dz) / length * Jet(2.0L * eta);
      root = sqrt(A);
    } else {
      root =
          Jet(std::sqrt(static_cast<Real>(axisymmetric_inertia_factor(body))));
    }
    Jet sum = speed(scene, has_theta, own);
    if (j > 1) sum += speed(scene, has_theta, before);
    Jet lagrangian = length * root * Jet(2.0L) / sum;
    const int row = layout.no_slip(j);
    const Jet slip = (dx * dx + dz * dz - length * length) /
                     Jet(2.0L * problem.reference_length(j));
    defect.see(slip.value, row);
    lagrangian += slip * Jet(static_cast<Real>(point.lambda[at(row)]));
    if (has_theta) {
      const int place_row = layout.place(j);
      const Real sigma = j / n;
      const Jet place = own.turned * Jet(static_cast<Real>(body.radius)) -
                        S * Jet(sigma * sigma);
      defect.see(place.value, place_row);
      lagrangian += place * Jet(static_cast<Real>(point.lambda[at(place_row)]));
    }
    for (int i = 0; i < stride; ++i) {
      if (j > 1)
        gradient[at(layout.state(j - 1, X) + i)] += lagrangian.gradient[at(i)];
      gradient[at(layout.state(j, X) + i)] += lagrangian.gradient[at(3 + i)];
    }
    gradient[at(layout.arc_length())] += lagrangian.gradient[6];
  }

  return summarise(problem, point, gradient, defect);
}

}  // namespace brachisto
