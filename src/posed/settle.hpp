// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Arcs held as equations, and where they begin and end as unknowns.

#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "brachisto/posed/problem.hpp"
#include "posed/refine.hpp"

namespace brachisto::ocp {

struct Settled {
  Mesh mesh;
  std::unique_ptr<nlp::Problem> program;  ///< moved to the point
  PrimalDual point;
  double cost;
};

/// From a solution on a mesh with a boundary at each kink: what holds on most
/// points of an element holds on all of it, and kinks are moved to where the
/// control is continuous. To rounding, where an interior-point method leaves
/// bounds by the root of its barrier parameter if multipliers vanish on an arc.
/// If that does not do, what holds on all points alone, and a path that touches
/// a bound and drifts along it as one that slides.
///
/// Nothing if some other element has points that are held and such that are
/// not, if what holds is the same on both sides of a kink, and if what comes
/// out breaks a bound or has a multiplier of the wrong sign.
///
/// \pre  the program has been moved to the point
[[nodiscard]] std::optional<Settled> settled(
    const Posed& problem, nlp::Problem& program, const MeshPath& path,
    const PrimalDual& point,
    const std::vector<RefinedMesh::Junction>& junctions);

}  // namespace brachisto::ocp
