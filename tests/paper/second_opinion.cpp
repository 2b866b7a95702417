// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Collocation and shooting, which share nothing but the physics, agree.

#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <string>

#include "brachisto/study/solve.hpp"
#include "paper/names.hpp"
#include "study/answer_kinds.hpp"
#include "support/reference_values.hpp"

namespace brachisto {
namespace {

using testing::kReferenceValues;
using testing::reference;
using testing::ReferenceValue;

class SecondOpinion : public ::testing::TestWithParam<ReferenceValue> {};

INSTANTIATE_TEST_SUITE_P(AllRows, SecondOpinion,
                         ::testing::ValuesIn(kReferenceValues),
                         testing::row_name);

TEST_P(SecondOpinion, Agrees) {
  // To the default tolerance of the mesh.
  constexpr double kAgreement = 1e-10;
  SolveOptions options;
  options.use<Collocation>().certify = Certify::Extremal;

  const Solution solution = solve(GetParam().scene(), options);

  ASSERT_TRUE(solution.verified()) << solution.message;
  ASSERT_TRUE(solution.extremal);
  EXPECT_TRUE(solution.extremal->solved) << solution.extremal->message;
  EXPECT_LE(solution.extremal->difference, kAgreement);
  EXPECT_NEAR(solution.extremal->tau, GetParam().tau, 1e-12 * GetParam().tau);
  EXPECT_LT(solution.extremal->error_estimate, 1e-12);
  ASSERT_NE(solution.certificate.find("extremal"), nullptr);
  EXPECT_TRUE(solution.certificate.find("extremal")->passed);
}

TEST_P(SecondOpinion, IsTheSameAnswerIfAskedFirst) {
  SolveOptions options;
  options.method = Shooting{};

  const Solution solution = solve(GetParam().scene(), options);

  ASSERT_TRUE(solution.verified()) << solution.message;
  const Trajectory& path = *trajectory_of(solution);
  EXPECT_NEAR(path.tau(), GetParam().tau, 1e-11 * GetParam().tau);
  EXPECT_NEAR(path.end_angle(), GetParam().end_angle, 1e-9);
  EXPECT_NEAR(path.centre_path_length(), GetParam().centre_path_length,
              1e-9 * GetParam().centre_path_length);
  EXPECT_EQ(solution.effort.iterations, 0);
}

TEST(ASecondOpinion, IsNotAskedForByDefault) {
  const Solution solution = solve(reference("uniform_L3").scene());

  EXPECT_FALSE(solution.extremal);
  EXPECT_EQ(solution.certificate.find("extremal"), nullptr);
}

}  // namespace
}  // namespace brachisto
