// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The mesh that follows a tolerance meets it, knows that it does, and does not
// do far more than that.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>

#include "brachisto/study/solve.hpp"
#include "extremal/shooting.hpp"
#include "study/answer_kinds.hpp"
#include "support/reference_values.hpp"

namespace brachisto {
namespace {

using testing::reference;
using testing::ReferenceValue;

// The indirect method's own error is below 1e-13; this allows for both.
constexpr double kReferenceError = 2e-13;

struct ToleranceCase {
  const ReferenceValue* row;
  double tolerance;
};

std::ostream& operator<<(std::ostream& out, const ToleranceCase& c) {
  return out << c.row->name << " to " << c.tolerance;
}

std::vector<ToleranceCase> all_cases() {
  std::vector<ToleranceCase> cases;
  for (const auto* row :
       {&reference("bead_L3"), &reference("uniform_L3"),
        &reference("reference_case"), &reference("L4"), &reference("fast"),
        &reference("theta_-90"), &reference("r_0.2"), &reference("k_0.100")}) {
    for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
      cases.push_back({row, tolerance});
    }
  }
  return cases;
}

class AdaptiveMesh : public ::testing::TestWithParam<ToleranceCase> {
 protected:
  [[nodiscard]] static Solution solve_case(const ToleranceCase& c) {
    SolveOptions options;
    options.use<Collocation>().discretisation.tolerance = c.tolerance;
    return solve(c.row->scene(), options);
  }
  /// τ to 13 digits or more.
  [[nodiscard]] static double exact_tau(const ReferenceValue& row) {
    if (row.source == testing::Source::ClosedForm) return row.tau;
    return solve_extremal(row.scene()).tau;
  }
};
INSTANTIATE_TEST_SUITE_P(Tolerances, AdaptiveMesh,
                         ::testing::ValuesIn(all_cases()));

TEST_P(AdaptiveMesh, MeetsItsToleranceAndKnowsIt) {
  const ToleranceCase& c = GetParam();
  const double exact = exact_tau(*c.row);

  const Solution solution = solve_case(c);

  ASSERT_TRUE(solution.verified()) << solution.message;
  ASSERT_TRUE(solution.estimated_error);
  const double estimate = *solution.estimated_error;
  const double error = std::abs(solution.motion()->tau() / exact - 1.0);
  EXPECT_LE(error, estimate + kReferenceError);
  EXPECT_LE(estimate, c.tolerance);
  // The estimate has a factor 2 and adds what may cancel in T: some ten times
  // the error, a hundred where T happens to pass the exact value.
  EXPECT_LE(estimate, 100.0 * std::max(error, 1e-12)) << "error " << error;
}

TEST_P(AdaptiveMesh, KeepsARecordOfItsMeshes) {
  const Solution solution = solve_case(GetParam());

  const std::vector<MeshRecord>& meshes = solution.effort.meshes;
  ASSERT_FALSE(meshes.empty());
  EXPECT_EQ(meshes.back().estimated_error, solution.estimated_error);
  const Mesh& mesh = trajectory_of(solution)->curve().mesh();
  EXPECT_EQ(meshes.back().degree, mesh.degree);
  EXPECT_EQ(meshes.back().elements, mesh.num_elements());
  EXPECT_EQ(solution.program()->nodes, mesh.num_nodes());
  // Each one refines the mesh before it; few are needed.
  EXPECT_LE(meshes.size(), 4u);
  int iterations = 0;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    iterations += meshes[i].iterations;
    EXPECT_GE(meshes[i].passes, 1);
    if (i == 0) continue;
    EXPECT_GT(meshes[i].degree * meshes[i].elements,
              meshes[i - 1].degree * meshes[i - 1].elements);
  }
  EXPECT_EQ(iterations, solution.effort.iterations);
}

TEST(AdaptiveMesh, SpendsMoreOnMoreDigits) {
  for (const auto* row : {&reference("reference_case"), &reference("fast")}) {
    int before = 0;
    for (const double tolerance : {1e-2, 1e-5, 1e-8, 1e-11}) {
      SolveOptions options;
      options.use<Collocation>().discretisation.tolerance = tolerance;

      const Solution solution = solve(row->scene(), options);

      ASSERT_TRUE(solution.verified()) << row->name << " to " << tolerance;
      EXPECT_GT(solution.program()->nodes, before)
          << row->name << " to " << tolerance;
      before = solution.program()->nodes;
    }
  }
}

TEST(AdaptiveMesh, NeedsFewerNodesThanAUniformOne) {
  // With the very number of elements that the adaptive mesh has, laid out
  // evenly, T is not as good: elements stand where the error is.
  const ReferenceValue& row = reference("r_0.2");
  SolveOptions options;
  Discretisation& mesh = options.use<Collocation>().discretisation;
  mesh.degree = 3;
  mesh.tolerance = 1e-8;
  const Solution adaptive = solve(row.scene(), options);
  ASSERT_TRUE(adaptive.verified()) << adaptive.message;
  SolveOptions uniform;
  uniform.use<Collocation>().discretisation.degree = 3;
  uniform.use<Collocation>().discretisation.elements =
      trajectory_of(adaptive)->curve().mesh().num_elements();

  const Solution even = solve(row.scene(), uniform);

  ASSERT_TRUE(even.estimated_error);
  EXPECT_GT(*even.estimated_error, *adaptive.estimated_error);
}

}  // namespace
}  // namespace brachisto
