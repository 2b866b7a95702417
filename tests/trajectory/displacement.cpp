// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What a displaced stretch costs, against whole evaluations of displaced paths,
// closed forms and what optimality says.

#include "trajectory/displacement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "brachisto/math/polynomial_basis.hpp"
#include "brachisto/study/solve.hpp"
#include "model/plane_curve.hpp"
#include "support/scenes.hpp"
#include "support/verified.hpp"
#include "support/world_scenes.hpp"
#include "trajectory/prescribed_motion.hpp"

namespace brachisto::testing {
namespace {

constexpr int kStretches = 5;

Scene with_friction(Scene scene, double mu) {
  scene.limits.friction = mu;
  return scene;
}

/// T on the path of the centre of a motion displaced by ε(s) between two
/// lengths, as a curve through many of its points.
double time_on_displaced(const Motion& motion, double from, double to,
                         double height) {
  constexpr int kPoints = 1000;
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  const Point start = motion.at(0.0).centre;
  const double beta = motion.start_angle();
  std::vector<double> q;
  std::vector<Point> offsets;
  for (int i = 1; i <= kPoints; ++i) {
    q.push_back(static_cast<double>(i) / kPoints);
    const TrajectoryPoint at = motion.at(q.back());
    const double x = (at.s - middle) / half;
    const double epsilon =
        std::abs(x) < 1.0 ? height * std::pow(1.0 - x * x, 3) : 0.0;
    offsets.push_back({at.centre.x - start.x - epsilon * std::sin(at.beta),
                       at.centre.z - start.z + epsilon * std::cos(at.beta)});
  }
  const Scene& scene = motion.scene();
  if (scene.world.start_speed > 0.0) {
    std::vector<Point> points{start};
    for (const Point p : offsets) {
      points.push_back({start.x + p.x, start.z + p.z});
    }
    return PrescribedMotion(scene, spline_through(points)).transit_time();
  }
  const double first = motion.at(q.front()).s / (q.front() * q.front());
  const Point at_start{first * std::cos(beta), first * std::sin(beta)};
  return PrescribedMotion(scene,
                          curve_from_rest(start, {at_start, {}}, q, offsets))
      .transit_time();
}

/// Of all stretches to 1 %.
void expect_as_whole_evaluations(const Motion& motion) {
  const double height = 1e-3 * motion.scene().H;
  const auto stretches = displaced_stretches(motion, kStretches, height);
  ASSERT_EQ(stretches.size(), static_cast<std::size_t>(kStretches));
  const double as_it_is =
      time_on_displaced(motion, 0.0, motion.centre_path_length(), 0.0);
  for (const DisplacedStretch& stretch : stretches) {
    const double from = stretch.from.s, to = stretch.to.s;
    // n = dt/dβ points downwards.
    const double lowered =
        time_on_displaced(motion, from, to, height) - as_it_is;
    const double raised =
        time_on_displaced(motion, from, to, -height) - as_it_is;
    EXPECT_NEAR(stretch.lowered / lowered, 1.0, 0.01) << from << " " << lowered;
    EXPECT_NEAR(stretch.raised / raised, 1.0, 0.01) << from << " " << raised;
  }
}

TEST(Displacement, AgreesWithWholeEvaluationsOfTheDisplacedPaths) {
  for (const Scene& scene :
       {bead_scene(), uniform_scene(), off_centred_scene(0.3),
        with_push(off_centred_scene(0.3), 2.0)}) {
    expect_as_whole_evaluations(*verified(scene).motion());
  }
}

TEST(Displacement, AgreesWithThemUnderLimits) {
  Scene pressed = with_friction(uniform_scene(), 0.4);
  pressed.limits.normal_min = 0.2;
  for (const Scene& scene :
       {with_friction(uniform_scene(), 0.5),
        with_friction(off_centred_scene(), 1.0), pressed,
        with_friction(in_air(uniform_scene(), 0.1, 0.05), 0.5)}) {
    expect_as_whole_evaluations(*verified(scene).motion());
  }
}

TEST(Displacement, AgreesWithThemInAir) {
  for (const Scene& scene :
       {in_air(bead_scene(), 0.0, 0.3), in_air(uniform_scene(), 0.5, 0.0),
        in_air(off_centred_scene(0.3), 0.1, 0.05),
        with_push(in_air(off_centred_scene(0.3), 0.1, 0.05), 2.0)}) {
    expect_as_whole_evaluations(*verified(scene).motion());
  }
}

TEST(Displacement, AgreesWithThemInTheFieldOfASphere) {
  for (const Scene& scene :
       {about_sphere(bead_scene(), below()),
        about_sphere(off_centred_scene(0.3), around()),
        about_sphere(uniform_scene(), in_the_way()),
        in_air(about_sphere(off_centred_scene(0.3), around()), 0.1, 0.05)}) {
    expect_as_whole_evaluations(*verified(scene).motion());
  }
}

TEST(Displacement, AgreesWithThemInAirAsThickAsOil) {
  // The speed follows the slope at once: in each of the panels the drag alone
  // would stop the body many times over.
  Scene scene = with_push(in_air(bead_scene(), 50.0, 0.0), 0.1);
  scene.contact = Contact::Centre;
  expect_as_whole_evaluations(
      PrescribedMotion(scene, straight_line({0.0, 0.0}, {scene.L, scene.H})));
}

TEST(Displacement, OfAnExtremalIsOfTheSecondOrder) {
  // ΔT is 0 of the first order between fixed ends, and positive of the second
  // on a minimum. What is odd in e falls as e³.
  for (const Scene& scene :
       {bead_scene(), uniform_scene(), off_centred_scene(0.3),
        in_air(uniform_scene(), 0.5, 0.0),
        in_air(off_centred_scene(0.3), 0.1, 0.05),
        about_sphere(off_centred_scene(0.3), around())}) {
    const Solution solution = verified(scene);
    const Motion& motion = *solution.motion();
    const double height = 1e-3 * scene.H;
    const auto once = displaced_stretches(motion, kStretches, height);
    const auto half = displaced_stretches(motion, kStretches, 0.5 * height);
    for (std::size_t i = 0; i < once.size(); ++i) {
      EXPECT_GT(once[i].raised, 0.0);
      EXPECT_GT(once[i].lowered, 0.0);
      // Of the next even order: relative (e/w)², with w 150 e or more and
      // factors of ε' up to 6: less than 1 %.
      EXPECT_NEAR((once[i].raised + once[i].lowered) /
                      (half[i].raised + half[i].lowered),
                  4.0, 0.04)
          << i;
      EXPECT_LT(std::abs(once[i].raised - once[i].lowered),
                0.1 * (once[i].raised + once[i].lowered))
          << i;
    }
  }
}

TEST(Displacement, OfABeadOnAnInclineIsInClosedForm) {
  // T = ∫ ds/√(2 g z): dT/de = −½ cos φ ∫ (1 − x²)³ ds/(z √(2 g z)) for a
  // displacement downwards, z = s sin φ.
  Scene scene = bead_scene();
  scene.contact = Contact::Centre;
  const PrescribedMotion motion(scene,
                                straight_line({0.0, 0.0}, {scene.L, scene.H}));
  const double length = std::hypot(scene.L, scene.H);
  const double sine = scene.H / length, cosine = scene.L / length;
  const math::QuadratureRule rule = math::gauss_legendre(60);
  const double height = 1e-6 * scene.H;
  for (const DisplacedStretch& stretch :
       displaced_stretches(motion, kStretches, height)) {
    // In √s the first one is smooth too.
    const double middle = 0.5 * (stretch.from.s + stretch.to.s);
    const double half = stretch.to.s - middle;
    const double p = std::sqrt(stretch.from.s), q = std::sqrt(stretch.to.s);
    double sum = 0.0;
    for (std::size_t i = 0; i < rule.points.size(); ++i) {
      const double root = p + rule.points[i] * (q - p);
      const double s = root * root, x = (s - middle) / half, z = s * sine;
      sum += rule.weights[i] * (q - p) * 2.0 * root * std::pow(1.0 - x * x, 3) /
             (z * std::sqrt(2.0 * scene.gravity * z));
    }
    const double slope = -0.5 * cosine * sum;
    // Of the second order e/z relative, and the panels' rule of third order on
    // forty panels.
    EXPECT_NEAR(stretch.lowered / (height * slope), 1.0, 1e-3);
    EXPECT_NEAR(stretch.raised / (-height * slope), 1.0, 1e-3);
  }
  EXPECT_NEAR(length, motion.centre_path_length(), 1e-12 * length);
}

TEST(Displacement, ThatABodyDoesNotGetOverIsInfinite) {
  // Raised by more than it has fallen.
  Scene scene = bead_scene();
  scene.contact = Contact::Centre;
  const PrescribedMotion motion(scene,
                                straight_line({0.0, 0.0}, {scene.L, scene.H}));
  const auto first = displaced_stretches(motion, kStretches, scene.H).front();
  EXPECT_TRUE(std::isinf(first.raised));
  EXPECT_TRUE(std::isfinite(first.lowered));
}

}  // namespace
}  // namespace brachisto::testing
