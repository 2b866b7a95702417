// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/transcription/element_errors.hpp"

#include "brachisto/math/gauss.hpp"
#include "brachisto/math/stop_condition.hpp"

namespace brachisto {

namespace {

/// ∫ 𝓗 over an element divided by its length, by the given rule.
double mean_hamiltonian(const ExtremalCurve& curve, int element,
                        const math::QuadratureRule& rule) {
  const Scene& scene = curve.scene();
  double mean = 0.0;
  for (std::size_t i = 0; i < rule.points.size(); ++i) {
    const ExtremalPoint at = curve.at(element, rule.points[i]);
    mean += rule.weights[i] * hamiltonian(scene.body, scene.gravity,
                                          {at.theta, at.w}, at.p, at.beta);
  }
  return mean;
}

}  // namespace

std::vector<double> element_errors(const ExtremalCurve& curve) {
  const Mesh& mesh = curve.mesh();
  // Exact for polynomials of degree 2p + 5, three orders above the error.
  const math::QuadratureRule fine = math::gauss_legendre(mesh.degree + 3);
  const math::QuadratureRule& own = collocation_scheme(mesh.degree).rule;
  std::vector<double> errors;
  errors.reserve(static_cast<std::size_t>(mesh.num_elements()));
  for (int e = 0; e < mesh.num_elements(); ++e) {
    check_stop(e);
    errors.push_back(
        curve.rolling_time() * mesh.length(e) *
        (mean_hamiltonian(curve, e, fine) - mean_hamiltonian(curve, e, own)));
  }
  return errors;
}

}  // namespace brachisto
