// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// A ball on rails: against cylinders that are known, an incline in closed form
// and whole solves of other balls.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

#include "brachisto/study/solve.hpp"
#include "model/cycloid.hpp"
#include "support/limited_scenes.hpp"
#include "support/newton_euler.hpp"
#include "support/scenes.hpp"
#include "support/verified.hpp"

namespace brachisto {
namespace {

using namespace testing;

/// R = 0.5 m on rails 0.6 m apart: r_e = 0.4 m.
Ball the_ball(double eta_m = 0.0) {
  return {.radius = 0.5, .eta_m = eta_m, .k = 0.4, .gauge = 0.6};
}
constexpr double kRadius = 0.4, kRatio = 1.25;

Scene with_ball(const Ball& ball, double theta_m = 0.2) {
  return scene_of(Body::rolling_ball(ball, theta_m));
}

double tau_of(const Scene& scene) {
  const Solution solution = verified(scene);
  return solution.verified() ? solution.motion()->tau() : std::nan("");
}

/// Sums of some hundred positive terms, each rounded.
constexpr double kOfRounding = 1e-13;

/// Without an offset the path does not depend on k, and √(1 + k) is a factor of
/// the time.
TEST(BallFromRest, TakesTheTimeOfTheCylinderBySquareRootsOfInertia) {
  for (const double gauge : {0.3, 0.6, 0.9}) {
    Ball ball = the_ball();
    ball.gauge = gauge;
    const double r = std::sqrt(0.25 - 0.25 * gauge * gauge);
    const double k_e = 0.4 * 0.25 / (r * r);
    const double times = std::sqrt((1.0 + k_e) / 1.4);

    const double of_cylinder =
        tau_of(scene_of(Body::cylinder(r, 0.0, 0.0, 0.4)));

    EXPECT_NEAR(tau_of(with_ball(ball)) / (of_cylinder * times), 1.0,
                kOfRounding);
  }
}

/// And that is a cycloid's.
TEST(BallFromRest, FollowsTheCycloid) {
  const Scene scene = with_ball(the_ball());
  const auto arc =
      axisymmetric_optimum(scene_of(Body::cylinder(kRadius, 0.0, 0.0, 0.4)));
  ASSERT_TRUE(arc);

  EXPECT_NEAR(
      tau_of(scene),
      arc->rolling_time(scene.gravity) *
          std::sqrt((1.0 + 0.4 * kRatio * kRatio) * 2.0 * scene.gravity),
      1e-11);
}

/// η R/r_e, k (R/r_e)², μ R/r_e and c R/r_e, and a floor that is lower by as
/// much as the ball reaches lower.
TEST(BallUnderLimits, IsTheCylinderThatIsRescaledByHand) {
  PathLimits limits;
  limits.friction = 0.8;
  limits.normal_min = 0.02;
  limits.normal_max = 3.0;
  limits.floor = 1.3;
  Scene of_ball = with_ball(the_ball(0.3));
  of_ball.world.losses.rolling = 0.01;
  of_ball.limits = limits;
  Scene of_cylinder = scene_of(
      Body::cylinder(kRadius, 0.3 * kRatio, 0.2, 0.4 * kRatio * kRatio));
  of_cylinder.world.losses.rolling = 0.01 * kRatio;
  of_cylinder.limits = limits;
  of_cylinder.limits.friction = 0.8 * kRatio;
  of_cylinder.limits.floor = 1.3 - (0.5 - kRadius);

  const Solution ball = verified(of_ball), cylinder = verified(of_cylinder);
  ASSERT_TRUE(ball.verified() && cylinder.verified());

  EXPECT_NEAR(ball.motion()->tau() / cylinder.motion()->tau(), 1.0,
              kOfRounding);
  // What is told of friction is told of the walls.
  for (std::size_t i = 0; i < ball.diagnostics->least_grip.size(); ++i) {
    const double mu = cylinder.diagnostics->least_grip[i].mu / kRatio;
    EXPECT_NEAR(ball.diagnostics->least_grip[i].mu, mu, 1e-9 * mu);
  }
  ASSERT_EQ(ball.limits.size(), cylinder.limits.size());
  for (std::size_t i = 0; i < ball.limits.size(); ++i) {
    SCOPED_TRACE(ball.limits[i].name);
    const double times = ball.limits[i].name == "friction" ? kRatio : 1.0;
    EXPECT_EQ(ball.limits[i].active.size(), cylinder.limits[i].active.size());
    EXPECT_NEAR(ball.limits[i].price.value(),
                times * cylinder.limits[i].price.value(), 1e-7);
  }
  EXPECT_LE(left_over(*ball.motion(), rigid_body_of(of_cylinder)).largest(),
            allowed_along(ball));
}

/// S = ½ v̇ T², v̇ = g (sin α − c (R/r_e) cos α)/(1 + k (R/r_e)²).
TEST(BallOnAnIncline, TakesTheTimeOfTheClosedForm) {
  Scene scene = with_ball(the_ball());
  scene.world.losses.rolling = 0.05;
  scene.contact = Contact::Centre;
  auto path = std::make_shared<GivenPath>();
  path->shape = GivenPath::Shape::Straight;
  scene.path = std::move(path);
  const double S = std::hypot(scene.L, scene.H);
  const double v_dot = scene.gravity * (scene.H - 0.05 * kRatio * scene.L) / S /
                       (1.0 + 0.4 * kRatio * kRatio);

  const Solution solution = verified(scene);

  EXPECT_NEAR(solution.motion()->transit_time() / std::sqrt(2.0 * S / v_dot),
              1.0, 1e-12);
}

/// By the numbers of the ball itself, the gauge being what it is.
class SensitivitiesOfABall : public ::testing::TestWithParam<double> {};

TEST_P(SensitivitiesOfABall, AreThoseOfWholeSolves) {
  SolveOptions options;
  options.use<Collocation>().sensitivities = SensitivityOrder::First;
  const Ball here = the_ball(GetParam());
  const Solution solution = verified(with_ball(here), options);
  ASSERT_TRUE(solution.sensitivities);
  const auto slope = [&](const std::function<void(Ball&, double)>& change) {
    constexpr double kStep = 1e-3;
    const auto at = [&](double by) {
      Ball ball = here;
      change(ball, by);
      // An offset the other way is one of half a turn more.
      const double turn = ball.eta_m < 0.0 ? std::numbers::pi : 0.0;
      ball.eta_m = std::abs(ball.eta_m);
      Scene scene = with_ball(ball);
      scene.body.theta_m += turn;
      return tau_of(scene);
    };
    return (8.0 * (at(kStep) - at(-kStep)) -
            (at(2.0 * kStep) - at(-2.0 * kStep))) /
           (12.0 * kStep);
  };
  const auto& rates = solution.sensitivities->by;

  EXPECT_NEAR(rates[SceneParameter::Radius].tau,
              slope([](Ball& ball, double by) { ball.radius += by; }), 1e-6);
  EXPECT_NEAR(rates[SceneParameter::K].tau,
              slope([](Ball& ball, double by) { ball.k += by; }), 1e-6);
  EXPECT_NEAR(rates[SceneParameter::EtaM].tau,
              slope([](Ball& ball, double by) { ball.eta_m += by; }), 1e-6);
}
INSTANTIATE_TEST_SUITE_P(OfOffsets, SensitivitiesOfABall,
                         ::testing::Values(0.0, 0.3));

}  // namespace
}  // namespace brachisto
