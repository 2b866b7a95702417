// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The formulas of a program have its values.

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "program_files/nl_numbering.hpp"
#include "program_files/programs.hpp"

namespace brachisto {
namespace {

using program_files::Formula;
using program_files::in_formulas;
using program_files::NlNumbering;
using program_files::ProgramInFormulas;
using testing::program_cases;
using testing::ProgramCase;
using testing::Random;

/// Reads Polish notation.
class Reader {
 public:
  Reader(const ProgramInFormulas& program, const std::vector<double>& x)
      : program_(program), x_(x) {}

  [[nodiscard]] double value(const Formula& formula) const {
    double sum = formula.constant();
    for (const Formula::Term& term : formula.terms()) {
      sum += term.coefficient * x_.at(static_cast<std::size_t>(term.unknown));
    }
    if (formula.tree().empty()) return sum;
    std::size_t next = 0;
    sum += operand(formula.tree(), next);
    EXPECT_EQ(next, formula.tree().size()) << "tokens are left over";
    return sum;
  }

 private:
  [[nodiscard]] double operand(const std::vector<Formula::Token>& tree,
                               std::size_t& next) const {
    using enum Formula::Operation;
    using Kind = Formula::Token::Kind;
    const Formula::Token token = tree.at(next++);
    if (token.kind == Kind::Constant) return token.value;
    if (token.kind == Kind::Unknown) {
      return x_.at(static_cast<std::size_t>(token.number));
    }
    if (token.kind == Kind::Quantity) {
      return value(program_.quantity(token.number));
    }
    if (token.number == static_cast<int>(If)) return chosen(tree, next);
    const double a = operand(tree, next);
    switch (static_cast<Formula::Operation>(token.number)) {
      case Plus:
        return a + operand(tree, next);
      case Minus:
        return a - operand(tree, next);
      case Times:
        return a * operand(tree, next);
      case Divided:
        return a / operand(tree, next);
      case Negative:
        return -a;
      case Root:
        return std::sqrt(a);
      case Sine:
        return std::sin(a);
      case Cosine:
        return std::cos(a);
      case Power:
        return std::exp(a);
      case Logarithm:
        return std::log(a);
      case Arctangent:
        return std::atan(a);
      case Greater:
      case If:
        break;
    }
    throw std::logic_error("an operation that is no number");
  }
  [[nodiscard]] double chosen(const std::vector<Formula::Token>& tree,
                              std::size_t& next) const {
    EXPECT_EQ(tree.at(next++).number,
              static_cast<int>(Formula::Operation::Greater));
    const double a = operand(tree, next);
    const bool above = a > operand(tree, next);
    const double there = operand(tree, next);
    const double otherwise = operand(tree, next);
    return above ? there : otherwise;
  }

  const ProgramInFormulas& program_;
  const std::vector<double>& x_;
};

TEST(Formula, KeepsWhatIsAffineOutOfItsTree) {
  const Formula x = Formula::unknown(3), y = Formula::unknown(5);

  const Formula affine = 2.0 * (x - y) / 4.0 + 1.0 + x;

  EXPECT_TRUE(affine.tree().empty());
  EXPECT_EQ(affine.constant(), 1.0);
  ASSERT_EQ(affine.terms().size(), 2U);
  EXPECT_EQ(affine.terms()[0].coefficient, 1.5);
  EXPECT_EQ(affine.terms()[1].coefficient, -0.5);
  EXPECT_FALSE((x * y).tree().empty());
}

TEST(Formula, ComputesWithConstants) {
  const Formula constant = sqrt(Formula(9.0)) * 2.0 - sin(Formula(0.0));

  EXPECT_EQ(constant.constant(), 6.0);
  EXPECT_TRUE(constant.tree().empty());
  EXPECT_TRUE((0.0 * Formula::unknown(1)).terms().empty());
}

TEST(Formula, SaysWhatHoldsOnEitherSide) {
  const Formula x = Formula::unknown(0);

  const Formula either = where_above(
      x, 2.0, [&] { return x * x; }, [] { return Formula(5.0); });

  using enum Formula::Operation;
  std::vector<Formula::Operation> operations;
  for (const Formula::Token& token : either.tree()) {
    if (token.kind != Formula::Token::Kind::Operation) continue;
    operations.push_back(static_cast<Formula::Operation>(token.number));
  }
  EXPECT_EQ(operations, (std::vector{If, Greater, Times}));
  EXPECT_EQ(either.tree().back().value, 5.0);
}

class Formulas : public ::testing::TestWithParam<ProgramCase> {};

TEST_P(Formulas, HaveTheValuesOfTheProgram) {
  constexpr std::uint32_t kSeed = 11;
  Random random(kSeed);
  const auto problem = GetParam().make();
  const auto formulas = in_formulas(*problem);
  const std::vector<double> x = GetParam().point(*problem, random);
  ASSERT_TRUE(problem->set_point(x)) << problem->refusal();
  const Reader read(*formulas, x);

  double f = 0.0;
  for (int i = 0; i < formulas->num_objective_parts(); ++i) {
    f += read.value(formulas->objective_part(i));
  }
  std::vector<double> g(static_cast<std::size_t>(problem->num_constraints()));
  problem->eval_g(g);

  // Of defects the size is that of states times entries of D.
  constexpr double kLargestTerm = 100.0;
  const int p = problem->mesh().degree;
  EXPECT_NEAR(f, problem->eval_f(), testing::rounding_of(p, std::abs(f)));
  for (int i = 0; i < problem->num_constraints(); ++i) {
    EXPECT_NEAR(read.value(formulas->constraint(i)),
                g[static_cast<std::size_t>(i)],
                testing::rounding_of(p, kLargestTerm))
        << problem->constraint_name(i);
  }
}

TEST_P(Formulas, AreNumberedAsTheFormatWants) {
  const auto problem = GetParam().make();
  const auto formulas = in_formulas(*problem);

  const NlNumbering order(*problem, *formulas);

  ASSERT_EQ(order.variables.size(),
            static_cast<std::size_t>(problem->num_variables()));
  ASSERT_EQ(order.constraints.size(),
            static_cast<std::size_t>(problem->num_constraints()));
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  for (int i = 0; i < problem->num_variables(); ++i) {
    EXPECT_EQ(order.variables[at(order.place_of_variable[at(i)])], i);
  }
  for (int row = 0; row < problem->num_constraints(); ++row) {
    const Formula formula = formulas->constraint(order.constraints[at(row)]);
    EXPECT_EQ(formula.tree().empty(), row >= order.nonlinear_constraints);
    for (const Formula::Token& token : formula.tree()) {
      if (token.kind == Formula::Token::Kind::Unknown) {
        EXPECT_LT(order.place_of_variable[at(token.number)],
                  order.nonlinear_in_constraints);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(ProgramFiles, Formulas,
                         ::testing::ValuesIn(program_cases()),
                         [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace brachisto
