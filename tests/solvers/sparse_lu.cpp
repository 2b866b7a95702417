// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The sparse factorisation against a dense one.

#include "solvers/sparse_lu.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "support/random_points.hpp"
#include "support/rounding.hpp"

namespace brachisto::testing {
namespace {

using WideMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
using WideVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

/// A matrix by coordinates, some positions given more than once.
struct Coordinates {
  int size = 0;
  nlp::SparsityPattern pattern;
  std::vector<double> values;

  void put(int row, int col, double value) {
    pattern.add(row, col);
    values.push_back(value);
  }
  /// Pivots where the permuted diagonal of random_sparse() stands.
  [[nodiscard]] nlp::EliminationOrder order(int stride = 1,
                                            int shift = 0) const {
    nlp::EliminationOrder out;
    for (int i = 0; i < size; ++i) {
      out.columns.push_back(i);
      out.rows.push_back((stride * i + shift) % size);
    }
    return out;
  }
  [[nodiscard]] WideMatrix dense() const {
    WideMatrix out = WideMatrix::Zero(size, size);
    for (std::size_t e = 0; e < values.size(); ++e) {
      out(pattern[e].row, pattern[e].col) += values[e];
    }
    return out;
  }
};

/// About four entries per row and a diagonal of either sign, in random order;
/// a third of the positions once more with another value.
Coordinates random_sparse(Random& random, int size) {
  Coordinates out;
  out.size = size;
  const auto any = [&] {
    return static_cast<int>(random.uniform(0.0, static_cast<double>(size)));
  };
  for (int i = 0; i < size; ++i) {
    // A permuted diagonal, so that pivots lie elsewhere.
    const double sign = random.uniform(-1.0, 1.0) < 0.0 ? -1.0 : 1.0;
    out.put((3 * i + 1) % size, i, sign * random.uniform(1.0, 3.0));
    for (int extra = 0; extra < 3; ++extra) {
      out.put(any(), any(), random.uniform(-1.0, 1.0));
    }
  }
  const std::size_t entries = out.values.size();
  for (std::size_t e = 0; e < entries; e += 3) {
    out.put(out.pattern[e].row, out.pattern[e].col, random.uniform(-0.5, 0.5));
  }
  return out;
}

TEST(SparseLu, SolvesLikeADenseFactorisation) {
  for (std::uint32_t seed = 1; seed <= 100; ++seed) {
    Random random(seed);
    // No multiple of three: 3 i + 1 is then a permutation.
    const int size = 2 + 3 * static_cast<int>(random.uniform(0.0, 20.0));
    const Coordinates A = random_sparse(random, size);
    const std::vector<double> b = random.vector(size, -1.0, 1.0);
    const Eigen::PartialPivLU<WideMatrix> dense(A.dense());
    const double condition =
        1.0 / static_cast<double>(std::max(dense.rcond(), 1e-30L));
    if (condition > 1e6) continue;
    const WideVector expected = dense.solve(
        Eigen::Map<const Eigen::VectorXd>(b.data(), size).cast<long double>());
    SparseLu lu(A.pattern, A.order(3, 1));

    ASSERT_TRUE(lu.factorise(A.values)) << "seed " << seed;
    const std::vector<double> y = lu.solve(b);

    // Refinement with an exact residual leaves the rounding of the result and a
    // power of cond ε, with a growth of the pivots of at most 1000.
    const double scale =
        static_cast<double>(expected.lpNorm<Eigen::Infinity>());
    const double once = ulps(1000.0 * size * condition);
    for (int i = 0; i < size; ++i) {
      EXPECT_NEAR(y[static_cast<std::size_t>(i)],
                  static_cast<double>(expected(i)),
                  (ulps(2.0) + once * once) * scale)
          << "seed " << seed << ", size " << size << ", row " << i;
    }
  }
}

TEST(SparseLu, KnowsTheSignOfTheDeterminant) {
  int negative = 0;
  for (std::uint32_t seed = 1; seed <= 300; ++seed) {
    Random random(seed);
    const int size = 2 + 3 * static_cast<int>(random.uniform(0.0, 8.0));
    const Coordinates A = random_sparse(random, size);
    const long double determinant =
        Eigen::FullPivLU<WideMatrix>(A.dense()).determinant();
    if (std::abs(determinant) < 1e-9L) continue;
    SparseLu lu(A.pattern, A.order(3, 1));

    ASSERT_TRUE(lu.factorise(A.values)) << "seed " << seed;

    EXPECT_EQ(lu.determinant_sign(), determinant > 0.0L ? 1 : -1)
        << "seed " << seed << ", size " << size;
    negative += determinant < 0.0L ? 1 : 0;
  }
  EXPECT_GT(negative, 50);
  EXPECT_LT(negative, 250);
}

TEST(SparseLu, OfAPermutationHasItsParity) {
  // (0 1 2) → (1 2 0) is even, (0 1 2) → (1 0 2) odd.
  Coordinates cycle;
  cycle.size = 3;
  for (int i = 0; i < 3; ++i) cycle.put((i + 1) % 3, i, 1.0);
  Coordinates swap;
  swap.size = 3;
  swap.put(0, 1, 1.0);
  swap.put(1, 0, 1.0);
  swap.put(2, 2, 1.0);
  SparseLu even(cycle.pattern, cycle.order());
  SparseLu odd(swap.pattern, swap.order());

  ASSERT_TRUE(even.factorise(cycle.values));
  ASSERT_TRUE(odd.factorise(swap.values));

  EXPECT_EQ(even.determinant_sign(), 1);
  EXPECT_EQ(odd.determinant_sign(), -1);
}

TEST(SparseLu, TakesDenseRowsAndColumnsLast) {
  // A band, and a border that couples with everything: where its rows became
  // pivots early, the factors would fill.
  for (std::uint32_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    const int size = 40;
    const int border = 1 + static_cast<int>(seed % 3);
    Coordinates A;
    A.size = size;
    for (int i = 0; i < size; ++i) {
      A.put(i, i, random.uniform(-2.0, 2.0));
      if (i > 0) A.put(i, i - 1, random.uniform(-1.0, 1.0));
      if (i + 1 < size) A.put(i, i + 1, random.uniform(-1.0, 1.0));
      for (int j = size - border; j < size; ++j) {
        A.put(i, j, random.uniform(-1.0, 1.0));
        A.put(j, i, random.uniform(-1.0, 1.0));
      }
    }
    const std::vector<double> b = random.vector(size, -1.0, 1.0);
    const Eigen::FullPivLU<WideMatrix> dense(A.dense());
    const WideVector expected = dense.solve(
        Eigen::Map<const Eigen::VectorXd>(b.data(), size).cast<long double>());
    nlp::EliminationOrder order = A.order();
    order.border = border;
    SparseLu lu(A.pattern, order);

    ASSERT_TRUE(lu.factorise(A.values)) << "seed " << seed;
    const std::vector<double> y = lu.solve(b);

    EXPECT_EQ(lu.determinant_sign(), dense.determinant() > 0.0L ? 1 : -1)
        << "seed " << seed;
    const double scale =
        static_cast<double>(expected.lpNorm<Eigen::Infinity>());
    const double once =
        ulps(1000.0 * size) / static_cast<double>(dense.rcond());
    for (int i = 0; i < size; ++i) {
      EXPECT_NEAR(y[static_cast<std::size_t>(i)],
                  static_cast<double>(expected(i)),
                  (ulps(2.0) + once * once) * scale)
          << "seed " << seed << ", row " << i;
    }
  }
}

TEST(SparseLu, SaysThatAMatrixIsSingular) {
  // Two equal rows: their elimination leaves an exact zero.
  Coordinates equal_rows;
  equal_rows.size = 3;
  for (int col = 0; col < 3; ++col) {
    equal_rows.put(0, col, 1.0 + col);
    equal_rows.put(1, col, 1.0 + col);
    equal_rows.put(2, col, 1.0 / (1.0 + col));
  }
  // An empty column.
  Coordinates structural;
  structural.size = 3;
  for (int row = 0; row < 3; ++row) {
    structural.put(row, 0, 1.0 + row);
    structural.put(row, 1, 2.0 - row);
  }
  // Values that cancel where the position is given twice.
  Coordinates cancelled;
  cancelled.size = 2;
  cancelled.put(0, 0, 1.0);
  cancelled.put(1, 1, 2.0);
  cancelled.put(1, 1, -2.0);
  for (const Coordinates& A : {equal_rows, structural, cancelled}) {
    SparseLu lu(A.pattern, A.order());

    EXPECT_FALSE(lu.factorise(A.values));
    EXPECT_EQ(lu.determinant_sign(), 0);
  }
}

TEST(SparseLu, RecoversFromASingularMatrix) {
  // The pattern is analysed once, the values change.
  Coordinates A;
  A.size = 2;
  A.put(0, 0, 0.0);
  A.put(0, 1, 2.0);
  A.put(1, 0, 0.0);
  A.put(1, 1, 1.0);
  SparseLu lu(A.pattern, A.order());
  EXPECT_FALSE(lu.factorise(A.values));

  ASSERT_TRUE(lu.factorise(std::vector{0.0, 2.0, 4.0, 1.0}));

  EXPECT_EQ(lu.determinant_sign(), -1);
  EXPECT_EQ(lu.solve(std::vector{2.0, 9.0}), (std::vector{2.0, 1.0}));
}

TEST(SparseLu, KeepsTheDigitsOfABadlyScaledMatrix) {
  // An arrow with rows of very different size, as multipliers make them: the
  // solution is all ones.
  constexpr int kSize = 30;
  Coordinates A;
  A.size = kSize;
  std::vector<double> b(kSize);
  for (int i = 0; i < kSize; ++i) {
    const double scale = std::ldexp(1.0, 3 * (i % 11) - 16);
    A.put(i, i, 2.0 * scale);
    if (i + 1 < kSize) A.put(i, kSize - 1, scale);
    if (i > 0) A.put(i, i - 1, -scale);
  }
  const WideMatrix dense = A.dense();
  for (int i = 0; i < kSize; ++i) {
    b[static_cast<std::size_t>(i)] = static_cast<double>(dense.row(i).sum());
  }
  SparseLu lu(A.pattern, A.order());

  ASSERT_TRUE(lu.factorise(A.values));

  for (const double value : lu.solve(b)) EXPECT_NEAR(value, 1.0, ulps(2.0));
}

}  // namespace
}  // namespace brachisto::testing
