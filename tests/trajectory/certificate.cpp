// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The certificate passes on a solution and on nothing that was tampered with.

#include "brachisto/trajectory/motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "support/numbers.hpp"
#include "trajectory/solved_case.hpp"

namespace brachisto {
namespace {

using enum StateComponent;

constexpr double kTurn = 2.0 * std::numbers::pi;

using testing::kNaN;
using testing::SolvedCase;
using CertificateOf = SolvedCase;

TEST_F(CertificateOf, TheSolutionPassesEveryCheck) {
  const Certificate result = certificate();

  for (const Check& check : result.checks) {
    EXPECT_TRUE(check.passed)
        << check.name << ": " << check.value << " > " << check.threshold;
  }
  EXPECT_TRUE(result.verified());
  for (const char* name :
       {"kkt_residual", "hamiltonian", "slope", "start_angle", "second_order",
        "legendre", "weierstrass", "defects", "contact_error", "closure",
        "energy_drift", "reintegrated_time", "reintegration_error",
        "slope_angle", "speed"}) {
    EXPECT_NE(result.find(name), nullptr) << name;
  }
}

TEST_F(CertificateOf, TheTimeIsJudgedByTheErrorOfTheTime) {
  // 3 ε, and what the integrator's steps add.
  const Certificate result = certificate();
  const Check* time = result.find("reintegrated_time");

  EXPECT_EQ(not_verified_because(result), std::vector<std::string>{});
  ASSERT_NE(time, nullptr);
  EXPECT_LT(time->threshold, 1e-9);
}

TEST_F(CertificateOf, WhatFailedIsSaidWithValueAndThreshold) {
  Certificate made;
  made.add("slope", 0.5, 0.25, "σ = 0.75");
  made.add("closure", 0.0, 1e-8);
  made.add("reintegration_error", kNaN, 0.1, "the body comes to rest");
  made.add("energy_drift", 0.5, kNaN);

  const std::vector<std::string> reasons = not_verified_because(made);

  ASSERT_EQ(reasons.size(), 3u);
  EXPECT_EQ(reasons[0], "slope is 0.5, more than 0.25 (σ = 0.75)");
  EXPECT_EQ(reasons[1],
            "reintegration_error cannot be measured (the body comes to rest)");
  EXPECT_EQ(reasons[2].find("nan"), std::string::npos) << reasons[2];
}

TEST_F(CertificateOf, SlopeAnglesShiftedByWholeTurnsMeanTheSame) {
  // β enters only through its sine and cosine, and a solver may leave single
  // values in another turn.
  for (const int c : {0, 1, 40, problem.mesh().num_points() - 1}) {
    unknown(problem.layout().beta(c)) += c % 2 == 0 ? kTurn : -kTurn;
  }

  EXPECT_TRUE(certificate().verified());
}

TEST_F(CertificateOf, AMovedNodeFails) {
  for (const StateComponent component : {X, Z, Theta, W}) {
    for (const int node : {1, 60, problem.mesh().num_nodes() - 1}) {
      const PrimalDual untouched = point;
      unknown(problem.layout().state(node, component)) += 1e-6;

      EXPECT_FALSE(passes("defects"))
          << "component " << static_cast<int>(component) << ", node " << node;
      EXPECT_FALSE(certificate().verified());
      point = untouched;
    }
  }
}

TEST_F(CertificateOf, AWrongRollingTimeFails) {
  unknown(problem.layout().rolling_time()) *= 1.0 + 1e-6;

  EXPECT_FALSE(passes("defects"));
}

TEST_F(CertificateOf, AnotherSlopeAngleFails) {
  unknown(problem.layout().beta(50)) += 1e-6;

  EXPECT_FALSE(passes("kkt_residual") && passes("defects"));
}

TEST_F(CertificateOf, WrongMultipliersFail) {
  for (double& lambda : point.lambda) lambda *= 1.0 + 1e-6;

  EXPECT_FALSE(passes("kkt_residual"));
}

TEST_F(CertificateOf, MultipliersOfZeroFail) {
  std::fill(point.lambda.begin(), point.lambda.end(), 0.0);

  EXPECT_FALSE(certificate().verified());
}

TEST_F(CertificateOf, AnotherEndAngleFails) {
  phi += 1e-6;

  EXPECT_FALSE(passes("closure"));
}

TEST_F(CertificateOf, AnOpenContactFails) {
  // A true extremal between fixed points, but of the wrong φ.
  phi += 0.1;
  problem.set_end_angle(phi);
  const SolverResult result = solve_with_ipopt(problem, point, {});
  ASSERT_EQ(result.status, Status::Solved) << result.message;
  point = result.point;

  EXPECT_TRUE(passes("kkt_residual"));
  EXPECT_TRUE(passes("defects"));
  EXPECT_FALSE(passes("closure"));
  EXPECT_FALSE(passes("contact_error"));
  EXPECT_FALSE(certificate().verified());
}

TEST_F(CertificateOf, ALoopFails) {
  // Turned further by half a radian at every point: beyond ±π, continuously.
  for (int c = 0; c < problem.mesh().num_points(); ++c) {
    unknown(problem.layout().beta(c)) -= 0.5 * c;
  }

  EXPECT_FALSE(passes("slope_angle"));
  EXPECT_FALSE(certificate().verified());
}

TEST_F(CertificateOf, ABodyThatGoesBackwardsFails) {
  unknown(problem.layout().state(60, W)) *= -1.0;
  EXPECT_FALSE(certificate().verified());

  for (int node = 1; node < problem.mesh().num_nodes(); ++node) {
    unknown(problem.layout().state(node, W)) *= -1.0;
  }

  EXPECT_FALSE(certificate().verified());
}

TEST_F(CertificateOf, ANegativeRollingTimeFails) {
  unknown(problem.layout().rolling_time()) *= -1.0;

  EXPECT_FALSE(certificate().verified());
}

TEST_F(CertificateOf, AnUnknownThatIsNotANumberFails) {
  const PrimalDual untouched = point;
  const VariableLayout& layout = problem.layout();
  for (const int index :
       {layout.state(60, X), layout.state(60, Z), layout.state(60, Theta),
        layout.state(60, W), layout.beta(0), layout.beta(60),
        layout.beta(layout.num_points() - 1), layout.rolling_time()}) {
    unknown(index) = kNaN;

    EXPECT_FALSE(certificate().verified()) << layout.variable_name(index);
    point = untouched;
  }
}

TEST_F(CertificateOf, AMultiplierThatIsNotANumberFails) {
  const PrimalDual untouched = point;
  const VariableLayout& layout = problem.layout();
  for (std::size_t i = 0; i < point.lambda.size(); i += 37) {
    point.lambda[i] = kNaN;

    EXPECT_FALSE(certificate().verified())
        << "multiplier of " << layout.constraint_name(static_cast<int>(i));
    point = untouched;
  }
}

TEST_F(CertificateOf, AnEndAngleThatIsNotANumberFails) {
  phi = kNaN;

  EXPECT_FALSE(certificate().verified());
}

TEST(EmptyCertificate, VerifiesNothing) {
  EXPECT_FALSE(Certificate{}.verified());
}

TEST(Checks, PassUpToTheirThresholdAndNeverForNaN) {
  Certificate certificate;

  certificate.add("below", 0.5, 1.0);
  certificate.add("at", 1.0, 1.0);
  certificate.add("above", std::nextafter(1.0, 2.0), 1.0, "somewhere");
  certificate.add("not a number", kNaN, 1.0);
  certificate.add("infinite", std::numeric_limits<double>::infinity(), 1.0);

  EXPECT_TRUE(certificate.find("below")->passed);
  EXPECT_TRUE(certificate.find("at")->passed);
  EXPECT_FALSE(certificate.find("above")->passed);
  EXPECT_EQ(certificate.find("above")->where, "somewhere");
  EXPECT_FALSE(certificate.find("not a number")->passed);
  EXPECT_FALSE(certificate.find("infinite")->passed);
  EXPECT_EQ(certificate.find("unheard of"), nullptr);
  EXPECT_FALSE(certificate.verified());
}

}  // namespace
}  // namespace brachisto
