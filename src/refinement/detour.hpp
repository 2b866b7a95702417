// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Other paths to start from: on the other side of what is in the way.

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "brachisto/model/scene.hpp"
#include "model/path_inequality.hpp"
#include "transcription/extremal_curve.hpp"

namespace brachisto {

/// A path at places of equal time apart, a motion only roughly.
struct RoughPath {
  double rolling_time;
  std::vector<TurningPoint<double>> places;
  /// That its ends are built from, if these are not those of the free extremal.
  struct Slopes {
    double at_A, at_B;
  };
  std::optional<Slopes> slopes;

  /// \param sigma  in [0, 1]
  [[nodiscard]] TurningPoint<double> at(double sigma) const;
};

/// Where else a path may lead than the free extremal does, for a method that
/// goes from path to path does not come from one side of a disc to the other:
/// for each disc that the extremal passes nearer than the disc's own reach, or
/// at no more than that from it, the extremal bent around its other side; then
/// the line from end to end; then a bow below it.
///
/// \param scene  in natural units
[[nodiscard]] std::vector<RoughPath> other_ways(
    const Scene& scene, const ExtremalCurve& free,
    const std::vector<PathInequality>& limits);

/// Of no more discs both sides are tried.
inline constexpr std::size_t kMostDiscs = 3;

/// How many discs the free extremal passes near.
[[nodiscard]] std::size_t discs_near(const ExtremalCurve& free,
                                     const std::vector<PathInequality>& limits);

/// The free extremal bent past the discs that it passes near, the first
/// kMostDiscs of them, once for each way of being over or under them.
[[nodiscard]] std::vector<RoughPath> ways_past_discs(
    const Scene& scene, const ExtremalCurve& free,
    const std::vector<PathInequality>& limits);

/// The free extremal with random waves on it, always the same, ends held:
///
///     z + Σ_k a_k sin(k π s/S),  |a_k| ≤ 0.3 H/k,  k = 1 … 4.
///
/// \return so many, or fewer where most are no ways of a body
[[nodiscard]] std::vector<RoughPath> waves(const Scene& scene,
                                           const ExtremalCurve& free,
                                           int count);

}  // namespace brachisto
