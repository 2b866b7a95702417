// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/nlp/problem.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>

#include "nlp/tiny_problem.hpp"

namespace brachisto::testing {
namespace {

/// The message of the std::invalid_argument that `call` throws.
std::string complaint(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no complaint";
}

TEST(Problem, NamesTheVectorOfTheWrongLength) {
  TinyProblem problem;
  std::vector<double> two(2), three(3), four(4), six(6);

  EXPECT_EQ(complaint([&] { static_cast<void>(problem.set_point(two)); }),
            "x has 2 entries, expected 3");
  ASSERT_TRUE(problem.set_point(three));
  EXPECT_EQ(complaint([&] { problem.eval_grad_f(two); }),
            "grad_f has 2 entries, expected 3");
  EXPECT_EQ(complaint([&] { problem.eval_g(three); }),
            "g has 3 entries, expected 2");
  EXPECT_EQ(complaint([&] { problem.eval_jac_g(six); }),
            "jac_g has 6 entries, expected 5");
  EXPECT_EQ(complaint([&] { problem.eval_hess_lag(1.0, three, four); }),
            "lambda has 3 entries, expected 2");
  EXPECT_EQ(complaint([&] { problem.eval_hess_lag(1.0, two, three); }),
            "hess_lag has 3 entries, expected 4");
}

/// Calls every eval_* function; counts those that refuse to work.
int refusals(const TinyProblem& problem) {
  std::vector<double> two(2), three(3), four(4), five(5);
  const std::function<void()> calls[] = {
      [&] { static_cast<void>(problem.eval_f()); },
      [&] { problem.eval_grad_f(three); },
      [&] { problem.eval_g(two); },
      [&] { problem.eval_jac_g(five); },
      [&] { problem.eval_hess_lag(1.0, two, four); },
  };
  int refused = 0;
  for (const auto& call : calls) {
    try {
      call();
    } catch (const std::logic_error&) {
      ++refused;
    }
  }
  return refused;
}

TEST(Problem, EvaluatesNothingBeforeItHasAPoint) {
  const TinyProblem problem;

  EXPECT_EQ(refusals(problem), 5);
}

TEST(Problem, EvaluatesNothingAtARefusedPoint) {
  TinyProblem problem;
  const std::vector<double> bad{-1.0, 0.0, 0.0};
  const std::vector<double> good{1.0, 0.0, 0.0};

  ASSERT_TRUE(problem.set_point(good));
  EXPECT_EQ(refusals(problem), 0);

  EXPECT_FALSE(problem.set_point(bad));
  EXPECT_EQ(problem.refusal(), "x[0] is negative");
  EXPECT_EQ(refusals(problem), 5);

  EXPECT_TRUE(problem.set_point(good));
  EXPECT_EQ(refusals(problem), 0);
}

TEST(Problem, DoesNotEvaluateTheSamePointTwice) {
  TinyProblem problem;
  problem.remembers = true;
  const std::vector<double> one{1.0, 2.0, 0.0};
  const std::vector<double> next{1.0, std::nextafter(2.0, 3.0), 0.0};

  ASSERT_TRUE(problem.set_point(one));
  EXPECT_EQ(problem.points, 1);
  ASSERT_TRUE(problem.set_point(one));
  EXPECT_EQ(problem.points, 1);
  EXPECT_EQ(problem.eval_f(), 5.0);

  ASSERT_TRUE(problem.set_point(next));
  EXPECT_EQ(problem.points, 2);
  EXPECT_GT(problem.eval_f(), 5.0);

  ASSERT_TRUE(problem.set_point(one));
  EXPECT_EQ(problem.points, 3);
  EXPECT_EQ(problem.eval_f(), 5.0);
}

TEST(Problem, EvaluatesEveryPointIfItDoesNotKnowTheLast) {
  TinyProblem problem;
  const std::vector<double> x{1.0, 2.0, 3.0};

  ASSERT_TRUE(problem.set_point(x));
  ASSERT_TRUE(problem.set_point(x));

  EXPECT_EQ(problem.points, 2);
}

TEST(Problem, EvaluatesAgainAfterARefusedPoint) {
  TinyProblem problem;
  problem.remembers = true;
  const std::vector<double> good{1.0, 2.0, 3.0};
  const std::vector<double> bad{-1.0, 2.0, 3.0};
  ASSERT_TRUE(problem.set_point(good));

  // A refused point is refused again, not remembered as a good one.
  EXPECT_FALSE(problem.set_point(bad));
  EXPECT_FALSE(problem.set_point(bad));
  EXPECT_EQ(refusals(problem), 5);
  const int before = problem.points;

  ASSERT_TRUE(problem.set_point(good));
  EXPECT_EQ(problem.points, before + 1);
  EXPECT_EQ(problem.eval_f(), 20.0);
}

TEST(Problem, EvaluatesNothingAtAPointThatThrew) {
  for (const bool remembers : {false, true}) {
    TinyProblem problem;
    problem.remembers = remembers;
    const std::vector<double> one{1.0, 2.0, 3.0};
    const std::vector<double> other{2.0, 2.0, 3.0};
    ASSERT_TRUE(problem.set_point(one));
    problem.throws = true;
    EXPECT_THROW(static_cast<void>(problem.set_point(other)),
                 std::runtime_error);

    EXPECT_EQ(refusals(problem), 5) << "remembers: " << remembers;

    // Nor is it taken for evaluated when it is asked for again.
    problem.throws = false;
    const int before = problem.points;
    ASSERT_TRUE(problem.set_point(other));
    EXPECT_EQ(problem.points, before + 1) << "remembers: " << remembers;
    EXPECT_EQ(refusals(problem), 0);
  }
}

TEST(Problem, PassesEvaluationsOn) {
  TinyProblem problem;
  std::vector<double> grad_f(3), g(2), jac_g(5), hess_lag(4);

  ASSERT_TRUE(problem.set_point(std::vector{2.0, 3.0, 1.0}));
  problem.eval_grad_f(grad_f);
  problem.eval_g(g);
  problem.eval_jac_g(jac_g);
  problem.eval_hess_lag(0.5, std::vector{7.0, 11.0}, hess_lag);

  EXPECT_EQ(problem.eval_f(), 18.0);
  EXPECT_EQ(grad_f, (std::vector{4.0, 6.0, 5.0}));
  EXPECT_EQ(g, (std::vector{4.0, 5.0}));
  EXPECT_EQ(jac_g, (std::vector{1.0, 1.0, -1.0, 3.0, 2.0}));
  EXPECT_EQ(hess_lag, (std::vector{0.5, 0.5, 11.0, 1.0}));
}

}  // namespace
}  // namespace brachisto::testing
