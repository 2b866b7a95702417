// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The next mesh of a stated problem, from the path on one and the path with
/// its elements cut in two.

#pragma once

#include <optional>
#include <vector>

#include "brachisto/posed/problem.hpp"
#include "posed/mesh_path.hpp"

namespace brachisto::ocp {

/// A mesh of plain elements, and between them short ones around junctions, at
/// which bounds begin to hold or cease to: what a path with a jump in its
/// control errs by on an element falls with the square of the length alone.
struct RefinedMesh {
  struct Junction {
    double sigma, half_width;
  };
  std::vector<double> boundaries;  ///< of plain elements
  std::vector<Junction> junctions;

  [[nodiscard]] Mesh mesh(int degree) const;
};

/// Two solutions and, of the finer one, what holds at each of its points: a
/// number for each variable of the point and each limit, 0 where it is free.
struct TwoPaths {
  const MeshPath& coarse;
  const MeshPath& fine;
  const std::vector<std::vector<int>>& held;
};

/// What each element of the coarse mesh errs by in the cost, about: the loss of
/// 𝓗 by its control and its states' defects times costates, at the points of
/// the finer path.
[[nodiscard]] std::vector<double> element_errors(const Posed& problem,
                                                 const TwoPaths& paths);

/// \param share  of the error, which an element may have
[[nodiscard]] RefinedMesh refined(const RefinedMesh& last,
                                  const TwoPaths& paths,
                                  const std::vector<double>& errors,
                                  double share);

}  // namespace brachisto::ocp
