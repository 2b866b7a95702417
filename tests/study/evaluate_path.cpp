// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/study/solve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "model/centre_curve.hpp"
#include "model/cycloid.hpp"

namespace brachisto {
namespace {

using Curve = GivenPath::Curve;
using Shape = GivenPath::Shape;

Scene reference_case(double eta_m = 2.0 / 3.0) {
  Scene scene;
  scene.body = Body::cylinder(1.0 / 3.0, eta_m, 0.0, 0.5);
  scene.L = 3.0;
  scene.H = 1.0;
  return scene;
}

Scene with_path(Scene scene, Curve curve, Shape shape) {
  auto path = std::make_shared<GivenPath>();
  path->curve = curve;
  path->shape = shape;
  scene.path = std::move(path);
  return scene;
}

TEST(EvaluatePath, KnowsTheCycloidOfTheUniformCylinder) {
  const Scene uniform = reference_case(0.0);
  const Solution solution =
      solve(with_path(uniform, Curve::Centre, Shape::Cycloid));

  ASSERT_TRUE(solution.verified()) << solution.message;
  // The optimum in closed form.
  const auto arc = axisymmetric_optimum(uniform);
  ASSERT_TRUE(arc);
  EXPECT_NEAR(solution.motion()->transit_time(),
              arc->rolling_time(uniform.gravity) * std::sqrt(1.5), 1e-12);
  EXPECT_NEAR(solution.motion()->end_angle(), arc->slope_angle(arc->psi_end),
              1e-12);
  EXPECT_TRUE(solution.feasible());
}

TEST(EvaluatePath, OfStandardCurvesIsSlowerThanTheExtremal) {
  const Scene scene = reference_case();
  const double extremal = solve(scene).motion()->tau();
  for (const Curve curve : {Curve::Centre, Curve::Track}) {
    for (const Shape shape :
         {Shape::Straight, Shape::Parabola, Shape::CircularArc}) {
      const Solution solution = solve(with_path(scene, curve, shape));
      if (solution.status == Status::Stalled) continue;
      ASSERT_TRUE(solution.verified()) << solution.message;
      EXPECT_GT(solution.motion()->tau(), extremal);
    }
  }
}

TEST(EvaluatePath, OnAnInclineTheGripNeededIsTheSameAllTheWay) {
  // A uniform cylinder on a slope β: R_n = cos β, R_t = k/(1 + k) sin β.
  const Solution solution =
      solve(with_path(reference_case(0.0), Curve::Track, Shape::Straight));

  ASSERT_TRUE(solution.verified()) << solution.message;
  for (const LeastGrip& grip : solution.diagnostics->least_grip) {
    EXPECT_NEAR(grip.mu, (0.5 / 1.5) * (1.0 / 3.0), 1e-12)
        << grip.share_of_time;
  }
}

TEST(EvaluatePath, WithoutInertiaABodyOnItsAxisNeedsNoGrip) {
  Scene scene = reference_case(0.0);
  scene.body.k = 0.0;
  const Solution solution = solve(scene);

  ASSERT_TRUE(solution.verified()) << solution.message;
  for (const LeastGrip& grip : solution.diagnostics->least_grip) {
    EXPECT_NEAR(grip.mu, 0.0, 1e-9) << grip.share_of_time;
  }
}

TEST(EvaluatePath, TouchesTheTrackAtBothEnds) {
  for (const Shape shape :
       {Shape::Straight, Shape::Parabola, Shape::CircularArc, Shape::Cycloid}) {
    const Solution solution =
        solve(with_path(reference_case(), Curve::Centre, shape));
    ASSERT_EQ(solution.status, Status::Solved) << solution.message;
    const Check* contact = solution.certificate.find("contact_error");
    ASSERT_NE(contact, nullptr);
    EXPECT_LE(contact->value, 1e-13);
  }
}

TEST(EvaluatePath, FindsTheExtremalAgainFromItsPoints) {
  const Scene scene = reference_case();
  const Solution extremal = solve(scene);
  ASSERT_TRUE(extremal.verified());
  double before = 1.0;
  for (const int n : {100, 400}) {
    auto path = std::make_shared<GivenPath>();
    path->curve = Curve::Track;
    path->shape = Shape::Points;
    for (int i = 0; i <= n; ++i) {
      path->points.push_back(
          extremal.motion()->at(static_cast<double>(i) / n).motion.contact);
    }
    Scene given = scene;
    given.path = path;
    const Solution again = solve(given);
    ASSERT_NE(again.motion(), nullptr) << again.message;
    // Of a stationary T an error of the path shows in second order, but for
    // the ends, where the curvature of the track is known to first order only.
    const double excess =
        again.motion()->tau() / extremal.motion()->tau() - 1.0;
    EXPECT_LT(std::abs(excess), 0.5 * before);
    before = std::abs(excess);
  }
  EXPECT_LT(before, 1e-4);
}

TEST(EvaluatePath, NamesAPathOnWhichTheBodyStalls) {
  // The cusp of a cycloid is narrower than any cylinder.
  const Solution solution =
      solve(with_path(reference_case(), Curve::Track, Shape::Cycloid));

  EXPECT_EQ(solution.status, Status::Stalled);
  EXPECT_FALSE(solution.verified());
  EXPECT_EQ(solution.motion(), nullptr);
  EXPECT_NE(solution.message.find("does not fit"), std::string::npos);
}

TEST(EvaluatePath, NamesAPathThatDoesNotExist) {
  Scene scene = with_path(reference_case(0.0), Curve::Centre, Shape::Cycloid);
  scene.L = 0.4;
  scene.H = 0.1;
  const Solution solution = solve(scene);

  EXPECT_EQ(solution.status, Status::NoAdmissiblePath);
  EXPECT_FALSE(solution.message.empty());
}

}  // namespace
}  // namespace brachisto
