// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The library by its own names, against matrices whose eigenvalues have a
// closed form.

#include "chain_library/brachisto_chain.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <vector>

#include "chain_library/kkt_matrix.hpp"
#include "solvers/mumps.hpp"

namespace brachisto::testing {
namespace {

using Chain =
    std::unique_ptr<brachisto_chain, decltype(&brachisto_chain_delete)>;

/// Rows of a lower triangle, counted from `first`.
struct Rows {
  std::vector<int> ptr, col = {};
  std::vector<double> values = {};
  int first = 0;

  [[nodiscard]] int size() const { return static_cast<int>(ptr.size()) - 1; }
  [[nodiscard]] Chain make() const {
    return {brachisto_chain_new(size(), ptr.data(), col.data(), first),
            &brachisto_chain_delete};
  }
};

Rows rows_of(const Eigen::MatrixXd& K, int first) {
  Rows rows{.ptr = {first}, .first = first};
  for (int i = 0; i < K.rows(); ++i) {
    for (int j = 0; j <= i; ++j) {
      if (K(i, j) == 0.0) continue;
      rows.col.push_back(j + first);
      rows.values.push_back(K(i, j));
    }
    rows.ptr.push_back(static_cast<int>(rows.col.size()) + first);
  }
  return rows;
}

/// −y'' − shift y on n inner points of equal steps. Its eigenvalues are
/// 2 − 2 cos(k π/(n + 1)) − shift, k = 1 … n.
Rows second_differences(int n, double shift, int first) {
  Rows rows{.ptr = {first}, .first = first};
  for (int i = 0; i < n; ++i) {
    if (i > 0) {
      rows.col.push_back(i - 1 + first);
      rows.values.push_back(-1.0);
    }
    rows.col.push_back(i + first);
    rows.values.push_back(2.0 - shift);
    rows.ptr.push_back(static_cast<int>(rows.col.size()) + first);
  }
  return rows;
}

TEST(BrachistoChain, KnowsTheInertiaOfSecondDifferences) {
  constexpr int n = 300;
  for (const int first : {0, 1}) {
    for (const double shift : {-0.5, 0.013, 1.0, 3.9, 4.5}) {
      const Rows rows = second_differences(n, shift, first);
      const Chain chain = rows.make();
      brachisto_chain_inertia inertia{};
      ASSERT_EQ(
          brachisto_chain_factorise(chain.get(), rows.values.data(), &inertia),
          BRACHISTO_CHAIN_OK);

      int negative = 0;
      double nearest = 4.0;
      for (int k = 1; k <= n; ++k) {
        const double eigenvalue =
            2.0 - 2.0 * std::cos(k * std::numbers::pi / (n + 1)) - shift;
        negative += eigenvalue < 0.0 ? 1 : 0;
        nearest = std::min(nearest, std::abs(eigenvalue));
      }
      EXPECT_EQ(inertia.negative, negative) << shift;
      EXPECT_EQ(inertia.positive, n - negative) << shift;

      // K x for x_i = i², twice: 2 − shift times it, less its neighbours.
      std::vector<double> x;
      const auto square = [](int i) { return static_cast<double>(i) * i; };
      for (int side = 0; side < 2; ++side) {
        for (int i = 1; i <= n; ++i) {
          x.push_back((2.0 - shift) * square(i) - (i > 1 ? square(i - 1) : 0) -
                      (i < n ? square(i + 1) : 0));
        }
      }
      ASSERT_EQ(brachisto_chain_solve(chain.get(), 2, x.data()),
                BRACHISTO_CHAIN_OK);
      // Backward stable: a few roundings of K x over the smallest eigenvalue.
      const double error = 64.0 * 2.2e-16 * 8.0 * square(n) / nearest;
      for (int i = 0; i < 2 * n; ++i) {
        EXPECT_NEAR(x[static_cast<std::size_t>(i)], square(i % n + 1), error);
      }
    }
  }
}

/// A row as another one, but for `apart` in its first entry.
Eigen::MatrixXd with_row_twice(const Eigen::MatrixXd& K, double apart) {
  const Eigen::Index n = K.rows();
  Eigen::Index one = 0;
  while (K(one, one) != 0.0) ++one;  // of an equation
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(n + 1, n + 1);
  out.topLeftCorner(n, n) = K;
  out.bottomLeftCorner(1, n) = K.row(one);
  Eigen::Index entry = 0;
  while (K(one, entry) == 0.0) ++entry;
  out(n, entry) += apart;
  out.topRightCorner(n, 1) = out.bottomLeftCorner(1, n).transpose();
  return out;
}

/// Regular, nearly singular, and singular; with up to five dense columns.
TEST(BrachistoChain, KnowsTheInertiaOfTwoHundredMatricesAsMumpsDoes) {
  int singular = 0;
  for (std::uint32_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    Eigen::MatrixXd K =
        kkt_matrix(80, 1 + static_cast<int>(seed % 3), 1, random);
    const auto n = K.rows();
    const Eigen::Index dense = seed % 6;
    Eigen::MatrixXd bordered = Eigen::MatrixXd::Zero(n + dense, n + dense);
    bordered.topLeftCorner(n, n) = K;
    for (Eigen::Index j = n; j < n + dense; ++j) {
      for (Eigen::Index i = 0; i < j; ++i) {
        bordered(i, j) = bordered(j, i) = random.uniform(-0.1, 0.1);
      }
      bordered(j, j) = 3.0;
    }
    constexpr double kNearly = 1e-5;
    if (seed % 3 == 1) bordered = with_row_twice(bordered, kNearly);
    if (seed % 3 == 2) bordered = with_row_twice(bordered, 0.0);
    const Rows rows = rows_of(bordered, 1);
    const Chain chain = rows.make();
    brachisto_chain_inertia ours{};

    const auto status =
        brachisto_chain_factorise(chain.get(), rows.values.data(), &ours);

    std::vector<int> row, col;
    for (int i = 0; i < rows.size(); ++i) {
      for (int e = rows.ptr[static_cast<std::size_t>(i)];
           e < rows.ptr[static_cast<std::size_t>(i) + 1]; ++e) {
        row.push_back(i + 1);
        col.push_back(rows.col[static_cast<std::size_t>(e) - 1]);
      }
    }
    const Inertia theirs =
        Mumps(dmumps_c).factorise(rows.size(), row, col, rows.values);
    SCOPED_TRACE(seed);
    EXPECT_EQ(status,
              theirs.zero > 0 ? BRACHISTO_CHAIN_SINGULAR : BRACHISTO_CHAIN_OK);
    singular += theirs.zero > 0 ? 1 : 0;
    EXPECT_EQ(ours.zero, theirs.zero);
    EXPECT_EQ(ours.negative, theirs.negative);
    EXPECT_EQ(ours.positive, theirs.positive);
  }
  EXPECT_EQ(singular, 67);
}

TEST(BrachistoChain, RefusesWhatIsNoPattern) {
  Rows falling = second_differences(20, 0.0, 0);
  std::swap(falling.ptr[3], falling.ptr[9]);
  Rows outside = second_differences(20, 0.0, 1);
  outside.col[7] = 21;
  Rows before = second_differences(20, 0.0, 1);
  before.col[7] = 0;
  Rows other_first = second_differences(20, 0.0, 0);
  other_first.first = 1;

  ::testing::internal::CaptureStderr();
  for (const Rows* rows : {&falling, &outside, &before, &other_first}) {
    EXPECT_EQ(rows->make(), nullptr);
  }
  EXPECT_EQ(::testing::internal::GetCapturedStderr(),
            "brachisto-chain: the pattern is none of a matrix\n");
}

TEST(BrachistoChain, SurvivesMatricesOfAllShapes) {
  Random random(3);
  std::vector<Eigen::MatrixXd> matrices;
  for (const int n : {0, 1, 2, 5, 40, 120}) {
    matrices.push_back(Eigen::MatrixXd::Zero(n, n));
    matrices.push_back(Eigen::MatrixXd::Identity(n, n));
    matrices.push_back(Eigen::MatrixXd::Ones(n, n));
    Eigen::MatrixXd arrow = Eigen::MatrixXd::Identity(n, n);
    if (n > 0) arrow.row(n - 1).setOnes(), arrow.col(n - 1).setOnes();
    matrices.push_back(arrow);
    for (int density = 1; density < 8; ++density) {
      Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n);
      for (int k = 0; k < density * n; ++k) {
        const int i = static_cast<int>(random.uniform(0.0, n));
        const int j = static_cast<int>(random.uniform(0.0, n));
        K(i, j) = K(j, i) = random.uniform(-1.0, 1.0);
      }
      matrices.push_back(K);
    }
  }
  ::testing::internal::CaptureStderr();
  int good = 0;
  for (const Eigen::MatrixXd& K : matrices) {
    const Rows rows = rows_of(K, 0);
    const Chain chain = rows.make();
    ASSERT_NE(chain, nullptr);
    brachisto_chain_inertia inertia{};
    const auto status =
        brachisto_chain_factorise(chain.get(), rows.values.data(), &inertia);
    std::vector<double> x(static_cast<std::size_t>(K.rows()), 1.0);
    const auto solved = brachisto_chain_solve(chain.get(), 1, x.data());
    ASSERT_EQ(solved == BRACHISTO_CHAIN_OK, status == BRACHISTO_CHAIN_OK);
    if (status == BRACHISTO_CHAIN_NONE) continue;
    ++good;
    EXPECT_EQ(inertia.positive + inertia.negative + inertia.zero, K.rows());
  }
  ::testing::internal::GetCapturedStderr();
  EXPECT_GT(good, 5);
}

TEST(BrachistoChain, LetsMumpsDoWhatIsNoChainIfItIsAskedTo) {
  Random random(4);
  constexpr int n = 400;
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i < n; ++i) K(i, i) = i % 3 == 0 ? -4.0 : 4.0;
  for (int k = 0; k < 6 * n; ++k) {
    const int i = static_cast<int>(random.uniform(0.0, n));
    const int j = static_cast<int>(random.uniform(0.0, n));
    if (i != j) K(i, j) = K(j, i) = random.uniform(-1.0, 1.0);
  }
  const Rows rows = rows_of(K, 1);
  const Chain chain = rows.make();
  brachisto_chain_inertia inertia{};
  ::testing::internal::CaptureStderr();
  ASSERT_EQ(
      brachisto_chain_factorise(chain.get(), rows.values.data(), &inertia),
      BRACHISTO_CHAIN_NONE);
  ASSERT_EQ(setenv("BRACHISTO_CHAIN_FALLBACK", "mumps", 1), 0);

  ASSERT_EQ(
      brachisto_chain_factorise(chain.get(), rows.values.data(), &inertia),
      BRACHISTO_CHAIN_OK);

  unsetenv("BRACHISTO_CHAIN_FALLBACK");
  EXPECT_NE(::testing::internal::GetCapturedStderr().find(
                "no chain of small blocks; MUMPS factorises it"),
            std::string::npos);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(K);
  EXPECT_EQ(inertia.negative, (eigen.eigenvalues().array() < 0.0).count());
  Eigen::VectorXd expected = Eigen::VectorXd::LinSpaced(n, -1.0, 1.0);
  Eigen::VectorXd x = K * expected;
  ASSERT_EQ(brachisto_chain_solve(chain.get(), 1, x.data()),
            BRACHISTO_CHAIN_OK);
  const double smallest = eigen.eigenvalues().cwiseAbs().minCoeff();
  EXPECT_LE((x - expected).cwiseAbs().maxCoeff(),
            64.0 * n * 1.1e-16 * K.norm() / smallest);
}

}  // namespace
}  // namespace brachisto::testing
