// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/limited_time.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "brachisto/math/index.hpp"
#include "model/start_angle.hpp"
#include "support/limited_problems.hpp"
#include "support/rounding.hpp"

namespace brachisto::testing {
namespace {

using enum StateComponent;
using nlp::Held;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(LimitedTimeSize, FollowsFromStatesLimitsAndContacts) {
  for (const Scene& scene :
       {bead_scene(), uniform_scene(), off_centred_scene()}) {
    const auto limits = limits_of_all_kinds(scene.body);
    const int states = scene.body.off_centred() ? 5 : 4;
    const int forces = scene.body.rolls() ? 3 : 1;
    for (const bool free : {false, true}) {
      for (const bool slope_fixed : {false, true}) {
        LimitedEnds ends;
        ends.free_contacts = free;
        ends.start_slope_fixed = slope_fixed;
        const LimitedTime problem(scene, limits, uniform_mesh(3, 4), ends);

        EXPECT_EQ(problem.num_variables(), 12 * (states + 1) + states + 1);
        EXPECT_EQ(problem.num_constraints(),
                  12 * (states + static_cast<int>(limits.size())) +
                      (free ? 4 : 0) + (slope_fixed ? 0 : forces));
      }
    }
  }
}

TEST(LimitedTimeBounds, FixTheStartAndWhatContactsAsk) {
  const Scene scene = off_centred_scene(-0.5);
  const double r = scene.body.radius, phi = -0.3, beta_0 = 1.2;
  for (const bool free : {false, true}) {
    LimitedEnds ends;
    ends.free_contacts = free;
    ends.phi = phi;
    ends.start = beta_0;
    ends.start_slope_fixed = !free;
    const LimitedTime problem(scene, {}, uniform_mesh(2, 3), ends);
    const VariableLayout& layout = problem.layout();
    std::set<int> fixed;
    const auto expect_fixed = [&](int index, double value) {
      fixed.insert(index);
      EXPECT_TRUE(problem.variable_range(index).single());
      EXPECT_NEAR(problem.variable_range(index).lower, value, ulps(2.0, 4.0))
          << layout.variable_name(index);
    };

    expect_fixed(layout.state(0, Theta), scene.body.theta_m);
    expect_fixed(layout.state(0, W), 0.0);
    if (!free) {
      expect_fixed(layout.state(0, X), r * std::sin(beta_0));
      expect_fixed(layout.state(0, Z), -r * std::cos(beta_0));
      expect_fixed(layout.state(0, Beta), beta_0);
      expect_fixed(layout.state(6, X), scene.L + r * std::sin(phi));
      expect_fixed(layout.state(6, Z), scene.H - r * std::cos(phi));
    }
    for (int i = 0; i < problem.num_variables(); ++i) {
      if (fixed.contains(i)) continue;
      EXPECT_FALSE(problem.variable_range(i).bounded());
    }
  }
}

/// Weights b of a rule sum up to 1, lengths h of elements as well.
TEST(LimitedTimeWeights, AreThoseOfTheQuadrature) {
  const Scene scene = off_centred_scene();
  const auto limits = limits_of_all_kinds(scene.body);
  const Mesh mesh{3, {0.0, 0.1, 0.45, 1.0}};
  LimitedEnds ends;
  ends.free_contacts = true;
  const LimitedTime problem(scene, limits, mesh, ends);
  const VariableLayout& layout = problem.layout();
  const int n = problem.num_variables();
  const auto sum = [&](auto index_at) {
    double out = 0.0;
    for (int c = 0; c < layout.num_points(); ++c) {
      out += problem.weight(index_at(c));
    }
    return out;
  };
  // Of nine terms below 1.
  const double rounding = ulps(4.0, 9.0);

  for (const StateComponent of : {X, Z, Theta, W, Beta}) {
    EXPECT_NEAR(sum([&](int c) { return layout.state(c + 1, of); }), 1.0,
                rounding);
    EXPECT_NEAR(sum([&](int c) { return n + layout.defect(c, of); }), 3.0,
                rounding);
    EXPECT_EQ(problem.weight(layout.state(0, of)),
              problem.weight(layout.state(1, of)));
  }
  EXPECT_NEAR(sum([&](int c) { return layout.control(c); }), 3.0, rounding);
  for (int i = 0; i < layout.num_limits(); ++i) {
    EXPECT_NEAR(sum([&](int c) { return n + layout.limit(c, i); }), 1.0,
                rounding);
  }
  EXPECT_EQ(problem.weight(layout.rolling_time()), 1.0);
  for (int i = layout.end_of_points(); i < problem.num_constraints(); ++i) {
    EXPECT_EQ(problem.weight(n + i), 1.0);
  }
}

TEST(LimitedTimeBounds, KeepSlopesThatAreNotFixed) {
  const Scene scene = off_centred_scene();
  LimitedEnds ends;
  ends.start = 0.4;
  ends.start_slope_fixed = true;
  LimitedTime problem(scene, {}, uniform_mesh(2, 3), ends);
  problem.bound_slopes(1.5);
  const VariableLayout& layout = problem.layout();

  EXPECT_EQ(problem.variable_range(layout.state(0, Beta)).lower, 0.4);
  EXPECT_TRUE(problem.variable_range(layout.state(0, Beta)).single());
  for (int node = 1; node < layout.num_nodes(); ++node) {
    const nlp::Range range = problem.variable_range(layout.state(node, Beta));
    EXPECT_EQ(range.lower, -1.5) << node;
    EXPECT_EQ(range.upper, 1.5) << node;
    if (node == layout.num_nodes() - 1) continue;  // its place is given
    for (const int other :
         {layout.state(node, X), layout.state(node, W), layout.control(node)}) {
      EXPECT_FALSE(problem.variable_range(other).bounded())
          << layout.variable_name(other);
    }
  }
  EXPECT_FALSE(problem.variable_range(layout.rolling_time()).bounded());
}

TEST(LimitedTimeHeld, AreEquationsAndTheOthersAreNotAskedFor) {
  const Scene scene = off_centred_scene();
  const auto limits = limits_of_all_kinds(scene.body);
  const Mesh mesh = uniform_mesh(3, 8);
  LimitedEnds ends;
  ends.free_contacts = true;
  const HeldLimits held = held_in_turn(mesh, limits);
  const LimitedTime problem(scene, limits, mesh, ends, held);
  const VariableLayout& layout = problem.layout();

  for (int c = 0; c < layout.num_points(); ++c) {
    for (int i = 0; i < layout.num_limits(); ++i) {
      const PathInequality& limit = limits[at(i)];
      const int e = c / 3;
      const bool last = c % 3 == 2;
      // A limit of the place begins with the node that its element begins with.
      const bool expected =
          e == i || (!limit.bounds_control() && last && e + 1 == i);
      const double bound =
          std::isfinite(limit.upper) ? limit.upper : limit.lower;
      const nlp::Range range = problem.constraint_range(layout.limit(c, i));

      EXPECT_EQ(problem.held_at(c, i) != Held::No, expected) << c << " " << i;
      EXPECT_EQ(range.lower, expected ? bound : -kInfinity);
      EXPECT_EQ(range.upper, expected ? bound : kInfinity);
    }
  }
  ASSERT_EQ(layout.num_start_rows(), 3);
  for (int i = 0; i < 3; ++i) {
    const nlp::Range range = problem.constraint_range(layout.start_row(i));
    EXPECT_EQ(range.lower, i == 0 ? limits[0].lower : -kInfinity);
    EXPECT_EQ(range.upper, i == 0 ? limits[0].lower : kInfinity);
  }
  const LimitedTime all = problem.as_inequalities();
  EXPECT_FALSE(all.held());
  const nlp::Range range = all.constraint_range(layout.limit(0, 2));
  EXPECT_EQ(range.lower, limits[2].lower);
  EXPECT_EQ(range.upper, limits[2].upper);
}

/// A limit of a place that is given would say of constants what they are.
TEST(LimitedTimeHeld, LeavesOutThePlaceOfAGivenEnd) {
  const Scene scene = uniform_scene();
  const auto limits = limits_of_all_kinds(scene.body);
  const LimitedTime problem(scene, limits, uniform_mesh(3, 4), {});
  const VariableLayout& layout = problem.layout();
  const int last = layout.num_points() - 1;

  for (int i = 0; i < layout.num_limits(); ++i) {
    EXPECT_EQ(problem.constraint_range(layout.limit(last, i)).bounded(),
              limits[at(i)].bounds_control())
        << i;
  }
}

class RefusedLimitedPoint : public ::testing::Test {
 protected:
  LimitedTime problem{off_centred_scene(),
                      limits_of_all_kinds(off_centred_scene().body),
                      uniform_mesh(2, 3), LimitedEnds{}};

  [[nodiscard]] std::vector<double> good() const {
    Random random(1);
    return random_point(problem, random);
  }
  void expect_refused(int index, double value, const std::string& because) {
    std::vector<double> x = good();
    x[at(index)] = value;
    EXPECT_FALSE(problem.set_point(x));
    EXPECT_EQ(problem.refusal(), because);
    EXPECT_TRUE(problem.set_point(good())) << "no way back";
  }
};

TEST_F(RefusedLimitedPoint, SaysWhatAndWhere) {
  const VariableLayout& layout = problem.layout();
  for (const double value : {0.0, -1.0, std::nan("")}) {
    expect_refused(layout.rolling_time(), value,
                   "the rolling time U is not positive");
    expect_refused(layout.state(4, W), value,
                   "the speed w is not positive at collocation point 3 of 6");
  }
  expect_refused(layout.state(2, Beta), std::nan(""),
                 "the slope angle is not finite at collocation point 1 of 6");
  expect_refused(
      layout.state(2, Theta), std::nan(""),
      "the inertia factor A is not positive at collocation point 1 of 6");
}

/// On an incline w = U g sin β σ and s = U² g sin β σ²/2: Radau's rules of
/// degree 2 and more are exact, and q = 0.
TEST(LimitedTimeDefects, VanishOnAnIncline) {
  const double U = 1.7, beta = 0.4;
  for (const Scene& scene : {bead_scene(), uniform_scene()}) {
    for (int p = 2; p <= 8; ++p) {
      LimitedTime problem(scene, {}, {p, {0.0, 0.1, 0.5, 1.0}}, {});
      const VariableLayout& layout = problem.layout();
      std::vector<double> x(at(problem.num_variables()), 0.0);
      const auto put = [&](int node, double sigma) {
        const double w = U * scene.gravity * std::sin(beta) * sigma;
        const double s = 0.5 * U * sigma * w;
        x[at(layout.state(node, X))] = s * std::cos(beta);
        x[at(layout.state(node, Z))] = s * std::sin(beta);
        x[at(layout.state(node, W))] = w;
        x[at(layout.state(node, Beta))] = beta;
      };
      put(0, 0.0);
      for (int c = 0; c < layout.num_points(); ++c) {
        const int e = c / p;
        put(c + 1, problem.mesh().boundaries[at(e)] +
                       problem.mesh().length(e) *
                           problem.scheme().rule.points[at(c % p)]);
      }
      x[at(layout.rolling_time())] = U;
      std::vector<double> g(at(problem.num_constraints()));

      ASSERT_TRUE(problem.set_point(x));
      problem.eval_g(g);

      for (const double defect : g) {
        EXPECT_NEAR(defect, 0.0, ulps(p + 1.0, 8.0 * 6.0 * p * p));
      }
      const double T = U * std::sqrt(1.0 + scene.body.k);
      EXPECT_NEAR(problem.eval_f(), T, ulps(8.0, T));
    }
  }
}

}  // namespace
}  // namespace brachisto::testing
