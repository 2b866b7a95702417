// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/cycloid.hpp"

#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "support/random_points.hpp"
#include "support/reference_values.hpp"
#include "support/rounding.hpp"
#include "support/scenes.hpp"

namespace brachisto::testing {
namespace {

/// What a rounding of ψ, a and φ by a few ε does to a figure of order one: the
/// root φ of an equation whose terms are of the size of its slope, then half a
/// dozen operations.
constexpr double kRoundings = 16.0;

class ClosedForm : public ::testing::TestWithParam<ReferenceValue> {};

TEST_P(ClosedForm, HasTheReferenceFigures) {
  const ReferenceValue& row = GetParam();
  const Scene scene = row.scene();

  const std::optional<CycloidArc> arc = axisymmetric_optimum(scene);

  ASSERT_TRUE(arc);
  const double end_angle = arc->slope_angle(arc->psi_end);
  const double T =
      arc->rolling_time(scene.gravity) * std::sqrt(1.0 + scene.body.k);
  const double tau = T * std::sqrt(2.0 * scene.gravity / scene.H);
  const double length = arc->arc_length(arc->psi_end);
  const double rail =
      length + scene.body.radius * (row.start_angle - end_angle);
  EXPECT_NEAR(tau, row.tau, ulps(kRoundings, row.tau));
  EXPECT_NEAR(length, row.centre_path_length,
              ulps(kRoundings, row.centre_path_length));
  EXPECT_NEAR(rail, row.rail_length, ulps(kRoundings, row.rail_length));
  EXPECT_NEAR(arc->slope_angle(0.0), row.start_angle, ulps(1.0, 2.0));
  EXPECT_NEAR(end_angle, row.end_angle, ulps(kRoundings));
}

std::vector<ReferenceValue> closed_form_rows() {
  std::vector<ReferenceValue> rows;
  for (const ReferenceValue& row : kReferenceValues) {
    if (row.source == Source::ClosedForm) rows.push_back(row);
  }
  return rows;
}

INSTANTIATE_TEST_SUITE_P(ReferenceValues, ClosedForm,
                         ::testing::ValuesIn(closed_form_rows()),
                         [](const auto& row) {
                           return std::string(row.param.name);
                         });

TEST(AxisymmetricOptimum, OfHalfACycloidTakesPiRootOfThreeOverTwoG) {
  // B = (r + π, r + 2) puts the end of the centre at the bottom of a cycloid
  // with a = 1, where the track is level.
  for (const double r : {0.1, 1.0 / 3.0, 2.0, 10.0}) {
    Scene scene = scene_of(Body::cylinder(r, 0.0, 0.0, 0.5));
    scene.L = r + kPi;
    scene.H = r + 2.0;

    const auto arc = axisymmetric_optimum(scene);

    ASSERT_TRUE(arc) << "r " << r;
    const double T = arc->rolling_time(scene.gravity) * std::sqrt(1.5);
    const double scale = 1.0 + r;  // L − r and H − r round like r
    EXPECT_NEAR(T, kPi * std::sqrt(1.5 / scene.gravity),
                ulps(kRoundings, scale))
        << "r " << r;
    EXPECT_NEAR(arc->a, 1.0, ulps(kRoundings, scale)) << "r " << r;
    EXPECT_NEAR(arc->psi_end, kPi, ulps(kRoundings, scale)) << "r " << r;
  }
}

/// Exact x or z gained by the arc, from its rounded a and ψ.
Point exact_reach(const CycloidArc& arc) {
  const Wide psi = arc.psi_end;
  const Wide x = arc.a * (psi - sin(psi));
  const Wide z = arc.a * (1 - cos(psi));
  return {x.convert_to<double>(), z.convert_to<double>()};
}

/// What a few roundings of a and ψ do to the end of an arc: with dx/dψ =
/// a (1 − cos ψ) and dz/dψ = a sin ψ.
Point reach_error(const CycloidArc& arc, double roundings) {
  const Point reach = exact_reach(arc);
  const double psi = arc.psi_end;
  return {ulps(roundings, reach.x + psi * reach.z),
          ulps(roundings, reach.z + arc.a * psi * std::abs(std::sin(psi)))};
}

TEST(CycloidBetween, EndsAtTheEndForAllRatios) {
  for (double ratio = 1e-6; ratio < 2e6; ratio *= std::sqrt(10.0)) {
    for (const double dz : {1e-3, 1.0, 1e4}) {
      const double dx = ratio * dz;

      const auto arc = cycloid_between({0.0, 0.0}, {dx, dz});

      ASSERT_TRUE(arc) << "ratio " << ratio;
      const Point reach = exact_reach(*arc);
      const Point error = reach_error(*arc, kRoundings);
      EXPECT_NEAR(reach.x, dx, error.x) << "ratio " << ratio << " dz " << dz;
      EXPECT_NEAR(reach.z, dz, error.z) << "ratio " << ratio << " dz " << dz;
      EXPECT_GT(arc->psi_end, 0.0);
      EXPECT_LT(arc->psi_end, 2.0 * kPi);
    }
  }
}

TEST(CycloidBetween, ApproachesItsLimitsAtExtremeRatios) {
  const auto narrow = cycloid_between({0.0, 0.0}, {1e-6, 1.0});
  const auto wide = cycloid_between({0.0, 0.0}, {1e6, 1.0});

  ASSERT_TRUE(narrow);
  ASSERT_TRUE(wide);
  // dx/dz = ψ/3 (1 + ψ²/60 + …) for small ψ.
  EXPECT_NEAR(narrow->psi_end, 3e-6, 3e-6 * 1e-12);
  // dx = 2 π a and dz = a (2π − ψ)²/2 to relative order 2π − ψ, so that
  // 2π − ψ = √(4π dz/dx); the next order is its square.
  const double gap = std::sqrt(4.0 * kPi * 1e-6);
  EXPECT_NEAR(2.0 * kPi - wide->psi_end, gap, gap * gap);
}

TEST(CycloidBetween, NeedsAnEndToTheRightAndBelow) {
  EXPECT_FALSE(cycloid_between({0.0, 0.0}, {0.0, 1.0}));
  EXPECT_FALSE(cycloid_between({0.0, 0.0}, {-1.0, 1.0}));
  EXPECT_FALSE(cycloid_between({0.0, 0.0}, {1.0, 0.0}));
  EXPECT_FALSE(cycloid_between({0.0, 2.0}, {1.0, 1.0}));
  EXPECT_FALSE(cycloid_between({0.0, 0.0}, {std::nan(""), 1.0}));
}

TEST(CycloidArc, DescribesOneMotion) {
  using Quadrature = boost::math::quadrature::gauss<double, 30>;
  const CycloidArc arc{{0.2, -0.3}, 0.8, 4.5};
  const double g = 9.81;
  for (const double psi : {1e-4, 0.3, 0.5, 1.0, 3.0, 4.5}) {
    // dx/dψ = a (1 − cos ψ), dz/dψ = a sin ψ.
    const auto speed = [&](double q) {
      return arc.a * std::hypot(1.0 - std::cos(q), std::sin(q));
    };

    const Point point = arc.at(psi);

    EXPECT_NEAR(point.x, 0.2 + 0.8 * (psi - std::sin(psi)), ulps(4.0, 4.0));
    EXPECT_NEAR(point.z, -0.3 + 0.8 * (1.0 - std::cos(psi)), ulps(4.0, 4.0));
    // 1 − cos ψ is off by ε/2, which turns the direction by that over ψ.
    EXPECT_NEAR(arc.slope_angle(psi),
                std::atan2(std::sin(psi), 1.0 - std::cos(psi)),
                ulps(4.0, 1.0 + 1.0 / psi));
    // Thirty points integrate 2 a sin ψ/2 to rounding; what they sum is off by
    // ε/ψ as above.
    EXPECT_NEAR(arc.arc_length(psi), Quadrature::integrate(speed, 0.0, psi),
                ulps(8.0, 2.0 * arc.a * psi));
    EXPECT_NEAR(std::pow(arc.fall_speed(g, psi), 2),
                2.0 * g * arc.a * (1.0 - std::cos(psi)), ulps(8.0, 4.0 * g));
  }
  // u = ∫ ds/w with ds = 2 a sin ψ/2 dψ and w = 2 √(g a) sin ψ/2.
  EXPECT_NEAR(arc.rolling_time(g), arc.psi_end * std::sqrt(arc.a / g),
              ulps(4.0, arc.rolling_time(g)));
}

TEST(CycloidArc, KeepsRelativeAccuracyNextToTheCusp) {
  const CycloidArc arc{{0.0, 0.0}, 1.0, 3.0};
  for (double psi = 1e-12; psi < 1.0; psi *= 3.0) {
    const Wide exact_psi = psi;

    const Point point = arc.at(psi);

    // Three roundings, and those of the ten terms of a series of which the
    // first is by far the largest; above the series, ψ − sin ψ ≥ ψ³/7 loses
    // the ulp of ψ, 7/ψ² of its own.
    const double cancelled = psi > 0.5 ? 7.0 / (psi * psi) : 0.0;
    EXPECT_LE(abs(point.x / (exact_psi - sin(exact_psi)) - 1),
              ulps(4.0 + cancelled))
        << "ψ " << psi;
    EXPECT_LE(abs(point.z / (1 - cos(exact_psi)) - 1), ulps(4.0))
        << "ψ " << psi;
  }
}

/// C_B(φ) is where the arc ends, with φ the slope it ends with.
///
/// φ is what is solved for, so the arc can be no better than a φ that is off
/// by ε φ makes it. With c = cos φ, a = (H − r c)/(2 c²) and ψ = π − 2 φ:
/// the numerator of a moves by ε (H + r (1 + |φ|)), its denominator by
/// 2 ε |φ tan φ| of itself, ψ by ε π.
void expect_smooth_contact(const Scene& scene, const CycloidArc& arc) {
  constexpr double kCount = 4.0;  // roundings of each kind
  const double phi = arc.slope_angle(arc.psi_end);
  const double r = scene.body.radius;
  const double c = std::cos(phi);
  const Point reach = exact_reach(arc);
  const double numerator = scene.H + r * (1.0 + 0.5 * kPi);
  const double per_a = reach.x / arc.a;  // dx/da = ψ − sin ψ
  const double x_size = per_a * numerator / (2.0 * c * c) +
                        reach.x * kPi * std::abs(std::tan(phi)) + scene.L + r;
  const double z_size =
      numerator + arc.a * kPi * std::abs(std::sin(arc.psi_end));

  const Point end = end_of_centre(scene, phi);
  EXPECT_NEAR(r + reach.x, end.x, ulps(kCount, x_size));
  EXPECT_NEAR(reach.z, end.z, ulps(kCount, z_size));
}

TEST(AxisymmetricOptimum, ClosesTheContactInAnyScene) {
  constexpr std::uint32_t kSeed = 7;
  Random random(kSeed);
  for (int sample = 0; sample < 500; ++sample) {
    Scene scene = uniform_scene();
    scene.L = std::exp(random.uniform(-4.0, 6.0));
    scene.H = std::exp(random.uniform(-3.0, 3.0));
    scene.body.radius = scene.H * random.uniform(0.01, 0.99);
    SCOPED_TRACE(::testing::Message()
                 << "seed " << kSeed << " sample " << sample << " L " << scene.L
                 << " H " << scene.H << " r " << scene.body.radius);

    const auto arc = axisymmetric_optimum(scene);

    ASSERT_TRUE(arc);
    expect_smooth_contact(scene, *arc);
  }
}

TEST(AxisymmetricOptimum, ExistsIffBLiesOutsideTheBodyAtItsStart) {
  // That is (L − r)² + H² > r²: for r ≥ H there is a gap of distances L between
  // r − √(r² − H²) and r + √(r² − H²), and none for r < H.
  constexpr double kMargin = 1e-6;
  for (const double r : {1.0 + 1e-3, 1.5, 4.0}) {
    Scene scene = scene_of(Body::cylinder(r, 0.0, 0.0, 0.5));
    const double half_gap = std::sqrt(r * r - 1.0);
    for (const double inside : {-1.0 + kMargin, -0.5, 0.0, 1.0 - kMargin}) {
      scene.L = r + inside * half_gap;
      EXPECT_FALSE(axisymmetric_optimum(scene)) << "r " << r << " " << inside;
    }
    for (const double outside : {1e-3, 0.1, 3.0}) {
      SCOPED_TRACE(::testing::Message() << "r " << r << " beyond " << outside);
      scene.L = r + half_gap + outside;
      const auto arc = axisymmetric_optimum(scene);
      ASSERT_TRUE(arc);
      expect_smooth_contact(scene, *arc);
      EXPECT_GT(arc->a, 0.0);
    }
    for (const double share : {0.01, 0.5, 0.99}) {
      // B below A on its near side: the body ends rolling down, φ > 0.
      SCOPED_TRACE(::testing::Message() << "r " << r << " before " << share);
      scene.L = share * (r - half_gap);
      const auto arc = axisymmetric_optimum(scene);
      ASSERT_TRUE(arc);
      expect_smooth_contact(scene, *arc);
      EXPECT_GT(arc->slope_angle(arc->psi_end), 0.0);
    }
  }
}

TEST(AxisymmetricOptimum, HasOnlyOneRoot) {
  // The equation of the closed form, sampled: one change of sign.
  constexpr int kSamples = 4000;
  for (const double r : {0.2, 1.0, 2.0}) {
    for (const double L : {0.05, 0.2, 4.0, 30.0}) {
      Scene scene = scene_of(Body::cylinder(r, 0.0, 0.0, 0.5));
      scene.L = L;
      if ((L - r) * (L - r) + 1.0 <= r * r) continue;
      int roots = 0;
      double before = 0.0;
      for (int i = 1; i < kSamples; ++i) {
        const double phi = kPi * (static_cast<double>(i) / kSamples - 0.5);
        const double c = std::cos(phi);
        const double s = std::sin(phi);
        const double value =
            (scene.H - r * c) * (kPi - 2.0 * phi - std::sin(2.0 * phi)) -
            2.0 * c * c * (L - r + r * s);
        if (before * value < 0.0) ++roots;
        before = value;
      }

      EXPECT_EQ(roots, 1) << "r " << r << " L " << L;
    }
  }
}

TEST(AxisymmetricOptimum, OfCentrePointsIsTheCycloidBetweenThem) {
  Scene scene = uniform_scene();
  scene.contact = Contact::Centre;

  const auto arc = axisymmetric_optimum(scene);
  const auto between = cycloid_between({0.0, 0.0}, {scene.L, scene.H});

  ASSERT_TRUE(arc && between);
  EXPECT_EQ(arc->a, between->a);
  EXPECT_EQ(arc->psi_end, between->psi_end);
}

TEST(AxisymmetricOptimum, BeatsTheStraightLine) {
  const Scene scene = bead_scene();

  const auto arc = axisymmetric_optimum(scene);

  // Down an incline of length ℓ: T = ℓ √(2/(g H)).
  ASSERT_TRUE(arc);
  const double straight =
      std::hypot(scene.L, scene.H) * std::sqrt(2.0 / (scene.gravity * scene.H));
  EXPECT_LT(arc->rolling_time(scene.gravity), straight);
}

/// Half of ψ_end and the radius a of the optimum, by bisection of its equation
/// in α = π − ψ/2, the angle by which the track at B falls short of vertical:
///
///     (H − r sin α)(ψ − sin ψ) = 2 sin²α (L − r − r cos α).
struct WideOptimum {
  Wide alpha, a;
};

WideOptimum wide_optimum(const Scene& scene) {
  const Wide r = scene.body.radius, L = scene.L, H = scene.H;
  const Wide pi = boost::math::constants::pi<Wide>();
  const auto reach = [&](const Wide& alpha) -> Wide {
    return L - r - r * cos(alpha);
  };
  const auto share = [&](const Wide& alpha) -> Wide {
    return 2 * (pi - alpha) + sin(2 * alpha);
  };
  const auto mismatch = [&](const Wide& alpha) -> Wide {
    const Wide s = sin(alpha);
    return (H - r * s) * share(alpha) - 2 * s * s * reach(alpha);
  };
  Wide low = 0;
  Wide high = r < H ? pi / 2 : Wide(asin(H / r));
  for (int i = 0; i < 400; ++i) {
    const Wide middle = (low + high) / 2;
    (mismatch(middle) > 0 ? low : high) = middle;
  }
  return {low, reach(low) / share(low)};
}

TEST(AxisymmetricOptimum, IsFoundHoweverLittleBLiesBelowA) {
  // The track leads up to B at α below the vertical, α ≈ H/r.
  for (const double r : {1e-6, 1.0 / 3.0, 1.4}) {
    for (double H = 1e-3; H > 1e-45; H *= 1e-3) {
      Scene scene = uniform_scene();
      scene.body.radius = r;
      scene.H = H;
      const WideOptimum exact = wide_optimum(scene);

      const auto arc = axisymmetric_optimum(scene);

      ASSERT_TRUE(arc) << "r " << r << " H " << H;
      const double alpha = exact.alpha.convert_to<double>();
      const double a = exact.a.convert_to<double>();
      EXPECT_NEAR(arc->psi_end, 2.0 * (kPi - alpha), ulps(4.0, 2.0 * kPi))
          << "r " << r << " H " << H;
      EXPECT_NEAR(arc->a, a, ulps(8.0, scene.L)) << "r " << r << " H " << H;
    }
  }
}

TEST(AxisymmetricOptimum, FallsAlmostStraightToANearB) {
  // a = L/(ψ − sin ψ) and H = a (1 − cos ψ): ψ ≈ 3 L/H, T = √(2H/g) then.
  for (double L = 1e-3; L > 1e-45; L *= 1e-3) {
    Scene scene = bead_scene();
    scene.L = L;

    const auto arc = axisymmetric_optimum(scene);

    ASSERT_TRUE(arc) << "L " << L;
    EXPECT_NEAR(arc->psi_end / (3.0 * L), 1.0, L * L + ulps(8.0)) << "L " << L;
    EXPECT_NEAR(arc->rolling_time(scene.gravity) *
                    std::sqrt(0.5 * scene.gravity / scene.H),
                1.0, L * L + ulps(8.0))
        << "L " << L;
  }
}

TEST(CycloidBetween, EndsAtTheEndForRatiosBeyondAllMeasure) {
  for (const double ratio : {1e-50, 1e-20, 1e20, 1e50}) {
    const auto arc = cycloid_between({0.0, 0.0}, {ratio, 1.0});

    ASSERT_TRUE(arc) << ratio;
    const Point end = arc->at(arc->psi_end);
    EXPECT_NEAR(end.x / ratio, 1.0, ulps(kRoundings)) << ratio;
    // Where ψ_end cannot be told from 2π, the end cannot from a cusp.
    if (ratio > 1.0) continue;
    EXPECT_NEAR(end.z, 1.0, ulps(kRoundings)) << ratio;
  }
}

}  // namespace
}  // namespace brachisto::testing
