// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// One text of the rolling body for numbers of two precisions, for four numbers
// at once, for jets and for intervals.

#include "support/scalars.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "extremal/arc_boundary.hpp"
#include "model/path_inequality.hpp"
#include "model/units.hpp"
#include "ocp/flow.hpp"
#include "ocp/integration.hpp"
#include "rolling/rolling_body.hpp"
#include "support/random_points.hpp"
#include "support/world_scenes.hpp"

namespace brachisto::testing {
namespace {

using rolling::Steered;
using rolling::Turning;

constexpr unsigned kPointSeed = 20260411;
// Some ten operations on numbers of order one.
constexpr double kFormulaRounding = 1e-14;

Scene in_all_of_the_world() {
  Scene scene =
      in_air(with_push(about_sphere(off_centred_scene(0.4), around()), 0.7),
             0.1, 0.05);
  scene.limits.friction = 0.6;
  scene.limits.normal_max = 3.0;
  scene.limits.curvature = {3.0, 2.0, CurvatureLimit::Of::Centre};
  scene.limits.floor = 1.4;
  scene.limits.discs = {{{1.5, 1.3}, 0.3}};
  scene.limits.half_planes = {{{1.5, 1.2}, -1.4}};
  scene = in_natural_units(scene);
  scene.world.side = FieldSide::Inside;
  return scene;
}

template <class Body>
Body described(const Scene& scene) {
  return {scene, inequalities(scene.body, scene.limits),
          1.0 / scene.body.radius};
}

template <class Problem>
ocp::PointOf<Problem, double> random_point(Random& random) {
  ocp::PointOf<Problem, double> yu{
      random.uniform(0.1, 0.9), random.uniform(0.1, 0.3),
      random.uniform(-1.0, 6.0), random.uniform(0.3, 0.6),
      random.uniform(-0.5, 1.2)};
  if constexpr (Problem::kStates == 5) yu[5] = random.uniform(-1.0, 1.0);
  return yu;
}

/// L, f and all limits at a point, as a row.
template <class Problem, class Scalar>
std::vector<Scalar> all_of(const Problem& problem,
                           const ocp::PointOf<Problem, Scalar>& yu) {
  const auto rates = problem.rates(yu);
  std::vector<Scalar> out{rates.cost};
  out.insert(out.end(), rates.states.begin(), rates.states.end());
  for (std::size_t i = 0; i < problem.num_limits(); ++i) {
    // Of what does not bound the control the steered body knows the rate.
    if (Problem::kStates == 4 && problem.limits()[i].bounds_control()) continue;
    out.push_back(problem.limit(i, yu));
  }
  return out;
}

template <class Scalar, class Problem>
ocp::PointOf<Problem, Scalar> converted(
    const Problem&, const ocp::PointOf<Problem, double>& yu) {
  ocp::PointOf<Problem, Scalar> out;
  for (std::size_t i = 0; i < yu.size(); ++i) out[i] = Scalar(yu[i]);
  return out;
}

template <class Problem>
class PointFunctionOf : public ::testing::Test {};
using Problems = ::testing::Types<Steered, Turning>;
TYPED_TEST_SUITE(PointFunctionOf, Problems);

TYPED_TEST(PointFunctionOf, IsTheSameForLongDoublesLanesAndIntervals) {
  const auto problem = described<TypeParam>(in_all_of_the_world());
  Random random(kPointSeed);
  for (int trial = 0; trial < 20; ++trial) {
    std::array<ocp::PointOf<TypeParam, double>, 4> points;
    for (auto& yu : points) yu = random_point<TypeParam>(random);
    ocp::PointOf<TypeParam, Lanes> at_once;
    for (std::size_t i = 0; i < at_once.size(); ++i) {
      for (std::size_t l = 0; l < 4; ++l) at_once[i].lane[l] = points[l][i];
    }

    const auto lanes = all_of(problem, at_once);

    for (std::size_t l = 0; l < 4; ++l) {
      const auto plainly = all_of(problem, points[l]);
      const auto precisely =
          all_of(problem, converted<long double>(problem, points[l]));
      const auto within =
          all_of(problem, converted<Interval>(problem, points[l]));
      ASSERT_EQ(plainly.size(), lanes.size());
      for (std::size_t i = 0; i < plainly.size(); ++i) {
        const double size = 1.0 + std::abs(plainly[i]);
        EXPECT_EQ(lanes[i].lane[l], plainly[i]) << i;
        EXPECT_NEAR(static_cast<double>(precisely[i]), plainly[i],
                    kFormulaRounding * size)
            << i;
        EXPECT_TRUE(within[i].contains(static_cast<double>(precisely[i]))) << i;
        EXPECT_LE(within[i].width(), 10.0 * kFormulaRounding * size) << i;
      }
    }
  }
}

/// The interval of a box has the values at its corners, and is not much wider.
TYPED_TEST(PointFunctionOf, EnclosesABoxByIntervals) {
  constexpr double kHalf = 1e-3, kMostStretch = 200.0;
  const auto problem = described<TypeParam>(in_all_of_the_world());
  Random random(kPointSeed);
  const auto centre = random_point<TypeParam>(random);
  ocp::PointOf<TypeParam, Interval> box;
  for (std::size_t i = 0; i < box.size(); ++i) {
    box[i] = Interval(centre[i] - kHalf, centre[i] + kHalf);
  }

  const auto enclosed = all_of(problem, box);

  for (int trial = 0; trial < 200; ++trial) {
    auto inside = centre;
    for (double& x : inside) x += random.uniform(-kHalf, kHalf);
    const auto values = all_of(problem, inside);
    for (std::size_t i = 0; i < values.size(); ++i) {
      EXPECT_TRUE(enclosed[i].contains(values[i])) << i;
    }
  }
  for (const Interval& value : enclosed) {
    EXPECT_LE(value.width(), kMostStretch * kHalf);
  }
}

/// The closed forms of the steered body in a uniform field are what jets are.
TEST(SteeredFalling, HasTheDerivativesThatJetsHave) {
  using rolling::SteeredFalling;
  using Jet = math::Jet2<double, 5>;
  Random random(kPointSeed);
  for (const double eta : {0.0, 0.4, 0.95}) {
    const Scene scene = in_natural_units(off_centred_scene(0.4));
    Scene with = scene;
    with.body.eta_m = eta;
    const SteeredFalling problem(with, {}, 1.0 / with.body.radius);
    const ocp::Flow<SteeredFalling> closed(problem);
    const ocp::Flow<Steered> by_jets{Steered(with, {}, 1.0 / with.body.radius)};
    for (int trial = 0; trial < 20; ++trial) {
      const auto yu = random_point<Steered>(random);
      const auto expected = problem.rates(ocp::as_variables<Jet>(yu));
      const auto found = problem.jets<Jet>(yu);
      const auto expect_same = [](const Jet& a, const Jet& b) {
        EXPECT_NEAR(a.value, b.value, kFormulaRounding);
        for (std::size_t i = 0; i < a.gradient.size(); ++i) {
          EXPECT_NEAR(a.gradient[i], b.gradient[i], kFormulaRounding) << i;
        }
        for (std::size_t i = 0; i < a.hessian.size(); ++i) {
          EXPECT_NEAR(a.hessian[i], b.hessian[i], 10.0 * kFormulaRounding) << i;
        }
      };
      expect_same(found.cost, expected.cost);
      for (std::size_t i = 0; i < 4; ++i) {
        expect_same(found.states[i], expected.states[i]);
      }
      std::array<double, 8> y;
      std::copy_n(yu.begin(), 4, y.begin());
      for (std::size_t i = 4; i < 8; ++i) y[i] = random.uniform(-1.0, 1.0);
      const auto h = closed.by_control(y, yu[4]);
      const auto by = by_jets.by_control(y, yu[4]);
      EXPECT_NEAR(h.first, by.first, 10.0 * kFormulaRounding);
      EXPECT_NEAR(h.second, by.second, 10.0 * kFormulaRounding);
    }
  }
}

/// A way through the integrator with these numbers.
template <class Scalar>
typename ocp::Flow<Steered, Scalar>::State integrated(
    const Scene& scene,
    const typename ocp::Flow<Steered, Scalar>::State& start) {
  using Flow = ocp::Flow<Steered, Scalar>;
  using Rates = ocp::FlowRates<Flow, true>;
  const Flow flow(described<Steered>(scene));
  ocp::AdaptiveIntegration<Rates> path(Rates{flow, Scalar(0.8)},
                                       Rates::stack_of(start));
  double step = 0.0;
  EXPECT_TRUE(ocp::advance(path, 0.3, {}, step, [](double) {}));
  return Rates::state_of(path.now());
}

constexpr std::array<double, 8> kStart{0.1,  0.2, 0.5,  0.6,
                                       -0.8, 0.1, 0.02, -0.9};

TEST(Integration, IsTheSameForLongDoublesAndLanes) {
  // A few steps of 1e-13 each, which differ in length.
  constexpr double kSteps = 1e-11;
  const Scene scene = in_all_of_the_world();
  std::array<std::array<double, 8>, 4> starts;
  starts.fill(kStart);
  std::array<long double, 8> precise;
  std::array<Lanes, 8> lanes;
  for (std::size_t i = 0; i < 8; ++i) {
    for (std::size_t l = 0; l < 4; ++l) {
      starts[l][i] *= 1.0 + 0.02 * static_cast<double>(l);
      lanes[i].lane[l] = starts[l][i];
    }
    precise[i] = kStart[i];
  }

  const auto by_lanes = integrated<Lanes>(scene, lanes);
  const auto precisely = integrated<long double>(scene, precise);

  for (std::size_t l = 0; l < 4; ++l) {
    const auto alone = integrated<double>(scene, starts[l]);
    for (std::size_t i = 0; i < 8; ++i) {
      EXPECT_NEAR(by_lanes[i].lane[l], alone[i], kSteps) << i << ", lane " << l;
      if (l > 0) continue;
      EXPECT_NEAR(static_cast<double>(precisely[i]), alone[i], kSteps) << i;
    }
  }
}

/// What is left of the equations of one free arc: at A, after it, and at B.
template <class Scalar>
std::vector<Scalar> shooting_residual(
    const Scene& scene, const typename ocp::Flow<Steered, Scalar>::State& start,
    Scalar beta) {
  const arcs::Departure leave(scene, std::nullopt, 0.8);
  const auto values = [](const auto& y, const Scalar& slope) {
    return arcs::Values<Scalar>{y[0], y[1], y[2], y[3], slope,
                                y[4], y[5], y[6], y[7], Scalar(0.0)};
  };
  std::vector<Scalar> out = leave.conditions(values(start, beta));
  const auto end = integrated<Scalar>(scene, start);
  for (const Scalar& row :
       arcs::end_conditions(scene, values(end, beta), false)) {
    out.push_back(row);
  }
  return out;
}

TEST(ShootingResidual, IsTheSameForLongDoublesAndLanes) {
  constexpr double kSteps = 1e-11, kBeta = 0.8;
  const Scene scene = in_all_of_the_world();
  std::array<long double, 8> precise;
  std::array<Lanes, 8> lanes;
  for (std::size_t i = 0; i < 8; ++i) {
    precise[i] = kStart[i];
    lanes[i] = Lanes(kStart[i]);
  }

  const auto alone = shooting_residual<double>(scene, kStart, kBeta);
  const auto by_lanes = shooting_residual<Lanes>(scene, lanes, Lanes(kBeta));
  const auto precisely = shooting_residual<long double>(scene, precise, kBeta);

  ASSERT_EQ(alone.size(), 8U);
  for (std::size_t i = 0; i < alone.size(); ++i) {
    EXPECT_NEAR(by_lanes[i].lane[3], alone[i], kSteps) << i;
    EXPECT_NEAR(static_cast<double>(precisely[i]), alone[i], kSteps) << i;
  }
}

}  // namespace
}  // namespace brachisto::testing
