// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Derivatives of limited_time: what they leave falls as h² and h³; nothing
// depends on what the patterns leave out.

#include "transcription/limited_time.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <ostream>
#include <set>
#include <string>
#include <utility>

#include "brachisto/math/index.hpp"
#include "derivatives/taylor_remainders.hpp"
#include "support/limited_problems.hpp"
#include "support/observed_order.hpp"
#include "support/world_scenes.hpp"

namespace brachisto::testing {
namespace {

struct LimitedCase {
  std::string name;
  Scene scene;
  int degree;
  std::optional<std::size_t> only;  ///< one limit alone
  bool free_contacts, held;

  [[nodiscard]] LimitedTime problem() const {
    auto limits = limits_of_all_kinds(scene.body);
    if (only) limits = {limits[*only]};
    const Mesh mesh{degree, {0.0, 0.1, 0.3, 0.45, 0.5, 0.6, 0.8, 0.95, 1.0}};
    LimitedEnds ends;
    ends.phi = -0.2;
    ends.free_contacts = free_contacts;
    std::optional<HeldLimits> equations;
    if (held) equations = held_in_turn(mesh, limits);
    return {scene, limits, mesh, ends, equations};
  }
};

std::ostream& operator<<(std::ostream& out, const LimitedCase& row) {
  return out << row.name;
}

std::vector<LimitedCase> limited_cases() {
  const std::pair<const char*, Body> bodies[] = {
      {"Bead", Body::bead()},
      {"Uniform", Body::cylinder(1.0 / 3.0, 0.0, 0.0, 0.5)},
      {"OffCentred", Body::cylinder(1.0 / 3.0, 2.0 / 3.0, -kPi / 6.0, 0.5)},
      {"NearlyPointMass", Body::cylinder(0.4, 0.9, 0.7, 0.05)},
  };
  std::vector<LimitedCase> cases;
  for (const auto& [name, body] : bodies) {
    const Scene scene = natural(scene_of(body));
    for (const int p : {1, 2, 3, 5, 8}) {
      for (const bool free : {false, true}) {
        for (const bool held : {false, true}) {
          cases.push_back(
              {fmt::format("{}Degree{}{}{}", name, p,
                           free ? "FreeContacts" : "", held ? "Held" : ""),
               scene,
               p,
               {},
               free,
               held});
        }
      }
    }
    const auto limits = limits_of_all_kinds(body);
    for (std::size_t i = 0; i < limits.size(); ++i) {
      cases.push_back({fmt::format("{}Limit{}Kind{}", name, i,
                                   static_cast<int>(limits[i].kind)),
                       scene, 3, i, false, false});
    }
    // So little inertia that the steps below do not show the order yet.
    if (body.k == 0.05) continue;
    const auto all_of_it = [&](const Sphere& sphere) {
      return natural(with_push(
          in_air(about_sphere(scene_of(body), sphere), 0.1, 0.05), 1.0));
    };
    for (const bool free : {false, true}) {
      const char* contacts = free ? "FreeContacts" : "";
      cases.push_back({fmt::format("{}OnAPlanet{}", name, contacts),
                       all_of_it(below()),
                       3,
                       {},
                       free,
                       false});
      cases.push_back({fmt::format("{}InAPlanet{}", name, contacts),
                       all_of_it(around()),
                       3,
                       {},
                       free,
                       true});
    }
  }
  return cases;
}

class LimitedDerivatives : public ::testing::TestWithParam<LimitedCase> {};

TEST_P(LimitedDerivatives, LeaveSquareAndCube) {
  TaylorRemainders remainder;
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    LimitedTime problem = GetParam().problem();
    const std::vector<double> x = random_point(problem, random);
    const std::vector<double> lambda =
        random.vector(problem.num_constraints(), -1.0, 1.0);
    remainder.add(problem, x, lambda,
                  random.vector(problem.num_variables(), -1.0, 1.0));
  }

  EXPECT_NEAR(observed_order(kSteps, remainder.g()), 2.0, kSlack)
      << "seeds from 1, remainders " << ::testing::PrintToString(remainder.g());
  EXPECT_NEAR(observed_order(kSteps, remainder.lagrangian()), 3.0, kSlack)
      << "seeds from 1, remainders "
      << ::testing::PrintToString(remainder.lagrangian());
}

/// An end of two elements is moved: the one grows, the other shrinks. What is
/// left of central differences falls as h².
TEST_P(LimitedDerivatives, ByLengthsAreThoseOfWholeSystems) {
  Random random(7);
  LimitedTime problem = GetParam().problem();
  const std::vector<double> x = random_point(problem, random);
  const std::vector<double> lambda =
      random.vector(problem.num_constraints(), -1.0, 1.0);
  const auto system_at = [&](double move) {
    LimitedTime moved = GetParam().problem();
    Mesh mesh = moved.mesh();
    mesh.boundaries[3] += move;
    moved.change(moved.limits(), mesh, moved.ends());
    EXPECT_TRUE(moved.set_point(x));
    std::vector<double> out(at(moved.num_variables()));
    moved.eval_grad_f(out);
    std::vector<double> jacobian(moved.jac_g_pattern().num_entries());
    moved.eval_jac_g(jacobian);
    for (std::size_t e = 0; e < jacobian.size(); ++e) {
      out[at(moved.jac_g_pattern()[e].col)] +=
          jacobian[e] * lambda[at(moved.jac_g_pattern()[e].row)];
    }
    std::vector<double> g(at(moved.num_constraints()));
    moved.eval_g(g);
    out.insert(out.end(), g.begin(), g.end());
    return out;
  };
  ASSERT_TRUE(problem.set_point(x));
  std::vector<double> rates(
      at(problem.num_variables() + problem.num_constraints()));
  problem.add_rates_by_length(2, 1.0, lambda, rates);
  problem.add_rates_by_length(3, -1.0, lambda, rates);

  double largest = 0.0;
  for (const double rate : rates) largest = std::max(largest, std::abs(rate));
  ASSERT_GT(largest, 0.0);
  // Elements of h ≥ 0.05 and powers of h down to h⁻²: the third derivative is
  // at most 12/h² of the first, what is left of a difference (step/h)² · 2.
  constexpr double kStep = 1e-4;
  const std::vector<double> less = system_at(-kStep), more = system_at(kStep);
  for (std::size_t i = 0; i < rates.size(); ++i) {
    EXPECT_NEAR((more[i] - less[i]) / (2.0 * kStep), rates[i], 1e-5 * largest)
        << i;
  }
}

/// A change of one unknown changes exactly the rows of its column, bit by bit:
/// whatever else moved would be missing in the pattern. The same of the
/// gradient of the Lagrangian and the Hessian.
TEST_P(LimitedDerivatives, HaveNothingOutsideThePattern) {
  LimitedTime problem = GetParam().problem();
  Random random(11);
  const std::vector<double> x = random_point(problem, random);
  std::vector<double> g(at(problem.num_constraints())), moved_g = g;
  std::set<std::pair<int, int>> entries;
  const auto& jac = problem.jac_g_pattern();
  for (std::size_t e = 0; e < jac.num_entries(); ++e) {
    entries.insert({jac[e].row, jac[e].col});
  }
  std::set<std::pair<int, int>> pairs;
  const auto& hess = problem.hess_lag_pattern();
  for (std::size_t e = 0; e < hess.num_entries(); ++e) {
    ASSERT_LE(hess[e].col, hess[e].row);
    pairs.insert({hess[e].row, hess[e].col});
    pairs.insert({hess[e].col, hess[e].row});
  }
  // In the order of the Jacobian's entries, whose values are functions of x.
  std::vector<double> here(jac.num_entries()), there = here;
  ASSERT_TRUE(problem.set_point(x));
  problem.eval_g(g);
  problem.eval_jac_g(here);
  for (int i = 0; i < problem.num_variables(); ++i) {
    std::vector<double> moved = x;
    moved[at(i)] += 1e-3;
    ASSERT_TRUE(problem.set_point(moved));
    problem.eval_g(moved_g);
    problem.eval_jac_g(there);

    for (int row = 0; row < problem.num_constraints(); ++row) {
      if (moved_g[at(row)] == g[at(row)]) continue;
      EXPECT_TRUE(entries.contains({row, i}))
          << problem.constraint_name(row) << " by " << problem.variable_name(i);
    }
    for (std::size_t e = 0; e < jac.num_entries(); ++e) {
      if (there[e] == here[e]) continue;
      EXPECT_TRUE(pairs.contains({jac[e].col, i}))
          << problem.variable_name(jac[e].col) << " and "
          << problem.variable_name(i);
    }
  }
}

TEST_P(LimitedDerivatives, KeepTheirPatternsAfterARefusedPoint) {
  LimitedTime problem = GetParam().problem();
  const nlp::SparsityPattern jac = problem.jac_g_pattern();
  const nlp::SparsityPattern hess = problem.hess_lag_pattern();
  Random random(12);
  const std::vector<double> good = random_point(problem, random);
  std::vector<double> bad = good;
  bad[at(problem.layout().state(3, StateComponent::W))] = -1.0;
  std::vector<double> before(jac.num_entries()), after = before;
  ASSERT_TRUE(problem.set_point(good));
  problem.eval_jac_g(before);

  EXPECT_FALSE(problem.set_point(bad));
  ASSERT_TRUE(problem.set_point(good));
  problem.eval_jac_g(after);

  EXPECT_EQ(before, after);
  EXPECT_EQ(problem.jac_g_pattern(), jac);
  EXPECT_EQ(problem.hess_lag_pattern(), hess);
}

INSTANTIATE_TEST_SUITE_P(Problems, LimitedDerivatives,
                         ::testing::ValuesIn(limited_cases()),
                         [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace brachisto::testing
