// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// An extremal as a function of the rolling time, arc by arc.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "extremal/arc_boundary.hpp"
#include "extremal/arc_flow.hpp"

namespace brachisto::arcs {

/// An extremal through the steps of its integration; between them
/// it is integrated anew, so that every point has the accuracy of the
/// integration. All in natural units.
class ArcPath {
 public:
  /// An arc, and what the costates of the states do at its end.
  struct Stretch {
    ArcFlow flow;
    double duration = 0.0;    ///< of u
    std::vector<Knot> knots;  ///< ascending in u, from the start of the arc
    /// They jump by Λ ∂c/∂y of this limit.
    std::optional<HeldLimit> jumps_along = {};
    double jump = 0.0;  ///< Λ
  };

  ArcPath() = default;
  /// \param leave  how the first arc leaves A, nothing: freely; of the costates
  ///               of one that is Forced nothing is known
  ArcPath(std::vector<Stretch> arcs, std::optional<Departure> leave);

  [[nodiscard]] bool empty() const { return arcs_.empty(); }
  [[nodiscard]] const std::vector<Stretch>& arcs() const { return arcs_; }
  /// Whether the costates of an arc mean nothing.
  [[nodiscard]] bool blind(std::size_t arc) const {
    return arc == 0 && leave_ && leave_->kind() == Departure::Kind::Forced;
  }
  /// U.
  [[nodiscard]] double rolling_time() const;
  /// With which A is touched.
  [[nodiscard]] double slope_at_start() const {
    const State start = at(0, 0.0).y;
    return leave_ ? leave_->contact_slope(start) : start[kBeta];
  }
  /// By how much the first slope behind A differs from it: by what an arc turns
  /// that is too short to tell.
  [[nodiscard]] double kink_at_start() const {
    return slope_at_start() - at(0, 0.0).y[kBeta];
  }
  [[nodiscard]] double slope_at_end() const {
    return at(arcs_.size() - 1, arcs_.back().knots.back().u).y[kBeta];
  }
  /// At so much u from the start of an arc; costs one step of the integration.
  [[nodiscard]] ArcPoint at(std::size_t arc, double u) const;
  /// The same as the integration has it. \pre the arc is not blind()
  [[nodiscard]] Knot knot_at(std::size_t arc, double u) const;

  /// Why the path is no extremal under the limits although its equations hold:
  /// a limit is exceeded, a multiplier or a jump has the wrong sign, a free arc
  /// is no minimum, the body rests. Empty if it is one. Looks at every step.
  [[nodiscard]] std::string objection(
      const std::vector<PathInequality>& limits) const;

 private:
  std::vector<Stretch> arcs_;
  std::optional<Departure> leave_;
};

}  // namespace brachisto::arcs
