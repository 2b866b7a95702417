// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "ocp/chain_elimination.hpp"

#include <cassert>
#include <cmath>
#include <utility>

namespace brachisto::ocp {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

ChainElimination::ChainElimination(const std::vector<ChainLink>& links) {
  const Index globals = links.front().globals.cols();
  // Rows that are left over: of the node, of q, and the right-hand side.
  MatrixXd carried(0, links.front().here.cols() + globals + 1);
  for (const ChainLink& link : links) {
    const Index width = link.here.cols();
    const Index next = link.next.cols();
    const Index before = carried.rows();
    const Index rows = before + link.here.rows();
    assert(rows >= width);
    // [here | next | globals | right-hand side]
    MatrixXd all = MatrixXd::Zero(rows, width + next + globals + 1);
    all.topLeftCorner(before, width) = carried.leftCols(width);
    all.topRightCorner(before, globals + 1) = carried.rightCols(globals + 1);
    all.bottomLeftCorner(link.here.rows(), width) = link.here;
    all.block(before, width, link.here.rows(), next) = link.next;
    all.block(before, width + next, link.here.rows(), globals) = link.globals;
    all.bottomRightCorner(link.here.rows(), 1) = -link.residual;
    if (&link == &links.back()) {
      last_ = width;
      final_matrix_ = all.leftCols(width + globals);
      final_ = math::LeastSquares(final_matrix_);
      final_right_ = all.rightCols(1);
      return;
    }
    const auto& [upper, rest, mirrored] = math::triangularise(all, width);
    Factors& out = factors_.emplace_back();
    out.upper = upper;
    out.next = rest.topLeftCorner(width, next);
    out.globals = rest.block(0, next, width, globals);
    out.right = rest.topRightCorner(width, 1);
    carried = rest.bottomRows(rows - width);
    // A negative pivot reverses the sign too.
    const bool negative = (upper.diagonal().array() < 0.0).count() % 2 != 0;
    mirrored_ = mirrored_ != (mirrored != negative);
  }
}

ChainVector ChainElimination::solve() const {
  const VectorXd last = final_.solve(final_right_);
  ChainVector out;
  out.globals = last.tail(last.size() - last_);
  out.nodes.resize(factors_.size() + 1);
  out.nodes.back() = last.head(last_);
  for (std::size_t i = factors_.size(); i-- > 0;) {
    const Factors& factors = factors_[i];
    const VectorXd right = factors.right - factors.next * out.nodes[i + 1] -
                           factors.globals * out.globals;
    out.nodes[i] = factors.upper.triangularView<Eigen::Upper>().solve(right);
  }
  return out;
}

// The rows of the pseudo-inverse are those of R⁻¹ Qᵀ, Q having orthonormal
// columns: ‖eᵀ R⁻¹‖, by substitution from the start on.
double ChainElimination::looseness(const Functional& sum) const {
  double square = 0.0;
  VectorXd globals = sum.globals;
  VectorXd carried;
  const auto own = [&](std::size_t i, Index width) -> VectorXd {
    return sum.nodes[i].size() > 0 ? sum.nodes[i] : VectorXd::Zero(width);
  };
  for (std::size_t i = 0; i < factors_.size(); ++i) {
    const Factors& factors = factors_[i];
    VectorXd right = own(i, factors.upper.cols());
    if (i > 0) right -= carried;
    const VectorXd z =
        factors.upper.transpose().triangularView<Eigen::Lower>().solve(right);
    square += z.squaredNorm();
    carried = factors.next.transpose() * z;
    globals -= factors.globals.transpose() * z;
  }
  VectorXd right(last_ + globals.size());
  right << own(factors_.size(), last_), globals;
  if (!factors_.empty()) right.head(last_) -= carried;
  const MatrixXd inverse = final_.pseudo_inverse();
  return std::sqrt(square + (inverse.transpose() * right).squaredNorm());
}

int ChainElimination::determinant_sign() const {
  assert(final_matrix_.rows() == final_matrix_.cols());
  const double last = math::determinant(final_matrix_);
  if (last == 0.0 || !std::isfinite(last)) return 0;
  return (last > 0.0) != mirrored_ ? 1 : -1;
}

}  // namespace brachisto::ocp
