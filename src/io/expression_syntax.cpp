// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/expression_syntax.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <vector>

#include "io/expression.hpp"
#include "io/findings.hpp"
#include "io/suggestion.hpp"

namespace brachisto::io {

namespace {

constexpr std::array<Function, 13> kFunctions{{
    {"sqrt", [](double x) { return std::sqrt(x); }},
    {"sin", [](double x) { return std::sin(x); }},
    {"cos", [](double x) { return std::cos(x); }},
    {"tan", [](double x) { return std::tan(x); }},
    {"asin", [](double x) { return std::asin(x); }},
    {"acos", [](double x) { return std::acos(x); }},
    {"atan", [](double x) { return std::atan(x); }},
    {"exp", [](double x) { return std::exp(x); }},
    {"log", [](double x) { return std::log(x); }},
    {"abs", [](double x) { return std::abs(x); }},
    {"min", nullptr, [](double x, double y) { return std::min(x, y); }},
    {"max", nullptr, [](double x, double y) { return std::max(x, y); }},
    {"pow", nullptr, [](double x, double y) { return std::pow(x, y); }},
}};

bool is_digit(char c) {
  return '0' <= c && c <= '9';
}
bool is_letter(char c) {
  return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_';
}

/// Length of the word at the beginning of a text.
std::size_t word_length(std::string_view text) {
  const auto end = std::ranges::find_if_not(
      text, [](char c) { return is_letter(c) || is_digit(c); });
  return static_cast<std::size_t>(end - text.begin());
}

void check_word(std::string_view word, bool after_number, Names names) {
  if (after_number) {
    throw ExpressionError(fmt::format(
        "{} follows a number directly; a product needs *", in_quotes(word)));
  }
  std::vector<std::string_view> known{"pi"};
  for (const Function& function : kFunctions) known.push_back(function.name);
  if (names == Names::Quantities) {
    for (const Quantity& quantity : kQuantities) known.push_back(quantity.name);
  }
  if (std::ranges::count(known, word) > 0) return;
  if (word == "deg" || word == "rad") {
    throw ExpressionError(
        fmt::format("{} may only stand behind an angle as a whole", word));
  }
  if (quantity_named(word) < kQuantities.size()) {
    throw ExpressionError(
        fmt::format("{} has no meaning here; only numbers of the section sweep "
                    "may name quantities",
                    in_quotes(word)));
  }
  throw ExpressionError(fmt::format("{} has no meaning here{}", in_quotes(word),
                                    suggestion(word, known)));
}

}  // namespace

std::span<const Function> functions() {
  return kFunctions;
}

std::size_t read_literal(std::string_view text, double& value) {
  // from_chars would also take "inf" and "nan".
  if (text.empty() || !(is_digit(text[0]) || text[0] == '.')) return 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error == std::errc::result_out_of_range) {
    throw ExpressionError("it is out of the range of double precision");
  }
  if (error != std::errc{}) return 0;
  return static_cast<std::size_t>(stop - text.data());
}

void check_tokens(std::string_view text, Names names) {
  int depth = 0;
  bool after_number = false;
  while (!text.empty()) {
    double value = 0.0;
    const std::size_t literal = read_literal(text, value);
    if (literal > 0) {
      text.remove_prefix(literal);
      after_number = true;
      continue;
    }
    const char c = text.front();
    if (is_letter(c)) {
      const std::string_view word = text.substr(0, word_length(text));
      check_word(word, after_number, names);
      text.remove_prefix(word.size());
      after_number = false;
      // muParser would take it for a name.
      if (std::ranges::count(kFunctions, word, &Function::name) > 0 &&
          !text.starts_with('(')) {
        throw ExpressionError(fmt::format(
            "{} is a function, whose argument follows in parentheses",
            in_quotes(word)));
      }
      continue;
    }
    if (std::string_view("+-*/^(), \t\n").find(c) == std::string_view::npos) {
      std::size_t length = 1;  // of a UTF-8 character
      while (length < text.size() && (text[length] & 0xC0) == 0x80) ++length;
      throw ExpressionError(fmt::format("{} has no meaning in a number",
                                        in_quotes(text.substr(0, length))));
    }
    if (c == '(') ++depth;
    if (c == ')') --depth;
    if (c == ',' && depth <= 0) {
      throw ExpressionError(
          "a comma separates arguments of functions only; decimals need a "
          "point");
    }
    after_number = false;
    text.remove_prefix(1);
  }
}

void check_no_sum(std::string_view text) {
  int depth = 0;
  bool after_operand = false;
  while (!text.empty()) {
    double value = 0.0;
    if (const std::size_t literal = read_literal(text, value); literal > 0) {
      text.remove_prefix(literal);
      after_operand = true;
      continue;
    }
    const char c = text.front();
    text.remove_prefix(1);
    if (c == '(') ++depth;
    if (c == ')') --depth;
    if ((c == '+' || c == '-') && depth == 0 && after_operand) {
      throw ExpressionError("a sum before deg or rad needs parentheses");
    }
    if (kBlanks.find(c) == std::string_view::npos) {
      after_operand = is_letter(c) || c == ')';
    }
  }
}

}  // namespace brachisto::io
