// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Compiled without contraction to fused operations, which would spoil the
// symmetry.

#include "io/spacing.hpp"

#include <algorithm>
#include <cmath>

#include "io/expression.hpp"

namespace brachisto::io {

namespace {

double linear(double from, double to, double part, double whole) {
  return (from * (whole - part) + to * part) / whole;
}

double logarithmic(double from, double to, double part, double whole) {
  // Extended precision, where there is any, so that decades come out as such.
  const long double f = static_cast<long double>(part) / whole;
  const long double rest = static_cast<long double>(whole - part) / whole;
  const long double size =
      std::pow(static_cast<long double>(std::abs(from)), rest) *
      std::pow(static_cast<long double>(std::abs(to)), f);
  return std::copysign(static_cast<double>(size), from);
}

}  // namespace

double between(double from, double to, double part, double whole,
               Spacing spacing) {
  const bool one_sign = (from > 0.0 && to > 0.0) || (from < 0.0 && to < 0.0);
  if (spacing == Spacing::Log && !one_sign) {
    throw ExpressionError(
        "spacing: log needs from and to of the same sign, and not 0");
  }
  if (part == 0.0) return from;
  if (part == whole) return to;
  const double value = spacing == Spacing::Linear
                           ? linear(from, to, part, whole)
                           : logarithmic(from, to, part, whole);
  if (!std::isfinite(value)) {
    throw ExpressionError("a value between from and to is not finite");
  }
  return std::clamp(value, std::min(from, to), std::max(from, to));
}

}  // namespace brachisto::io
