// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/continuation.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace brachisto::arcs {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using ocp::ChainElimination;
using ocp::ChainLink;
using ocp::ChainVector;

// Those repeated with half the length included.
constexpr int kMostSteps = 2000;
constexpr double kFirstStep = 0.1;  // as measured by Branch::measure()
constexpr double kLongestStep = 0.4;
constexpr double kShortestStep = 1e-7;
constexpr double kWantedContraction = 0.1;
constexpr double kLargestContraction = 0.4;
constexpr double kLargestCorrection = 0.15;  // in steps
constexpr double kSmallestCosine = 0.95;     // between successive tangents

/// Enough digits to stay on the branch; the last point gets the others. The
/// longer the path, the more a local error moves its end: measured, about with
/// the square of the number of turns.
ocp::StepControl loose(int num_pieces) {
  constexpr double kLocalError = 1e-9;
  constexpr double kTightest = 1e-13;
  constexpr double kShort = 6.0;  // pieces
  const double excess = std::max(1.0, num_pieces / kShort);
  return {.tolerance = std::max(kTightest, kLocalError / (excess * excess)),
          .halve = false};
}

/// A linear function of the last node and of the globals, with the parameter
/// behind them.
struct EndRow {
  VectorXd node, globals;

  [[nodiscard]] double of(const ChainVector& v) const {
    return node.dot(v.nodes.back()) + globals.dot(v.globals);
  }
};

/// Direction of the branch at a solution.
struct Tangent {
  ChainVector direction;  ///< of unit length
  EndRow along;           ///< how far a change leads along it
  /// Sign of the determinant of the equations with `along` as last row. It is
  /// the same all along a branch (Keller 1977), and different on the other side
  /// of two branches that nearly cross.
  int orientation = 0;

  [[nodiscard]] double parameter() const {
    return direction.globals(direction.globals.size() - 1);
  }
};

/// A solution, or where Newton's method gave up.
struct Corrected {
  bool converged = false;
  ChainVector point;
  std::vector<ChainLink> links;
  Jet slope_at_B;
  double transit_time = 0.0;
  int steps = 0;
  double contraction = 0.0;  ///< ‖second correction‖ / ‖first‖

  [[nodiscard]] double parameter() const {
    return point.globals(point.globals.size() - 1);
  }
};

class Branch {
 public:
  Branch(const ArcSystem& system, const ChainVector& start,
         const Family& family)
      : system_(system),
        family_(family),
        control_(loose(system.num_pieces())),
        start_(start) {
    start_.globals.conservativeResize(start.globals.size() + 1);
    start_.globals(start.globals.size()) = family.from;
    // Natural sizes: those of the start for times and costates, 1 for lengths,
    // speeds and angles; p_θ is r times a costate of arc length.
    const VectorXd& end = start.nodes.back();
    const double p = std::hypot(end(free_arc::kPX), end(free_arc::kPZ));
    const double p_w = std::abs(start.nodes.front()(free_arc::kPW));
    node_size_.setOnes(end.size());
    node_size_(free_arc::kPX) = node_size_(free_arc::kPZ) = p;
    node_size_(free_arc::kPTheta) =
        1.0 / rotation_per_length(family.scene(family.from));
    node_size_(free_arc::kPW) = std::max(1.0, p_w);
    global_size_.setOnes(start_.globals.size());
    global_size_.head(start.globals.size()) = start.globals;
  }

  [[nodiscard]] FollowedBranch follow(
      const std::function<void(double)>& reached) const;

 private:
  [[nodiscard]] bool linearise(Corrected& at) const;
  [[nodiscard]] Corrected correct(ChainVector predicted, const EndRow& row,
                                  double value) const;
  [[nodiscard]] Tangent tangent_at(const Corrected& here,
                                   const EndRow& along) const;
  [[nodiscard]] MatrixXd measure(const Jet& slope_at_B) const;
  [[nodiscard]] double distance(const MatrixXd& measure,
                                const ChainVector& change) const;
  [[nodiscard]] double size_of(const ChainVector& change) const;
  [[nodiscard]] EndRow parameter_row() const;
  [[nodiscard]] double fold_between(const Corrected& here,
                                    const Tangent& tangent, double length,
                                    double slope) const;

  const ArcSystem& system_;
  const Family& family_;
  ocp::StepControl control_;
  ChainVector start_;
  VectorXd node_size_, global_size_;
};

// The derivative by the parameter is a difference: directions need few digits,
// and the equations have a solution whatever they are.
bool Branch::linearise(Corrected& at) const {
  constexpr double kDifference = 1e-5;
  const Index globals = at.point.globals.size() - 1;
  const double parameter = at.parameter();
  ArcSystem::Point inner{at.point.nodes, at.point.globals.head(globals)};
  ArcSystem::Linearisation here, beside;
  const auto evaluate = [&](double value, ArcSystem::Linearisation& out,
                            bool derivatives) {
    return system_.in(family_.scene(value))
        .evaluate(inner, control_, out, derivatives);
  };
  if (!evaluate(parameter, here, true) ||
      !evaluate(parameter + kDifference, beside, false)) {
    return false;
  }
  at.links = std::move(here.links);
  for (std::size_t i = 0; i < at.links.size(); ++i) {
    MatrixXd& by = at.links[i].globals;
    by.conservativeResize(Eigen::NoChange, globals + 1);
    by.col(globals) =
        (beside.links[i].residual - at.links[i].residual) / kDifference;
  }
  at.slope_at_B = here.slope_at_B;
  at.transit_time = here.transit_time;
  return true;
}

/// The links with one more row at the end.
std::vector<ChainLink> bordered(std::vector<ChainLink> links, const EndRow& row,
                                double gap) {
  ChainLink& last = links.back();
  const Index rows = last.residual.size();
  last.here.conservativeResize(rows + 1, Eigen::NoChange);
  last.next.conservativeResize(rows + 1, Eigen::NoChange);
  last.globals.conservativeResize(rows + 1, Eigen::NoChange);
  last.residual.conservativeResize(rows + 1);
  last.here.row(rows) = row.node.transpose();
  last.globals.row(rows) = row.globals.transpose();
  last.residual(rows) = gap;
  return links;
}

/// Newton's method, undamped: what does not contract is too far from the
/// branch.
Corrected Branch::correct(ChainVector predicted, const EndRow& row,
                          double value) const {
  constexpr int kMost = 6;
  constexpr double kSmall = 1e-7, kGrowing = 0.75;
  Corrected out;
  out.point = std::move(predicted);
  double before = 0.0;
  for (;; ++out.steps) {
    if (!linearise(out)) return out;
    const ChainVector change =
        ChainElimination(bordered(out.links, row, row.of(out.point) - value))
            .solve();
    const double size = size_of(change);
    if (out.steps == 1) out.contraction = size / before;
    out.converged = size <= kSmall;
    const bool lost = out.steps > 0 && !(size <= kGrowing * before);
    if (out.converged || lost || out.steps == kMost) return out;
    out.point = moved(out.point, 1.0, change);
    before = size;
  }
}

/// What distances are measured in, by the last node and by the globals: U, p_x
/// and p_z at B, φ and the parameter.
MatrixXd Branch::measure(const Jet& slope_at_B) const {
  const Index width = node_size_.size();
  MatrixXd out =
      MatrixXd::Zero(3 + global_size_.size(), width + global_size_.size());
  for (const Index p : {free_arc::kPX, free_arc::kPZ}) {
    out(p - free_arc::kPX, p) = 1.0 / node_size_(p);
  }
  for (Index j = 0; j < width; ++j) {
    out(2, j) = slope_at_B.gradient[static_cast<std::size_t>(j)];
  }
  for (Index j = 0; j < global_size_.size(); ++j) {
    out(3 + j, width + j) = 1.0 / global_size_(j);
  }
  return out;
}

double Branch::distance(const MatrixXd& measure,
                        const ChainVector& change) const {
  VectorXd end(measure.cols());
  end << change.nodes.back(), change.globals;
  return (measure * end).norm();
}

double Branch::size_of(const ChainVector& change) const {
  double largest =
      change.globals.cwiseQuotient(global_size_).lpNorm<Eigen::Infinity>();
  for (const VectorXd& node : change.nodes) {
    largest = std::max(
        largest, node.cwiseQuotient(node_size_).lpNorm<Eigen::Infinity>());
  }
  return largest;
}

EndRow Branch::parameter_row() const {
  const Index globals = global_size_.size();
  return {VectorXd::Zero(node_size_.size()),
          VectorXd::Unit(globals, globals - 1)};
}

/// The tangent that makes an acute angle with `along`.
Tangent Branch::tangent_at(const Corrected& here, const EndRow& along) const {
  std::vector<ChainLink> links = here.links;
  for (ChainLink& link : links) link.residual.setZero();
  const ChainElimination chain(bordered(std::move(links), along, -1.0));
  Tangent out{chain.solve(), {}, chain.determinant_sign()};
  const MatrixXd in = measure(here.slope_at_B);
  const double length = distance(in, out.direction);
  out.direction.globals /= length;
  for (VectorXd& node : out.direction.nodes) node /= length;
  VectorXd end(in.cols());
  end << out.direction.nodes.back(), out.direction.globals;
  const VectorXd row = in.transpose() * (in * end);
  out.along = {row.head(node_size_.size()), row.tail(global_size_.size())};
  return out;
}

/// The parameter at the fold between two points of the branch, by regula falsi
/// on how far to go along the tangent until it stands still.
///
/// \param slope  of the parameter at the end of the step of this length
double Branch::fold_between(const Corrected& here, const Tangent& tangent,
                            double length, double slope) const {
  constexpr int kSteps = 8;
  constexpr double kFlat = 1e-5;
  double low = 0.0;
  double slope_low = tangent.parameter();
  double high = length;
  double slope_high = slope;
  double parameter = here.parameter();
  for (int i = 0; i < kSteps; ++i) {
    const double middle =
        low + (high - low) * slope_low / (slope_low - slope_high);
    const ChainVector predicted = moved(here.point, middle, tangent.direction);
    const Corrected at =
        correct(predicted, tangent.along, tangent.along.of(predicted));
    if (!at.converged) return parameter;
    parameter = at.parameter();
    const double found = tangent_at(at, tangent.along).parameter();
    if (std::abs(found) < kFlat) return parameter;
    if (found * slope_low > 0.0) {
      low = middle;
      slope_low = found;
      slope_high *= 0.5;  // the Illinois variant: never keep an end for long
    } else {
      high = middle;
      slope_high = found;
      slope_low *= 0.5;
    }
  }
  return parameter;
}

FollowedBranch Branch::follow(
    const std::function<void(double)>& reached) const {
  const EndRow parameter = parameter_row();
  FollowedBranch branch;
  const auto keep = [&](const Corrected& at) {
    branch.point = {at.point.nodes,
                    at.point.globals.head(at.point.globals.size() - 1)};
    branch.points.push_back(
        {at.parameter(), at.slope_at_B.value, at.transit_time});
    if (reached) reached(at.parameter());
  };
  Corrected here = correct(start_, parameter, family_.from);
  branch.newton_steps += here.steps;
  if (!here.converged) {
    branch.point = system_.start();
    return branch;
  }
  keep(here);
  Tangent tangent = tangent_at(here, parameter);
  double step = kFirstStep;

  for (int i = 0; i < kMostSteps; ++i) {
    const double slope = tangent.parameter();
    const double to_target = (family_.to - here.parameter()) / slope;
    const bool lands = to_target > 0.0 && to_target <= step;
    const double length = lands ? to_target : step;
    const ChainVector predicted = moved(here.point, length, tangent.direction);
    Corrected next =
        lands ? correct(predicted, parameter, family_.to)
              : correct(predicted, tangent.along, tangent.along.of(predicted));
    branch.newton_steps += next.steps;
    bool good = next.converged && next.contraction <= kLargestContraction &&
                distance(measure(next.slope_at_B),
                         moved(next.point, -1.0, predicted)) <=
                    kLargestCorrection * length &&
                next.parameter() <= family_.to + 1e-12;
    Tangent next_tangent;
    if (good) {
      next_tangent = tangent_at(next, tangent.along);
      good = tangent.along.of(next_tangent.direction) >= kSmallestCosine &&
             next_tangent.orientation == tangent.orientation;
    }
    if (!good) {
      ++branch.rejected_steps;
      step = 0.5 * length;
      if (step < kShortestStep) {
        branch.end = BranchEnd::StepTooSmall;
        return branch;
      }
      continue;
    }

    const double next_slope = next_tangent.parameter();
    const bool fold = next_slope * slope < 0.0;
    if (fold) {
      branch.folds.push_back(fold_between(here, tangent, length, next_slope));
    }
    keep(next);
    const double contraction = next.contraction;
    here = std::move(next);
    tangent = std::move(next_tangent);
    if (lands) {
      branch.end = BranchEnd::Reached;
      return branch;
    }
    if ((fold && !family_.follow_folds) || here.parameter() < family_.from) {
      branch.end = BranchEnd::TurnsBack;
      return branch;
    }
    const double growth =
        std::sqrt(kWantedContraction / std::max(contraction, 1e-3));
    step = std::min(kLongestStep, length * std::clamp(growth, 0.3, 2.0));
  }
  branch.end = BranchEnd::MaxSteps;
  return branch;
}

}  // namespace

FollowedBranch follow_branch(const ArcSystem& system,
                             const ArcSystem::Point& start,
                             const Family& family,
                             const std::function<void(double)>& reached) {
  assert(system.num_arcs() == 1 && family.from < family.to);
  return Branch(system, start, family).follow(reached);
}

}  // namespace brachisto::arcs
