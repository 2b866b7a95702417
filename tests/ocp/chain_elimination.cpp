// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Elimination along a chain against dense factors of the whole system.

#include "ocp/chain_elimination.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <Eigen/QR>
#include <vector>

#include "support/random_points.hpp"

namespace brachisto::testing {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using ocp::ChainElimination;
using ocp::ChainLink;
using ocp::ChainVector;

constexpr unsigned kChainSeed = 20260412;
constexpr Index kGlobals = 3;
const std::vector<Index> kWidths{4, 4, 6, 6, 4, 5};

MatrixXd random_matrix(Random& random, Index rows, Index cols) {
  MatrixXd out(rows, cols);
  for (double& x : out.reshaped()) x = random.uniform(-1.0, 1.0);
  return out;
}

/// Nodes of different widths; `more` equations than unknowns.
std::vector<ChainLink> random_chain(Random& random, Index more) {
  std::vector<ChainLink> links;
  for (std::size_t i = 0; i < kWidths.size(); ++i) {
    const bool last = i + 1 == kWidths.size();
    const Index next = last ? 0 : kWidths[i + 1];
    Index rows = std::max(next, kWidths[i]) + (i == 0 ? 3 : 0);
    if (last) rows = kWidths[i] + more;
    links.push_back({random_matrix(random, rows, kWidths[i]),
                     random_matrix(random, rows, next),
                     random_matrix(random, rows, kGlobals),
                     random_matrix(random, rows, 1)});
  }
  return links;
}

struct Dense {
  MatrixXd matrix;
  VectorXd right;
};

Dense dense(const std::vector<ChainLink>& links) {
  Index rows = 0, columns = 0;
  for (const ChainLink& link : links) {
    rows += link.here.rows();
    columns += link.here.cols();
  }
  Dense out{MatrixXd::Zero(rows, columns + kGlobals), VectorXd(rows)};
  Index row = 0, column = 0;
  for (const ChainLink& link : links) {
    const Index size = link.here.rows();
    out.matrix.block(row, column, size, link.here.cols()) = link.here;
    column += link.here.cols();
    out.matrix.block(row, column, size, link.next.cols()) = link.next;
    out.matrix.block(row, columns, size, kGlobals) = link.globals;
    out.right.segment(row, size) = -link.residual;
    row += size;
  }
  return out;
}

VectorXd stacked(const ChainVector& vector) {
  Index size = vector.globals.size();
  for (const VectorXd& node : vector.nodes) size += node.size();
  VectorXd out(size);
  Index at = 0;
  for (const VectorXd& node : vector.nodes) {
    out.segment(at, node.size()) = node;
    at += node.size();
  }
  out.tail(vector.globals.size()) = vector.globals;
  return out;
}

// Thirty unknowns of order one; condition numbers of random matrices of this
// size are a few thousand at most.
constexpr double kEliminationRounding = 1e-10;

TEST(ChainElimination, SolvesByLeastSquares) {
  Random random(kChainSeed);
  for (const Index more : {0, 1, 4}) {
    const std::vector<ChainLink> links = random_chain(random, more);
    const Dense whole = dense(links);
    const VectorXd expected =
        whole.matrix.completeOrthogonalDecomposition().solve(whole.right);

    const VectorXd found = stacked(ChainElimination(links).solve());

    EXPECT_LE((found - expected).norm(), kEliminationRounding * expected.norm())
        << more;
  }
}

TEST(ChainElimination, MeetsAllEquationsWhereSomeUnknownsAreLeftOpen) {
  Random random(kChainSeed);
  std::vector<ChainLink> links = random_chain(random, 0);
  ChainLink& last = links.back();
  // The last component of the last node, and a global, in no equation.
  last.here.col(4).setZero();
  links[links.size() - 2].next.col(4).setZero();
  for (ChainLink& link : links) link.globals.col(1).setZero();
  // Equations that agree: of the right-hand side of some unknowns.
  const Dense whole = dense(links);
  const VectorXd unknowns = random_matrix(random, whole.matrix.cols(), 1);
  const VectorXd right = whole.matrix * unknowns;
  Index row = 0;
  for (ChainLink& link : links) {
    link.residual = -right.segment(row, link.residual.size());
    row += link.residual.size();
  }

  const VectorXd found = stacked(ChainElimination(links).solve());

  EXPECT_LE((whole.matrix * found - right).norm(),
            kEliminationRounding * right.norm());
  EXPECT_NEAR(found(found.size() - 2), 0.0, kEliminationRounding);
  EXPECT_NEAR(found(found.size() - kGlobals - 1), 0.0, kEliminationRounding);
}

TEST(ChainElimination, TellsHowLooseASumOfUnknownsIs) {
  Random random(kChainSeed);
  const std::vector<ChainLink> links = random_chain(random, 2);
  const MatrixXd inverse =
      dense(links).matrix.completeOrthogonalDecomposition().pseudoInverse();
  const ChainElimination chain(links);
  Index first = 0;
  for (std::size_t i = 0; i < kWidths.size(); ++i) {
    ChainElimination::Functional sum;
    sum.nodes.resize(kWidths.size());
    sum.nodes[i] = random_matrix(random, kWidths[i], 1);
    sum.globals = random_matrix(random, kGlobals, 1);
    const Eigen::RowVectorXd row =
        sum.nodes[i].transpose() * inverse.middleRows(first, kWidths[i]) +
        sum.globals.transpose() * inverse.bottomRows(kGlobals);

    EXPECT_NEAR(chain.looseness(sum), row.norm(),
                kEliminationRounding * row.norm())
        << i;

    first += kWidths[i];
  }
}

TEST(ChainElimination, KnowsTheSignOfTheDeterminant) {
  constexpr Index kWidth = 4, kNodes = 5, kAtStart = 2;
  Random random(kChainSeed);
  int positive = 0;
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<ChainLink> links;
    for (Index i = 0; i < kNodes; ++i) {
      const bool last = i + 1 == kNodes;
      const Index rows = last     ? kWidth + kGlobals - kAtStart
                         : i == 0 ? kWidth + kAtStart
                                  : kWidth;
      links.push_back({random_matrix(random, rows, kWidth),
                       random_matrix(random, rows, last ? 0 : kWidth),
                       random_matrix(random, rows, kGlobals),
                       random_matrix(random, rows, 1)});
    }
    const double determinant = dense(links).matrix.determinant();

    const int sign = ChainElimination(links).determinant_sign();

    EXPECT_EQ(sign, determinant > 0.0 ? 1 : -1) << trial;
    if (sign > 0) ++positive;
  }
  EXPECT_GT(positive, 0);
  EXPECT_LT(positive, 20);
}

}  // namespace
}  // namespace brachisto::testing
