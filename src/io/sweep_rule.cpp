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

/// Calls the alternative that fits.
template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

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
  using Expressions = std::vector<const Expression*>;
  return std::visit(Overloaded{[](const WordList&) { return Expressions{}; },
                               [](const NumberList& list) {
                                 Expressions all;
                                 for (const Expression& number : list.numbers) {
                                   all.push_back(&number);
                                 }
                                 return all;
                               },
                               [](const auto& ends) {
                                 return Expressions{&ends.from, &ends.to};
                               }},
                    rule);
}

SweepValue value_of(const SweepEntry& entry, std::size_t index,
                    const QuantityValues& quantities) {
  const auto part_of = [&](const auto& ends, double part, double whole) {
    return between(number(ends.from, quantities), number(ends.to, quantities),
                   part, whole, ends.spacing);
  };
  return std::visit(
      Overloaded{
          [&](const WordList& list) -> SweepValue { return list.words[index]; },
          [&](const NumberList& list) -> SweepValue {
            return number(list.numbers[index], quantities);
          },
          [&](const NumberRange& range) -> SweepValue {
            return part_of(range, static_cast<double>(index),
                           static_cast<double>(entry.count - 1));
          },
          [&](const NumberSample& sample) -> SweepValue {
            return part_of(sample, sample.stream.draw(index),
                           RandomStream::kWhole);
          }},
      entry.rule);
}

}  // namespace brachisto::io
