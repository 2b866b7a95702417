// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Random paths to start a program from.

#pragma once

#include <vector>

#include "math/portable_random.hpp"
#include "refinement/detour.hpp"
#include "transcription/limited_curve.hpp"

namespace brachisto {

/// A motion by its rolling time, tabulated finely enough for a start.
struct RandomPath {
  std::vector<double> u;
  std::vector<TurningPoint<double>> at;

  [[nodiscard]] double rolling_time() const { return u.back(); }
  [[nodiscard]] TurningPoint<double> operator()(double sigma) const;
};

/// The centre's path from random slopes at A and B: a cubic with waves on it,
///
///     c(t) = cubic(t) + 16 t² (1 − t)² Σ_k a_k sin(k π t + b_k),  k = 1 … 6,
///
/// |a_k| ≤ waviness/k, passed as fast as the scene's uniform field and start
/// speed make the body without any loss.
///
/// \return empty if the body would not get through, or if the path turns back
///         or over
[[nodiscard]] RandomPath random_path(const Scene& scene, double waviness,
                                     SplitMix64& random);

/// The first of them that is not empty.
/// \param attempts  by which those it took are counted up
[[nodiscard]] RandomPath some_random_path(const Scene& scene, double waviness,
                                          SplitMix64& random, int& attempts);

/// The first `count` of them of a fixed seed, always the same, with their own
/// slopes at A and B; fewer where most are no ways of a body.
[[nodiscard]] std::vector<RoughPath> random_ways(const Scene& scene, int count);

/// A cold start: without multipliers.
[[nodiscard]] PrimalDual start_on(const LimitedTime& problem,
                                  const RandomPath& path);
[[nodiscard]] PrimalDual start_on(const LimitedTime& problem,
                                  const RoughPath& path);

}  // namespace brachisto
