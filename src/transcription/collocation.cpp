// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/collocation.hpp"

#include <array>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <vector>

namespace brachisto {

namespace {

std::vector<double> with_start(const std::vector<double>& points) {
  std::vector<double> nodes{0.0};
  nodes.insert(nodes.end(), points.begin(), points.end());
  return nodes;
}

template <class Scheme>
const Scheme& scheme_of(int degree) {
  static std::array<std::unique_ptr<const Scheme>, kLargestDegree + 1> schemes;
  static std::mutex mutex;
  if (degree < 1 || degree > kLargestDegree) {
    throw std::invalid_argument("collocation degree out of range");
  }
  const std::scoped_lock lock(mutex);
  auto& scheme = schemes[static_cast<std::size_t>(degree)];
  if (!scheme) scheme = std::make_unique<const Scheme>(degree);
  return *scheme;
}

}  // namespace

CollocationScheme::CollocationScheme(int p)
    : degree(p),
      nodes(math::gauss_lobatto_points(p + 1)),
      points(math::gauss_legendre(p).points),
      rule(math::gauss_legendre(p)),
      interpolation(nodes.values_at(rule.points)),
      derivative(nodes.slopes_at(rule.points)),
      integral(points.integrals_to(nodes.nodes(), rule)) {}

RadauScheme::RadauScheme(int p)
    : degree(p),
      rule(math::radau_right(p)),
      nodes(with_start(rule.points)),
      points(rule.points),
      derivative(nodes.slopes_at(rule.points)) {}

const CollocationScheme& collocation_scheme(int degree) {
  return scheme_of<CollocationScheme>(degree);
}

const RadauScheme& radau_scheme(int degree) {
  return scheme_of<RadauScheme>(degree);
}

}  // namespace brachisto
