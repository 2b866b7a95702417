// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What the rules of a sweep give.

#include <fmt/format.h>

#include "io/sweep_section.hpp"

namespace brachisto::io {

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
