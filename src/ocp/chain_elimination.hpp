// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The linear systems of multiple shooting, solved by orthogonal elimination
/// along the chain of arcs.

#pragma once

#include <Eigen/Core>
#include <vector>

#include "math/dense.hpp"

namespace brachisto::ocp {

/// Linearised equations that belong to one node: for changes δs of the node, of
/// the next one and δq of the unknowns that any equation may have,
///
///     here δs_i + next δs_{i+1} + globals δq = −residual.
///
/// There are at least as many as the node has components; those of the last
/// node have no `next`.
struct ChainLink {
  Eigen::MatrixXd here, next, globals;
  Eigen::VectorXd residual;
};

/// Values of, or changes to, all unknowns.
struct ChainVector {
  std::vector<Eigen::VectorXd> nodes;
  Eigen::VectorXd globals;
};

/// Orthogonal factors of such a chain.
///
/// From the start on, the rows that are left over at a node, together with
/// those of the next one, form a column block whose QR factors give δs_i from
/// δs_{i+1} and δq, and the rows that go on to the next node. Orthogonal
/// transformations keep this stable whether the flow grows or shrinks, which
/// condensing by products of the arcs' matrices is not, and they keep the
/// lengths of residuals: what is found is the solution by least squares where
/// there are more equations than unknowns. What is left open by all of them
/// shows at the end, in a small matrix for the last node and q: its complete
/// orthogonal decomposition tells the rank, and of all changes the one that
/// changes these least is taken. Cost: linear in nodes.
class ChainElimination {
 public:
  explicit ChainElimination(const std::vector<ChainLink>& links);

  /// The change that makes the residuals of the links vanish.
  [[nodiscard]] ChainVector solve() const;

  /// A sum of unknowns, with such weights; nodes that have none are empty.
  using Functional = ChainVector;
  /// By how much it moves with the right-hand sides at most: the length of its
  /// row of the pseudo-inverse.
  [[nodiscard]] double looseness(const Functional& sum) const;

  /// Sign of the determinant of as many equations as unknowns, 1 or −1; 0 if
  /// they are singular.
  [[nodiscard]] int determinant_sign() const;

 private:
  struct Factors {
    Eigen::MatrixXd upper;  ///< triangular, of δs_i
    Eigen::MatrixXd next, globals;
    Eigen::VectorXd right;
  };
  std::vector<Factors> factors_;
  Eigen::Index last_ = 0;  ///< components of the last node
  bool mirrored_ = false;  ///< whether the transformations reverse a sign
  Eigen::MatrixXd final_matrix_;
  math::LeastSquares final_;
  Eigen::VectorXd final_right_;
};

}  // namespace brachisto::ocp
