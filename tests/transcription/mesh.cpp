// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/mesh.hpp"

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

}  // namespace
}  // namespace brachisto::testing
