// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/time_sensitivity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <ostream>
#include <string>

#include "model/centre_curve.hpp"
#include "support/world_scenes.hpp"

namespace brachisto {
namespace {

using namespace testing;

Scene on_curve(Scene scene, GivenPath::Shape shape) {
  auto path = std::make_shared<GivenPath>();
  path->curve = GivenPath::Curve::Centre;
  path->shape = shape;
  scene.path = std::move(path);
  scene.contact = Contact::Centre;
  return scene;
}

/// By loss and by k at q, of t = √(2 s (1 + k)/(g (sin β − c cos β))).
TEST(TimeSensitivity, IsThatOfTheClosedFormOnAnIncline) {
  Scene scene = on_curve(uniform_scene(), GivenPath::Shape::Straight);
  for (const double c : {0.0, 0.02, 0.2}) {
    scene.world.losses.rolling = c;
    const PrescribedMotion motion(scene, centre_curve(scene));
    ASSERT_FALSE(motion.stall());
    const TimeSensitivity sensitivity(motion);
    const double slope = std::atan2(scene.H, scene.L);
    const double pull = std::sin(slope) - c * std::cos(slope);
    for (const double q : {1e-3, 0.1, 0.5, 0.77, 1.0}) {
      const double s = motion.at(q).s;
      const double t =
          std::sqrt(2.0 * s * (1.0 + scene.body.k) / (scene.gravity * pull));

      const SensitiveTime found = sensitivity.at(q);

      // Tens of additions of terms of one sign.
      constexpr double kRounding = 1e-13;
      EXPECT_NEAR(found.t, t, kRounding * t);
      EXPECT_NEAR(found.by[0], 0.5 * t * std::cos(slope) / pull,
                  kRounding * t / pull);
      EXPECT_NEAR(found.by[1], 0.5 * t / (1.0 + scene.body.k), kRounding * t);
    }
  }
  EXPECT_EQ(TimeSensitivity(PrescribedMotion(scene, centre_curve(scene)))
                .at(0.0)
                .by[0],
            0.0);
}

struct World {
  std::string name;
  std::function<Scene(Scene)> of;
};
std::ostream& operator<<(std::ostream& out, const World& world) {
  return out << world.name;
}

class TimeSensitivityIn : public ::testing::TestWithParam<World> {};

/// Central differences of whole motions, whose error falls as the square of
/// the step until that of the motions, 1e-13 over the step, is left.
TEST_P(TimeSensitivityIn, IsWhatDifferencesTendTo) {
  for (const double eta : {0.0, 0.4}) {
    for (const auto shape :
         {GivenPath::Shape::Parabola, GivenPath::Shape::Cycloid}) {
      Scene scene = uniform_scene();
      scene.body.eta_m = eta;
      scene.body.theta_m = 0.3;
      scene = GetParam().of(on_curve(scene, shape));
      scene.world.losses.rolling = 0.02;
      const auto motion_of = [](const Scene& of) {
        return PrescribedMotion(of, centre_curve(of));
      };
      const PrescribedMotion motion = motion_of(scene);
      ASSERT_FALSE(motion.stall());
      const TimeSensitivity sensitivity(motion);
      const std::function<double&(Scene&)> numbers[] = {
          [](Scene& of) -> double& { return of.world.losses.rolling; },
          [](Scene& of) -> double& { return of.body.k; }};
      for (std::size_t p = 0; p < kMotionNumbers; ++p) {
        for (const double q : {0.2, 0.61, 1.0}) {
          const auto difference = [&](double step) {
            Scene more = scene, less = scene;
            numbers[p](more) += step;
            numbers[p](less) -= step;
            return (motion_of(more).at(q).t - motion_of(less).at(q).t) /
                   (2.0 * step);
          };
          const double exact = sensitivity.at(q).by[p];
          // Of the fourth order by Richardson.
          constexpr double kStep = 4e-3;
          const double best =
              (4.0 * difference(0.5 * kStep) - difference(kStep)) / 3.0;
          const double coarse = std::abs(difference(kStep) - exact);

          EXPECT_NEAR(best, exact, 1e-9 + 1e-2 * coarse) << p << " at " << q;
          EXPECT_NEAR(coarse / std::abs(difference(0.5 * kStep) - exact), 4.0,
                      0.1);
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Worlds, TimeSensitivityIn,
    ::testing::Values(
        World{"at_rest", [](const Scene& s) { return s; }},
        World{"pushed", [](const Scene& s) { return with_push(s, 1.0); }},
        World{"in_air", [](const Scene& s) { return in_air(s, 0.1, 0.05); }},
        World{"about_a_sphere",
              [](const Scene& s) { return about_sphere(s, around()); }}),
    [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace brachisto
