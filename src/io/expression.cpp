// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/expression.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <muParser.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <mutex>
#include <numbers>

#include "io/expression_syntax.hpp"
#include "math/angle.hpp"

namespace brachisto::io {

namespace {

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

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

std::string expression_grammar() {
  std::vector<std::string_view> names;
  for (const Function& function : functions()) names.push_back(function.name);
  return fmt::format("numbers, + - * / ^ ( ), pi, {}", fmt::join(names, ", "));
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
    : text_(trimmed(text)) {
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
    number = trimmed(number.substr(0, number.size() - suffix.size()));
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
