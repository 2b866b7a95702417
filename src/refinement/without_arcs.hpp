// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The path under limits on a mesh that knows no arcs.

#pragma once

#include <functional>
#include <optional>

#include "refinement/arc_fit.hpp"
#include "refinement/pass_protocol.hpp"

namespace brachisto {

/// Of T, relative, what a path without arcs may err by where no other tolerance
/// is stated: at junctions, which lie within elements, its program has order
/// one or two.
inline constexpr double kToleranceWithoutArcs = 1e-4;
inline constexpr const char* kSolvedWithoutArcs =
    "solved under limits on a mesh that knows no arcs; where limits begin and "
    "cease to hold was not found";

/// Whether limits are equations along known arcs; else they are inequalities.
[[nodiscard]] inline bool arcs_are_known(const LimitedCurve& curve) {
  return curve.problem().held().has_value();
}

/// A solution of the program that keeps the limits between the points too. It
/// has no arcs.
struct PathWithoutArcs {
  FittedPath path;
  /// Relative, of T: what the last meshes changed, finer everywhere or where
  /// limits are kept, and what it costs to keep them between the points.
  double estimated_error;
};

/// What solve_without_arcs() comes to.
struct SolvedWithoutArcs {
  /// Nothing if a mesh has no solution, or so many do not suffice; the protocol
  /// tells why.
  std::optional<PathWithoutArcs> path;
  /// On the last mesh on which the contact was closed.
  std::optional<LimitedCurve> closed;

  /// What tells most of the arcs, which may do although it is not accurate
  /// itself; null if no contact was closed.
  [[nodiscard]] const LimitedCurve* finest() const {
    return path ? &path->path.curve : closed ? &*closed : nullptr;
  }
};

/// The program under the limits of the scene, on elements that are halved where
/// what holds changes, until T changes by no more than a share of the
/// tolerance; then on all of them halved. From there on limits are kept between
/// the points too, in two ways: bounds are drawn in, and what then costs much
/// is quartered; or else elements are quartered first as long as to draw their
/// bounds in would cost much. The contact is closed on each mesh.
///
/// \param coarse     a solution of the same limits as inequalities
/// \param tolerance  relative, of T
/// \param ipopt      options; iterations are those left in the protocol
/// \param suffices   told what a way comes to: the next is not gone if it does
void solve_without_arcs(
    const LimitedCurve& coarse, double tolerance, const IpoptOptions& ipopt,
    PassProtocol& protocol,
    const std::function<bool(SolvedWithoutArcs solved)>& suffices);

}  // namespace brachisto
