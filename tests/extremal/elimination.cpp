// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cstdlib>

#include "extremal/chain_elimination.hpp"

namespace brachisto::shooting {
namespace {

constexpr int kArcs = 4;
constexpr int kSize = 6 * (kArcs + 1) + kGlobals;
constexpr int kFirstGlobal = 6 * (kArcs + 1);

using Dense = Eigen::MatrixXd;

/// A chain with random entries. Eigen draws from std::rand.
struct RandomChain {
  explicit RandomChain(unsigned seed) {
    std::srand(seed);
    jacobian.start_states.setRandom();
    jacobian.start_globals.setRandom();
    jacobian.arcs.resize(kArcs);
    for (auto& arc : jacobian.arcs) {
      arc.states.setRandom();
      arc.globals.setRandom();
      rows.arcs.push_back(Vector6::Random());
    }
    jacobian.end_states.setRandom();
    jacobian.end_globals.setRandom();
    rows.start.setRandom();
    rows.end.setRandom();
    last.setRandom();
  }

  [[nodiscard]] Dense dense() const {
    Dense matrix = Dense::Zero(kSize, kSize);
    matrix.block<kStartRows, 6>(0, 0) = jacobian.start_states;
    matrix.block<kStartRows, kGlobals>(0, kFirstGlobal) =
        jacobian.start_globals;
    int row = kStartRows;
    for (int i = 0; i < kArcs; ++i, row += 6) {
      const auto& arc = jacobian.arcs[static_cast<std::size_t>(i)];
      matrix.block<6, 6>(row, 6 * i) = -arc.states;
      matrix.block<6, 6>(row, 6 * i + 6).setIdentity();
      matrix.block<6, kGlobals>(row, kFirstGlobal) = -arc.globals;
    }
    matrix.block<kEndRows, 6>(row, 6 * kArcs) = jacobian.end_states;
    matrix.block<kEndRows, kGlobals>(row, kFirstGlobal) = jacobian.end_globals;
    matrix.block<1, kGlobals>(kSize - 1, kFirstGlobal) = last.transpose();
    return matrix;
  }

  [[nodiscard]] Eigen::VectorXd right_hand_side(double value) const {
    Eigen::VectorXd out(kSize);
    out << -rows.start, -rows.arcs[0], -rows.arcs[1], -rows.arcs[2],
        -rows.arcs[3], -rows.end, value;
    return out;
  }

  ChainJacobian jacobian;
  ChainRows rows;
  Globals last;
};

TEST(ChainElimination, AgreesWithADenseFactorisation) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const RandomChain chain(seed);
    const Eigen::VectorXd expected =
        chain.dense().fullPivLu().solve(chain.right_hand_side(0.7));

    const ChainVector found =
        ChainElimination(chain.jacobian, chain.last).solve(chain.rows, 0.7);

    const double tolerance = 1e-10 * expected.norm();
    for (int i = 0; i <= kArcs; ++i) {
      EXPECT_LT((found.nodes[static_cast<std::size_t>(i)] -
                 expected.segment<6>(6 * i))
                    .norm(),
                tolerance)
          << "node " << i << ", seed " << seed;
    }
    EXPECT_LT((found.globals - expected.tail<kGlobals>()).norm(), tolerance)
        << "seed " << seed;
  }
}

TEST(ChainElimination, KnowsTheSignOfTheDeterminant) {
  int positive = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const RandomChain chain(seed);
    const double determinant = chain.dense().determinant();

    const int sign =
        ChainElimination(chain.jacobian, chain.last).determinant_sign();

    EXPECT_EQ(sign, determinant > 0.0 ? 1 : -1) << "seed " << seed;
    if (sign > 0) ++positive;
  }
  EXPECT_GT(positive, 0);
  EXPECT_LT(positive, 20);
}

}  // namespace
}  // namespace brachisto::shooting
