// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "math/minima.hpp"

#include <algorithm>
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

/// The same of an end of the samples, the last of three that fall towards it
/// from either side, if the parabola has risen again there; nothing where it is
/// far from doing so.
std::optional<double> drop_before(const Sample& a, const Sample& b,
                                  const Sample& end) {
  const double first = (b.value - a.value) / (b.at - a.at);
  const double last = (end.value - b.value) / (end.at - b.at);
  const double bend = (last - first) / (end.at - a.at);
  const double width = end.at - b.at;        // less than 0 at the first sample
  const double slope = last + bend * width;  // at the end
  // Its lowest place: half an interval behind the end it may be an error.
  const double behind = -slope / (2.0 * bend) / width;
  if (!(bend > 0.0) || !(behind < 0.5)) return std::nullopt;
  return behind < 0.0 ? slope * slope / (4.0 * bend) : 0.0;
}

/// The minimum between an end of the samples and the one next to it.
std::optional<Sample> minimum_before(double bound, bool hidden_alone,
                                     const Sample& a, const Sample& b,
                                     const Sample& end,
                                     const std::function<double(double)>& f) {
  if (!(end.value < b.value) || (hidden_alone && end.value < bound)) return {};
  const auto drop = drop_before(a, b, end);
  if (!drop || end.value - 2.0 * *drop > bound) return {};
  const auto [lower, upper] = std::minmax(b.at, end.at);
  const Sample lowest = find_minimum(f, lower, upper);
  if (!(lowest.value < end.value && lowest.value <= bound)) return {};
  return lowest;
}

std::vector<Sample> minima(double bound, bool hidden_alone,
                           std::span<const Sample> samples,
                           const std::function<double(double)>& f) {
  std::vector<Sample> minima;
  const std::size_t n = samples.size();
  if (n < 3) return minima;
  const auto at_end = [&](const Sample& a, const Sample& b, const Sample& end) {
    const auto found = minimum_before(bound, hidden_alone, a, b, end, f);
    if (found) minima.push_back(*found);
  };
  at_end(samples[2], samples[1], samples[0]);
  for (std::size_t i = 1; i + 1 < n; ++i) {
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
  at_end(samples[n - 3], samples[n - 2], samples[n - 1]);
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
