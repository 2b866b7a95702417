// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Motions on given paths in other worlds against closed forms and the equation
// of motion.

#include <gtest/gtest.h>

#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <memory>
#include <numbers>

#include "model/inertia.hpp"
#include "support/world_scenes.hpp"
#include "trajectory/certify.hpp"
#include "trajectory/prescribed_motion.hpp"

namespace brachisto::testing {
namespace {

constexpr double kGravity = 9.81;
constexpr double kRounding = 2e-14;  // of T, relative
const Point kA{0.0, 0.0}, kB{3.0, 1.0};

/// From A to B as points of the centre's path.
Scene from_A_to_B(const Body& body) {
  Scene scene;
  scene.body = body;
  scene.L = kB.x;
  scene.H = kB.z;
  scene.contact = Contact::Centre;
  scene.path = std::make_shared<const GivenPath>();
  return scene;
}

double verified_time(const PrescribedMotion& motion) {
  EXPECT_FALSE(motion.stall());
  const Certificate certificate = certify_path(motion, 1e-10);
  for (const Check& check : certificate.checks) {
    EXPECT_TRUE(check.passed) << check.name << " " << check.value;
  }
  return motion.transit_time();
}

double time_on_incline(const Scene& scene) {
  return verified_time(PrescribedMotion(scene, straight_line(kA, kB)));
}

const double kLength = std::hypot(kB.x, kB.z);

/// Of an incline: A v̇ = a.
double slope_force() {
  return kGravity * kB.z / kLength;
}

TEST(PrescribedInWorlds, OnAnInclineLinearDragLetsItFallAsInClosedForm) {
  // A v̇ = a − c v, so that s = v∞ (t − (1 − e^{−ct/A}) A/c).
  const Body body = Body::cylinder(0.2, 0.0, 0.3, 0.5);
  for (const double c : {0.1, 3.0, 30.0}) {
    const double T = time_on_incline(in_air(from_A_to_B(body), c, 0.0));
    const double A = 1.5, terminal = slope_force() / c;
    EXPECT_NEAR(terminal * (T + std::expm1(-c * T / A) * A / c) / kLength, 1.0,
                kRounding)
        << c;
  }
}

TEST(PrescribedInWorlds, OnAnInclineQuadraticDragLetsItFallAsInClosedForm) {
  // v² = (a/c)(1 − e^{−2cs/A}), so that T = A/√(ac) arcosh e^{cS/A}.
  const Body body = Body::cylinder(0.2, 0.0, 0.3, 0.5);
  for (const double c : {0.05, 1.0, 20.0}) {
    const double T = time_on_incline(in_air(from_A_to_B(body), 0.0, c));
    const double A = 1.5, x = c * kLength / A;
    // arcosh e^x = x + log(1 + √(1 − e^{−2x})).
    const double expected = A / std::sqrt(slope_force() * c) *
                            (x + std::log1p(std::sqrt(-std::expm1(-2.0 * x))));
    EXPECT_NEAR(T / expected, 1.0, kRounding) << c;
  }
}

TEST(PrescribedInWorlds, APushOnAnInclineIsUniformlyAccelerated) {
  const Body body = Body::cylinder(0.2, 0.0, 0.3, 0.5);
  // A push of 1e-6 changes T by 7e-7 of it, all of which happens within 1e-13
  // m.
  for (const double v : {1e-6, 1e-5, 1e-4, 1e-3, 1.0, 50.0}) {
    const double T = time_on_incline(with_push(from_A_to_B(body), v));
    const double gain = slope_force() / 1.5;
    EXPECT_NEAR(
        T * (v + std::sqrt(v * v + 2.0 * gain * kLength)) / (2.0 * kLength),
        1.0, kRounding)
        << v;
  }
}

TEST(PrescribedInWorlds, AChordThroughASphereIsAnOscillator) {
  const double R = 50.0, g = 9.81;
  // The middle of the chord lies at the share 0.7 of the way to B.
  const double half = 0.7 * kLength, beta = std::atan2(kB.z, kB.x);
  const double deep = 40.0;
  const Sphere sphere{{half * std::cos(beta) - deep * std::sin(beta),
                       half * std::sin(beta) + deep * std::cos(beta)},
                      R,
                      g};
  const double T =
      time_on_incline(about_sphere(from_A_to_B(Body::bead()), sphere));
  const double expected = std::acos((half - kLength) / half) * std::sqrt(R / g);
  EXPECT_NEAR(T / expected, 1.0, kRounding);
}

/// The time of a fall from rest at d₀ to d outside of a mass with GM.
double fall_time(double GM, double d_0, double d) {
  const double x = d / d_0, rest = (d_0 - d) / d_0;
  return std::sqrt(d_0 * d_0 * d_0 / (2.0 * GM)) *
         (std::asin(std::sqrt(rest)) + std::sqrt(x * rest));
}

/// A sphere with its centre on the line from A to B at the distance d_0 from A.
Sphere straight_ahead(double d_0, double R, double g) {
  return {{kB.x / kLength * d_0, kB.z / kLength * d_0}, R, g};
}

TEST(PrescribedInWorlds, AFallTowardsAPlanetIsKeplers) {
  for (const double R : {0.5, 1000.0}) {
    const double d_0 = R + kLength + 0.3, g = 9.81;
    const double T = time_on_incline(
        about_sphere(from_A_to_B(Body::bead()), straight_ahead(d_0, R, g)));
    // Beside a large planet the difference of distances has lost digits here.
    EXPECT_NEAR(T / fall_time(g * R * R, d_0, d_0 - kLength), 1.0,
                R > 1.0 ? 1e-12 : kRounding);
  }
}

TEST(PrescribedInWorlds, AWayUpFromAPlanetIsTheFallBackwards) {
  const double R = 0.5, d_1 = 0.8, top = d_1 + 2.0 * kLength, g = 9.81;
  Sphere sphere{{-kB.x / kLength * d_1, -kB.z / kLength * d_1}, R, g};
  const double GM = g * R * R;
  const double v = std::sqrt(2.0 * GM * (1.0 / d_1 - 1.0 / top));
  const double T = time_on_incline(
      with_push(about_sphere(from_A_to_B(Body::bead()), sphere), v));
  const double expected =
      fall_time(GM, top, d_1) - fall_time(GM, top, d_1 + kLength);
  EXPECT_NEAR(T / expected, 1.0, kRounding);
}

TEST(PrescribedInWorlds, AWayThroughTheSurfaceHasBothLaws) {
  const double R = 2.0, d_0 = 3.0, g = 9.81, GM = g * R * R;
  const double T = time_on_incline(
      about_sphere(from_A_to_B(Body::bead()), straight_ahead(d_0, R, g)));
  // Inside r = R cos ωt − (v/ω) sin ωt, to beyond the centre.
  const double v = std::sqrt(2.0 * GM * (1.0 / R - 1.0 / d_0));
  const double omega = std::sqrt(g / R);
  const double amplitude = std::hypot(R, v / omega);
  const double inside =
      std::acos((d_0 - kLength) / amplitude) - std::atan2(v / omega, R);
  EXPECT_NEAR(T / (fall_time(GM, d_0, R) + inside / omega), 1.0, kRounding);
}

TEST(PrescribedInWorlds, AnEarthLosesNoDigitsOfAStartOnItsSurface) {
  // The law of the outside goes over into the inside's 1 mm below A; both are
  // uniform to 1e-6 and more.
  const double R = 6.371e6;
  const Scene scene = about_sphere(from_A_to_B(Body::bead()),
                                   straight_ahead(R + 1e-3, R, kGravity));
  const double T = time_on_incline(scene);
  EXPECT_NEAR(T / std::sqrt(2.0 * kLength / kGravity), 1.0, 1e-6);
}

TEST(PrescribedInWorlds, AnOffCentredCylinderInAirObeysNewtonAndEuler) {
  // About the contact: I_b θ̈ + ... from the two equations of the centre of mass
  // and the one of rotation, with the drag on the centre, solved for the
  // acceleration and the forces of the track at each moment.
  const Body body = Body::cylinder(0.2, 0.6, -0.4, 0.3);
  const Scene scene = with_push(in_air(from_A_to_B(body), 0.7, 0.2), 0.5);
  const double beta = std::atan2(kB.z, kB.x);
  const double c = std::cos(beta), s = std::sin(beta), r = body.radius;
  const double r_m = r * body.eta_m, I = body.k * r * r;
  using State = std::array<double, 2>;
  const auto rate = [&](const State& y, State& dy, double) {
    const double theta = body.theta_m + y[0] / r, v = y[1], omega = v / r;
    const double x = r_m * std::cos(theta), z = r_m * std::sin(theta);
    const double brakes = v * (0.7 + 0.2 * v);
    // Centre of mass: a (c, s) + α (−z, x) − ω² (x, z) = F + R, a = r α, per
    // mass; moments about it: I α = (arm × (R + drag's)). R = R_t (c, s) +
    // R_n (s, −c) at the contact r (−s, c), the drag −brakes (c, s) at the
    // centre. Unknown α: with M(α) linear, from two values.
    const auto moment = [&](double alpha) {
      const double a_x = r * alpha * c - alpha * z - omega * omega * x;
      const double a_z = r * alpha * s + alpha * x - omega * omega * z;
      const double R_x = a_x + brakes * c, R_z = a_z + brakes * s - kGravity;
      const double arm_x = -r * s - x, arm_z = r * c - z;
      return arm_x * R_z - arm_z * R_x + (-x) * (-brakes * s) -
             (-z) * (-brakes * c) - I * alpha;
    };
    const double at_0 = moment(0.0);
    dy = {v, r * at_0 / (at_0 - moment(1.0))};
  };
  const PrescribedMotion motion(scene, straight_line(kA, kB));
  const double T = verified_time(motion);
  State y{0.0, 0.5};
  namespace odeint = boost::numeric::odeint;
  odeint::integrate_adaptive(
      odeint::make_controlled(1e-13, 1e-13,
                              odeint::runge_kutta_fehlberg78<State>()),
      rate, y, 0.0, T, 1e-4);
  EXPECT_NEAR(y[0], kLength, 1e-10);
  EXPECT_NEAR(y[1], motion.at(1.0).motion.v_c, 1e-10);
}

TEST(PrescribedInWorlds, AStiffStartIsSolved) {
  // v₀ is gone within 2 mm; then v = a/c but for the last of the fall from v₀.
  const double c = 1000.0, a = slope_force();
  for (const double v : {0.0, 2.0, 20.0, 1000.0}) {
    const Scene scene = with_push(in_air(from_A_to_B(Body::bead()), c, 0.0), v);
    const double T = time_on_incline(scene);
    // s = (a/c) T + (v₀ − a/c)(1 − e^{−cT})/c.
    EXPECT_NEAR((a / c * T + (v - a / c) / c * -std::expm1(-c * T)) / kLength,
                1.0, 1e-12)
        << v;
  }
}

TEST(PrescribedInWorlds, AirThatBrakesWithinNoTimeIsNeverVerifiedWrong) {
  for (const double c : {1e7, 1e12}) {
    const PrescribedMotion motion(
        with_push(in_air(from_A_to_B(Body::bead()), c, 0.0), 2.0),
        straight_line(kA, kB));
    if (motion.stall()) {
      EXPECT_EQ(motion.stall()->reason, Stall::Reason::NotFollowed);
      continue;
    }
    if (!certify_path(motion, 1e-10).verified()) continue;
    EXPECT_NEAR(motion.transit_time() * slope_force() / c / kLength, 1.0, 1e-6);
  }
}

TEST(PrescribedInWorlds, AHillStopsWhereAirHasTakenTheEnergy) {
  // Upwards A v v' = −a − c v²: v² = (v₀² + a/c) e^{−2cs} − a/c.
  const double v = 5.0, c = 0.3, a = slope_force();
  Scene scene = with_push(in_air(from_A_to_B(Body::bead()), 0.0, c), v);
  const Point up{kB.x, -kB.z};
  const double stop = 0.5 / c * std::log1p(c * v * v / a);
  ASSERT_LT(stop, kLength);
  const PrescribedMotion motion(scene, straight_line(kA, up));
  ASSERT_TRUE(motion.stall());
  EXPECT_EQ(motion.stall()->reason, Stall::Reason::Stops);
  EXPECT_NEAR(motion.stall()->centre.x, stop * kB.x / kLength, 1e-9);
  scene.world.start_speed = 20.0;
  EXPECT_FALSE(PrescribedMotion(scene, straight_line(kA, up)).stall());
}

TEST(PrescribedInWorlds, AHillStopsWhereAPushIsUsedUp) {
  // ½ v² = g z, up a straight hill: to the digits of the halves of a cell.
  constexpr double v = 2.0;
  const Scene scene = with_push(from_A_to_B(Body::bead()), v);
  const PrescribedMotion motion(scene, straight_line(kA, {kB.x, -kB.z}));
  ASSERT_TRUE(motion.stall());
  EXPECT_EQ(motion.stall()->reason, Stall::Reason::Stops);
  EXPECT_NEAR(motion.stall()->centre.z, -0.5 * v * v / scene.gravity, 1e-9);
}

TEST(PrescribedInWorlds, OnlyRestWantsAPullAlongThePath) {
  const PlaneCurvePtr up = straight_line(kA, {kB.x, -kB.z});
  const Scene scene = from_A_to_B(Body::bead());
  const PrescribedMotion at_rest(in_air(scene, 0.1, 0.0), up);
  ASSERT_TRUE(at_rest.stall());
  EXPECT_EQ(at_rest.stall()->reason, Stall::Reason::DoesNotStart);
  EXPECT_FALSE(PrescribedMotion(with_push(scene, 9.0), up).stall());
}

TEST(PrescribedInWorlds, CurvesOfAnyKindAreVerified) {
  const Body body = Body::cylinder(0.3, 0.6, 0.2, 0.4);
  for (const PlaneCurvePtr& curve :
       {parabola({0.3, 0.0}, {3.0, 0.8}, 0.5 * std::numbers::pi),
        circular_arc({0.3, 0.0}, {3.0, 0.8}, 1.0),
        cycloid_curve({0.3, 0.0}, {3.0, 0.8})}) {
    Scene scene = from_A_to_B(body);
    scene.contact = Contact::Centre;
    for (const Sphere& sphere : {around(), below(), in_the_way()}) {
      for (const double c : {0.0, 0.05}) {
        const PrescribedMotion motion(
            in_air(about_sphere(scene, sphere), c, 0.5 * c), curve);
        ASSERT_FALSE(motion.stall());
        EXPECT_LE(motion.error_estimate(), 1e-12);
        const Certificate found = certify_path(motion, 1e-10);
        for (const Check& check : found.checks) {
          // These curves do not lead from A to B.
          if (check.name == "contact_error") continue;
          EXPECT_TRUE(check.passed) << check.name << " " << check.value;
        }
      }
    }
  }
}

}  // namespace
}  // namespace brachisto::testing
