// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/expression.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <muParser.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <numbers>
#include <vector>

#include "io/expression_syntax.hpp"

namespace brachisto::io {

namespace {

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

/// A fresh parser for each expression: nothing is left over from the last one,
/// and its cost does not matter beside that of a solve.
mu::Parser make_parser() {
  mu::Parser parser;
  parser.ClearConst();  // its own _pi has 13 digits only
  parser.ClearFun();
  parser.DefineConst("pi", std::numbers::pi);
  for (const Function& function : functions()) {
    const std::string name(function.name);
    if (function.of_two != nullptr) {
      parser.DefineFun(name, function.of_two);
    } else {
      parser.DefineFun(name, function.of_one);
    }
  }
  return parser;
}

double evaluate_expression(std::string_view text) {
  check_tokens(text);
  constexpr int kNotFinite = FE_DIVBYZERO | FE_OVERFLOW | FE_INVALID;
  try {
    mu::Parser parser = make_parser();
    parser.SetExpr(std::string(text));
    std::feclearexcept(kNotFinite);
    const double value = parser.Eval();
    if (!std::isfinite(value)) {
      throw ExpressionError("its value is not finite");
    }
    if (std::fetestexcept(kNotFinite) != 0) {
      throw ExpressionError("a part of it is not finite");
    }
    return value;
  } catch (const mu::Parser::exception_type& error) {
    throw ExpressionError(error.GetCode() == mu::ecINTERNAL_ERROR
                              ? "it is not complete"
                              : error.GetMsg());
  }
}

double evaluate_unsuffixed(std::string_view text) {
  if (text.empty()) throw ExpressionError("it is empty");
  const bool negative = text.front() == '-';
  const bool sign = negative || text.front() == '+';
  const std::string_view digits = text.substr(sign ? 1 : 0);
  double value = 0.0;
  if (!digits.empty() && read_literal(digits, value) == digits.size()) {
    return negative ? -value : value;
  }
  return evaluate_expression(text);
}

}  // namespace

std::string expression_grammar() {
  std::vector<std::string_view> names;
  for (const Function& function : functions()) names.push_back(function.name);
  return fmt::format("numbers, + - * / ^ ( ), pi, {}", fmt::join(names, ", "));
}

double evaluate(std::string_view text, Unit unit) {
  text = trimmed(text);
  if (text.size() > kMaxExpressionLength) {
    throw ExpressionError(
        fmt::format("it is longer than {} characters", kMaxExpressionLength));
  }
  const std::size_t last = text.find_last_not_of("abcdefghijklmnopqrstuvwxyz_");
  const std::string_view suffix =
      last == std::string_view::npos ? text : text.substr(last + 1);
  if (suffix != "deg" && suffix != "rad") return evaluate_unsuffixed(text);

  if (unit == Unit::None) {
    throw ExpressionError(
        fmt::format("{} is a unit of angles, and this is none", suffix));
  }
  const std::string_view number =
      trimmed(text.substr(0, text.size() - suffix.size()));
  check_no_sum(number);
  const double value = evaluate_unsuffixed(number);
  if (suffix == "rad") return value;
  // The product is exact for few-digit degrees, so that -30 deg = -pi/6.
  constexpr long double kPi = std::numbers::pi;
  return static_cast<double>(static_cast<long double>(value) * kPi / 180);
}

}  // namespace brachisto::io
