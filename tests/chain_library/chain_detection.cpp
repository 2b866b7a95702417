// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/chain_detection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "chain_library/kkt_matrix.hpp"

namespace brachisto::testing {
namespace {

using nlp::ChainStructure;

struct Found {
  nlp::SparsityPattern pattern;
  std::vector<bool> no_diagonal;
  std::optional<ChainStructure> chain;
};

Found chain_of(const Eigen::MatrixXd& K) {
  Found out;
  const int n = static_cast<int>(K.rows());
  for (int i = 0; i < n; ++i) {
    out.no_diagonal.push_back(K(i, i) == 0.0);
    for (int j = 0; j <= i; ++j) {
      if (K(i, j) != 0.0 || i == j) out.pattern.add(i, j);
    }
  }
  out.chain =
      find_chain(MatrixGraph::of_pattern(n, out.pattern), out.no_diagonal);
  return out;
}

/// What ChainStructure asks for.
bool is_chain(const Found& found) {
  const ChainStructure& chain = *found.chain;
  bool good = true;
  found.pattern.for_each([&](std::size_t, int i, int j) {
    const int a = chain.block[static_cast<std::size_t>(i)];
    const int b = chain.block[static_cast<std::size_t>(j)];
    if (a == ChainStructure::kBorder || b == ChainStructure::kBorder) return;
    const auto [low, high] = std::minmax(a, b);
    // Of one link: 2 e, 2 e + 1, 2 e + 2.
    good = good && low >= 0 && high <= 2 * chain.num_links &&
           high - low <= (low % 2 == 0 ? 2 : 1);
  });
  return good;
}

TEST(ChainDetection, FindsTheStepsOfAMixedProblem) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const int states = 1 + static_cast<int>(seed % 4);
    const int controls = static_cast<int>(seed % 3);
    const Found found = chain_of(kkt_matrix(150, states, controls, random));

    ASSERT_TRUE(found.chain) << seed;
    EXPECT_TRUE(is_chain(found)) << seed;
    // The parameter alone couples with everything.
    EXPECT_EQ(std::ranges::count(found.chain->block, ChainStructure::kBorder),
              1)
        << seed;
    // States and the rows that determine them part the links.
    std::vector<int> separator(
        static_cast<std::size_t>(found.chain->num_links) + 1);
    for (const int block : found.chain->block) {
      if (block >= 0 && block % 2 == 0) {
        ++separator[static_cast<std::size_t>(block / 2)];
      }
    }
    EXPECT_LE(std::ranges::max(separator), 2 * states) << seed;
  }
}

/// Dense blocks of given sizes, each overlapping the next one by some unknowns.
Eigen::MatrixXd blocks(const std::vector<int>& sizes, int overlap) {
  int size = overlap;
  for (const int n : sizes) size += n - overlap;
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(size, size);
  int begin = 0;
  for (const int n : sizes) {
    K.block(begin, begin, n, n).setOnes();
    begin += n - overlap;
  }
  K.diagonal().setConstant(2.0);
  return K;
}

TEST(ChainDetection, IsRightForBlocksOfAllSizes) {
  for (const int overlap : {0, 1, 5, 20}) {
    for (const int wide : {25, 30, 60, 100}) {
      std::vector<int> sizes;
      for (int i = 0; i < 20; ++i) sizes.push_back(i % 2 == 0 ? wide : 45);
      const Found found = chain_of(blocks(sizes, overlap));
      ASSERT_TRUE(found.chain) << overlap << ' ' << wide;
      EXPECT_TRUE(is_chain(found)) << overlap << ' ' << wide;
    }
  }
  // Unknowns that nothing couples with.
  const Found diagonal = chain_of(Eigen::MatrixXd::Identity(400, 400));
  ASSERT_TRUE(diagonal.chain);
  EXPECT_TRUE(is_chain(diagonal));
}

TEST(ChainDetection, FindsABorderBesideWideSteps) {
  Random random(7);
  const Found found = chain_of(kkt_matrix(16, 20, 2, random));
  ASSERT_TRUE(found.chain);
  EXPECT_TRUE(is_chain(found));
}

TEST(ChainDetection, FindsNoneWhereEverythingIsClose) {
  // Each unknown beside some twenty others anywhere: a few steps from all.
  Random random(1);
  Eigen::MatrixXd K = Eigen::MatrixXd::Identity(400, 400);
  for (int i = 0; i < 400; ++i) {
    for (int k = 0; k < 10; ++k) {
      const int j = static_cast<int>(random.uniform(0.0, 400.0));
      K(i, j) = K(j, i) = 1.0;
    }
  }
  EXPECT_FALSE(chain_of(K).chain);
  EXPECT_FALSE(chain_of(Eigen::MatrixXd::Identity(3, 3)).chain);
}

TEST(ChainDetection, TakesPartsThatNothingJoins) {
  Random random(3);
  const Eigen::MatrixXd one = kkt_matrix(60, 2, 1, random);
  const Eigen::Index n = one.rows();
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  K.topLeftCorner(n, n) = one;
  K.bottomRightCorner(n, n) = kkt_matrix(60, 2, 1, random);

  const Found found = chain_of(K);

  ASSERT_TRUE(found.chain);
  EXPECT_TRUE(is_chain(found));
}

}  // namespace
}  // namespace brachisto::testing
