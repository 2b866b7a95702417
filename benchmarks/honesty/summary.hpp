// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// True errors beside estimated ones.

#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "support/text.hpp"

namespace brachisto::benchmarks {

/// Errors below this are not told from zero: what references are known to.
inline constexpr double kResolution = 1e-12;
/// An estimate may exceed the true error by this factor and still be of use.
inline constexpr double kUsefulFactor = 100.0;

/// One scene solved to one tolerance.
struct Measurement {
  double tolerance = 0.0;
  bool verified = false;
  double true_error = std::numeric_limits<double>::quiet_NaN();  ///< relative
  double estimate = std::numeric_limits<double>::quiet_NaN();    ///< relative
  int degree = 0, elements = 0, meshes = 0, iterations = 0, newton_steps = 0;
  double seconds = 0.0;
  FixedText<300> reason;  ///< why it is not verified

  /// The error was larger than stated.
  [[nodiscard]] bool too_small_an_estimate() const {
    return verified && true_error > std::max(estimate, kResolution);
  }
  [[nodiscard]] bool misses_tolerance() const {
    return verified && true_error > std::max(tolerance, kResolution);
  }
  [[nodiscard]] bool too_large_an_estimate() const {
    return verified &&
           estimate > kUsefulFactor * std::max(true_error, kResolution);
  }
};

struct Named {
  std::string name;
  Measurement measured;
};

[[nodiscard]] std::string csv(const std::vector<Named>& all);

/// A line for each tolerance, then every violation. Markdown.
[[nodiscard]] std::string summary(const std::vector<Named>& all,
                                  const std::vector<double>& tolerances);

}  // namespace brachisto::benchmarks
