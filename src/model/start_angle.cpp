// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/start_angle.hpp"

#include <cmath>
#include <numbers>

#include "math/roots.hpp"
#include "model/energy.hpp"
#include "model/inertia.hpp"

namespace brachisto {

double start_angle(const Body& body) {
  constexpr double kHalfPi = std::numbers::pi / 2.0;
  // Exact by symmetry, and free of rounding so.
  if (!body.off_centred() || body.theta_m == 0.0) return kHalfPi;

  const double eta = body.eta_m;
  const double theta_m = body.theta_m;
  const auto first_term = [&](double beta) {
    return inertia_factor(body, theta_m, beta) * std::cos(beta);
  };
  const auto stationarity = [&](double beta) {
    return first_term(beta) -
           energy_slope(body, theta_m, beta) * eta * std::cos(theta_m - beta);
  };
  // a > 0 between these; there the first term alone is left, and it changes
  // sign from one end to the other.
  const double margin = std::asin(eta * std::cos(theta_m));
  const double first = -margin;
  const double last = 2.0 * kHalfPi + margin;
  return math::find_root(stationarity, first, last, first_term(first),
                         first_term(last));
}

}  // namespace brachisto
