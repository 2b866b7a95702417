// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The solutions along a branch, and where they point.

#pragma once

#include <algorithm>
#include <deque>
#include <functional>

#include "brachisto/nlp/problem.hpp"
#include "brachisto/ocp/mesh.hpp"

namespace brachisto {

/// A solution on the way.
struct BranchPoint {
  double fraction;  ///< of the whole way
  Mesh mesh;        ///< on which the solution is given
  PrimalDual point;
  double phi;  ///< [rad]
};

/// How solutions are continued.
struct Prediction {
  /// Largest degree of the polynomials through the last solutions.
  int most_degree = 3;
  /// The fraction up to which a branch changes by leaps: polynomials are in
  /// log(1 + fraction/knee). 0: in the fraction itself.
  double knee = 0.0;
  /// The mesh changes along the way, and is predicted too.
  bool moving_mesh = false;
};

/// How far two points of a branch are apart, in whatever counts.
using BranchDistance =
    std::function<double(const BranchPoint&, const BranchPoint&)>;

/// The last solutions on a branch, and the polynomials through them.
///
/// The error of the polynomial of degree k at t is C_k (t − t_0) ⋯ (t − t_k),
/// the t_i being the last points. Each new solution tells C_k for every k that
/// there were points for, and so which degree reaches furthest with an error
/// that is wanted: low ones where the branch bends sharply, high ones where it
/// is smooth.
class BranchHistory {
 public:
  BranchHistory(BranchPoint start, const Prediction& prediction);

  /// Chooses the degree of the next prediction too.
  ///
  /// \param wanted  error of a prediction
  /// \param growth  largest ratio of a step to the one before it
  /// \return the step to the next solution, as a distance()
  double add(BranchPoint point, const BranchDistance& error, double wanted,
             double growth);
  /// The same on a moving mesh, where predictions of other degrees have other
  /// meshes and their errors are not known: the degree is the largest there are
  /// points for.
  ///
  /// \param error  of the prediction that led to the point
  double add(BranchPoint point, double error, double wanted, double growth);
  /// After a step that failed: lines cannot be led astray as far as other
  /// polynomials, which see a fold ahead as a steep ascent.
  void expect_less() {
    if (!prediction_.moving_mesh) degree_ = std::min(degree_, 1);
  }
  [[nodiscard]] const BranchPoint& last() const { return points_.front(); }
  /// The polynomial through the last points, at `fraction`. The boundaries of a
  /// moving mesh need not be in order.
  [[nodiscard]] BranchPoint predict(double fraction) const {
    return predict(fraction, degree_);
  }

  /// How far along the variable of the polynomials a fraction is.
  [[nodiscard]] double distance(double fraction) const;
  [[nodiscard]] double fraction_at(double distance) const;

 private:
  void push(BranchPoint point);
  [[nodiscard]] int available_degree() const {
    return static_cast<int>(points_.size()) - 1;
  }
  [[nodiscard]] BranchPoint predict(double fraction, int degree) const;
  /// (t − t_0) ⋯ (t − t_degree).
  [[nodiscard]] double product(double t, int degree) const;

  std::deque<BranchPoint> points_;  ///< the last one in front
  Prediction prediction_;
  int degree_ = 0;  ///< of the next prediction
};

}  // namespace brachisto
