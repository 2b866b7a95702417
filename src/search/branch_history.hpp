// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The solutions along a branch, and where they point.

#pragma once

#include <deque>

#include "brachisto/nlp/problem.hpp"
#include "transcription/mesh.hpp"

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
  /// Degree of the polynomial through the last solutions, if there are so many.
  int degree = 1;
  /// The fraction up to which a branch changes by leaps: polynomials are in
  /// log(1 + fraction/knee). 0: in the fraction itself.
  double knee = 0.0;
  /// The mesh changes along the way, and is predicted too.
  bool moving_mesh = false;
};

/// The last solutions on a branch, enough of them for one prediction.
class BranchHistory {
 public:
  BranchHistory(BranchPoint start, const Prediction& prediction);

  void add(BranchPoint point);
  [[nodiscard]] const BranchPoint& last() const { return points_.back(); }
  /// Degree of the next prediction.
  [[nodiscard]] int degree() const {
    return static_cast<int>(points_.size()) - 1;
  }
  /// The polynomial through the points, at `fraction`. The boundaries of a
  /// moving mesh need not be in order.
  [[nodiscard]] BranchPoint predict(double fraction) const;

  /// How far along the variable of the polynomials a fraction is.
  [[nodiscard]] double distance(double fraction) const;
  [[nodiscard]] double fraction_at(double distance) const;

 private:
  std::deque<BranchPoint> points_;
  Prediction prediction_;
};

}  // namespace brachisto
