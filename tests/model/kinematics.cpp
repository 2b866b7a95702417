// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/model/kinematics.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "model/energy.hpp"
#include "model/inertia.hpp"
#include "model/start_angle.hpp"
#include "support/random_points.hpp"
#include "support/rounding.hpp"
#include "support/scenes.hpp"

namespace brachisto::testing {
namespace {

struct WideVector {
  Wide x, z;
};

/// A body on a circular path of its centre, in fifty digits and in time: what
/// the equations under test are not written in. Conservation of energy gives
/// the speed; the rest is differentiation.
class CircularMotion {
 public:
  CircularMotion(const Body& body, double gravity, const PathState& state)
      : body_(body), gravity_(gravity), state_(state) {
    kappa_ = Wide(state.beta_rate) / state.w;
  }

  [[nodiscard]] Wide kappa() const { return kappa_; }

  /// Speed of the centre where it has gone the arc length s.
  [[nodiscard]] Wide speed(const Wide& s) const {
    const Wide E = Wide(state_.w) * state_.w / (2 * Wide(gravity_)) + fall(s);
    const Wide eta = body_.eta_m;
    const Wide A = 1 + eta * eta + body_.k - 2 * eta * sin(theta(s) - beta(s));
    return sqrt(2 * Wide(gravity_) * E / A);
  }
  /// Velocity of the centre of mass: of c + r η (cos θ, sin θ).
  [[nodiscard]] WideVector mass_velocity(const Wide& s) const {
    const Wide v = speed(s);
    const Wide eta = body_.eta_m;
    return {v * (cos(beta(s)) - eta * sin(theta(s))),
            v * (sin(beta(s)) + eta * cos(theta(s)))};
  }
  /// Acceleration of the centre of mass, v d/ds of its velocity: a central
  /// difference, off by the square of 1e-15.
  [[nodiscard]] WideVector mass_acceleration() const {
    const WideVector ahead = mass_velocity(kStep);
    const WideVector behind = mass_velocity(-kStep);
    const Wide rate = speed(0) / (2 * kStep);
    return {rate * (ahead.x - behind.x), rate * (ahead.z - behind.z)};
  }
  [[nodiscard]] Wide centre_acceleration() const {
    return speed(0) * (speed(kStep) - speed(-kStep)) / (2 * kStep);
  }

 private:
  inline static const Wide kStep = Wide(1e-15);

  [[nodiscard]] Wide beta(const Wide& s) const {
    return state_.beta + kappa_ * s;
  }
  [[nodiscard]] Wide theta(const Wide& s) const {
    return state_.theta + s / Wide(body_.radius);
  }
  /// Drop of the centre of mass since s = 0.
  [[nodiscard]] Wide fall(const Wide& s) const {
    const Wide lever = Wide(body_.radius) * body_.eta_m;
    return (cos(Wide(state_.beta)) - cos(beta(s))) / kappa_ +
           lever * (sin(theta(s)) - sin(Wide(state_.theta)));
  }

  Body body_;
  double gravity_;
  PathState state_;
  Wide kappa_;
};

struct MotionSample {
  Body body;
  double gravity;
  PathState state;
};

MotionSample random_motion_sample(Random& random) {
  MotionSample sample;
  sample.body = random_cylinder(random, 0.9);
  sample.body.k = std::max(sample.body.k, 0.05);
  sample.gravity = random.uniform(0.5, 10.0);
  sample.state.centre = {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
  sample.state.theta = random.uniform(-2.0, 6.0);
  sample.state.beta = random.uniform(-kPi, kPi);
  sample.state.w = random.uniform(0.1, 3.0);
  sample.state.beta_rate = random.uniform(-3.0, 3.0);
  return sample;
}

/// Forces are sums of terms of this size; A, of which a rounding is up to six
/// times as large relative to it (η ≤ 0.9, k ≥ 0.05), divides them twice.
double force_rounding(const MotionSample& s) {
  const double A = inertia_factor(s.body, s.state.theta, s.state.beta);
  const double rates =
      s.state.w * (s.state.w / s.body.radius + std::abs(s.state.beta_rate));
  return ulps(4.0 * 6.0, 2.0 + (2.0 / A + 2.0 * rates / (A * A * s.gravity)));
}

TEST(Kinematics, ForcesAccelerateTheCentreOfMass) {
  constexpr std::uint32_t kSeed = 1;
  Random random(kSeed);
  for (int i = 0; i < 300; ++i) {
    const MotionSample s = random_motion_sample(random);

    const Kinematics motion = kinematics(s.body, s.gravity, s.state);

    // m r̈ = m g e_z + R; R_n points from the track, R_t along the motion.
    const CircularMotion witness(s.body, s.gravity, s.state);
    const WideVector a = witness.mass_acceleration();
    const Wide sine = sin(Wide(s.state.beta)), cosine = cos(Wide(s.state.beta));
    const Wide R_x = a.x / s.gravity, R_z = a.z / s.gravity - 1;
    const Wide R_n = R_x * sine - R_z * cosine;
    const Wide R_t = R_x * cosine + R_z * sine;
    EXPECT_NEAR(motion.R_n, R_n.convert_to<double>(), force_rounding(s))
        << "seed " << kSeed << " sample " << i;
    EXPECT_NEAR(motion.R_t, R_t.convert_to<double>(), force_rounding(s))
        << "seed " << kSeed << " sample " << i;
  }
}

TEST(Kinematics, ForcesTurnTheBodyAboutItsCentreOfMass) {
  // Euler's equation k m r² ω̇ = torque of R about the centre of mass, which no
  // formula for the forces uses.
  constexpr std::uint32_t kSeed = 2;
  Random random(kSeed);
  for (int i = 0; i < 300; ++i) {
    const MotionSample s = random_motion_sample(random);

    const Kinematics motion = kinematics(s.body, s.gravity, s.state);

    const double sine = std::sin(s.state.beta), cosine = std::cos(s.state.beta);
    const double R_x = motion.R_t * cosine + motion.R_n * sine;
    const double R_z = motion.R_t * sine - motion.R_n * cosine;
    const double r = s.body.radius;
    const double torque = ((motion.contact.x - motion.mass_centre.x) * R_z -
                           (motion.contact.z - motion.mass_centre.z) * R_x) /
                          r;
    const CircularMotion witness(s.body, s.gravity, s.state);
    const double v_dot = witness.centre_acceleration().convert_to<double>();
    const double lever = (2.0 * r + 1.0) / r;  // of points that are rounded
    EXPECT_NEAR(torque, s.body.k * v_dot / s.gravity,
                (1.0 + lever) * force_rounding(s))
        << "seed " << kSeed << " sample " << i;
  }
}

TEST(Kinematics, SpeedsAndCurvaturesFollowFromThePath) {
  constexpr std::uint32_t kSeed = 3;
  Random random(kSeed);
  for (int i = 0; i < 300; ++i) {
    const MotionSample s = random_motion_sample(random);

    const Kinematics motion = kinematics(s.body, s.gravity, s.state);

    const CircularMotion witness(s.body, s.gravity, s.state);
    const double v = witness.speed(0).convert_to<double>();
    const Wide margin = 1 - s.body.radius * witness.kappa();
    const Wide kappa_b = witness.kappa() / margin;
    EXPECT_NEAR(motion.v_c, v, ulps(8.0, v)) << "sample " << i;
    EXPECT_NEAR(motion.omega, v / s.body.radius, ulps(8.0, motion.omega));
    // 1 − r κ cancels where the track is about to fold.
    const double size =
        1.0 + s.body.radius * std::abs(s.state.beta_rate) / s.state.w;
    EXPECT_NEAR(motion.fold_margin, margin.convert_to<double>(),
                ulps(4.0, size))
        << "seed " << kSeed << " sample " << i;
    EXPECT_LE(abs(motion.kappa_b / kappa_b - 1),
              ulps(8.0, size / std::abs(motion.fold_margin)))
        << "seed " << kSeed << " sample " << i;
  }
}

TEST(Kinematics, OfAUniformCylinderOnAnInclineAreTheTextbookOnes) {
  const double k = 0.5, beta = 0.6, g = 9.81;
  const Body body = Body::cylinder(0.3, 0.0, 0.0, k);

  const Kinematics motion =
      kinematics(body, g, {.centre = {}, .theta = 2.0, .beta = beta, .w = 1.7});

  EXPECT_NEAR(motion.R_n, std::cos(beta), ulps(4.0));
  EXPECT_NEAR(motion.R_t, -k / (1.0 + k) * std::sin(beta), ulps(4.0));
  EXPECT_EQ(motion.kappa_b, 0.0);
  EXPECT_EQ(motion.fold_margin, 1.0);
  EXPECT_DOUBLE_EQ(motion.v_c, 1.7 / std::sqrt(1.0 + k));
}

TEST(Kinematics, OfAnOffCentredCylinderOnALevelTrackAreThoseOfARockingRoller) {
  // From Lagrange's function with the mass at r η below the centre, turned by
  // α from there: with 𝓐 = 1 + η² + k − 2 η cos α,
  //   r 𝓐 α̈ = −η sin α (g + r α̇²),
  // and the track pushes up with 1 + (r η/g)(α̈ sin α + α̇² cos α) and along
  // with what moves the centre of mass, (−r α̈ + r η (α̈ cos α − α̇² sin α))/g,
  // to the right. Rolling to the right, θ = π/2 + φ with φ = −α.
  const double r = 0.3, eta = 0.6, k = 0.4, g = 9.81;
  const Body body = Body::cylinder(r, eta, 0.5 * kPi, k);
  for (const double phi : {0.0, 0.4, 1.5, 3.0}) {
    const double w = 1.3;
    const double A = 1.0 + eta * eta + k - 2.0 * eta * std::cos(phi);
    const double phi_dot = w / std::sqrt(A) / r;
    const double phi_ddot =
        -eta * std::sin(phi) * (g + r * phi_dot * phi_dot) / (r * A);

    const Kinematics motion = kinematics(
        body, g, {.centre = {}, .theta = 0.5 * kPi + phi, .beta = 0.0, .w = w});

    const double upwards = 1.0 + r * eta / g *
                                     (phi_ddot * std::sin(phi) +
                                      phi_dot * phi_dot * std::cos(phi));
    const double along = r / g *
                         (phi_ddot - eta * (phi_ddot * std::cos(phi) -
                                            phi_dot * phi_dot * std::sin(phi)));
    // Terms below 10.
    EXPECT_NEAR(motion.R_n, upwards, ulps(16.0, 10.0)) << "φ " << phi;
    EXPECT_NEAR(motion.R_t, along, ulps(16.0, 10.0)) << "φ " << phi;
  }
}

TEST(Kinematics, TheTrackDoesNotPushAtTheStartOfAnExtremal) {
  // R_n = cos β − (a η/A) cos(θ − β) is the equation of the start angle.
  constexpr std::uint32_t kSeed = 4;
  Random random(kSeed);
  for (int i = 0; i < 300; ++i) {
    const Body body = random_cylinder(random, 0.9);
    PathState start;
    start.theta = body.theta_m;
    start.beta = start_angle(body);
    start.beta_rate = random.uniform(-2.0, 0.0);

    const Kinematics motion = kinematics(body, 1.0, start);

    const double A = inertia_factor(body, start.theta, start.beta);
    EXPECT_NEAR(motion.R_n, 0.0, ulps(64.0, 1.0 + 1.0 / A))
        << "seed " << kSeed << " sample " << i;
  }
}

TEST(Kinematics, CurvaturesAtTheStartAreTheirLimits) {
  const Body body = Body::cylinder(0.25, 0.5, 0.0, 0.5);
  PathState start;
  start.beta = 0.5 * kPi;
  start.beta_rate = -1.5;

  const Kinematics motion = kinematics(body, 1.0, start);

  EXPECT_EQ(motion.v_c, 0.0);
  EXPECT_EQ(motion.kappa_b, -1.0 / body.radius);
  EXPECT_EQ(motion.fold_margin, std::numeric_limits<double>::infinity());
}

TEST(Kinematics, OfABeadAreThoseOfAPoint) {
  // On a circle of radius ρ: R_n = cos β − v²/(ρ g), no friction.
  const double g = 9.81, beta = 0.4, v = 1.2, rho = 2.0;

  const Kinematics motion =
      kinematics(Body::bead(), g, {{0.3, 0.7}, 0.0, beta, v, v / rho});

  EXPECT_NEAR(motion.R_n, std::cos(beta) - v * v / (rho * g), ulps(4.0));
  EXPECT_NEAR(motion.R_t, 0.0, ulps(4.0));
  EXPECT_EQ(motion.v_c, v);
  EXPECT_EQ(motion.omega, 0.0);
  EXPECT_EQ(motion.contact.x, 0.3);
  EXPECT_EQ(motion.mass_centre.z, 0.7);
  EXPECT_DOUBLE_EQ(motion.kappa_b, 1.0 / rho);
}

TEST(Kinematics, ForcesDoNotDependOnUnits) {
  Random random(5);
  const MotionSample s = random_motion_sample(random);
  const double length = 0.01, time = 7.0;  // new units, in old ones
  Body body = s.body;
  body.radius /= length;
  PathState state = s.state;
  state.w *= time / length;
  state.beta_rate *= time;

  const Kinematics motion = kinematics(s.body, s.gravity, s.state);
  const Kinematics same =
      kinematics(body, s.gravity * time * time / length, state);

  EXPECT_NEAR(same.R_n, motion.R_n, force_rounding(s));
  EXPECT_NEAR(same.R_t, motion.R_t, force_rounding(s));
  const double size =
      1.0 + s.body.radius * std::abs(s.state.beta_rate) / s.state.w;
  EXPECT_NEAR(same.kappa_b / (motion.kappa_b * length), 1.0,
              ulps(8.0, size / std::abs(motion.fold_margin)));
}

}  // namespace
}  // namespace brachisto::testing
