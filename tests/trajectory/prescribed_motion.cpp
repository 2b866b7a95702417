// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Motions on given paths against closed forms and the equation of motion.

#include "trajectory/prescribed_motion.hpp"

#include <gtest/gtest.h>

#include <array>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "brachisto/math/clock.hpp"
#include "math/cpu_clock.hpp"
#include "model/centre_curve.hpp"
#include "model/cycloid.hpp"
#include "support/scenes.hpp"
#include "trajectory/certify.hpp"

namespace brachisto {
namespace {

using testing::scene_of;

constexpr double kGravity = 9.81;
constexpr double kVertical = 0.5 * std::numbers::pi;
constexpr double kRounding = 1e-12;  // of T, relative; see kTolerance there

double time_on(const Body& body, const PlaneCurvePtr& centre) {
  const PrescribedMotion motion(scene_of(body), centre);
  EXPECT_FALSE(motion.stall());
  EXPECT_LE(motion.error_estimate(), kRounding);
  return motion.transit_time();
}

TEST(PrescribedMotion, OnAStraightLineIsUniformlyAccelerated) {
  const double length = std::hypot(3.0, 1.0);
  const double bead = length * std::sqrt(2.0 / (kGravity * 1.0));
  const PlaneCurvePtr line = straight_line({0.0, 0.0}, {3.0, 1.0});

  EXPECT_NEAR(time_on(Body::bead(), line) / bead, 1.0, kRounding);
  EXPECT_NEAR(time_on(Body::cylinder(0.2, 0.0, 0.3, 0.5), line) /
                  (bead * std::sqrt(1.5)),
              1.0, kRounding);
}

TEST(PrescribedMotion, OnACycloidTakesTimeInProportionToPsi) {
  const auto arc = cycloid_between({0.5, -0.2}, {3.0, 1.0});
  ASSERT_TRUE(arc);
  const PlaneCurvePtr curve = cycloid_curve({0.5, -0.2}, {3.0, 1.0});
  const double expected = arc->psi_end * std::sqrt(arc->a / kGravity);

  EXPECT_NEAR(time_on(Body::bead(), curve) / expected, 1.0, kRounding);
}

TEST(PrescribedMotion, OnAQuarterCircleIsThatOfAPendulum) {
  // Released level with the pivot it reaches the bottom after a quarter period.
  const double R = 1.7;
  const double expected =
      std::sqrt(R / kGravity) *
      boost::math::ellint_1(std::sin(0.25 * std::numbers::pi));
  const PlaneCurvePtr arc = circular_arc({0.0, 0.0}, {R, R}, kVertical);

  EXPECT_NEAR(time_on(Body::bead(), arc) / expected, 1.0, kRounding);
}

TEST(PrescribedMotion, OnAParabolaIsItsIntegral) {
  // x = 3 z², vertical at the start; z = y² takes the root out of dt.
  boost::math::quadrature::tanh_sinh<double> rule;
  const double expected = rule.integrate(
      [](double y) {
        const double slope = 6.0 * y * y;
        return 2.0 * std::sqrt((1.0 + slope * slope) / (2.0 * kGravity));
      },
      0.0, 1.0);
  const PlaneCurvePtr curve = parabola({0.0, 0.0}, {3.0, 1.0}, kVertical);

  EXPECT_NEAR(time_on(Body::bead(), curve) / expected, 1.0, kRounding);
}

TEST(PrescribedMotion, OfAnOffCentredCylinderObeysLagrange) {
  // On an incline A s'' = g (sin β + η cos θ) − ½ A_s s'², in time.
  const Body body =
      Body::cylinder(0.077, 0.6521, -83.25 / 180.0 * std::numbers::pi, 0.255);
  const double beta = std::atan2(0.18, 1.49);
  const double length = std::hypot(0.18, 1.49);
  using State = std::array<double, 2>;
  const auto rate = [&](const State& y, State& dy, double) {
    const double theta = body.theta_m + y[0] / body.radius;
    const double A = 1.0 + body.eta_m * body.eta_m + body.k -
                     2.0 * body.eta_m * std::sin(theta - beta);
    const double A_s = -2.0 * body.eta_m * std::cos(theta - beta) / body.radius;
    dy[0] = y[1];
    dy[1] = (kGravity * (std::sin(beta) + body.eta_m * std::cos(theta)) -
             0.5 * A_s * y[1] * y[1]) /
            A;
  };
  namespace odeint = boost::numeric::odeint;
  Scene scene = scene_of(body);
  scene.L = 1.49;
  scene.H = 0.18;
  const PrescribedMotion motion(scene, straight_line({0.0, 0.0}, {1.49, 0.18}));
  ASSERT_FALSE(motion.stall());
  State y{0.0, 0.0};
  odeint::integrate_adaptive(
      odeint::make_controlled(1e-13, 1e-13,
                              odeint::runge_kutta_fehlberg78<State>()),
      rate, y, 0.0, motion.transit_time(), 1e-4);

  EXPECT_NEAR(y[0], length, 1e-10);
  EXPECT_NEAR(y[1], motion.at(1.0).motion.v_c, 1e-10);
}

TEST(PrescribedMotion, HasTheSpeedOfItsEnergyEverywhere) {
  const Body body = Body::cylinder(1.0 / 3.0, 2.0 / 3.0, 0.0, 0.5);
  const PrescribedMotion motion(
      scene_of(body), circular_arc({0.3, 0.0}, {3.0, 0.9}, kVertical));
  ASSERT_FALSE(motion.stall());
  const double z_0 = motion.at(0.0).motion.mass_centre.z;
  for (const TrajectoryPoint& point : motion.fine_sample(0)) {
    // ½ v_cm² + ½ k r² ω² = g × fall of the centre of mass, with v_cm from
    // the no-slip motion of the centre of mass about the contact.
    const Kinematics& m = point.motion;
    const double arm = std::hypot(m.mass_centre.x - m.contact.x,
                                  m.mass_centre.z - m.contact.z);
    const double kinetic = 0.5 * m.omega * m.omega *
                           (arm * arm + body.k * body.radius * body.radius);
    EXPECT_NEAR(kinetic, kGravity * (m.mass_centre.z - z_0), 1e-12);
  }
}

TEST(PrescribedMotion, DoesNotDependOnWhoseCurveALineIs) {
  const Body body = Body::cylinder(0.25, 0.5, 0.2, 0.5);
  const PlaneCurvePtr track = straight_line({0.0, 0.0}, {3.0, 1.0});
  EXPECT_NEAR(time_on(body, centre_path_over(track, body.radius)) /
                  time_on(body, track),
              1.0, kRounding);
}

TEST(PrescribedMotion, OverAnArcIsOnAnotherArc) {
  // A valley of radius R holds a centre on the concentric arc of R − r.
  const double r = 0.25, R = 1.5;
  const Body body = Body::cylinder(r, 0.5, 0.2, 0.5);
  const PlaneCurvePtr track = circular_arc({0.0, 0.0}, {R, R}, kVertical);
  const PlaneCurvePtr centre = circular_arc({r, 0.0}, {R, R - r}, kVertical);
  EXPECT_NEAR(time_on(body, centre_path_over(track, r)) / time_on(body, centre),
              1.0, kRounding);
}

TEST(PrescribedMotion, OnASplineThroughAnArcComesCloseToTheArc) {
  const double R = 2.0;
  const PlaneCurvePtr arc = circular_arc({0.0, 0.0}, {R, R}, 1.2);
  const double expected = time_on(Body::bead(), arc);
  double last = 1.0;
  for (const int n : {20, 40, 80}) {
    std::vector<Point> points;
    for (int i = 0; i <= n; ++i) {
      points.push_back(
          point_of(*arc, arc->at(std::sqrt(static_cast<double>(i) / n))));
    }
    const PrescribedMotion motion(scene_of(Body::bead()),
                                  spline_through(points));
    ASSERT_FALSE(motion.stall());
    const double error = std::abs(motion.transit_time() / expected - 1.0);
    // Order 4 of the spline; the slope at the start, of order 3, comes into T
    // with a stretch of length h, where the body is slow: √h.
    EXPECT_LT(error, last / 8.0);
    last = error;
  }
}

TEST(PrescribedMotion, IsSlowerThanTheExtremal) {
  const Body body = Body::cylinder(1.0 / 3.0, 2.0 / 3.0, 0.0, 0.5);
  // τ of the reference case, by the indirect method.
  const double extremal = 5.093444466618 / std::sqrt(2.0 * kGravity);
  Scene scene = scene_of(body);
  scene.body.eta_m = 0.0;
  const auto arc = axisymmetric_optimum(scene);
  ASSERT_TRUE(arc);
  const double cycloid =
      time_on(body, cycloid_curve(arc->start, arc->at(arc->psi_end)));
  EXPECT_GT(cycloid, extremal);
  EXPECT_LT(cycloid, 1.1 * extremal);
}

TEST(PrescribedMotion, StallsWhereItsEnergyIsUsedUp) {
  // Down to z = 1 and up again to z = −0.5, where it cannot get.
  const PlaneCurvePtr curve = spline_through(
      {{0.0, 0.0}, {1.0, 0.9}, {2.0, 1.0}, {3.0, 0.6}, {4.0, -0.5}});
  const PrescribedMotion motion(scene_of(Body::bead()), curve);
  ASSERT_TRUE(motion.stall());
  EXPECT_EQ(motion.stall()->reason, Stall::Reason::Stops);
  EXPECT_GT(motion.stall()->centre.x, 3.0);
  EXPECT_NEAR(motion.stall()->centre.z, 0.0, 0.1);
  EXPECT_NE(motion.stall()->message().find("stalls"), std::string::npos);
}

TEST(PrescribedMotion, DoesNotStartUphill) {
  // sin β + η cos θ_m < 0: the centre of mass would have to rise.
  const Body body = Body::cylinder(0.2, 0.8, std::numbers::pi, 0.1);
  const PrescribedMotion motion(scene_of(body),
                                straight_line({0.0, 0.0}, {3.0, 1.0}));
  ASSERT_TRUE(motion.stall());
  EXPECT_EQ(motion.stall()->reason, Stall::Reason::DoesNotStart);
}

TEST(PrescribedMotion, DoesNotStartWhereForcesBalance) {
  // sin β = μ cos β, but for rounding.
  Scene scene = scene_of(Body::bead());
  scene.world.losses.sliding = 1.0 / 3.0;
  const PrescribedMotion motion(scene, straight_line({0.0, 0.0}, {3.0, 1.0}));
  ASSERT_TRUE(motion.stall());
  EXPECT_EQ(motion.stall()->reason, Stall::Reason::DoesNotStart);
}

TEST(PrescribedMotion, BeginsWithTheCurvatureOfItsCurve) {
  const Body body = Body::cylinder(0.02, 0.0, 0.0, 0.4);
  // From 60° down to where it ends: over its chord c, at angle α to +x, it
  // turns by 2 (60° − α), so that |κ| = 2 sin(60° − α)/c.
  const double alpha = std::atan2(1.0, 3.0), c = std::hypot(3.0, 1.0);
  const double kappa = -2.0 * std::sin(std::numbers::pi / 3.0 - alpha) / c;
  const PrescribedMotion motion(
      scene_of(body),
      circular_arc({0.0, 0.0}, {3.0, 1.0}, std::numbers::pi / 3.0));
  const TrajectoryPoint first = motion.at_nodes().front();
  const double r = body.radius;
  EXPECT_NEAR(first.motion.kappa_b, kappa / (1.0 - r * kappa), 1e-6);
  EXPECT_NEAR(first.motion.fold_margin, 1.0 - r * kappa, 1e-6);
}

TEST(PrescribedMotion, ABeadTouchesTheEndsOfItsCurveAtAnySlope) {
  // From 150° over the left of A, the chord at α: an arc that turns by
  // 2 (α − 150°) has the length c (150° − α)/sin(150° − α).
  const double angle = 5.0 * std::numbers::pi / 6.0;
  Scene scene = scene_of(Body::bead());
  scene.world.start_speed = 8.0;
  GivenPath path;
  path.shape = GivenPath::Shape::CircularArc;
  path.start_angle = angle;
  scene.path = std::make_shared<const GivenPath>(path);
  const double half = angle - std::atan2(1.0, 3.0);
  const PrescribedMotion motion(scene, centre_curve(scene));
  ASSERT_FALSE(motion.stall());
  EXPECT_NEAR(motion.at_nodes().back().s,
              std::hypot(3.0, 1.0) * half / std::sin(half), 1e-9);
}

TEST(PrescribedMotion, DoesNotFitIntoANarrowValley) {
  const Body body = Body::cylinder(0.6, 0.0, 0.0, 0.5);
  const PlaneCurvePtr track = circular_arc({0.0, 0.0}, {0.5, 0.5}, kVertical);
  const PrescribedMotion motion(scene_of(body), centre_path_over(track, 0.6));
  ASSERT_TRUE(motion.stall());
  EXPECT_EQ(motion.stall()->reason, Stall::Reason::DoesNotFit);
}

/// A curve that counts how often it is asked.
class Counting final : public PlaneCurve {
 public:
  explicit Counting(PlaneCurvePtr curve) : curve_(std::move(curve)) {}

  [[nodiscard]] Point start() const override { return curve_->start(); }
  [[nodiscard]] CurvePlace at(double q) const override {
    ++count;
    return curve_->at(q);
  }
  [[nodiscard]] Pace pace(double q) const override {
    ++count;
    return curve_->pace(q);
  }
  [[nodiscard]] std::vector<double> joints() const override {
    return curve_->joints();
  }

  mutable double count = 0.0;

 private:
  PlaneCurvePtr curve_;
};

/// Evaluations of a spline through so many points of z = x/3 + 0.6 sin(πx/3)
/// that its motion, diagnosis and certificate take.
double evaluations(int points) {
  std::vector<Point> track;
  for (int i = 0; i <= points; ++i) {
    const double x = 3.0 * i / points;
    track.push_back({x, x / 3.0 + 0.6 * std::sin(std::numbers::pi * x / 3.0)});
  }
  const auto curve =
      std::make_shared<Counting>(centre_path_over(spline_through(track), 0.1));
  Scene scene = scene_of(Body::cylinder(0.1, 0.3, 0.0, 0.5));
  GivenPath path;
  path.curve = GivenPath::Curve::Track;
  scene.path = std::make_shared<const GivenPath>(path);
  const PrescribedMotion motion(scene, curve);
  static_cast<void>(motion.diagnose());
  EXPECT_TRUE(certify_path(motion, 1e-10).verified());
  return curve->count;
}

TEST(PrescribedMotion, NamesALeastForceThatIsTheLimitAtTheStart) {
  // On a vertical start δ = θ_m − π/2, so that R_n → F/A = −a η sin θ_m / A
  // with a = 1 + η cos θ_m and A = 1 + η² + k + 2 η cos θ_m; from there it
  // rises.
  const double eta = 0.05;
  const double theta_m = 1.6;
  const double k = 0.1;
  const double a = 1.0 + eta * std::cos(theta_m);
  const double A = 1.0 + eta * eta + k + 2.0 * eta * std::cos(theta_m);
  const double limit = -a * eta * std::sin(theta_m) / A;
  const PrescribedMotion motion(scene_of(Body::cylinder(0.4, eta, theta_m, k)),
                                cycloid_curve({0.4, 0.0}, {3.0, 1.0}));

  const PathDiagnostics found = motion.diagnose();

  EXPECT_NEAR(found.at_start.normal_force, limit, 1e-14);
  EXPECT_TRUE(found.at_start.lifts_off());
  EXPECT_EQ(found.min_normal_force.value, found.at_start.normal_force);
  EXPECT_TRUE(found.min_normal_force.at_start);
}

TEST(PrescribedMotion, OfASplineTakesWorkInProportionToItsPoints) {
  const double few = evaluations(500);
  const double many = evaluations(4000);

  // Eight times the points; what does not depend on them makes it less, and
  // some hundred evaluations per point where it is more.
  EXPECT_LE(many / few, 8.0);
  EXPECT_GE(many / few, 4.0);
  EXPECT_LE(many / 4000.0, 2000.0);
}

/// β = β₀ − ε sin k s with r ε k = 1 + δ: where cos k s < −1/(1 + δ), over
/// phases of ±φ, the track runs back by 2 (r ε sin φ − φ/k) on each wave. The
/// spline of 80 slopes to a wave, h = 2π/80 apart in phase, has dβ/ds to h³/125
/// of it at the most (4e-6), which is a share of 1.5 · 4e-6/δ of the way back.
/// The narrowest fold is as wide as two thirds of h.
TEST(PrescribedMotion, TellsHowFarItsTrackFoldsBack) {
  constexpr int kWaves = 5, kPlaces = 80 * kWaves;
  Body body;
  body.radius = 0.1;
  body.k = 0.5;
  const double S = 2.0, k = 2.0 * std::numbers::pi * kWaves / S;
  for (const double delta : {-1e-3, 3e-4, 1e-3, 1e-2, 1e-1}) {
    const double epsilon = (1.0 + delta) / (body.radius * k);
    SlopesAlong slopes{S, {}, {}, true};
    for (int i = 0; i <= kPlaces; ++i) {
      const double share = static_cast<double>(i) / kPlaces;
      slopes.q.push_back(std::sqrt(share));
      slopes.beta.push_back(0.8 - epsilon * std::sin(k * S * share));
    }
    const PrescribedMotion motion(scene_of(body),
                                  curve_of_slopes({0.0, -body.radius}, slopes));
    ASSERT_FALSE(motion.stall()) << delta;

    const PathDiagnostics path = motion.diagnose();

    if (delta < 0.0) {
      EXPECT_GT(path.min_fold_margin.value, 0.0);
      EXPECT_EQ(path.folds_back, 0.0);
      continue;
    }
    const double phi = std::acos(1.0 / (1.0 + delta));
    const double back = 2.0 * (body.radius * epsilon * std::sin(phi) - phi / k);
    EXPECT_NEAR(path.min_fold_margin.value, -delta, 4e-6) << delta;
    EXPECT_NEAR(path.folds_back / back, 1.0, 6e-6 / delta) << delta;
  }
}

TEST(PrescribedMotion, IsStoppedFromOutside) {
  std::vector<Point> track;
  for (int i = 0; i <= 20000; ++i) {
    const double x = 3.0 * i / 20000;
    track.push_back({x, x / 3.0 + 0.1 * std::sin(std::numbers::pi * x / 3.0)});
  }
  const StopScope scope(StopCondition(0.02, nullptr));
  const double begin = process_cpu_seconds();

  EXPECT_THROW(
      {
        const PrescribedMotion motion(scene_of(Body::bead()),
                                      spline_through(track));
        static_cast<void>(motion.diagnose());
        static_cast<void>(certify_path(motion, 1e-10));
      },
      Stopped);
  EXPECT_LT(process_cpu_seconds() - begin, 0.3);
}

}  // namespace
}  // namespace brachisto
