// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The certificate of a track under limits passes on the answer and on nothing
// that was tampered with.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "brachisto/math/index.hpp"
#include "support/limited_answer.hpp"
#include "trajectory/certify.hpp"

namespace brachisto::testing {
namespace {

using enum StateComponent;

/// Relative error of T, with room.
constexpr double kLimitedError = 1e-10;

class LimitedCertificate : public ::testing::TestWithParam<const char*> {
 protected:
  static const LimitedCurve& answer() {
    static std::map<std::string, LimitedCurve> solved;
    const auto place = solved.find(GetParam());
    if (place != solved.end()) return place->second;
    return solved
        .emplace(GetParam(), solved_curve(limited_reference(GetParam()).scene))
        .first->second;
  }
  [[nodiscard]] const VariableLayout& layout() const {
    return answer().problem().layout();
  }
  [[nodiscard]] Certificate certificate(double mismatch = 0.0) const {
    return certify(LimitedCurve(answer().problem(), point), mismatch,
                   kLimitedError);
  }
  [[nodiscard]] bool passes(const std::string& check,
                            double mismatch = 0.0) const {
    const Certificate result = certificate(mismatch);
    const Check* found = result.find(check);
    return found != nullptr && found->passed;
  }
  /// A row of a limit that holds, not next to a junction, and the size of its
  /// multiplier; the greatest of all.
  [[nodiscard]] int held_row() const {
    int best = -1;
    for (int c = 1; c + 1 < layout().num_points(); ++c) {
      for (int i = 0; i < layout().num_limits(); ++i) {
        const int row = layout().limit(c, i);
        if (best < 0 || std::abs(point.lambda[at(row)]) >
                            std::abs(point.lambda[at(best)])) {
          best = row;
        }
      }
    }
    return best;
  }
  /// A row of a limit that does not hold.
  [[nodiscard]] int free_row() const {
    for (int c = layout().num_points() / 2; c < layout().num_points(); ++c) {
      for (int i = 0; i < layout().num_limits(); ++i) {
        if (!answer().active(c, i)) return layout().limit(c, i);
      }
    }
    return -1;
  }

  PrimalDual point = answer().point();
};

TEST_P(LimitedCertificate, PassesOnTheAnswer) {
  const Certificate result = certificate();

  for (const Check& check : result.checks) {
    EXPECT_TRUE(check.passed)
        << check.name << ": " << check.value << " > " << check.threshold;
  }
  EXPECT_TRUE(result.verified());
  for (const char* name :
       {"kkt_residual", "defects", "complementarity", "multiplier_signs",
        "limits", "second_order", "contact_error", "closure", "slope_angle",
        "reintegration_error", "reintegrated_limits"}) {
    EXPECT_NE(result.find(name), nullptr) << name;
  }
}

TEST_P(LimitedCertificate, FailsOnAMultiplierOfTheWrongSign) {
  point.lambda[at(held_row())] *= -1.0;

  EXPECT_FALSE(passes("multiplier_signs"));
  EXPECT_FALSE(passes("kkt_residual"));
}

TEST_P(LimitedCertificate, FailsOnAllMultipliersOfTheWrongSign) {
  // A maximum in the limits' place: stationary for the objective turned about.
  for (double& lambda : point.lambda) lambda *= -1.0;

  EXPECT_FALSE(passes("multiplier_signs"));
}

TEST_P(LimitedCertificate, FailsOnAMultiplierOfALimitThatDoesNotHold) {
  const int row = free_row();
  ASSERT_GE(row, 0);
  LimitedTime problem = answer().problem().as_inequalities();
  // Towards the bound there is; the slack is of order one.
  const bool below = std::isfinite(problem.constraint_range(row).lower);
  point.lambda[at(row)] = below ? -1e-3 : 1e-3;

  EXPECT_FALSE(passes("complementarity"));
  EXPECT_FALSE(passes("kkt_residual"));
}

TEST_P(LimitedCertificate, FailsOnAMovedNode) {
  for (const StateComponent component : {X, Z, W, Beta}) {
    for (const int node : {1, layout().num_nodes() / 2}) {
      const PrimalDual untouched = point;
      point.x[at(layout().state(node, component))] += 1e-6;

      EXPECT_FALSE(passes("defects"))
          << static_cast<int>(component) << " " << node;
      point = untouched;
    }
  }
}

TEST_P(LimitedCertificate, FailsOnAMovedContact) {
  const int last = layout().num_nodes() - 1;
  point.x[at(layout().state(last, X))] += 1e-6;

  EXPECT_FALSE(passes("contact_error"));
  EXPECT_FALSE(certificate().verified());
}

TEST_P(LimitedCertificate, FailsOnContactsThatAreNotClosed) {
  EXPECT_FALSE(passes("closure", 1e-6));
  EXPECT_FALSE(passes("closure", std::nan("")));
}

TEST_P(LimitedCertificate, FailsOnAnotherRollingTime) {
  point.x[at(layout().rolling_time())] *= 1.0 + 1e-6;

  EXPECT_FALSE(passes("defects"));
}

/// Of β alone: a polynomial that vanishes at all nodes of an element but one
/// bends the path between them.
TEST_P(LimitedCertificate, FailsOnASlopeThatBendsBetweenTheNodes) {
  const int p = answer().problem().mesh().degree;
  const int element = answer().problem().mesh().num_elements() / 2;
  for (int n = 1; n < p; ++n) {
    point.x[at(layout().state(element * p + n, Beta))] +=
        n % 2 == 0 ? 1e-4 : -1e-4;
  }

  EXPECT_FALSE(passes("reintegration_error"));
  EXPECT_FALSE(certificate().verified());
}

TEST_P(LimitedCertificate, FailsOnALoop) {
  for (int node = 0; node < layout().num_nodes(); ++node) {
    point.x[at(layout().state(node, Beta))] -= 0.2 * node;
  }

  EXPECT_FALSE(passes("slope_angle"));
}

TEST_P(LimitedCertificate, FailsOnMultipliersThatAreNoNumbers) {
  const PrimalDual untouched = point;
  for (std::size_t i = 0; i < point.lambda.size(); i += 53) {
    point.lambda[i] = std::nan("");

    EXPECT_FALSE(certificate().verified())
        << answer().problem().constraint_name(static_cast<int>(i));
    point = untouched;
  }
}

INSTANTIATE_TEST_SUITE_P(Answers, LimitedCertificate,
                         ::testing::Values("friction_0.6", "valley_2",
                                           "floor_0.9", "optimal_K2",
                                           "uniform_friction_0.5",
                                           "bead_floor_1.0"),
                         [](const auto& row) {
                           std::string name = row.param;
                           std::replace(name.begin(), name.end(), '.', '_');
                           return name;
                         });

/// The free extremal needs more friction than there is: a path of no limits,
/// judged by them.
TEST(LimitedCertificateOfATrack, ThatIsTooSteepForItsLimitsFails) {
  const LimitedReference loose = limited_reference("friction_3");
  const LimitedCurve curve = solved_curve(loose.scene);
  auto limits = curve.problem().limits();
  for (PathInequality& limit : limits) limit.number = 1.0;
  const LimitedTime harder(curve.problem().scene(), limits,
                           curve.problem().mesh(), curve.problem().ends());
  const Certificate result =
      certify(LimitedCurve(harder, curve.point()), 0.0, kLimitedError);

  ASSERT_NE(result.find("limits"), nullptr);
  EXPECT_FALSE(result.find("limits")->passed);
  EXPECT_NE(result.find("limits")->where.find("friction"), std::string::npos);
  EXPECT_FALSE(result.find("reintegrated_limits")->passed);
  EXPECT_FALSE(result.find("defects")->passed);
}

/// The certificate of an answer, read as one to another question: what it was
/// built with, slopes included, is as it was.
Certificate as_answer_to(const Scene& asked, const LimitedCurve& curve) {
  const LimitedTime& problem = curve.problem();
  return certify(
      LimitedCurve(LimitedTime(asked, problem.limits(), problem.mesh(),
                               problem.ends(), problem.held()),
                   curve.point()),
      0.0, kLimitedError);
}

/// Whatever shape the body has: a bead's contact at B has no part in its slope.
TEST(LimitedCertificateOfATrack, ThatEndsWithAnotherSlopeThanIsAskedForFails) {
  for (const Scene& scene : {off_centred_scene(), bead_scene()}) {
    Scene asked = under(scene, bends(2.0, 3.0), Contact::EndSlope);
    asked.end_slope = -0.5;
    const LimitedCurve curve = solved_curve(asked);
    Scene other = curve.problem().scene();
    EXPECT_TRUE(as_answer_to(other, curve).verified());
    other.end_slope = 0.4;

    const Certificate result = as_answer_to(other, curve);

    ASSERT_NE(result.find("end_slope"), nullptr);
    EXPECT_FALSE(result.find("end_slope")->passed);
    EXPECT_NEAR(result.find("end_slope")->value, 0.9, 1e-12);
  }
}

TEST(LimitedCertificateOfATrack, ThatStartsWithAnotherSlopeThanTheLawFails) {
  const LimitedCurve curve =
      solved_curve(limited_reference("uniform_friction_0.5").scene);
  Scene other = curve.problem().scene();
  EXPECT_TRUE(as_answer_to(other, curve).verified());
  other.limits.friction = 1.0;

  const Certificate result = as_answer_to(other, curve);

  ASSERT_NE(result.find("start_angle"), nullptr);
  EXPECT_FALSE(result.find("start_angle")->passed);
  // tan β₀ = 3 μ.
  EXPECT_NEAR(result.find("start_angle")->value,
              std::atan(3.0) - std::atan(1.5), 1e-12);
}

/// On a mesh too coarse for its arcs the limits hold at the points and not
/// between them: so does the answer of an interior-point method.
TEST(LimitedCertificateOfATrack, ThatKeepsLimitsAtItsPointsAloneFails) {
  const LimitedCurve curve = solved_curve(limited_reference("floor_0.9").scene);
  const Mesh& mesh = curve.problem().mesh();
  const int p = mesh.degree;
  PrimalDual point = curve.point();
  const VariableLayout& layout = curve.problem().layout();
  // z lowered at every other node of an element on the floor and raised at the
  // others, in turn: at nodes by 1e-9, which is allowed, between them by the
  // amplification of the interpolation.
  for (int e = 0; e < mesh.num_elements(); ++e) {
    if (!curve.active(e * p + 1, 0)) continue;
    for (int n = 1; n < p; ++n) {
      point.x[at(layout.state(e * p + n, Z))] += 2e-7 * (n % 2 == 0 ? 1 : -1);
    }
    break;
  }

  const Certificate result =
      certify(LimitedCurve(curve.problem(), point), 0.0, kLimitedError);

  EXPECT_FALSE(result.find("limits")->passed);
  EXPECT_NE(result.find("limits")->where.find("floor"), std::string::npos)
      << result.find("limits")->where;
}

}  // namespace
}  // namespace brachisto::testing
