// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/trajectory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "brachisto/study/solve.hpp"
#include "model/energy.hpp"
#include "study/answer_kinds.hpp"
#include "support/observed_order.hpp"
#include "support/reference_values.hpp"

namespace brachisto {
namespace {

using testing::reference;

SolveOptions mesh(int degree, int elements) {
  SolveOptions options;
  Discretisation& mesh = options.use<Collocation>().discretisation;
  mesh.degree = degree;
  mesh.elements = elements;
  return options;
}

/// On a mesh so fine that values between nodes are good to some 1e-11.
Trajectory fine_path(const testing::ReferenceValue& row) {
  Solution solution = solve(row.scene(), mesh(8, 40));
  return *trajectory_of(solution);
}

TEST(Trajectory, TheNormalForceVanishesAtTheStartAndFrictionDoesNot) {
  // R_n = 0 by the equation of the start angle; the relation holds exactly at
  // β₀, which the curve meets with the order of the mesh.
  constexpr double kTolerance = 1e-9;
  for (const auto* row : {&reference("reference_case"), &reference("theta_-30"),
                          &reference("theta_60"), &reference("fast")}) {
    const Trajectory path = fine_path(*row);

    const Kinematics start = path.at(0.0).motion;

    EXPECT_NEAR(start.R_n, 0.0, kTolerance) << row->name;
    // A body at rest gains v̇ = g a/A, its centre of mass v̇ (t + η dr̂/dθ).
    const Body& body = path.scene().body;
    const double beta = row->start_angle;
    const double turned = body.theta_m - beta;
    const double a = std::sin(beta) + body.eta_m * std::cos(body.theta_m);
    const double A = 1.0 + body.eta_m * body.eta_m + body.k -
                     2.0 * body.eta_m * std::sin(turned);
    const double R_t =
        a / A * (1.0 - body.eta_m * std::sin(turned)) - std::sin(beta);
    EXPECT_NEAR(start.R_t, R_t, kTolerance) << row->name;
    EXPECT_GT(std::abs(R_t), 0.01) << row->name;
    EXPECT_EQ(start.v_c, 0.0) << row->name;
  }
}

TEST(Trajectory, TheTrackTouchesBothPoints) {
  // The start is exact up to the curve's own β₀, the end up to the tangency of
  // the contact, 1e-10 rad at the worst.
  constexpr double kTolerance = 1e-9;
  for (const auto* row : {&reference("reference_case"), &reference("theta_-30"),
                          &reference("bead_L3")}) {
    const Trajectory path = fine_path(*row);

    const Point A = path.at(0.0).motion.contact;
    const Point B = path.at(1.0).motion.contact;

    EXPECT_NEAR(A.x, 0.0, kTolerance) << row->name;
    EXPECT_NEAR(A.z, 0.0, kTolerance) << row->name;
    EXPECT_NEAR(B.x, row->L, kTolerance) << row->name;
    EXPECT_NEAR(B.z, 1.0, kTolerance) << row->name;
  }
}

TEST(Trajectory, TheStartAngleOfTheCurveIsTheOneInClosedForm) {
  const Trajectory path = fine_path(reference("theta_-30"));

  // The slope of the curve is found from states and costates alone.
  EXPECT_NEAR(path.at(0.0).beta, path.start_angle(), 1e-9);
}

/// Largest |w² − 2gE| over element ends, over the largest w².
double energy_drift(const Trajectory& path) {
  const ExtremalCurve& curve = path.curve();
  const Scene& scene = curve.scene();
  const double z_start = curve.at_node(0).centre.z;
  double drift = 0.0;
  double scale = 0.0;
  for (int e = 0; e <= curve.mesh().num_elements(); ++e) {
    const ExtremalPoint at = curve.at_node(e * curve.mesh().degree);
    const double E = energy_height(scene.body, at.centre.z - z_start, at.theta);
    drift = std::max(drift, std::abs(at.w * at.w - 2.0 * scene.gravity * E));
    scale = std::max(scale, at.w * at.w);
  }
  return drift / scale;
}

TEST(EnergyDrift, FallsWithTwiceTheDegree) {
  // It is the quadrature error of ∫cos θ dθ. Meshes and tolerance as in the
  // tests of convergence: its constant drifts by less than a fifth.
  constexpr double kSlopeTolerance = 0.35;
  for (const int degree : {1, 2, 3}) {
    std::array<double, 4> h{};
    std::array<double, 4> drift{};
    int elements = degree == 3 ? 16 : 24;
    for (std::size_t i = 0; i < h.size(); ++i) {
      const Solution solution =
          solve(reference("reference_case").scene(), mesh(degree, elements));
      ASSERT_TRUE(trajectory_of(solution)) << solution.message;
      h[i] = 1.0 / elements;
      drift[i] = energy_drift(*trajectory_of(solution));
      elements = elements * 3 / 2;
    }

    EXPECT_NEAR(testing::observed_order(h, drift), 2.0 * degree,
                kSlopeTolerance)
        << "degree " << degree << ": " << drift[0] << ", " << drift[1] << ", "
        << drift[2] << ", " << drift[3];
  }
}

TEST(EnergyDrift, IsNothingButRoundingOnceTheCylinderIsCentred) {
  // With η = 0 the equations of z and w² are one and the same, discretely too.
  // What remains are defects below the KKT tolerance of 1e-12.
  constexpr double kTolerance = 1e-12;
  for (const int degree : {1, 2, 5}) {
    const Solution solution =
        solve(reference("uniform_L3").scene(), mesh(degree, 12));
    ASSERT_TRUE(trajectory_of(solution)) << solution.message;

    EXPECT_LE(energy_drift(*trajectory_of(solution)), kTolerance) << degree;
  }
}

// Central differences of second order with steps δ in σ. Along the paths used
// here everything varies like sines of angles that change by up to some 30 rad
// per unit of σ, so the third derivative is up to 30² times the first and the
// relative error δ² 30²/6.
constexpr double kStep = 1e-4;
constexpr double kDifferenceError = kStep * kStep * 30.0 * 30.0 / 6.0;
constexpr std::array kPlaces{0.05, 0.2, 0.35, 0.5, 0.65, 0.8, 0.95};

TEST(Kinematics, TheSpeedIsTheRateOfTheArcLength) {
  const Trajectory path = fine_path(reference("reference_case"));
  for (const double sigma : kPlaces) {
    const TrajectoryPoint before = path.at(sigma - kStep);
    const TrajectoryPoint after = path.at(sigma + kStep);

    const double rate = (after.s - before.s) / (after.t - before.t);

    const double v_c = path.at(sigma).motion.v_c;
    EXPECT_NEAR(rate, v_c, kDifferenceError * v_c) << "at sigma = " << sigma;
  }
}

TEST(Kinematics, TheBodyTurnsWithoutSlip) {
  const Trajectory path = fine_path(reference("reference_case"));
  const Body& body = path.scene().body;
  for (const double sigma : kPlaces) {
    const TrajectoryPoint before = path.at(sigma - kStep);
    const TrajectoryPoint after = path.at(sigma + kStep);

    const double rate = (after.theta - before.theta) / (after.t - before.t);

    const double omega = path.at(sigma).motion.omega;
    EXPECT_NEAR(rate, omega, kDifferenceError * omega);
    EXPECT_NEAR(path.at(sigma).theta,
                body.theta_m + path.at(sigma).s / body.radius, 1e-9);
  }
}

TEST(Kinematics, TheForcesAreNewtonsLawForTheCentreOfMass) {
  // m a_cm = m g ẑ + R_n n + R_t t with t = (cos β, sin β) and n pointing from
  // the track to the centre, (sin β, −cos β): eqs. (20)–(21) once more, the
  // acceleration by differences of positions in time.
  const Trajectory path = fine_path(reference("reference_case"));
  const double g = path.scene().gravity;
  // Second differences over unequal steps: of first order in the inequality
  // of the steps, which is δ; the rest as above. Accelerations are some g.
  const double tolerance = 30.0 * kStep;
  for (const double sigma : kPlaces) {
    const TrajectoryPoint before = path.at(sigma - kStep);
    const TrajectoryPoint at = path.at(sigma);
    const TrajectoryPoint after = path.at(sigma + kStep);
    const double h1 = at.t - before.t;
    const double h2 = after.t - at.t;
    const auto second = [&](double a, double b, double c) {
      return 2.0 * ((c - b) / h2 - (b - a) / h1) / (h1 + h2);
    };

    const double ax =
        second(before.motion.mass_centre.x, at.motion.mass_centre.x,
               after.motion.mass_centre.x) /
        g;
    const double az =
        second(before.motion.mass_centre.z, at.motion.mass_centre.z,
               after.motion.mass_centre.z) /
            g -
        1.0;

    const double along = ax * std::cos(at.beta) + az * std::sin(at.beta);
    const double across = ax * std::sin(at.beta) - az * std::cos(at.beta);
    EXPECT_NEAR(along, at.motion.R_t, tolerance) << "at sigma = " << sigma;
    EXPECT_NEAR(across, at.motion.R_n, tolerance) << "at sigma = " << sigma;
  }
}

TEST(Kinematics, TheCurvatureIsThatOfTheTrack) {
  const Trajectory path = fine_path(reference("reference_case"));
  // Five-point differences of fourth order with steps of 1e-3: second
  // derivatives err by δ⁴ 30⁶/90 of their size, 1e-5, and by 1e-11/δ² from what
  // the mesh leaves of positions between nodes, 1e-5 too.
  constexpr double kWide = 1e-3;
  constexpr double kTolerance = 2e-5;
  for (const double sigma : kPlaces) {
    std::array<Point, 5> p;
    for (std::size_t i = 0; i < p.size(); ++i) {
      p[i] = path.at(sigma + (static_cast<double>(i) - 2.0) * kWide)
                 .motion.contact;
    }
    const auto first = [&](double Point::*c) {
      return (8.0 * (p[3].*c - p[1].*c) - (p[4].*c - p[0].*c)) / 12.0;
    };
    const auto second = [&](double Point::*c) {
      return (16.0 * (p[3].*c + p[1].*c) - (p[4].*c + p[0].*c) -
              30.0 * (p[2].*c)) /
             12.0;
    };
    const double dx = first(&Point::x);
    const double dz = first(&Point::z);

    const double curvature = (dx * second(&Point::z) - dz * second(&Point::x)) /
                             std::pow(dx * dx + dz * dz, 1.5);

    const double kappa_b = path.at(sigma).motion.kappa_b;
    EXPECT_NEAR(curvature, kappa_b,
                kTolerance * std::max(1.0, std::abs(kappa_b)))
        << "at sigma = " << sigma;
  }
}

double polygon_length(const Trajectory& path, int per_element) {
  const std::vector<TrajectoryPoint> rows = path.sample(per_element);
  double length = 0.0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const Point& a = rows[i - 1].motion.contact;
    const Point& b = rows[i].motion.contact;
    length += std::hypot(b.x - a.x, b.z - a.z);
  }
  return length;
}

TEST(RailLength, IsTheLengthOfTheTrackIfItDoesNotFold) {
  for (const auto* row : {&reference("reference_case"), &reference("theta_-30"),
                          &reference("uniform_L3")}) {
    const Trajectory path = fine_path(*row);
    ASSERT_GT(path.diagnose().min_fold_margin.value, 0.0) << row->name;

    // Chords are short by a series in δ²; two of them cancel its first term.
    const double coarse = polygon_length(path, 50);
    const double fine = polygon_length(path, 100);
    const double length = fine + (fine - coarse) / 3.0;

    // The first term itself is `correction`; the next one is smaller by the
    // square of an angle of turn per chord, 30/2000, and then some.
    const double correction = std::abs(fine - coarse);
    EXPECT_NEAR(path.rail_length(), length, 1e-3 * correction + 1e-10)
        << row->name;
  }
}

TEST(Rotation, IsTheArcLengthOverTheRadius) {
  const Trajectory path = fine_path(reference("reference_case"));

  ASSERT_TRUE(path.rotation());
  EXPECT_NEAR(*path.rotation(), path.at(1.0).theta - path.at(0.0).theta, 1e-9);
  EXPECT_FALSE(fine_path(reference("bead_L3")).rotation());
}

TEST(Sampling, NodesAreInOrderFromAToB) {
  const Solution solution = solve(reference("theta_-30").scene(), mesh(5, 20));

  const std::vector<TrajectoryPoint> rows = solution.motion()->at_nodes();

  ASSERT_EQ(rows.size(), 101u);
  EXPECT_EQ(rows.front().u, 0.0);
  EXPECT_EQ(rows.front().t, 0.0);
  EXPECT_DOUBLE_EQ(rows.back().t, solution.motion()->transit_time());
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_GT(rows[i].u, rows[i - 1].u) << i;
    EXPECT_GT(rows[i].t, rows[i - 1].t) << i;
    EXPECT_GT(rows[i].s, rows[i - 1].s) << i;
  }
}

TEST(Diagnostics, SharesOfFrictionFallAsTheThresholdGrows) {
  const PathDiagnostics path =
      fine_path(reference("reference_case")).diagnose();

  EXPECT_GT(path.friction_above_0_3, path.friction_above_0_5);
  EXPECT_GT(path.friction_above_0_5, path.friction_above_1);
  EXPECT_GT(path.friction_above_1, 0.0);
  EXPECT_LT(path.friction_above_0_3, 1.0);
}

TEST(Diagnostics, SharesOfFrictionOfAUniformCylinderAreInClosedForm) {
  // R_n = (2 + k)/(1 + k) sin ψ/2 and R_t = −k/(1 + k) cos ψ/2 on a cycloid,
  // whose ψ is proportional to time: |R_t| > μ R_n up to tan ψ/2 = k/((2 + k)
  // μ) and, with these numbers, not again before the end, ψ = π − 2 β_end.
  const testing::ReferenceValue& row = reference("uniform_L3");
  const double k = row.scene().body.k;
  const double end = std::numbers::pi - 2.0 * row.end_angle;
  const auto share = [&](double mu) {
    return 2.0 * std::atan(k / ((2.0 + k) * mu)) / end;
  };

  const PathDiagnostics path = fine_path(row).diagnose();

  // Forces between nodes are as good as slopes, 1e-7 on this mesh.
  EXPECT_NEAR(path.friction_above_0_3, share(0.3), 1e-6);
  EXPECT_NEAR(path.friction_above_0_5, share(0.5), 1e-6);
  EXPECT_NEAR(path.friction_above_1, share(1.0), 1e-6);
}

TEST(Grip, OfAUniformCylinderIsInClosedForm) {
  // |R_t|/R_n = k/(2 + k) cot ψ/2 as above, which falls up to ψ = π and rises
  // from there on to less than it was at 5 % of the time; none would do at the
  // start, where ψ = 0.
  const testing::ReferenceValue& row = reference("uniform_L3");
  const double k = row.scene().body.k;
  const double end = std::numbers::pi - 2.0 * row.end_angle;

  const PathDiagnostics path = fine_path(row).diagnose();

  EXPECT_EQ(path.least_grip[0].mu, std::numeric_limits<double>::infinity());
  for (std::size_t i = 1; i < path.least_grip.size(); ++i) {
    const auto [share, mu] = path.least_grip[i];
    EXPECT_EQ(share, kGripShares[i]);
    const double known = k / (2.0 + k) / std::tan(0.5 * share * end);
    // Slopes are as good as 1e-7, and forces at the first hundredth of the time
    // are that small.
    EXPECT_NEAR(mu / known, 1.0, 1e-5) << share;
  }
}

TEST(Grip, OfABodyWithoutInertiaIsThatOfItsOffset) {
  // The reaction points through the centre of mass: R_t/R_n = η cos δ/(1 − η
  // sin δ) with δ = θ − β, whose greatest is η/√(1 − η²), at sin δ = η. The
  // body turns more than once. At the start, where both forces vanish, it is
  // less.
  Scene scene = reference("reference_case").scene();
  scene.body = Body::cylinder(scene.body.radius, 0.6, 0.0, 0.0);

  const Solution solution = solve(scene);

  ASSERT_TRUE(solution.verified()) << solution.message;
  for (const LeastGrip& grip : solution.diagnostics->least_grip) {
    EXPECT_NEAR(grip.mu, 0.6 / 0.8, 1e-7) << grip.share_of_time;
  }
}

TEST(Grip, IsNoMoreThanALimitOnFrictionThatIsKept) {
  // R_n comes down to 0 on the way, and |R_t| ≤ μ R_n with it: both are
  // rounding there, of either sign. Elsewhere the limit holds.
  Scene scene;
  scene.L = 14.929;
  scene.H = 1.456;
  scene.body = Body::cylinder(0.2, 0.0, 0.0, 0.6388);
  scene.contact = Contact::EndSlope;
  constexpr double kMu = 0.2165;
  scene.limits.friction = kMu;
  scene.limits.curvature.hump = 1.819;
  scene.limits.curvature.valley = 1.168;
  for (const double end_slope : {0.104, 0.05}) {
    scene.end_slope = end_slope;

    const Solution solution = solve(scene);

    ASSERT_TRUE(solution.verified()) << solution.message;
    EXPECT_LT(solution.diagnostics->min_normal_force.value, 1e-8);
    for (const LeastGrip& grip : solution.diagnostics->least_grip) {
      EXPECT_LE(grip.mu, kMu * (1.0 + 1e-14)) << grip.share_of_time;
      EXPECT_NEAR(grip.mu, kMu, 1e-6) << grip.share_of_time;
    }
  }
}

/// A motion of which forces alone are told, as functions of t = σ.
class MotionOfForces final : public Motion {
 public:
  struct Force {
    double normal, tangential;
  };

  MotionOfForces(std::optional<double> friction, Force (*force)(double))
      : force_(force) {
    scene_.limits.friction = friction;
  }

  [[nodiscard]] const Scene& scene() const override { return scene_; }
  [[nodiscard]] double transit_time() const override { return 1.0; }
  [[nodiscard]] double centre_path_length() const override { return 1.0; }
  [[nodiscard]] double start_angle() const override { return 0.0; }
  [[nodiscard]] double end_angle() const override { return 0.0; }
  [[nodiscard]] StartLimits at_start() const override { return {}; }
  [[nodiscard]] TrajectoryPoint at(double sigma) const override {
    TrajectoryPoint out;
    out.sigma = out.t = out.u = sigma;
    out.motion.R_n = force_(sigma).normal;
    out.motion.R_t = force_(sigma).tangential;
    return out;
  }
  [[nodiscard]] std::vector<TrajectoryPoint> at_nodes() const override {
    return fine_sample(0);
  }
  [[nodiscard]] std::vector<TrajectoryPoint> fine_sample(int) const override {
    std::vector<TrajectoryPoint> rows;
    for (int i = 0; i <= 100; ++i) rows.push_back(at(i / 100.0));
    return rows;
  }

 private:
  Scene scene_;
  Force (*force_)(double);
};

TEST(Grip, OfForcesThatVanishIsThatOfTheLimitAlone) {
  constexpr double kMu = 0.25;
  const auto mu = [](std::optional<double> friction, auto force) {
    return std::tan(
        MotionOfForces(friction, force).friction_angle_after(0.255));
  };
  // R_n touches −3e-8, and friction is within 1e-8 of kMu R_n there.
  const auto kept = [](double t) {
    const double R_n = (t - 0.5) * (t - 0.5) - 3e-8;
    return MotionOfForces::Force{R_n, std::max(kMu * R_n + 9e-9, 0.0)};
  };
  EXPECT_LE(mu(kMu, kept), kMu * (1.0 + 1e-14));
  EXPECT_NEAR(mu(kMu, kept), kMu, 1e-6);
  // A limit that is not kept excuses nothing.
  const auto lost = [](double t) {
    const double R_n = (t - 0.5) * (t - 0.5) - 1e-4;
    return MotionOfForces::Force{R_n, 0.1};
  };
  EXPECT_LT(mu(kMu, lost), 0.0) << "an angle above π/2: none would do";
  EXPECT_LT(mu({}, lost), 0.0);
}

TEST(Grip, IsWhatTheForcesOfADenseTableAskFor) {
  // Of N rows at distances h the greatest ratio is within h²/8
  // max|(|R_t|/R_n)″| of the path's, where it is not the first one after the
  // share.
  const Trajectory path = fine_path(reference("theta_-30"));
  const std::vector<TrajectoryPoint> rows = path.fine_sample(20'000);

  for (const double share : {0.01, 0.05, 0.3}) {
    double greatest = 0.0;
    for (const TrajectoryPoint& row : rows) {
      if (row.t < share * path.transit_time()) continue;
      greatest = std::max(greatest, std::abs(row.motion.R_t) / row.motion.R_n);
    }
    const double mu = std::tan(path.friction_angle_after(share));
    EXPECT_GE(mu, greatest * (1.0 - 1e-12)) << share;
    // The ratio falls like 1/t there, so that the first row, which is later by
    // at most 1/20 000 of the way, has less by as much over the share.
    EXPECT_LE(mu, greatest * (1.0 + 3.0 / 20'000.0 / share)) << share;
  }
}

TEST(Diagnostics, TheFoldMarginOfAValleyExceedsOne) {
  // A cycloid turns upwards all the way: κ_c < 0, and 1 − r κ_c > 1.
  const PathDiagnostics path = fine_path(reference("uniform_L3")).diagnose();

  EXPECT_GT(path.min_fold_margin.value, 1.0);
  EXPECT_LT(path.max_curvature.value, 0.0);
}

TEST(Diagnostics, AreThoseOfThePathAndNotOfTheMesh) {
  // Extremes are minimised between samples; what is left is the error of R_n
  // and κ_b themselves between nodes, of order p: 5 at N = 20.
  constexpr double kTolerance = 1e-4;
  for (const auto* row : {&reference("reference_case"), &reference("fast")}) {
    const PathDiagnostics coarse =
        solve(row->scene(), mesh(5, 20)).motion()->diagnose();
    const PathDiagnostics fine =
        solve(row->scene(), mesh(5, 80)).motion()->diagnose();

    const auto expect_same = [&](const Extreme& a, const Extreme& b) {
      EXPECT_NEAR(a.value, b.value, kTolerance * std::abs(b.value))
          << row->name;
      // At an extreme the value is blind to the place: a root of the tolerance.
      EXPECT_NEAR(a.x, b.x, std::sqrt(kTolerance)) << row->name;
    };
    expect_same(coarse.normal_force_after_rise, fine.normal_force_after_rise);
    expect_same(coarse.max_normal_force, fine.max_normal_force);
    expect_same(coarse.max_curvature, fine.max_curvature);
    expect_same(coarse.curvature_after_rise, fine.curvature_after_rise);
    expect_same(coarse.min_fold_margin, fine.min_fold_margin);
  }
}

/// Friction of the first body changes its sign just where it dips below μ R_n,
/// and the second one's curvature is greatest next to B, between two rows of a
/// coarse mesh. Counted on a table of 1e5 rows, each for its own step.
TEST(Diagnostics, SeeWhatLiesBetweenTheRowsOfACoarseMesh) {
  Scene turning, ending;
  turning.body = Body::cylinder(0.8918315630316677, 0.8615616208020894,
                                -0.37217047577666307, 0.024610221569112575);
  turning.L = 2.3141696141525556;
  turning.H = 3.9072268787366213;
  ending.body = Body::cylinder(0.3495, 0.1223, 0.4412, 0.5855);
  ending.L = 2.497;
  ending.H = 1.0;
  for (const Scene& scene : {turning, ending}) {
    const Solution solution = solve(scene);
    ASSERT_TRUE(solution.verified());
    constexpr int kRows = 100000;
    double above = 0.0, flattest = -1e300, last = 0.0;
    for (int i = 1; i <= kRows; ++i) {
      const TrajectoryPoint at = solution.motion()->at(1.0 * i / kRows);
      if (std::abs(at.motion.R_t) > 0.3 * at.motion.R_n) above += at.t - last;
      last = at.t;
      flattest = std::max(flattest, at.motion.kappa_b);
    }

    const PathDiagnostics& path = *solution.diagnostics;
    // Four changes of the sign, each found to a step.
    EXPECT_NEAR(path.friction_above_0_3, above / last, 4.0 * 2.0 / kRows);
    if (path.min_fold_margin.value > 0.0) {
      EXPECT_NEAR(path.max_curvature.value, flattest, 1e-6);
    }
  }
}

TEST(Diagnostics, TheNormalForceRisesFromItsLimitAtTheStart) {
  const Trajectory path = fine_path(reference("reference_case"));
  const PathDiagnostics found = path.diagnose();

  EXPECT_EQ(found.min_normal_force.value, 0.0);
  EXPECT_TRUE(found.min_normal_force.at_start);
  EXPECT_FALSE(found.max_normal_force.at_start);
  EXPECT_FALSE(found.at_start.lifts_off());
  EXPECT_NEAR(found.min_curvature.value, -3.0, 1e-15);
  EXPECT_TRUE(found.min_curvature.at_start);
}

TEST(Diagnostics, TheNormalForceAfterItsFirstRiseIsThatOfADenseSample) {
  const Trajectory path = fine_path(reference("reference_case"));
  const PathDiagnostics found = path.diagnose();
  std::vector<double> forces;
  for (int i = 0; i <= 20000; ++i) {
    forces.push_back(path.at(i / 20000.0).motion.R_n);
  }
  std::size_t first = 1;
  while (forces[first + 1] > forces[first]) ++first;
  const double expected = *std::min_element(
      forces.begin() + static_cast<std::ptrdiff_t>(first), forces.end());

  // A sample misses the minimum by its step squared, times some 30².
  EXPECT_NEAR(found.normal_force_after_rise.value, expected, 1e-5);
  EXPECT_GT(found.normal_force_after_rise.value, 0.1);
  EXPECT_LT(forces[1], 0.01);
}

TEST(Diagnostics, AForceThatOnlyRisesFromTheStartIsSmallestAtTheEnd) {
  // A bead: R_n = 2 cos β rises to 2 at the lowest point, then falls to 2 cos
  // φ.
  const Trajectory path = fine_path(reference("bead_L3"));

  const PathDiagnostics found = path.diagnose();

  EXPECT_NEAR(found.normal_force_after_rise.value,
              2.0 * std::cos(path.end_angle()), 1e-9);
  EXPECT_NEAR(found.normal_force_after_rise.x, 3.0, 1e-9);
  EXPECT_NEAR(found.max_normal_force.value, 2.0, 1e-9);
  EXPECT_EQ(found.min_curvature.value,
            -std::numeric_limits<double>::infinity());
}

TEST(Diagnostics, SeeNoCrossingWhereNoneIs) {
  EXPECT_FALSE(fine_path(reference("reference_case")).diagnose().self_crossing);
}

TEST(Diagnostics, ABeadOnItsCycloidPressesWithTwiceTheNormalWeight) {
  // On a cycloid from its cusp v² = 2 g z and the radius of curvature is
  // 4 a cos β, so that v²/(ρ g) = cos β too and R_n = 2 cos β.
  const Trajectory path = fine_path(reference("bead_L3"));
  for (const double sigma : kPlaces) {
    const TrajectoryPoint at = path.at(sigma);

    EXPECT_NEAR(at.motion.R_n, 2.0 * std::cos(at.beta), 1e-9);
  }
}

}  // namespace
}  // namespace brachisto
