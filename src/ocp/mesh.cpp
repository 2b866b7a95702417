// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/ocp/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "brachisto/math/index.hpp"

namespace brachisto {

Mesh::Place Mesh::locate(double sigma) const {
  const auto after =
      std::upper_bound(boundaries.begin() + 1, boundaries.end() - 1, sigma);
  const auto element = static_cast<int>(after - boundaries.begin()) - 1;
  return {element, (sigma - boundaries[static_cast<std::size_t>(element)]) /
                       length(element)};
}

Mesh uniform_mesh(int degree, int num_elements) {
  Mesh mesh{degree, {}};
  mesh.boundaries.reserve(static_cast<std::size_t>(num_elements) + 1);
  for (int e = 0; e <= num_elements; ++e) {
    mesh.boundaries.push_back(static_cast<double>(e) / num_elements);
  }
  return mesh;
}

namespace {

/// `count` elements of equal mass, given the mass of each old element.
Mesh divide(const Mesh& mesh, const std::vector<double>& mass, int count) {
  const double total = std::accumulate(mass.begin(), mass.end(), 0.0);
  Mesh out{mesh.degree, {0.0}};
  std::size_t e = 0;
  double before = 0.0;  // mass of the old elements left of e
  for (int i = 1; i < count; ++i) {
    const double goal = total * i / count;
    while (e + 1 < mass.size() && before + mass[e] < goal) before += mass[e++];
    const double t = std::clamp((goal - before) / mass[e], 0.0, 1.0);
    out.boundaries.push_back(mesh.boundaries[e] +
                             t * mesh.length(static_cast<int>(e)));
  }
  out.boundaries.push_back(1.0);
  return out;
}

}  // namespace

Mesh equidistribute(const Mesh& mesh, std::span<const double> errors,
                    double target, int degree, double size) {
  const auto n = static_cast<std::size_t>(mesh.num_elements());
  if (!std::all_of(errors.begin(), errors.end(),
                   [](double error) { return std::isfinite(error); })) {
    Mesh finer = stretch(mesh, 2 * mesh.num_elements());
    finer.degree = degree;
    return finer;
  }
  // A share may vanish by accident of its sign: each element counts at least a
  // part of its neighbours'.
  constexpr double kNeighbour = 0.3;
  std::vector<double> shares(n);
  for (std::size_t e = 0; e < n; ++e) {
    shares[e] = std::abs(errors[e]);
    if (e > 0) {
      shares[e] = std::max(shares[e], kNeighbour * std::abs(errors[e - 1]));
    }
    if (e + 1 < n) {
      shares[e] = std::max(shares[e], kNeighbour * std::abs(errors[e + 1]));
    }
  }
  // Elements that are exact to rounding still need some width.
  const double floor =
      1e-6 * *std::max_element(shares.begin(), shares.end()) + 1e-300;
  const double order = 2.0 * mesh.degree + 1.0;
  // Each old element's length in its own unit ρ.
  std::vector<double> mass(n);
  for (std::size_t e = 0; e < n; ++e) {
    mass[e] = std::pow(std::max(shares[e], floor) / size, 1.0 / order);
  }
  const double total = std::accumulate(mass.begin(), mass.end(), 0.0);
  // N elements of equal mass have the error N · size · (total/N)^(2p+1).
  const double wanted_order = 2.0 * degree + 1.0;
  const double wanted = std::pow(std::pow(total, wanted_order) * size / target,
                                 1.0 / (wanted_order - 1.0));
  const int count = static_cast<int>(
      std::ceil(std::clamp(wanted, std::max(4.0, 0.25 * static_cast<double>(n)),
                           8.0 * static_cast<double>(n) + 8.0)));

  Mesh out = divide(mesh, mass, count);
  out.degree = degree;
  return out;
}

Mesh equidistribute(const Mesh& mesh, std::span<const double> errors,
                    double target) {
  return equidistribute(mesh, errors, target, mesh.degree, 1.0);
}

Mesh stretch(const Mesh& mesh, int count) {
  return divide(
      mesh,
      std::vector<double>(static_cast<std::size_t>(mesh.num_elements()), 1.0),
      count);
}

Mesh halved(const Mesh& mesh) {
  Mesh out{mesh.degree, {0.0}};
  for (int e = 0; e < mesh.num_elements(); ++e) {
    out.boundaries.push_back(mesh.sigma(e, 0.5));
    out.boundaries.push_back(mesh.boundaries[at(e + 1)]);
  }
  return out;
}

}  // namespace brachisto
