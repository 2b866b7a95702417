// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Straight pieces converge with order 2, for every start angle and, because the
// end angle comes from transversality, in β_end too; the estimated error holds.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "brachisto/study/solve.hpp"
#include "study/answer_kinds.hpp"
#include "support/observed_order.hpp"
#include "support/reference_values.hpp"

namespace brachisto {
namespace {

using testing::observed_order;
using testing::reference;
using testing::ReferenceValue;

Solution solve_on_pieces(const ReferenceValue& row, int pieces) {
  SolveOptions options;
  Discretisation& mesh = options.use<Collocation>().discretisation;
  mesh.formulation = Formulation::ArcLength;
  mesh.elements = pieces;
  return solve(row.scene(), options);
}

class ArcLengthOrder : public ::testing::TestWithParam<ReferenceValue> {};
INSTANTIATE_TEST_SUITE_P(
    Cases, ArcLengthOrder,
    ::testing::Values(reference("bead_L3"), reference("uniform_L3"),
                      reference("reference_case"), reference("theta_-30"),
                      reference("theta_-90"), reference("theta_60"),
                      reference("r_0.2"), reference("fast")));

TEST_P(ArcLengthOrder, IsTwoInTheTimeAndInTheEndAngle) {
  // An error C h² (1 + D h²) with |D| h² below a quarter on the coarsest mesh:
  // the slope over a factor of eight is off by less than log(5/4)/log 8 = 0.11.
  // A share of order one of a fiftieth would bend it by as much.
  constexpr double kSlopeTolerance = 0.12;
  constexpr std::array kPieces{100, 200, 400, 800};
  const ReferenceValue& row = GetParam();
  std::array<double, 4> h{}, tau{}, end_angle{};

  for (std::size_t i = 0; i < h.size(); ++i) {
    const Solution solution = solve_on_pieces(row, kPieces[i]);
    ASSERT_TRUE(solution.verified()) << solution.message;
    h[i] = 1.0 / kPieces[i];
    tau[i] = std::abs(solution.motion()->tau() / row.tau - 1.0);
    end_angle[i] = std::abs(solution.motion()->end_angle() - row.end_angle);
    // Honest, and no wild guess: half as much again as its two parts, the one
    // that the end point is off by and the rest, if they had one sign. With
    // |D| h² below a quarter that is less than twice as much.
    const TrajectoryPoint end = solution.motion()->at(1.0);
    const double of_end = row.r / end.motion.v_c * end_angle[i] /
                          solution.motion()->transit_time();
    EXPECT_LE(tau[i], *solution.estimated_error) << kPieces[i];
    EXPECT_LE(*solution.estimated_error, 2.0 * (2.0 * of_end + tau[i]))
        << kPieces[i];
  }

  EXPECT_NEAR(observed_order(h, tau), 2.0, kSlopeTolerance)
      << tau[0] << ", " << tau[1] << ", " << tau[2] << ", " << tau[3];
  EXPECT_NEAR(observed_order(h, end_angle), 2.0, kSlopeTolerance)
      << end_angle[0] << ", " << end_angle[1] << ", " << end_angle[2] << ", "
      << end_angle[3];
}

TEST_P(ArcLengthOrder, HasAnHonestErrorAcrossALongStride) {
  // Of order two the change across a factor of 16 is 255 errors, of which the
  // estimate takes more than 1/80 as one: less than four of them.
  constexpr int kPieces = 40'000;
  const ReferenceValue& row = GetParam();

  const Solution solution = solve_on_pieces(row, kPieces);

  ASSERT_TRUE(solution.verified()) << solution.message;
  const std::vector<MeshRecord>& meshes = solution.effort.meshes;
  ASSERT_EQ(meshes[meshes.size() - 2].elements, kPieces / 16);
  const double error = std::abs(solution.motion()->tau() / row.tau - 1.0);
  const double end_angle =
      std::abs(solution.motion()->end_angle() - row.end_angle);
  const double of_end = row.r / solution.motion()->at(1.0).motion.v_c *
                        end_angle / solution.motion()->transit_time();
  EXPECT_LE(error, *solution.estimated_error);
  EXPECT_LE(*solution.estimated_error, 4.0 * (2.0 * of_end + error));
}

TEST(ArcLength, MeetsItsTolerance) {
  for (const char* name : {"reference_case", "theta_60", "uniform_L3"}) {
    for (const ReferenceValue& row : testing::kReferenceValues) {
      if (std::string_view(row.name) != name) continue;
      constexpr double kTolerance = 1e-7;
      SolveOptions options;
      Discretisation& mesh = options.use<Collocation>().discretisation;
      mesh.formulation = Formulation::ArcLength;
      mesh.tolerance = kTolerance;

      const Solution solution = solve(row.scene(), options);

      ASSERT_TRUE(solution.verified()) << row.name << ": " << solution.message;
      EXPECT_LE(*solution.estimated_error, kTolerance) << row.name;
      EXPECT_NEAR(solution.motion()->tau() / row.tau, 1.0,
                  *solution.estimated_error)
          << row.name;
    }
  }
}

TEST(ArcLength, HasASmoothMotionThroughItsNodes) {
  // The motion on the curve exceeds the least time by the square of the curve's
  // error, so that it tells the error of T: what is left are the ends, which
  // are off by T_φ Δφ, a tenth of it.
  const ReferenceValue& row = reference("theta_-30");

  const Solution solution = solve_on_pieces(row, 400);

  ASSERT_TRUE(solution.verified()) << solution.message;
  const double error = std::abs(solution.motion()->tau() / row.tau - 1.0);
  EXPECT_NEAR(
      answer_as<PiecewiseAnswer>(solution.answer)->motion.on_curve().tau() /
          row.tau,
      1.0, 0.1 * error);
  // κ_b and R_n are second derivatives of the curve: compared to collocation.
  const Solution smooth = solve(row.scene());
  ASSERT_TRUE(smooth.verified());
  EXPECT_NEAR(solution.diagnostics->max_normal_force.value,
              smooth.diagnostics->max_normal_force.value, 1e-2);
  EXPECT_NEAR(solution.diagnostics->max_curvature.value,
              smooth.diagnostics->max_curvature.value, 1e-2);
}

TEST(ArcLength, FindsNoLiftOffWhereThereIsNone) {
  // What collocation says of the same scene, or that the mesh does not tell. On
  // all of them R_n = 0 at the start itself.
  for (const ReferenceValue& row :
       {reference("bead_L3"), reference("uniform_L3"),
        reference("reference_case"), reference("theta_-30"),
        reference("theta_-90"), reference("theta_60"), reference("r_0.2"),
        reference("fast")}) {
    const Solution smooth = solve(row.scene());
    ASSERT_TRUE(smooth.verified()) << row.name;
    for (const int pieces : {20, 50, 100}) {
      const Solution solution = solve_on_pieces(row, pieces);
      if (!solution.verified()) continue;  // too coarse for its own checks
      EXPECT_TRUE(!solution.undecided_because().empty() ||
                  solution.feasible() == smooth.feasible())
          << row.name << ' ' << pieces;
      const PathDiagnostics& path = *solution.diagnostics;
      EXPECT_EQ(path.at_start.normal_force, 0.0);
      EXPECT_DOUBLE_EQ(solution.motion()->at(0.0).beta,
                       solution.motion()->start_angle());
      // An estimate, whose parts are of one order.
      constexpr double kParts = 3.0;
      EXPECT_NEAR(path.normal_force_after_rise.value,
                  smooth.diagnostics->normal_force_after_rise.value,
                  kParts * path.normal_force_error)
          << row.name << ' ' << pieces;
    }
  }
}

TEST(ArcLength, IsTheSameByMumpsAndByNewtonsMethod) {
  // Ipopt with MUMPS alone against Newton's method with another factorisation
  // on the conditions and the contact together: both reach the KKT tolerance of
  // 1e-12 and an open contact of 1e-12 rad.
  constexpr double kDifference = 1e-10;
  const ReferenceValue& row = reference("theta_-30");
  SolveOptions options;
  Discretisation& mesh = options.use<Collocation>().discretisation;
  mesh.formulation = Formulation::ArcLength;
  mesh.elements = 200;
  const Solution polished = solve(row.scene(), options);
  options.use<Collocation>().polish = false;

  const Solution plain = solve(row.scene(), options);

  ASSERT_TRUE(polished.verified()) << polished.message;
  ASSERT_TRUE(plain.verified()) << plain.message;
  EXPECT_EQ(plain.effort.meshes.back().newton_steps, 0);
  EXPECT_NEAR(plain.motion()->tau(), polished.motion()->tau(), kDifference);
  EXPECT_NEAR(plain.motion()->end_angle(), polished.motion()->end_angle(),
              kDifference);
}

TEST(ArcLength, EndsAtGivenPointsOfTheCentreToo) {
  // Free of A and B being points of a track: the bead's cycloid, whatever the
  // body, if its centre of mass lies on the axis.
  Scene scene = reference("uniform_L3").scene();
  scene.contact = Contact::Centre;
  SolveOptions options;
  Discretisation& mesh = options.use<Collocation>().discretisation;
  mesh.formulation = Formulation::ArcLength;
  mesh.elements = 200;
  const double expected =
      std::sqrt(1.0 + scene.body.k) * reference("bead_L3").tau;

  const Solution solution = solve(scene, options);

  ASSERT_TRUE(solution.verified()) << solution.message;
  EXPECT_NEAR(solution.motion()->tau() / expected, 1.0,
              *solution.estimated_error);
}

TEST(ArcLength, RefusesWhatItDoesNotHave) {
  SolveOptions options;
  Discretisation& mesh = options.use<Collocation>().discretisation;
  mesh.formulation = Formulation::ArcLength;
  mesh.degree = 2;

  EXPECT_THROW(static_cast<void>(solve(reference("bead_L3").scene(), options)),
               std::invalid_argument);
}

}  // namespace
}  // namespace brachisto
