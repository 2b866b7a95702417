// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/expression.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>

#include "support/numbers.hpp"

namespace brachisto::io {
namespace {

using testing::kPi;

/// Why a text is refused; "" if it is not.
std::string refusal(const std::string& text, Unit unit = Unit::None) {
  try {
    static_cast<void>(evaluate(text, unit));
  } catch (const ExpressionError& error) {
    return error.what();
  }
  return "";
}

TEST(Expression, LiteralsAreTheNearestDoubles) {
  EXPECT_EQ(evaluate("0.1"), 0.1);
  EXPECT_EQ(evaluate("1e-10"), 1e-10);
  EXPECT_EQ(evaluate("9007199254740993"), 9007199254740992.0);
  EXPECT_EQ(evaluate("2.2250738585072011e-308"), 2.2250738585072011e-308);
  EXPECT_EQ(evaluate("0.1000000000000000055511151231257827021181583404541"),
            0.1);
}

TEST(Expression, LiteralsNeedNoDigitsOnOneSideOfThePoint) {
  EXPECT_EQ(evaluate("1."), 1.0);
  EXPECT_EQ(evaluate(".5"), 0.5);
  EXPECT_EQ(evaluate("+3"), 3.0);
  EXPECT_EQ(evaluate("-3"), -3.0);
  EXPECT_EQ(evaluate(" 7\n"), 7.0);
}

TEST(Expression, LeadingZerosDoNotMeanOctal) {
  EXPECT_EQ(evaluate("010"), 10.0);
  EXPECT_EQ(evaluate("010+1"), 11.0);
}

TEST(Expression, ArithmeticFollowsTheUsualPrecedence) {
  EXPECT_EQ(evaluate("1/3"), 1.0 / 3.0);
  EXPECT_EQ(evaluate("1-2-3"), -4.0);
  EXPECT_EQ(evaluate("2*3/4"), 1.5);
  EXPECT_EQ(evaluate("-2^2"), -4.0);
  EXPECT_EQ(evaluate("2^3^2"), 512.0);
  EXPECT_EQ(evaluate("2^-1"), 0.5);
  EXPECT_EQ(evaluate("(1+2)*3"), 9.0);
  EXPECT_EQ(evaluate("1e-5-2"), 1e-5 - 2.0);
}

TEST(Expression, PiHasAllDigits) {
  EXPECT_EQ(evaluate("pi"), kPi);
  EXPECT_EQ(evaluate("-pi/6"), -kPi / 6.0);
}

TEST(Expression, FunctionsAreThoseOfTheStandardLibrary) {
  EXPECT_EQ(evaluate("1/sqrt(2)"), 1.0 / std::sqrt(2.0));
  EXPECT_EQ(evaluate("sqrt(1-0.5)"), std::sqrt(0.5));
  EXPECT_EQ(evaluate("sin(0.3)"), std::sin(0.3));
  EXPECT_EQ(evaluate("cos(0.3)"), std::cos(0.3));
  EXPECT_EQ(evaluate("tan(0.3)"), std::tan(0.3));
  EXPECT_EQ(evaluate("asin(0.3)"), std::asin(0.3));
  EXPECT_EQ(evaluate("acos(0.3)"), std::acos(0.3));
  EXPECT_EQ(evaluate("atan(0.3)"), std::atan(0.3));
  EXPECT_EQ(evaluate("exp(0.3)"), std::exp(0.3));
  EXPECT_EQ(evaluate("log(0.3)"), std::log(0.3));
  EXPECT_EQ(evaluate("abs(-0.3)"), 0.3);
  EXPECT_EQ(evaluate("min(2, 1)"), 1.0);
  EXPECT_EQ(evaluate("max(2, 1)"), 2.0);
  EXPECT_EQ(evaluate("pow(2, 0.5)"), std::pow(2.0, 0.5));
}

TEST(Expression, AFunctionNeedsItsArgument) {
  const std::string reason =
      " is a function, whose argument follows in parentheses";

  for (const std::string text :
       {"sin", "2*sin", "sin + 1", "sin (1)", "abs(sin)", "min, 1"}) {
    const std::string word = text[0] == 'm' ? "min" : "sin";
    EXPECT_EQ(refusal(text), '"' + word + '"' + reason) << text;
    EXPECT_THROW(Expression(text, Unit::None, Names::Quantities),
                 ExpressionError)
        << text;
  }
}

TEST(Expression, DegreesAgreeWithFractionsOfPiToTheLastBit) {
  EXPECT_EQ(evaluate("-30 deg", Unit::Angle), -kPi / 6.0);
  EXPECT_EQ(evaluate("45deg", Unit::Angle), kPi / 4.0);
  EXPECT_EQ(evaluate("60 deg", Unit::Angle), kPi / 3.0);
  EXPECT_EQ(evaluate("90 deg", Unit::Angle), kPi / 2.0);
  EXPECT_EQ(evaluate("(90-60) deg", Unit::Angle), kPi / 6.0);
  EXPECT_EQ(evaluate("180/4 deg", Unit::Angle), kPi / 4.0);
  EXPECT_EQ(evaluate("1e-1 deg", Unit::Angle), kPi / 1800.0);
}

TEST(Expression, RadiansMayBeNamed) {
  EXPECT_EQ(evaluate("0.5 rad", Unit::Angle), 0.5);
  EXPECT_EQ(evaluate("pi/6 rad", Unit::Angle), kPi / 6.0);
}

TEST(Expression, ASumBeforeASuffixNeedsParentheses) {
  const std::string reason = "a sum before deg or rad needs parentheses";

  EXPECT_EQ(refusal("90-60 deg", Unit::Angle), reason);
  EXPECT_EQ(refusal("pi/2 - 30 deg", Unit::Angle), reason);
  EXPECT_EQ(refusal("sin(1)+1 rad", Unit::Angle), reason);
  EXPECT_EQ(refusal("2*-3 deg", Unit::Angle), "");
}

TEST(Expression, SuffixesBelongBehindAnglesAsAWhole) {
  EXPECT_EQ(refusal("30 deg"), "deg is a unit of angles, and this is none");
  EXPECT_EQ(refusal("30 deg + 1", Unit::Angle),
            "deg may only stand behind an angle as a whole");
  EXPECT_EQ(refusal("deg", Unit::Angle), "it is empty");
}

TEST(Expression, NonFiniteValuesAreRefused) {
  EXPECT_EQ(refusal("1/0"), "its value is not finite");
  EXPECT_EQ(refusal("sqrt(-1)"), "its value is not finite");
  EXPECT_EQ(refusal("1/(1/0)"), "a part of it is not finite");
  EXPECT_EQ(refusal("min(1, exp(1e4))"), "a part of it is not finite");
  EXPECT_EQ(refusal("1e999"), "it is out of the range of double precision");
  EXPECT_EQ(refusal("inf"), "\"inf\" has no meaning here");
  EXPECT_NE(refusal(".inf"), "");
  EXPECT_NE(refusal("-.INF"), "");
  EXPECT_NE(refusal(".nan"), "");
  EXPECT_NE(refusal("nan"), "");
}

TEST(Expression, CommasOnlySeparateArguments) {
  const std::string reason =
      "a comma separates arguments of functions only; decimals need a point";

  EXPECT_EQ(refusal("2,3"), reason);
  EXPECT_EQ(refusal("1,"), reason);
  EXPECT_EQ(refusal("max(1, 2), 3"), reason);
  EXPECT_NE(refusal("(2,3)"), "");
  EXPECT_NE(refusal("max(1, (2, 3))"), "");
}

TEST(Expression, OtherNotationsOfNumbersAreRefused) {
  EXPECT_EQ(refusal("0x10"),
            "\"x10\" follows a number directly; a product needs *");
  EXPECT_EQ(refusal("1_000"),
            "\"_000\" follows a number directly; a product needs *");
  EXPECT_EQ(refusal("2pi"),
            "\"pi\" follows a number directly; a product needs *");
  EXPECT_NE(refusal("1 000"), "");
  EXPECT_NE(refusal("1e"), "");
  EXPECT_NE(refusal("1..5"), "");
  EXPECT_NE(refusal("."), "");
}

TEST(Expression, WhatMuParserWouldTakeBesidesNumbersIsRefused) {
  EXPECT_EQ(refusal("x = 3"), "\"x\" has no meaning here");
  EXPECT_EQ(refusal("_pi"), "\"_pi\" has no meaning here; did you mean pi?");
  EXPECT_EQ(refusal("_e"), "\"_e\" has no meaning here");
  EXPECT_EQ(refusal("1 < 2"), "\"<\" has no meaning in a number");
  EXPECT_EQ(refusal("1 ? 2 : 3"), "\"?\" has no meaning in a number");
  EXPECT_EQ(refusal("\"1\""), "\"\"\" has no meaning in a number");
  EXPECT_EQ(refusal("sum(1, 2)"), "\"sum\" has no meaning here");
}

TEST(Expression, WordsGetASuggestion) {
  EXPECT_EQ(refusal("sqr(2)"),
            "\"sqr\" has no meaning here; did you mean sqrt?");
  EXPECT_EQ(refusal("Pi"), "\"Pi\" has no meaning here; did you mean pi?");
}

TEST(Expression, CharactersAreNotCutInMessages) {
  EXPECT_EQ(refusal("1 + θ"), "\"θ\" has no meaning in a number");
}

TEST(Expression, UnfinishedOnesAreRefused) {
  EXPECT_EQ(refusal(""), "it is empty");
  EXPECT_EQ(refusal("-"), "it is not complete");
  EXPECT_NE(refusal("3+"), "");
  EXPECT_NE(refusal("(1"), "");
  EXPECT_NE(refusal("1)"), "");
  EXPECT_NE(refusal("sqrt()"), "");
  EXPECT_NE(refusal("sqrt 4"), "");
  EXPECT_NE(refusal("max(1)"), "");
}

TEST(Expression, NamesStandForQuantities) {
  const QuantityValues scene{0.25, 0.5, 1.5, 0.75, 3.0, 2.0};
  const auto value = [&](const std::string& text, Unit unit = Unit::None) {
    return Expression(text, unit).value(scene);
  };

  EXPECT_EQ(value("r"), 0.25);
  EXPECT_EQ(value("eta_m"), 0.5);
  EXPECT_EQ(value("theta_m"), 1.5);
  EXPECT_EQ(value("k"), 0.75);
  EXPECT_EQ(value("L"), 3.0);
  EXPECT_EQ(value("H"), 2.0);
  EXPECT_EQ(value("sqrt(1-k) + L^H"), std::sqrt(0.25) + 9.0);
  EXPECT_EQ(value("eta_m*90 deg", Unit::Angle), kPi / 4);
  EXPECT_EQ(value("(eta_m + 1) rad", Unit::Angle), 1.5);
}

TEST(Expression, NamesAreEvaluatedAnewEachTime) {
  const Expression expression("k^2 + 1/2");

  for (const double k : {0.1, 0.7, 3.0}) {
    EXPECT_EQ(expression.value({0, 0, 0, k, 0, 0}), k * k + 0.5);
  }
}

TEST(Expression, TellsWhichNamesItHas) {
  EXPECT_TRUE(Expression("sqrt(2)").quantities().empty());
  EXPECT_EQ(Expression("H/L").quantities().size(), 2u);
  EXPECT_EQ(Expression("k - k").quantities(),
            std::vector<std::size_t>{quantity_named("k")});
}

TEST(Expression, WithNamesIsCheckedAtOnce) {
  const auto refused = [](const std::string& text) {
    try {
      static_cast<void>(Expression(text));
    } catch (const ExpressionError&) {
      return true;
    }
    return false;
  };

  for (const std::string text : {"k +", "2k", "k(2)", "(k", "k L", "K", "g",
                                 "k deg", "k = 2", "sqrt k"}) {
    EXPECT_TRUE(refused(text)) << text;
  }
}

TEST(Expression, NamesAreRefusedWhereThereAreNone) {
  EXPECT_EQ(refusal("sqrt(1-k)"),
            "\"k\" has no meaning here; only numbers of the section sweep may "
            "name quantities");
}

TEST(Expression, LengthIsLimited) {
  const std::string longest(kMaxExpressionLength, '1');

  EXPECT_EQ(refusal(longest), "");
  EXPECT_EQ(refusal(longest + "1"), "it is longer than 200 characters");
  EXPECT_EQ(refusal(std::string(100'000, '(')),
            "it is longer than 200 characters");
}

/// The direction that an angle of a file means.
double direction(const std::string& text) {
  return Expression(text, Unit::Angle, Names::None).direction();
}

TEST(Expression, WholeTurnsOfDegreesAreTakenOffExactly) {
  for (const std::int64_t degrees :
       {std::int64_t{361}, std::int64_t{-725}, std::int64_t{1'000'000'000'000},
        std::int64_t{1'000'000'000'000'000'000}}) {
    EXPECT_EQ(direction(std::to_string(degrees) + " deg"),
              evaluate(std::to_string(degrees % 360) + " deg", Unit::Angle))
        << degrees;
  }
  EXPECT_EQ(direction("1e18 deg"), evaluate("280 deg", Unit::Angle));
}

TEST(Expression, AnglesWithinATurnStayWhatTheyAre) {
  for (const char* text : {"360 deg", "-360 deg", "330 deg", "6.28", "-2*pi"}) {
    EXPECT_EQ(direction(text), evaluate(text, Unit::Angle)) << text;
  }
}

}  // namespace
}  // namespace brachisto::io
