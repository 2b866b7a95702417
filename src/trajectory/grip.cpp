// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/grip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace brachisto {

namespace {

/// The least number of three digits that is not below a positive x but for
/// rounding and for what limits are kept to: a body pressed with its weight
/// that keeps |R_t| ≤ μ R_n to ε asks for μ + ε.
double rounded_up(double x) {
  constexpr double kRounding = 1e-6;  // of the last digit
  const double digit = std::pow(10.0, std::floor(std::log10(x)) - 2.0);
  const double open = std::max(kRounding, kForceKept / digit);
  return std::max(0.0, std::ceil(x / digit - open) * digit);
}

}  // namespace

double friction_coefficient(double rho) {
  // Written so that a NaN counts as too much.
  return rho < 0.5 * std::numbers::pi ? std::tan(rho)
                                      : std::numeric_limits<double>::infinity();
}

std::string grip_in_words(double mu) {
  if (!std::isfinite(mu)) return "more than any";
  return fmt::format("{:.3g}", mu > 0.0 ? rounded_up(mu) : 0.0);
}

std::string grip_in_words(std::span<const LeastGrip> grip) {
  std::string out;
  std::string last;
  std::string of_the_time = " of the time";
  for (const LeastGrip& one : grip) {
    const std::string mu = grip_in_words(one.mu);
    // From where less is enough; that of the start is told at the end.
    if (mu == last || (one.share_of_time == 0.0 && !std::isfinite(one.mu))) {
      continue;
    }
    last = mu;
    out += (out.empty() ? "" : ", ") + mu;
    if (one.share_of_time == 0.0) {
      out += " from the start on";
    } else {
      out += fmt::format(" from {:g} %{} on", 100.0 * one.share_of_time,
                         std::exchange(of_the_time, ""));
    }
  }
  const bool of_start = grip.size() > 1 && grip[0].share_of_time == 0.0 &&
                        !std::isfinite(grip[0].mu) && std::isfinite(grip[1].mu);
  return of_start ? out + "; more than any at the start itself" : out;
}

}  // namespace brachisto
