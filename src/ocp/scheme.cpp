// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/ocp/mesh.hpp"

#include <array>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <utility>
#include <vector>

namespace brachisto {

namespace {

std::vector<double> with_start(const std::vector<double>& points) {
  std::vector<double> nodes{0.0};
  nodes.insert(nodes.end(), points.begin(), points.end());
  return nodes;
}

enum class Family { Gauss, Radau };

template <Family family>
const CollocationScheme& scheme_of(int degree) {
  static std::array<std::unique_ptr<const CollocationScheme>,
                    kLargestDegree + 1>
      schemes;
  static std::mutex mutex;
  if (degree < 1 || degree > kLargestDegree) {
    throw std::invalid_argument("collocation degree out of range");
  }
  const std::scoped_lock lock(mutex);
  auto& scheme = schemes[static_cast<std::size_t>(degree)];
  if (scheme) return *scheme;
  const bool gauss = family == Family::Gauss;
  math::QuadratureRule rule =
      gauss ? math::gauss_legendre(degree) : math::radau_right(degree);
  std::vector<double> nodes =
      gauss ? math::gauss_lobatto_points(degree + 1) : with_start(rule.points);
  scheme = std::make_unique<const CollocationScheme>(std::move(rule),
                                                     std::move(nodes));
  return *scheme;
}

}  // namespace

CollocationScheme::CollocationScheme(math::QuadratureRule its_points,
                                     std::vector<double> its_nodes)
    : degree(static_cast<int>(its_points.points.size())),
      points_are_nodes(its_nodes.back() == its_points.points.back()),
      rule(std::move(its_points)),
      nodes(std::move(its_nodes)),
      points(rule.points),
      interpolation(nodes.values_at(rule.points)),
      derivative(nodes.slopes_at(rule.points)),
      integral(points.integrals_to(nodes.nodes(), rule)) {}

const CollocationScheme& gauss_scheme(int degree) {
  return scheme_of<Family::Gauss>(degree);
}

const CollocationScheme& radau_scheme(int degree) {
  return scheme_of<Family::Radau>(degree);
}

}  // namespace brachisto
