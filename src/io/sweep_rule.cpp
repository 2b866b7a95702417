// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What the rules of a sweep give. Compiled without contraction to fused
// operations, which would spoil the symmetry of a range.

#include "io/sweep_section.hpp"

#include <fmt/format.h>

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

namespace {

/// The value of an expression, which a mistake names.
double number(const Expression& expression, const QuantityValues& quantities) {
  try {
    return expression.value(quantities);
  } catch (const ExpressionError& error) {
    throw ExpressionError(fmt::format(
        "{} is not a number: {}", in_quotes(expression.text()), error.what()));
  }
}

}  // namespace

std::vector<const Expression*> expressions_of(const SweepRule& rule) {
  if (const auto* range = std::get_if<NumberRange>(&rule)) {
    return {&range->from, &range->to};
  }
  std::vector<const Expression*> all;
  if (const auto* list = std::get_if<std::vector<Expression>>(&rule)) {
    for (const Expression& number : *list) all.push_back(&number);
  }
  return all;
}

SweepValue value_of(const SweepEntry& entry, std::size_t index,
                    const QuantityValues& quantities) {
  if (const auto* words = std::get_if<std::vector<std::string>>(&entry.rule)) {
    return (*words)[index];
  }
  if (const auto* list = std::get_if<std::vector<Expression>>(&entry.rule)) {
    return number((*list)[index], quantities);
  }
  const auto& range = std::get<NumberRange>(entry.rule);
  const double part =
      range.random ? range.random->draw(index) : static_cast<double>(index);
  const double whole = range.random ? RandomStream::kWhole
                                    : static_cast<double>(entry.count - 1);
  return between(number(range.from, quantities), number(range.to, quantities),
                 part, whole, range.spacing);
}

}  // namespace brachisto::io
