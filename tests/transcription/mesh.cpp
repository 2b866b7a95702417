// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/ocp/mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "support/rounding.hpp"

namespace brachisto::testing {
namespace {

TEST(UniformMesh, CutsTheUnitIntervalIntoEqualElements) {
  for (const int elements : {1, 2, 3, 10, 49, 1000}) {
    const Mesh mesh = uniform_mesh(3, elements);

    ASSERT_EQ(mesh.num_elements(), elements);
    EXPECT_EQ(mesh.boundaries.front(), 0.0);
    EXPECT_EQ(mesh.boundaries.back(), 1.0);
    EXPECT_TRUE(std::ranges::is_sorted(mesh.boundaries));
    for (int e = 0; e < elements; ++e) {
      // Boundaries round like numbers below 1.
      EXPECT_NEAR(mesh.length(e), 1.0 / elements, ulps(1.0)) << "element " << e;
    }
  }
}

TEST(Mesh, CountsElementEndsOnce) {
  const Mesh mesh{4, {0.0, 0.1, 0.5, 1.0}};

  EXPECT_EQ(mesh.num_elements(), 3);
  EXPECT_EQ(mesh.num_points(), 12);
  EXPECT_EQ(mesh.num_nodes(), 13);
  EXPECT_DOUBLE_EQ(mesh.length(1), 0.4);
}

TEST(Mesh, LocatesAPlaceOnTheElementThatItBelongsTo) {
  const Mesh mesh{4, {0.0, 0.125, 0.5, 1.0}};
  struct Row {
    double sigma;
    int element;
    double t;
  };
  // An end belongs to the element that begins there, B to the last one; beyond
  // A and B the first and the last go on.
  for (const Row& row :
       {Row{0.0, 0, 0.0}, Row{0.0625, 0, 0.5}, Row{0.125, 1, 0.0},
        Row{0.40625, 1, 0.75}, Row{0.5, 2, 0.0}, Row{1.0, 2, 1.0},
        Row{-0.125, 0, -1.0}, Row{1.25, 2, 1.5}}) {
    const auto [element, t] = mesh.locate(row.sigma);

    EXPECT_EQ(element, row.element) << row.sigma;
    EXPECT_EQ(t, row.t) << row.sigma;
    EXPECT_EQ(mesh.sigma(element, t), row.sigma);
  }
}

}  // namespace
}  // namespace brachisto::testing
