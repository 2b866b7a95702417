// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/chain_elimination.hpp"

namespace brachisto::shooting {

ChainElimination::ChainElimination(const ChainJacobian& jacobian,
                                   const Globals& row) {
  constexpr int kStacked = kStartRows + 6;
  Eigen::Matrix<double, kStartRows, 6> states = jacobian.start_states;
  Eigen::Matrix<double, kStartRows, kGlobals> globals = jacobian.start_globals;
  links_.reserve(jacobian.arcs.size());
  for (const ChainJacobian::Arc& arc : jacobian.arcs) {
    Eigen::Matrix<double, kStacked, 6> column;
    column << states, -arc.states;
    Eigen::Matrix<double, kStacked, 6 + kGlobals> rest;
    rest.setZero();
    rest.bottomLeftCorner<6, 6>().setIdentity();
    rest.topRightCorner<kStartRows, kGlobals>() = globals;
    rest.bottomRightCorner<6, kGlobals>() = -arc.globals;

    Link link;
    link.qr.compute(column);
    rest.applyOnTheLeft(link.qr.householderQ().adjoint());
    link.next = rest.topLeftCorner<6, 6>();
    link.globals = rest.topRightCorner<6, kGlobals>();
    states = rest.bottomLeftCorner<kStartRows, 6>();
    globals = rest.bottomRightCorner<kStartRows, kGlobals>();
    links_.push_back(std::move(link));
  }
  Final last;
  last << states, globals, jacobian.end_states, jacobian.end_globals,
      Eigen::Matrix<double, 1, 6>::Zero(), row.transpose();
  final_.compute(last);
}

ChainVector ChainElimination::solve(const ChainRows& rows, double value) const {
  std::vector<Vector6> reduced(links_.size());
  Eigen::Matrix<double, kStartRows, 1> carried = -rows.start;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    Stacked stacked;
    stacked << carried, -rows.arcs[i];
    stacked.applyOnTheLeft(links_[i].qr.householderQ().adjoint());
    reduced[i] = stacked.head<6>();
    carried = stacked.tail<kStartRows>();
  }
  Eigen::Matrix<double, kFinalRows, 1> last;
  last << carried, -rows.end, value;
  last = final_.solve(last).eval();

  ChainVector solution;
  solution.globals = last.tail<kGlobals>();
  solution.nodes.resize(links_.size() + 1);
  solution.nodes.back() = last.head<6>();
  for (std::size_t i = links_.size(); i-- > 0;) {
    const Link& link = links_[i];
    const Vector6 right = reduced[i] - link.next * solution.nodes[i + 1] -
                          link.globals * solution.globals;
    solution.nodes[i] =
        link.qr.matrixQR().topRows<6>().triangularView<Eigen::Upper>().solve(
            right);
  }
  return solution;
}

ChainVector ChainElimination::solve(double value) const {
  ChainRows rows;
  rows.start.setZero();
  rows.arcs.assign(links_.size(), Vector6::Zero());
  rows.end.setZero();
  return solve(rows, value);
}

int ChainElimination::determinant_sign() const {
  // Each reflection has determinant −1; what remains is block triangular.
  int sign = 1;
  for (const Link& link : links_) {
    for (Eigen::Index j = 0; j < 6; ++j) {
      if (link.qr.hCoeffs()(j) != 0.0) sign = -sign;
      if (link.qr.matrixQR()(j, j) < 0.0) sign = -sign;
    }
  }
  const double last = final_.determinant();
  if (last == 0.0) return 0;
  return last > 0.0 ? sign : -sign;
}

}  // namespace brachisto::shooting
