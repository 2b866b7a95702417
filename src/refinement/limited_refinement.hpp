// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// From the free extremal to the fastest track under limits.

#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "refinement/arc_accuracy.hpp"
#include "refinement/refinement.hpp"
#include "refinement/tightening.hpp"

namespace brachisto {

/// What searches for one answer may take, in steps of solvers times the
/// equations that each of them solves: more where more iterations are allowed
/// than by default, but never less.
[[nodiscard]] inline double most_search_work(const MeshOptions& options) {
  constexpr double kByDefault = 1.7e7, kIterations = Limits{}.iterations;
  return kByDefault * std::max(1.0, options.ipopt.max_iterations / kIterations);
}
/// The shares of it, each from where its way begins: under the limits asked
/// for, from what the free path leads to, beside what a rough try takes; for
/// random starts, and for what they lead to; for meshes that know no arcs,
/// where the first share left them too little; under looser limits, and from
/// random starts there.
inline constexpr double kSearchAsAsked = 0.52, kSearchCold = 0.12,
                        kSearchFromCold = 0.15, kSearchOnMesh = 0.4,
                        kSearchLooser = 0.4, kSearchNearer = 0.3;
/// The share that certifying a looser path has at the least, should the search
/// have gone beyond its own.
inline constexpr double kCertifyLooser = 0.1;

/// A path under loosened_limits() of a scene.
struct LoosenedPath : LimitedAnswer {
  double by;  ///< at 0 its digits were not found
  /// Else the estimated error is not known yet.
  [[nodiscard]] bool knows_arcs() const { return !path.arcs.empty(); }
};

/// Outcome of refine_limited().
struct LimitedRefinement : RefinementProtocol {
  std::optional<LimitedAnswer> answer = {};
  std::optional<BlockingLimit> blocking = {};  ///< if limits were not kept
  /// Without an answer: under tighter and tighter limits.
  std::vector<LoosenedPath> loosened = {};
  double work = 0.0;  ///< see most_search_work()
  /// Ways, in words; the last may be an end.
  std::vector<std::string> tried = {};
  bool from_random = false;  ///< the answer: others may be faster
  bool rough = false;        ///< the answer: found at once, without care
};

/// In stages.
///
/// - Tightening: on a coarse mesh of equal elements an interior-point method
///   solves a row of programs, from limits that the free extremal keeps to
///   those of the scene, each from the solution before; the contact follows.
///   If in the end that led nowhere, once more from each of other_ways(). A
///   rough try on half of the mesh comes first.
/// - Arcs: where limits hold and where not is read off, elements end at the
///   junctions, and junctions and contacts are found as roots (fit_arcs()). If
///   the result exceeds a limit or has a multiplier of the wrong sign the arcs
///   are corrected; if no arcs fit, the coarse mesh is made finer and they are
///   read off again, or followed from the loosest limits on. Where that leads
///   nowhere the scene is solved under much looser limits, and these are
///   tightened as far as a path follows them, or the program, solved from the
///   last path or like a scene of its own, finds one further on.
/// - Random paths: if no way from the free path leads anywhere, cold_paths().
/// - Without arcs: if none fit, the program itself is solved on finer and finer
///   meshes, and arcs are read off again. Where these do not fit either that
///   mesh is the answer, which knows no arcs (solve_without_arcs()). If what
///   was tried before left too little work for that, it comes once more, last.
/// - Accuracy: with the arcs known the path is as smooth on each as that of a
///   free extremal. Arcs get more elements until degree p + 1 on the same ones,
///   by which the error is estimated, changes T by no more than is wanted.
///
/// \param scene  in natural units, with limits
/// \param free   the extremal without them, with the end angle φ
/// \param care   whether a rough try comes first
[[nodiscard]] LimitedRefinement refine_limited(const Scene& scene,
                                               const Discretisation& wanted,
                                               const ExtremalCurve& free,
                                               double phi, MeshOptions options,
                                               Tightening::Care care);

/// From random paths alone, for a scene whose free extremal was not reached.
///
/// \param elsewhere  an extremal of another world, with the end angle φ: a
///                   measure of sizes
[[nodiscard]] LimitedRefinement refine_limited_cold(
    const Scene& scene, const Discretisation& wanted,
    const ExtremalCurve& elsewhere, double phi, MeshOptions options);

/// The same from the path of a neighbouring scene, whose arcs are fitted and
/// corrected under the limits of this one, or all along the way there: arcs are
/// born and die. Nothing if limits of other kinds or at other places hold
/// there.
///
/// \param neighbour  of a scene in natural units
/// \param most_work  by default most_search_work()
[[nodiscard]] std::optional<LimitedRefinement> refine_limited_beside(
    const Scene& scene, const Discretisation& wanted,
    const FittedPath& neighbour, MeshOptions options,
    std::optional<double> most_work = {});

}  // namespace brachisto
