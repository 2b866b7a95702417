// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The linearised equations of one node of a shooting over arcs, in the making.

#pragma once

#include "extremal/arc_flow.hpp"
#include "ocp/chain_elimination.hpp"

namespace brachisto::arcs {

/// The equations that belong to one node.
class NodeEquations {
 public:
  NodeEquations(Eigen::Index width, Eigen::Index next, Eigen::Index globals) {
    // Matching, the condition of its start, and what junctions add.
    constexpr Eigen::Index kMost = 2 * static_cast<Eigen::Index>(kSize) + 6;
    link_.here.setZero(kMost, width);
    link_.next.setZero(kMost, next);
    link_.globals.setZero(kMost, globals);
    link_.residual.setZero(kMost);
  }

  /// An equation of this node alone.
  void add(const Jet& value) {
    for (Eigen::Index j = 0; j < link_.here.cols(); ++j) {
      link_.here(size_, j) = value.gradient[static_cast<std::size_t>(j)];
    }
    link_.residual(size_++) = value.value;
  }
  /// That a function of the next node equals one of the end of a piece, which
  /// takes a share of the duration that is unknown `duration`.
  void add(const Jet& next, const Jet& last, const PieceEnd& end, int duration,
           double share) {
    const Eigen::Map<const Eigen::RowVectorXd> by(last.gradient.data(),
                                                  end.y.size());
    link_.here.row(size_) = -by * end.by_start;
    link_.globals(size_, duration) = -by.dot(end.rates) * share;
    for (Eigen::Index j = 0; j < link_.next.cols(); ++j) {
      link_.next(size_, j) = next.gradient[static_cast<std::size_t>(j)];
    }
    link_.residual(size_++) = next.value - last.value;
  }
  /// The derivative of the equation that was added last.
  [[nodiscard]] double& by_global(int i) { return link_.globals(size_ - 1, i); }
  /// Within an arc all components fit together.
  void match(const Node& next, const PieceEnd& end, int duration,
             double share) {
    const Eigen::Index width = next.size();
    link_.here.middleRows(size_, width) = -end.by_start;
    link_.next.middleRows(size_, width).setIdentity();
    link_.globals.col(duration).segment(size_, width) = -end.rates * share;
    link_.residual.segment(size_, width) = next - end.y;
    size_ += width;
  }
  /// Costates that mean nothing are zero.
  void pin_costates(const Node& y) {
    for (Eigen::Index i = kStates; i < y.size(); ++i) {
      link_.here(size_, i) = 1.0;
      link_.residual(size_++) = y(i);
    }
  }
  /// The states of a node fit together.
  void match_states(const Node& next, const PieceEnd& end, int duration,
                    double share) {
    const auto states = static_cast<Eigen::Index>(kStates);
    link_.here.middleRows(size_, states) = -end.by_start.topRows(states);
    link_.next.middleRows(size_, states).leftCols(states).setIdentity();
    link_.globals.col(duration).segment(size_, states) =
        -end.rates.head(states) * share;
    link_.residual.segment(size_, states) = (next - end.y).head(states);
    size_ += states;
  }

  [[nodiscard]] ocp::ChainLink take() const {
    return {link_.here.topRows(size_), link_.next.topRows(size_),
            link_.globals.topRows(size_), link_.residual.head(size_)};
  }

 private:
  ocp::ChainLink link_;
  Eigen::Index size_ = 0;
};

}  // namespace brachisto::arcs
