// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/variable_layout.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <set>
#include <vector>

namespace brachisto::testing {
namespace {

using enum StateComponent;

std::vector<StateComponent> components(const VariableLayout& layout) {
  if (layout.has_theta()) return {X, Z, Theta, W};
  return {X, Z, W};
}

std::vector<int> range(int count) {
  std::vector<int> indices(static_cast<std::size_t>(count));
  std::iota(indices.begin(), indices.end(), 0);
  return indices;
}

class Layout : public ::testing::TestWithParam<bool> {
 protected:
  const VariableLayout layout{7, GetParam()};
};

TEST_P(Layout, GivesEveryUnknownItsOwnIndex) {
  std::vector<int> indices{layout.rolling_time()};
  for (int n = 0; n < layout.num_nodes(); ++n) {
    for (const auto c : components(layout)) {
      indices.push_back(layout.state(n, c));
    }
  }
  for (int c = 0; c < layout.num_points(); ++c) {
    indices.push_back(layout.beta(c));
  }

  EXPECT_THAT(indices, ::testing::UnorderedElementsAreArray(
                           range(layout.num_variables())));
}

TEST_P(Layout, GivesEveryConstraintItsOwnIndex) {
  std::vector<int> indices;
  for (int point = 0; point < layout.num_points(); ++point) {
    for (const auto c : components(layout)) {
      indices.push_back(layout.defect(point, c));
    }
  }

  EXPECT_THAT(indices, ::testing::UnorderedElementsAreArray(
                           range(layout.num_constraints())));
}

TEST_P(Layout, GivesEveryIndexItsOwnName) {
  std::set<std::string> variables, constraints;
  for (int i = 0; i < layout.num_variables(); ++i) {
    variables.insert(layout.variable_name(i));
  }
  for (int i = 0; i < layout.num_constraints(); ++i) {
    constraints.insert(layout.constraint_name(i));
  }

  EXPECT_EQ(variables.size(), static_cast<std::size_t>(layout.num_variables()));
  EXPECT_EQ(constraints.size(),
            static_cast<std::size_t>(layout.num_constraints()));
}

TEST_P(Layout, NamesWhatStandsThere) {
  EXPECT_EQ(layout.variable_name(layout.state(0, X)), "x[0]");
  EXPECT_EQ(layout.variable_name(layout.state(7, Z)), "z[7]");
  EXPECT_EQ(layout.variable_name(layout.state(3, W)), "w[3]");
  EXPECT_EQ(layout.variable_name(layout.beta(6)), "beta[6]");
  EXPECT_EQ(layout.variable_name(layout.rolling_time()), "U");
  EXPECT_EQ(layout.constraint_name(layout.defect(0, X)), "defect of x[0]");
  EXPECT_EQ(layout.constraint_name(layout.defect(6, W)), "defect of w[6]");
  if (!layout.has_theta()) return;
  EXPECT_EQ(layout.variable_name(layout.state(3, Theta)), "theta[3]");
  EXPECT_EQ(layout.constraint_name(layout.defect(2, Theta)),
            "defect of theta[2]");
}

TEST_P(Layout, StandsInTheDocumentedOrder) {
  // x_0 z_0 [θ_0] w_0 β_0 x_1 … w_{Np} U.
  int next = 0;
  for (int n = 0; n < layout.num_nodes(); ++n) {
    for (const auto c : components(layout)) {
      EXPECT_EQ(layout.state(n, c), next++);
    }
    if (n < layout.num_points()) {
      EXPECT_EQ(layout.beta(n), next++);
    }
  }
  EXPECT_EQ(layout.rolling_time(), next++);
  EXPECT_EQ(layout.num_variables(), next);
}

INSTANTIATE_TEST_SUITE_P(Bodies, Layout, ::testing::Bool(),
                         [](const auto& row) {
                           return row.param ? "WithTheta" : "WithoutTheta";
                         });

class LayoutOfPieces : public ::testing::TestWithParam<bool> {
 protected:
  const VariableLayout layout = VariableLayout::of_pieces(7, GetParam());
};

TEST_P(LayoutOfPieces, StandsInTheDocumentedOrder) {
  // x_1 z_1 [θ_1] x_2 … S; no slip and place of piece 1, of piece 2 …
  int next = 0, row = 0;
  for (int n = 1; n < layout.num_nodes(); ++n) {
    EXPECT_EQ(layout.state(n, X), next++);
    EXPECT_EQ(layout.state(n, Z), next++);
    if (layout.has_theta()) {
      EXPECT_EQ(layout.state(n, Theta), next++);
    }
    EXPECT_EQ(layout.no_slip(n), row++);
    if (layout.has_theta()) {
      EXPECT_EQ(layout.place(n), row++);
    }
  }
  EXPECT_EQ(layout.arc_length(), next++);
  EXPECT_EQ(layout.num_variables(), next);
  EXPECT_EQ(layout.num_constraints(), row);
}

TEST_P(LayoutOfPieces, NamesWhatStandsThere) {
  EXPECT_EQ(layout.variable_name(layout.state(1, X)), "x[1]");
  EXPECT_EQ(layout.variable_name(layout.state(7, Z)), "z[7]");
  EXPECT_EQ(layout.variable_name(layout.arc_length()), "S");
  EXPECT_EQ(layout.constraint_name(layout.no_slip(1)), "no slip[1]");
  if (!layout.has_theta()) return;
  EXPECT_EQ(layout.variable_name(layout.state(3, Theta)), "theta[3]");
  EXPECT_EQ(layout.constraint_name(layout.place(7)), "place[7]");
}

TEST_P(LayoutOfPieces, KnowsTheNodeOfAnUnknownAndThePieceOfAConstraint) {
  for (int n = 1; n < layout.num_nodes(); ++n) {
    EXPECT_EQ(layout.node_of(layout.state(n, Z)), n);
    EXPECT_TRUE(layout.is_state(layout.state(n, Z)));
    EXPECT_EQ(layout.point_of(layout.no_slip(n)), n - 1);
  }
}

INSTANTIATE_TEST_SUITE_P(Bodies, LayoutOfPieces, ::testing::Bool(),
                         [](const auto& row) {
                           return row.param ? "WithTheta" : "WithoutTheta";
                         });

}  // namespace
}  // namespace brachisto::testing
