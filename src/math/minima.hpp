// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Minima of a smooth function that is known at samples.

#pragma once

#include <functional>
#include <span>
#include <vector>

namespace brachisto::math {

/// A value of a function and the argument it is taken at.
struct Sample {
  double at = 0.0;
  double value = 0.0;
};

/// Minimum of f between `lower` and `upper` by Brent's method, to half the
/// bits of the argument; more cannot be told from values.
[[nodiscard]] Sample find_minimum(const std::function<double(double)>& f,
                                  double lower, double upper);

/// The local minima below `bound` that lie between the ends of a sequence of
/// samples, in their order. f is taken to have no more than one minimum
/// between neighbouring samples, where it shows as a sample that is not above
/// both its neighbours, or as an end to which f falls less and less; those
/// whose parabola, its drop below the sample doubled, stays above `bound` are
/// not looked at.
///
/// \param samples  ascending in their argument, no two of one place
[[nodiscard]] std::vector<Sample> minima_below(
    double bound, std::span<const Sample> samples,
    const std::function<double(double)>& f);

/// Those of them that samples hide: none beside them is below `bound`.
[[nodiscard]] std::vector<Sample> hidden_minima_below(
    double bound, std::span<const Sample> samples,
    const std::function<double(double)>& f);

}  // namespace brachisto::math
