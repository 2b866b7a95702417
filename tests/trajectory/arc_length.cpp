// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The certificate of an arc_length solution, and that it finds what is wrong.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "model/units.hpp"
#include "solvers/newton_solver.hpp"
#include "support/scenes.hpp"
#include "support/solved_problem.hpp"
#include "trajectory/arc_length_motion.hpp"
#include "trajectory/certify.hpp"
#include "trajectory/extended_residual.hpp"
#include "transcription/contact_equation.hpp"
#include "transcription/prolongation.hpp"

namespace brachisto::testing {
namespace {

constexpr int kPieces = 200;
// Relative error of T at N = 200: 9.1e-6; its estimate.
constexpr double kErrorOfPieces = 1.4e-5;

/// A solution with its contact closed, from an end angle next to it.
struct ArcCase {
  Scene scene = off_centred_scene(-kPi / 6.0);
  ArcLength problem{in_natural_units(scene), kPieces, -0.086};
  PrimalDual point;
  double phi = 0.0;

  ArcCase() {
    const SolvedProblem smooth =
        solved(problem.scene(), uniform_mesh(5, 16), -0.086);
    const ExtremalCurve curve(smooth.problem, smooth.point);
    ContactEquation contact(problem);
    NewtonOptions options;
    options.to_rounding = true;
    const NewtonResult result =
        NewtonSolver(problem, &contact)
            .solve(prolong(curve, problem), -0.086, options);
    point = result.point;
    phi = result.phi;
  }
  [[nodiscard]] Certificate certificate(double error = kErrorOfPieces) {
    EXPECT_TRUE(problem.set_point(point.x));
    const ArcLengthMotion motion(problem, point.x, problem.eval_f(), phi, scene,
                                 natural_units(scene));
    return certify(problem, point, phi, motion, error);
  }
  /// Names of the checks that fail.
  [[nodiscard]] std::vector<std::string> failed(double error = kErrorOfPieces) {
    std::vector<std::string> names;
    for (const Check& check : certificate(error).checks) {
      if (!check.passed) names.push_back(check.name);
    }
    return names;
  }
};

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

TEST(ArcLengthCertificate, VerifiesASolution) {
  ArcCase solution;

  EXPECT_EQ(solution.failed(), std::vector<std::string>{});
}

TEST(ArcLengthCertificate, FindsWrongMultipliers) {
  ArcCase solution;
  for (double& lambda : solution.point.lambda) lambda *= 1.0 + 1e-6;

  EXPECT_TRUE(contains(solution.failed(), "kkt_residual"));
}

TEST(ArcLengthCertificate, FindsABentPiece) {
  ArcCase solution;
  solution.point.x[static_cast<std::size_t>(
      solution.problem.layout().state(kPieces / 2, StateComponent::Z))] += 1e-6;

  const std::vector<std::string> failed = solution.failed();

  EXPECT_TRUE(contains(failed, "defects"));
  EXPECT_TRUE(contains(failed, "kkt_residual"));
}

TEST(ArcLengthCertificate, FindsAnOpenContact) {
  ArcCase solution;
  solution.phi += 1e-6;

  EXPECT_TRUE(contains(solution.failed(), "closure"));
}

TEST(ArcLengthCertificate, FindsAnErrorThatIsClaimedTooSmall) {
  ArcCase solution;

  EXPECT_TRUE(contains(solution.failed(1e-7), "reintegrated_time"));
}

TEST(ArcLengthResidual, IsTheProblemsOwnButForRounding) {
  ArcCase solution;
  solution.point.x[static_cast<std::size_t>(
      solution.problem.layout().state(kPieces / 3, StateComponent::X))] += 1e-3;
  ASSERT_TRUE(solution.problem.set_point(solution.point.x));
  std::vector<double> g(solution.point.lambda.size());
  solution.problem.eval_g(g);
  double defect = 0.0;
  for (const double value : g) defect = std::max(defect, std::abs(value));

  const ExtendedResidual other =
      extended_residual(solution.problem, solution.point);

  EXPECT_NEAR(other.defects, defect, 1e-12 * defect);
}

}  // namespace
}  // namespace brachisto::testing
