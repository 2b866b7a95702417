// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// From a solution on a mesh to an answer on arcs, as accurately as is wanted.

#pragma once

#include <optional>
#include <vector>

#include "refinement/arc_accuracy.hpp"
#include "refinement/limited_refinement.hpp"
#include "refinement/without_arcs.hpp"

namespace brachisto {

/// Arcs are found with elements that follow them well, whatever is wanted.
inline constexpr int kArcDegree = 7;

/// Arcs as they are read off, corrected until they keep the limits; if none
/// fit, once more on graded elements. The protocol tells why there are none.
///
/// \param mesh  a solution whose limits are inequalities
[[nodiscard]] std::optional<FittedPath> arcs_from(const LimitedCurve& mesh,
                                                  int degree, ArcSearch& search,
                                                  PassProtocol& protocol);

/// By the degree and on the elements that are wanted, or on as many as its
/// tolerance takes.
///
/// \param path  of degree kArcDegree
[[nodiscard]] std::optional<LimitedAnswer> refined(FittedPath path,
                                                   const Discretisation& wanted,
                                                   ArcSearch& search,
                                                   PassProtocol& protocol);

/// What a coarse path leads to without arcs.
struct FromMesh {
  std::optional<FittedPath> path;       ///< on arcs read off a finer mesh
  std::optional<PathWithoutArcs> mesh;  ///< that itself
};

/// By the ways of solve_without_arcs(), one after the other; nothing if neither
/// leads anywhere.
///
/// \param coarse  as solve_without_arcs() has it
/// \param options of the solver, with the iterations of the protocol
[[nodiscard]] FromMesh without_its_arcs(const LimitedCurve& coarse,
                                        const Discretisation& wanted,
                                        const IpoptOptions& options,
                                        ArcSearch& search,
                                        PassProtocol& protocol);

/// The mesh itself as the answer, which the protocol tells.
[[nodiscard]] LimitedAnswer answer_without_arcs(const PathWithoutArcs& found,
                                                PassProtocol& protocol);

/// Whether the arcs that a coarse path tells are worth a try.
enum class ItsArcs { Tried, Known };

/// The answer that a coarse path leads to: on its arcs, or if these lead to
/// none, or are known, on those of finer meshes; where they do not either, the
/// finest mesh.
///
/// \param mesh  of a scene in natural units, its limits being inequalities
[[nodiscard]] LimitedRefinement refine_from_mesh(
    const LimitedCurve& mesh, const Discretisation& wanted,
    const MeshOptions& options, ItsArcs its_arcs = ItsArcs::Tried);

}  // namespace brachisto
