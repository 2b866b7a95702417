// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/rolling_time.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <set>

#include "brachisto/math/index.hpp"
#include "model/start_angle.hpp"
#include "support/numbers.hpp"
#include "support/random_points.hpp"
#include "support/rounding.hpp"
#include "support/scenes.hpp"

namespace brachisto::testing {
namespace {

using enum StateComponent;

TEST(RollingTimeSize, OfAnOffCentredBodyFollowsFromItsFourStates) {
  for (int p = 1; p <= 8; ++p) {
    for (const int N : {1, 3, 10}) {
      const RollingTime problem(off_centred_scene(), uniform_mesh(p, N), 0.0);
      const int points = N * p;

      // x, z, θ, w at the nodes, β at the points, U.
      EXPECT_EQ(problem.num_variables(), 4 * (points + 1) + points + 1);
      EXPECT_EQ(problem.num_constraints(), 4 * points);
      // Per point: four differences over p + 1 nodes; the rates of x, z, θ
      // depend on w and that of w on θ, each at p + 1 nodes; x, z, w on β; all
      // four on U.
      EXPECT_EQ(problem.jac_g_pattern().num_entries(),
                at(points * (8 * (p + 1) + 7)));
      // Per element: θθ, a triangle over the nodes; wβ and θβ; ββ, diagonal,
      // for each point has its own; wU and θU; βU.
      EXPECT_EQ(problem.hess_lag_pattern().num_entries(),
                at(N * ((p + 1) * (p + 2) / 2 + 2 * p * (p + 1) + p +
                        2 * (p + 1) + p)));
    }
  }
}

TEST(RollingTimeSize, OfACentredBodyFollowsFromItsThreeStates) {
  for (const Scene& scene : {bead_scene(), uniform_scene()}) {
    for (int p = 1; p <= 8; ++p) {
      for (const int N : {1, 3, 10}) {
        const RollingTime problem(scene, uniform_mesh(p, N), 0.0);
        const int points = N * p;

        EXPECT_EQ(problem.num_variables(), 3 * (points + 1) + points + 1);
        EXPECT_EQ(problem.num_constraints(), 3 * points);
        // As above without θ: the rates of x and z depend on w, that of w on no
        // state.
        EXPECT_EQ(problem.jac_g_pattern().num_entries(),
                  at(points * (5 * (p + 1) + 6)));
        EXPECT_EQ(problem.hess_lag_pattern().num_entries(),
                  at(N * (p * (p + 1) + p + (p + 1) + p)));
      }
    }
  }
}

void expect_same_ranges(const RollingTime& one, const RollingTime& other) {
  for (int i = 0; i < one.num_variables(); ++i) {
    const nlp::Range range = one.variable_range(i);
    EXPECT_EQ(range.lower, other.variable_range(i).lower) << i;
    EXPECT_EQ(range.upper, other.variable_range(i).upper) << i;
  }
}

TEST(RollingTimeBounds, FixTheStartAndTheEndOfTheCentreAndNothingElse) {
  for (const Scene& scene :
       {bead_scene(), uniform_scene(), off_centred_scene(-0.5)}) {
    const double phi = -0.3;
    const RollingTime problem(scene, uniform_mesh(2, 3), phi);
    const VariableLayout& layout = problem.layout();
    const double r = scene.body.radius;
    const double beta_0 = start_angle(scene.body);
    std::set<int> fixed;
    const auto expect_fixed = [&](int index, double value) {
      fixed.insert(index);
      EXPECT_TRUE(problem.variable_range(index).single());
      EXPECT_NEAR(problem.variable_range(index).lower, value, ulps(2.0, 4.0))
          << layout.variable_name(index);
    };

    expect_fixed(layout.state(0, X), r * std::sin(beta_0));
    expect_fixed(layout.state(0, Z), -r * std::cos(beta_0));
    expect_fixed(layout.state(0, W), 0.0);
    if (layout.has_theta()) {
      expect_fixed(layout.state(0, Theta), scene.body.theta_m);
    }
    expect_fixed(layout.state(6, X), scene.L + r * std::sin(phi));
    expect_fixed(layout.state(6, Z), scene.H - r * std::cos(phi));
    for (int i = 0; i < problem.num_variables(); ++i) {
      if (fixed.contains(i)) continue;
      EXPECT_FALSE(problem.variable_range(i).bounded());
    }
  }
}

TEST(RollingTimeBounds, FollowTheEndAngle) {
  RollingTime moved(uniform_scene(), uniform_mesh(2, 3), 0.9);
  const RollingTime fresh(uniform_scene(), uniform_mesh(2, 3), -0.2);

  moved.set_end_angle(-0.2);

  expect_same_ranges(moved, fresh);
}

/// An evaluable point, to be spoilt.
TEST(RollingTimeMove, BecomesTheProgramOfTheOtherScene) {
  Scene other = off_centred_scene();
  other.body.eta_m *= 0.5;
  other.body.theta_m += 0.3;
  other.L += 1.0;
  const Mesh mesh{3, {0.0, 0.3, 1.0}};
  RollingTime moved(off_centred_scene(), uniform_mesh(3, 2), -0.1);
  RollingTime fresh(other, mesh, -0.2);
  Random random(1);
  const std::vector<double> x = random_point(fresh, random);
  ASSERT_TRUE(moved.set_point(x));
  moved.move_to(other, mesh, -0.2);

  ASSERT_TRUE(moved.set_point(x));
  ASSERT_TRUE(fresh.set_point(x));

  expect_same_ranges(moved, fresh);
  EXPECT_EQ(moved.eval_f(), fresh.eval_f());
  std::vector<double> of_moved(at(fresh.num_constraints()));
  std::vector<double> of_fresh(of_moved.size());
  moved.eval_g(of_moved);
  fresh.eval_g(of_fresh);
  EXPECT_EQ(of_moved, of_fresh);
}

class RefusedPoint : public ::testing::Test {
 protected:
  RollingTime problem{off_centred_scene(), uniform_mesh(2, 3), 0.0};
  std::vector<double> x = good();

  [[nodiscard]] std::vector<double> good() const {
    Random random(1);
    return random_point(problem, random);
  }
  void expect_refused(const char* because) {
    std::vector<double> g(at(problem.num_constraints()));
    EXPECT_FALSE(problem.set_point(x));
    EXPECT_EQ(problem.refusal(), because);
    EXPECT_THROW(problem.eval_g(g), std::logic_error);
    EXPECT_TRUE(problem.set_point(good())) << "no way back";
  }
};

TEST_F(RefusedPoint, NeedsAPositiveRollingTime) {
  for (const double U : {0.0, -1.0, kNaN}) {
    x = good();
    x[at(problem.layout().rolling_time())] = U;

    expect_refused("the rolling time U is not positive");
  }
}

TEST_F(RefusedPoint, NeedsAPositiveSpeedAtEveryPoint) {
  // Points 2 and 3 belong to element 1, with the nodes 2, 3 and 4.
  for (const double w : {0.0, -1.0, kNaN}) {
    x = good();
    for (int n = 2; n <= 4; ++n) x[at(problem.layout().state(n, W))] = w;

    EXPECT_FALSE(problem.set_point(x));
    EXPECT_TRUE(problem.refusal().starts_with(
        "the speed w is not positive at collocation point"))
        << problem.refusal();
  }
}

TEST_F(RefusedPoint, NamesThePoint) {
  for (int n = 0; n < problem.layout().num_nodes(); ++n) {
    x[at(problem.layout().state(n, W))] = n < 4 ? 1.0 : -1.0;
  }

  // In element 1 it is 1, 1, −1 at the nodes, 1 − 2 t (2 t − 1), which is still
  // positive at both points; in element 2 it is −1.
  const double t = 0.5 + 0.5 / std::sqrt(3.0);
  ASSERT_GT(1.0 - 2.0 * t * (2.0 * t - 1.0), 0.0);
  expect_refused("the speed w is not positive at collocation point 4 of 6");
}

TEST_F(RefusedPoint, NeedsFiniteAngles) {
  x[at(problem.layout().beta(3))] = kNaN;
  expect_refused("the slope angle is not finite at collocation point 3 of 6");

  x = good();
  x[at(problem.layout().state(1, Theta))] = kNaN;
  expect_refused(
      "the inertia factor A is not positive at collocation point 0 of 6");

  RollingTime centred(uniform_scene(), uniform_mesh(2, 3), 0.0);
  Random random(1);
  std::vector<double> y = random_point(centred, random);
  y[at(centred.layout().beta(3))] = kNaN;
  EXPECT_FALSE(centred.set_point(y));
  EXPECT_EQ(centred.refusal(),
            "the slope angle is not finite at collocation point 3 of 6");
}

/// States of a polynomial motion put into the unknowns.
template <class Motion>
std::vector<double> sample(const RollingTime& problem, double U,
                           const Motion& motion) {
  const VariableLayout& layout = problem.layout();
  const Mesh& mesh = problem.mesh();
  const auto sigma = [&](int element, double t) {
    return mesh.boundaries[at(element)] + t * mesh.length(element);
  };
  std::vector<double> x(at(problem.num_variables()));
  for (int e = 0; e < mesh.num_elements(); ++e) {
    for (int n = 0; n <= mesh.degree; ++n) {
      const auto state =
          motion(sigma(e, problem.scheme().nodes.nodes()[at(n)]));
      const int node = e * mesh.degree + n;
      x[at(layout.state(node, X))] = state.x;
      x[at(layout.state(node, Z))] = state.z;
      x[at(layout.state(node, W))] = state.w;
      if (layout.has_theta()) x[at(layout.state(node, Theta))] = state.theta;
    }
    for (int j = 0; j < mesh.degree; ++j) {
      x[at(layout.beta(e * mesh.degree + j))] =
          motion(sigma(e, problem.scheme().rule.points[at(j)])).beta;
    }
  }
  x[at(layout.rolling_time())] = U;
  return x;
}

struct Motion {
  double x, z, theta, w, beta;
};

TEST(RollingTimeDefects, VanishOnAnInclineWhereStatesAreQuadratic) {
  // w = U g sin β σ, s = U² g sin β σ²/2: Gauss integrates w exactly for all
  // degrees.
  const double U = 1.7, beta = 0.4;
  for (const Scene& scene : {bead_scene(), uniform_scene()}) {
    for (int p = 1; p <= 8; ++p) {
      RollingTime problem(scene, {p, {0.0, 0.1, 0.5, 1.0}}, 0.0);
      const double g = scene.gravity;
      const std::vector<double> x = sample(problem, U, [&](double sigma) {
        const double s = 0.5 * U * U * g * std::sin(beta) * sigma * sigma;
        return Motion{1.0 + s * std::cos(beta), s * std::sin(beta), 0.0,
                      U * g * std::sin(beta) * sigma, beta};
      });
      std::vector<double> defects(at(problem.num_constraints()));

      ASSERT_TRUE(problem.set_point(x));
      problem.eval_g(defects);

      // D sums p + 1 products of states below 8 with entries below 6 p².
      for (std::size_t i = 0; i < defects.size(); ++i) {
        EXPECT_NEAR(defects[i], 0.0, ulps(p + 1.0, 8.0 * 6.0 * p * p))
            << "degree " << p << " "
            << problem.constraint_name(static_cast<int>(i));
      }
    }
  }
}

TEST(RollingTimeDefects, RollWithoutSlipOverAnyPolynomial) {
  // With w of degree p − 1 and θ its integral the no-slip rows vanish.
  const double U = 1.3;
  const Scene scene = off_centred_scene();
  for (int p = 1; p <= 8; ++p) {
    RollingTime problem(scene, {p, {0.0, 0.2, 1.0}}, 0.0);
    const std::vector<double> x = sample(problem, U, [&](double sigma) {
      const double w = 1.0 + std::pow(sigma, p - 1);
      const double integral = sigma + std::pow(sigma, p) / p;
      return Motion{0.0, 0.0, 0.3 + U * integral / scene.body.radius, w, 0.4};
    });
    std::vector<double> defects(at(problem.num_constraints()));

    ASSERT_TRUE(problem.set_point(x));
    problem.eval_g(defects);

    for (int c = 0; c < problem.layout().num_points(); ++c) {
      EXPECT_NEAR(defects[at(problem.layout().defect(c, Theta))], 0.0,
                  ulps(p + 1.0, 8.0 * 6.0 * p * p))
          << "degree " << p << " point " << c;
    }
  }
}

TEST(RollingTimeObjective, IsTheIntegralOfRootA) {
  using Quadrature = boost::math::quadrature::gauss<double, 30>;
  const Scene scene = off_centred_scene();
  RollingTime problem(scene, uniform_mesh(8, 10), 0.0);
  const double U = 2.1, beta = 0.4;
  const auto root_A = [&](double sigma) {
    const double eta = scene.body.eta_m;
    return std::sqrt(1.0 + eta * eta + scene.body.k -
                     2.0 * eta * std::sin(3.0 * sigma - beta));
  };

  ASSERT_TRUE(problem.set_point(sample(problem, U, [&](double sigma) {
    return Motion{0.0, 0.0, 3.0 * sigma, 1.0, beta};
  })));

  // Both rules are exact to rounding for so smooth a function: errors like
  // (3/10/ρ)^16, ρ > 1 its distance from a singularity.
  EXPECT_NEAR(problem.eval_f(), U * Quadrature::integrate(root_A, 0.0, 1.0),
              ulps(16.0, U));
}

TEST(RollingTimeObjective, OfACentredBodyIsTheRollingTimeTimesRootOnePlusK) {
  for (const Scene& scene : {bead_scene(), uniform_scene()}) {
    RollingTime problem(scene, uniform_mesh(5, 7), 0.0);
    Random random(3);
    const std::vector<double> x = random_point(problem, random);

    ASSERT_TRUE(problem.set_point(x));

    const double T = x.back() * std::sqrt(1.0 + scene.body.k);
    EXPECT_NEAR(problem.eval_f(), T, ulps(8.0, T));
  }
}

}  // namespace
}  // namespace brachisto::testing
