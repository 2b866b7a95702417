// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "math/minima.hpp"

#include <boost/math/tools/minima.hpp>
#include <cstdint>
#include <optional>

namespace brachisto::math {

namespace {

/// How far the parabola through three samples, the middle one lowest, falls
/// below it.
double drop_below(const Sample& a, const Sample& b, const Sample& c) {
  const double left = (a.value - b.value) / (b.at - a.at);
  const double right = (c.value - b.value) / (c.at - b.at);
  // With t = x − b: f = b + slope t + bend t², f(a) and f(c) as given.
  const double bend = (left + right) / (c.at - a.at);
  const double slope =
      (right * (b.at - a.at) - left * (c.at - b.at)) / (c.at - a.at);
  return bend > 0.0 ? slope * slope / (4.0 * bend) : 0.0;
}

/// The same of the last of three samples that fall, if the parabola has risen
/// again there; nothing where it is far from doing so.
std::optional<double> drop_before(const Sample& a, const Sample& b,
                                  const Sample& c) {
  const double first = (b.value - a.value) / (b.at - a.at);
  const double last = (c.value - b.value) / (c.at - b.at);
  const double bend = (last - first) / (c.at - a.at);
  const double width = c.at - b.at;
  const double slope = last + bend * width;  // at c
  // Its lowest place: half an interval behind the end it may be an error.
  const double behind = -slope / (2.0 * bend);
  if (!(bend > 0.0) || !(behind < 0.5 * width)) return std::nullopt;
  return slope > 0.0 ? slope * slope / (4.0 * bend) : 0.0;
}

std::vector<Sample> minima(double bound, bool hidden_alone,
                           std::span<const Sample> samples,
                           const std::function<double(double)>& f) {
  std::vector<Sample> minima;
  for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
    const Sample& before = samples[i - 1];
    const Sample& here = samples[i];
    const Sample& after = samples[i + 1];
    // Of equal neighbours the first one counts.
    if (!(here.value < before.value) || !(here.value <= after.value)) continue;
    if (hidden_alone && here.value < bound) continue;
    if (here.value - 2.0 * drop_below(before, here, after) > bound) continue;
    Sample lowest = find_minimum(f, before.at, after.at);
    if (here.value < lowest.value) lowest = here;
    if (lowest.value <= bound) minima.push_back(lowest);
  }
  if (samples.size() < 3) return minima;
  const Sample& end = samples.back();
  const Sample& before = samples[samples.size() - 2];
  if (!(end.value < before.value) || (hidden_alone && end.value < bound)) {
    return minima;
  }
  const auto drop = drop_before(samples[samples.size() - 3], before, end);
  if (!drop || end.value - 2.0 * *drop > bound) return minima;
  const Sample lowest = find_minimum(f, before.at, end.at);
  if (lowest.value < end.value && lowest.value <= bound) {
    minima.push_back(lowest);
  }
  return minima;
}

}  // namespace

Sample find_minimum(const std::function<double(double)>& f, double lower,
                    double upper) {
  constexpr int kHalfTheBits = 26;
  std::uintmax_t evaluations = 40;
  const auto [at, value] = boost::math::tools::brent_find_minima(
      f, lower, upper, kHalfTheBits, evaluations);
  return {at, value};
}

std::vector<Sample> minima_below(double bound, std::span<const Sample> samples,
                                 const std::function<double(double)>& f) {
  return minima(bound, false, samples, f);
}

std::vector<Sample> hidden_minima_below(
    double bound, std::span<const Sample> samples,
    const std::function<double(double)>& f) {
  return minima(bound, true, samples, f);
}

}  // namespace brachisto::math
