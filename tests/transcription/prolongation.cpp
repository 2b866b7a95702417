// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/prolongation.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "brachisto/math/index.hpp"
#include "brachisto/nlp/problem.hpp"
#include "support/observed_order.hpp"
#include "support/rounding.hpp"
#include "support/scenes.hpp"
#include "support/solved_problem.hpp"

namespace brachisto::testing {
namespace {

TEST(Prolongation, ToTheSameMeshChangesNothing) {
  for (const Scene& scene : {natural(bead_scene()), natural(uniform_scene()),
                             natural(off_centred_scene(-kPi / 6.0))}) {
    for (const int p : {1, 2, 5, 8}) {
      const SolvedProblem solution =
          solved(scene, {p, {0.0, 0.1, 0.35, 0.6, 1.0}}, -0.15);
      const VariableLayout& layout = solution.problem.layout();
      const ExtremalCurve curve(solution.problem, solution.point);

      const PrimalDual same = prolong(curve, solution.problem);

      ASSERT_EQ(same.x.size(), solution.point.x.size());
      ASSERT_EQ(same.lambda.size(), solution.point.lambda.size());
      EXPECT_EQ(same.x.back(), solution.point.x.back());
      for (int i = 0; i < solution.problem.num_variables(); ++i) {
        // States to p roundings; the place of a node in its element is found
        // to ε/h, which moves values by their slope, below 20, times that.
        double tolerance = ulps(p + 1.0, 16.0) + ulps(20.0 / 0.1);
        // A slope angle is the minimum of 𝓗, flat to the solver's residual of
        // 1e-12 over h b_j ∂²𝓗/∂β², all above 1/500 together.
        if (i % (layout.num_states() + 1) == layout.num_states()) {
          tolerance += 500.0 * 1e-12;
        }
        EXPECT_NEAR(same.x[at(i)], solution.point.x[at(i)], tolerance)
            << "degree " << p << " " << solution.problem.variable_name(i);
      }
      for (int i = 0; i < solution.problem.num_constraints(); ++i) {
        EXPECT_NEAR(same.lambda[at(i)], solution.point.lambda[at(i)],
                    100.0 * 1e-12)
            << "degree " << p << " " << solution.problem.constraint_name(i);
      }
    }
  }
}

TEST(Prolongation, ToAFinerMeshLeavesAResidualThatFallsWithTheMesh) {
  // States and costates between the nodes are right to h^{p+1}; rows hold
  // another factor h, the stationarity of a state, which D couples to them
  // without it, does not.
  for (const Scene& scene :
       {natural(uniform_scene()), natural(off_centred_scene(-kPi / 6.0))}) {
    for (const int p : {2, 3, 4}) {
      std::array<double, 4> h{}, residual{}, infeasibility{};
      for (std::size_t level = 0; level < h.size(); ++level) {
        const int elements = 6 << level;
        const SolvedProblem coarse =
            solved(scene, uniform_mesh(p, elements), -0.15);
        const ExtremalCurve curve(coarse.problem, coarse.point);
        RollingTime fine(scene, uniform_mesh(p, 2 * elements), -0.15);

        const PrimalDual start = prolong(curve, fine);

        const nlp::KktResidual kkt = nlp::kkt_residual(fine, start);
        h[level] = 1.0 / elements;
        residual[level] = kkt.max();
        infeasibility[level] = kkt.infeasibility;
      }

      EXPECT_GT(observed_order(h, residual), p + 0.5)
          << "degree " << p << " residuals " << residual.front() << " … "
          << residual.back();
      EXPECT_GT(observed_order(h, infeasibility), p + 0.5) << "degree " << p;
    }
  }
}

TEST(Prolongation, SavesIterations) {
  const Scene scene = natural(off_centred_scene(-kPi / 6.0));
  const SolvedProblem coarse = solved(scene, uniform_mesh(4, 8), -0.15);
  RollingTime fine(scene, uniform_mesh(4, 16), -0.15);
  const auto arc =
      cycloid_between(start_of_centre(scene), end_of_centre(scene, -0.15));

  const SolverResult cold =
      solve_with_ipopt(fine, cycloid_guess(fine, *arc), {});
  const SolverResult warm = solve_with_ipopt(
      fine, prolong(ExtremalCurve(coarse.problem, coarse.point), fine), {});

  ASSERT_EQ(cold.status, Status::Solved) << cold.message;
  ASSERT_EQ(warm.status, Status::Solved) << warm.message;
  EXPECT_LT(warm.iterations, cold.iterations);
}

}  // namespace
}  // namespace brachisto::testing
