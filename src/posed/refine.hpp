// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The next mesh of a stated problem, from the path on one and the path with
/// its elements cut in two.

#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "brachisto/posed/problem.hpp"
#include "posed/bounds.hpp"
#include "posed/mesh_path.hpp"

namespace brachisto::ocp {

/// A mesh of plain elements, and what is made of junctions, at which bounds
/// begin to hold or cease to.
///
/// Where the control has a kink there is a boundary: what a path errs by whose
/// boundary is δ from its junction falls with δ², and the next path tells the
/// place better. Where the control jumps a boundary at the very place would
/// leave nothing free to reach the end with: a short element encloses it, and
/// what a path errs by falls with the square of its length, until it is known
/// so well that its place can be an unknown (free_junctions.hpp).
struct RefinedMesh {
  struct Junction {
    double sigma;
    double half_width = 0.0;  ///< of the short element
    /// Of a kink: from where it was taken to be before; where it is new, its
    /// room; 0 once it is settled.
    double moved = 0.0;
    bool is_new = false;  ///< the mesh before knew nothing of it
  };
  std::vector<double> boundaries;  ///< of plain elements
  std::vector<Junction> junctions;

  [[nodiscard]] Mesh mesh(int degree) const;
  [[nodiscard]] bool has_kinks() const {
    return std::ranges::any_of(
        junctions, [](const Junction& j) { return j.half_width == 0.0; });
  }
  /// Of a jump that an element encloses.
  [[nodiscard]] bool has_width() const {
    return std::ranges::any_of(
        junctions, [](const Junction& j) { return j.half_width > 0.0; });
  }
  [[nodiscard]] bool has_new() const {
    return std::ranges::any_of(junctions, &Junction::is_new);
  }
  /// There are some, and none is a kink.
  [[nodiscard]] bool all_jump() const {
    return !junctions.empty() && !has_kinks();
  }
  /// By how much the kink moved that did so most; 0 without one.
  [[nodiscard]] double moved() const;
};

/// Two solutions, and what holds along the finer one.
struct TwoPaths {
  const MeshPath& coarse;
  const MeshPath& fine;
  const HeldAlong& held;
};

/// What each element of the coarse mesh errs by in the cost, about: the loss of
/// 𝓗 by its control and its states' defects times costates, at the points of
/// the finer path.
[[nodiscard]] std::vector<double> element_errors(const Posed& problem,
                                                 const TwoPaths& paths);

/// Adds boundaries that cut an element in as many pieces as its error wants.
///
/// \param excess  its error over what it may be; none are added up to 1
void cut(const Mesh& mesh, int element, double excess,
         std::vector<double>& boundaries);

/// \param share  of the error, which an element may have
[[nodiscard]] RefinedMesh refined(const RefinedMesh& last,
                                  const TwoPaths& paths,
                                  const std::vector<double>& errors,
                                  double share);

}  // namespace brachisto::ocp
