// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/expression.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <muParser.h>

#include <algorithm>
#include <array>
#include <cfenv>
#include <charconv>
#include <cmath>
#include <mutex>
#include <numbers>
#include <vector>

#include "io/findings.hpp"
#include "io/text_lines.hpp"
#include "io/visible_text.hpp"
#include "math/angle.hpp"

namespace brachisto::io {

namespace {

/// A function of one or of two numbers that expressions may call.
struct Function {
  std::string_view name;
  double (*of_one)(double);
  double (*of_two)(double, double) = nullptr;
};

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

/// The characters that separate tokens.
constexpr std::string_view kBlanks = " \t\n";

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
  const std::vector<std::string_view> known = expression_names(names);
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

/// Reads the unsigned literal at the beginning of a text, correctly rounded.
/// \return its length, 0 if there is none
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

/// Refuses what is not a literal, pi, a name, a function, an operator, a
/// parenthesis or a comma within parentheses, before muParser sees it: it would
/// also take assignments, comparisons, text, several results and names of its
/// own.
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

/// Refuses a sum outside of parentheses: `pi/2 - 30 deg` is meant otherwise
/// than (pi/2 − 30)°.
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

mu::Parser make_parser() {
  mu::Parser parser;
  parser.ClearConst();  // its own _pi has 13 digits only
  parser.ClearFun();
  parser.DefineConst("pi", std::numbers::pi);
  for (const Function& function : kFunctions) {
    const std::string name(function.name);
    if (function.of_two != nullptr) {
      parser.DefineFun(name, function.of_two);
    } else {
      parser.DefineFun(name, function.of_one);
    }
  }
  return parser;
}

/// What muParser says, in our words where its own would puzzle.
std::string reason(const mu::Parser::exception_type& error) {
  return error.GetCode() == mu::ecINTERNAL_ERROR ? "it is not complete"
                                                 : error.GetMsg();
}

/// True if a text is a literal with or without a sign.
bool read_number(std::string_view text, double& value) {
  const bool negative = text.front() == '-';
  const bool sign = negative || text.front() == '+';
  const std::string_view digits = text.substr(sign ? 1 : 0);
  if (digits.empty() || read_literal(digits, value) != digits.size()) {
    return false;
  }
  if (negative) value = -value;
  return true;
}

/// The product is exact for few-digit degrees, so that -30 deg = -pi/6.
double radians(double degrees) {
  constexpr long double kPi = std::numbers::pi;
  return static_cast<double>(static_cast<long double>(degrees) * kPi / 180);
}

}  // namespace

std::vector<std::string_view> expression_names(Names names) {
  std::vector<std::string_view> known{"pi"};
  for (const Function& function : kFunctions) known.push_back(function.name);
  if (names == Names::Quantities) {
    for (const Quantity& quantity : kQuantities) known.push_back(quantity.name);
  }
  return known;
}

std::string expression_grammar() {
  return fmt::format("numbers, + - * / ^ ( ), {}",
                     fmt::join(expression_names(Names::None), ", "));
}

/// A parser of its own, nothing left over from another text, whose variables
/// are the quantities.
class Expression::Program {
 public:
  Program(const std::string& text, Names names)
      : text_(text), parser_(make_parser()) {
    if (names == Names::Quantities) {
      for (std::size_t i = 0; i < kQuantities.size(); ++i) {
        parser_.DefineVar(std::string(kQuantities[i].name), &variables_[i]);
      }
    }
    parser_.SetExpr(text_);
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  [[nodiscard]] std::vector<std::size_t> quantities() const {
    std::vector<std::size_t> used;
    try {
      for (const auto& [name, unused] : parser_.GetUsedVar()) {
        used.push_back(quantity_named(name));
      }
    } catch (const mu::Parser::exception_type& error) {
      throw ExpressionError(reason(error));
    }
    return used;
  }

  [[nodiscard]] double value(const QuantityValues& values) {
    constexpr int kNotFinite = FE_DIVBYZERO | FE_OVERFLOW | FE_INVALID;
    const std::scoped_lock lock(mutex_);
    variables_ = values;
    try {
      std::feclearexcept(kNotFinite);
      const double value = parser_.Eval();
      if (!std::isfinite(value)) {
        throw ExpressionError("its value is not finite");
      }
      if (std::fetestexcept(kNotFinite) != 0) {
        throw ExpressionError("a part of it is not finite");
      }
      return value;
    } catch (const ExpressionError&) {
      // Its constant parts were evaluated just now and would not be again, so
      // that the next scene would not see what is wrong with them.
      parser_.SetExpr(text_);
      throw;
    } catch (const mu::Parser::exception_type& error) {
      throw ExpressionError(reason(error));
    }
  }

 private:
  std::string text_;
  QuantityValues variables_{};
  mu::Parser parser_;
  std::mutex mutex_;
};

Expression::Expression(std::string_view text, Unit unit, Names names)
    : text_(trimmed(text, kBlanks)) {
  if (text_.size() > kMaxExpressionLength) {
    throw ExpressionError(
        fmt::format("it is longer than {} characters", kMaxExpressionLength));
  }
  std::string_view number = text_;
  const std::size_t last =
      number.find_last_not_of("abcdefghijklmnopqrstuvwxyz_");
  const std::string_view suffix =
      last == std::string_view::npos ? number : number.substr(last + 1);
  if (suffix == "deg" || suffix == "rad") {
    if (unit == Unit::None) {
      throw ExpressionError(
          fmt::format("{} is a unit of angles, and this is none", suffix));
    }
    degrees_ = suffix == "deg";
    number = trimmed(number.substr(0, number.size() - suffix.size()), kBlanks);
    check_no_sum(number);
  }

  if (number.empty()) throw ExpressionError("it is empty");
  if (!read_number(number, constant_)) {
    check_tokens(number, names);
    program_ = std::make_shared<Program>(std::string(number), names);
    if (names == Names::Quantities) quantities_ = program_->quantities();
    if (!quantities_.empty()) return;
    constant_ = program_->value({});
    program_.reset();
  }
}

double Expression::value(const QuantityValues& values) const {
  const double number = program_ ? program_->value(values) : constant_;
  return degrees_ ? radians(number) : number;
}

double Expression::direction() const {
  constexpr double kTurnInDegrees = 360.0;
  if (!degrees_) return math::within_a_turn(constant_);
  return radians(std::abs(constant_) > kTurnInDegrees
                     ? std::fmod(constant_, kTurnInDegrees)
                     : constant_);
}

double evaluate(std::string_view text, Unit unit) {
  return Expression(text, unit, Names::None).value({});
}

}  // namespace brachisto::io
