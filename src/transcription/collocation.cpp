// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/transcription/collocation.hpp"

#include <array>
#include <memory>
#include <mutex>
#include <stdexcept>

namespace brachisto {

namespace {

/// ∫ from 0 to each node of each Lagrange polynomial of `points`, exact: its
/// degree p − 1 is below 2p.
math::SmallMatrix integrate(const math::LagrangeBasis& nodes,
                            const math::LagrangeBasis& points,
                            const math::QuadratureRule& rule) {
  math::SmallMatrix out(nodes.size(), points.size());
  std::vector<double> values(static_cast<std::size_t>(points.size()));
  for (int n = 0; n < nodes.size(); ++n) {
    const double end = nodes.nodes()[static_cast<std::size_t>(n)];
    for (std::size_t q = 0; q < rule.points.size(); ++q) {
      points.evaluate(end * rule.points[q], values);
      for (int j = 0; j < points.size(); ++j) {
        out(n, j) +=
            end * rule.weights[q] * values[static_cast<std::size_t>(j)];
      }
    }
  }
  return out;
}

}  // namespace

CollocationScheme::CollocationScheme(int p)
    : degree(p),
      nodes(math::gauss_lobatto_points(p + 1)),
      points(math::gauss_legendre(p).points),
      rule(math::gauss_legendre(p)),
      interpolation(nodes.values_at(rule.points)),
      derivative(nodes.slopes_at(rule.points)),
      integral(integrate(nodes, points, rule)) {}

const CollocationScheme& collocation_scheme(int degree) {
  static std::array<std::unique_ptr<const CollocationScheme>,
                    kLargestDegree + 1>
      schemes;
  static std::mutex mutex;
  if (degree < 1 || degree > kLargestDegree) {
    throw std::invalid_argument("collocation degree out of range");
  }
  const std::scoped_lock lock(mutex);
  auto& scheme = schemes[static_cast<std::size_t>(degree)];
  if (!scheme) scheme = std::make_unique<const CollocationScheme>(degree);
  return *scheme;
}

}  // namespace brachisto
