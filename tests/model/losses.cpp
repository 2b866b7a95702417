// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Losses at a point of a path, against Newton's and Euler's laws for the body
// and the moment or the friction that the load brings about.

#include "model/losses.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>
#include <string>

#include "brachisto/math/jet.hpp"
#include "brachisto/model/kinematics.hpp"
#include "model/contact.hpp"
#include "model/moving.hpp"
#include "model/path_inequality.hpp"
#include "model/start_angle.hpp"
#include "support/world_scenes.hpp"

namespace brachisto {
namespace {

using namespace testing;

constexpr int kPoints = 200;
/// Of sums of a dozen terms of order one to a hundred.
constexpr double kForceRounding = 1e-12;

/// v̇, R_n and R_t by the laws alone: forces on the centre of mass along and
/// across the track, and moments about it. With t along the motion and n from
/// the track,
///
///     x_cm = c + r_m e(θ),  r θ̇ = v,  m ẍ_cm = m G + R_n n + R_t t − m D t,
///     I θ̈ = (x_b − x_cm) × (R_n n + R_t t) + (c − x_cm) × (−m D t) − c r R_n,
///
/// and of a bead R_t = −μ R_n.
struct Laws {
  double v_dot, R_n, R_t;  ///< forces per mass
};
Laws by_laws(const Scene& scene, const Moving& at) {
  using Vector = Eigen::Vector2d;
  const Body& body = scene.body;
  const auto cross = [](const Vector& a, const Vector& b) {
    return a.x() * b.y() - a.y() * b.x();
  };
  const Vector t(std::cos(at.beta), std::sin(at.beta));
  const Vector n(std::sin(at.beta), -std::cos(at.beta));
  const Vector e(std::cos(at.theta), std::sin(at.theta));
  const Vector e_turned(-e.y(), e.x());
  const double r = body.radius, r_m = r * body.eta_m;
  const double omega = body.rolls() ? at.v / r : 0.0;
  const double per_r = body.rolls() ? 1.0 / r : 0.0;
  const double D =
      scene.world.air.linear * at.v + scene.world.air.quadratic * at.v * at.v;
  const Losses& lost = scene.world.losses;
  // ẍ_cm = v̇ (t + η e⊥) + v β̇ (−n) − r_m ω² e.
  const Vector by_v_dot = t + r_m * per_r * e_turned;
  const Vector rest = -at.v * at.turning * n - r_m * omega * omega * e -
                      Vector(0.0, scene.gravity) + D * t;
  Eigen::Matrix3d matrix;
  Eigen::Vector3d right;
  matrix.row(0) << by_v_dot.dot(t), 0.0, -1.0;
  matrix.row(1) << by_v_dot.dot(n), -1.0, 0.0;
  right[0] = -rest.dot(t);
  right[1] = -rest.dot(n);
  if (body.rolls()) {
    const Vector arm = -r * n - r_m * e;  // x_b − x_cm
    matrix.row(2) << body.k * r * r * per_r,
        -(cross(arm, n) - lost.rolling * r), -cross(arm, t);
    right[2] = cross(-r_m * e, -D * t);
  } else {
    matrix.row(2) << 0.0, lost.sliding, 1.0;
    right[2] = 0.0;
  }
  const Eigen::Vector3d found = matrix.partialPivLu().solve(right);
  return {found[0], found[1], found[2]};
}

class LossesOf : public ::testing::TestWithParam<const char*> {
 protected:
  [[nodiscard]] Scene next() {
    const std::string kind = GetParam();
    Scene scene = bead_scene();
    if (kind == "bead") {
      scene.world.losses.sliding = in(0.0, 0.8);
    } else {
      const double eta = kind == "uniform" ? 0.0 : in(0.05, 0.9);
      scene.body = Body::cylinder(in(0.1, 1.0), eta, in(-1.0, 1.0),
                                  in(0.05, 1.0) * (1.0 - eta * eta));
      scene.world.losses.rolling = in(0.0, 0.2);
    }
    scene.world.air = {in(0.0, 0.3), in(0.0, 0.3)};
    return scene;
  }
  [[nodiscard]] Moving place() {
    return {in(-9.0, 9.0), in(-3.0, 3.0), in(0.2, 6.0), in(-8.0, 8.0)};
  }

 private:
  double in(double from, double to) {
    return std::uniform_real_distribution<>(from, to)(random_);
  }
  std::mt19937 random_{20261125};
};

TEST_P(LossesOf, LeaveTheForcesThatTheLawsHave) {
  for (int i = 0; i < kPoints; ++i) {
    const Scene scene = next();
    const Moving at = place();
    const TurningPoint<double> state = state_of(scene, at);
    const double g = scene.gravity;

    const Laws laws = by_laws(scene, at);
    const ContactForce<double> force = contact_force(scene, state);
    const Kinematics motion = kinematics(
        scene, {{0.0, 0.0}, state.theta, state.beta, state.w, state.q});

    const double scale = 1.0 + std::abs(laws.R_n) + std::abs(laws.R_t);
    EXPECT_NEAR(motion.v_c, at.v, kForceRounding * at.v);
    EXPECT_NEAR(g * force.normal, laws.R_n, kForceRounding * scale);
    EXPECT_NEAR(g * force.tangential, laws.R_t, kForceRounding * scale);
    EXPECT_NEAR(g * motion.R_n, laws.R_n, kForceRounding * scale);
    EXPECT_NEAR(g * motion.R_t, laws.R_t, kForceRounding * scale);
  }
}

/// v̇ by the rate of the state, which turning has no part in, and by v = W/√A*,
/// in which all of turning is.
TEST_P(LossesOf, SlowAsTheLawsHaveItHoweverTheSlopeTurns) {
  using On = math::Jet1<double, 1>;
  for (int i = 0; i < kPoints; ++i) {
    const Scene scene = next();
    const Moving at = place();
    const TurningPoint<double> state = state_of(scene, at);
    const double spin = scene.body.rolls() ? at.v / scene.body.radius : 0.0;

    const double root = root_of_inertia(scene, at.theta, at.beta);
    const On time = On::variable(0.0, 0);
    const double root_dot = root_of_inertia(scene, On(at.theta) + time * spin,
                                            On(at.beta) + time * at.turning)
                                .gradient[0];
    const double W_dot = speed_gain(scene, state) / root;
    const double v_dot = (W_dot - at.v * root_dot) / root;

    const Laws laws = by_laws(scene, at);
    EXPECT_NEAR(
        v_dot, laws.v_dot,
        kForceRounding * (1.0 + std::abs(laws.v_dot) + std::abs(laws.R_n)));
  }
}

INSTANTIATE_TEST_SUITE_P(Bodies, LossesOf,
                         ::testing::Values("bead", "uniform", "off_centred"),
                         [](const auto& row) { return row.param; });

TEST(Losses, OfNothingLeaveAnOffCentredBodyItsInertia) {
  const Body body = Body::cylinder(1.0 / 3.0, 2.0 / 3.0, 0.0, 0.5);

  const double without = std::sqrt(inertia_factor(body, 0.3, 1.1));

  EXPECT_NEAR(losses::root_of_inertia(body, 1e-9, 0.3, 1.1), without, 1e-8);
}

/// However often it has turned: with a whole turn of θ nothing changes.
TEST(Losses, LeaveTheStateOfAScaleThatRotationDoesNotChange) {
  const Body body = Body::cylinder(0.005, 2.0 / 3.0, 0.0, 0.5);

  const double before = losses::root_of_inertia(body, 0.2, 0.3, 1.1);
  const double after =
      losses::root_of_inertia(body, 0.2, 0.3 + 200.0 * kPi, 1.1);

  EXPECT_NEAR(after, before, 1e-12);
}

/// tan β₀ = −(1 + γ c)/(c − γ), γ = c/(1 + k), of an axisymmetric cylinder that
/// no limit keeps on its track: the root of d/dβ e^{−γβ} (sin β − c cos β).
TEST(Losses, TurnTheStartBeyondTheVerticalWhereTheLoadMayPull) {
  constexpr double c = 0.1, gamma = c / 1.5;
  Scene scene = uniform_scene();
  scene.world.losses.rolling = c;

  EXPECT_NEAR(start_angle(scene), std::atan2(1.0 + gamma * c, gamma - c),
              1e-14);
}

}  // namespace
}  // namespace brachisto
