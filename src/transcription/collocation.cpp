// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/transcription/collocation.hpp"

#include <array>
#include <memory>
#include <mutex>
#include <stdexcept>

namespace brachisto {

CollocationScheme::CollocationScheme(int p)
    : degree(p),
      nodes(math::gauss_lobatto_points(p + 1)),
      points(math::gauss_legendre(p).points),
      rule(math::gauss_legendre(p)),
      interpolation(nodes.values_at(rule.points)),
      derivative(nodes.slopes_at(rule.points)),
      integral(points.integrals_to(nodes.nodes(), rule)) {}

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
