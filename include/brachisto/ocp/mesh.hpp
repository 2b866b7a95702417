// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The mesh: how σ ∈ [0, 1] is cut into elements.

#pragma once

#include <span>
#include <vector>

namespace brachisto {

/// Elements with polynomials of one degree.
struct Mesh {
  int degree = 1;                  ///< p ≥ 1
  std::vector<double> boundaries;  ///< N + 1 values, 0 = first < … < last = 1

  [[nodiscard]] int num_elements() const {
    return static_cast<int>(boundaries.size()) - 1;
  }
  /// N p, the number of collocation points.
  [[nodiscard]] int num_points() const { return num_elements() * degree; }
  /// N p + 1, the number of nodes, element ends counted once.
  [[nodiscard]] int num_nodes() const { return num_points() + 1; }
  /// A place t ∈ [0, 1] of an element.
  struct Place {
    int element;
    double t;
  };
  /// Where σ lies: at the beginning of an element rather than at the end of the
  /// one before; outside [0, 1] on the first or the last.
  [[nodiscard]] Place locate(double sigma) const;
  /// σ at a place.
  [[nodiscard]] double sigma(int element, double t) const {
    return boundaries[static_cast<std::size_t>(element)] + t * length(element);
  }
  /// h_e, the length of element e.
  [[nodiscard]] double length(int element) const {
    const auto e = static_cast<std::size_t>(element);
    return boundaries[e + 1] - boundaries[e];
  }
};

/// N elements of equal length.
[[nodiscard]] Mesh uniform_mesh(int degree, int num_elements);

/// A mesh of degree p on which every element has about the same share of the
/// error, and all shares together about `target`.
///
/// \param mesh    of degree p, which `errors` were measured on
/// \param errors  one per element, in the units of target; signs do not matter
///
/// An element of length h has the error C h^(2p+1); the number of elements per
/// unit of σ is taken proportional to C^(1/(2p+1)), interpolated between the
/// old elements. At least a quarter of the old number of elements stays.
///
/// Where an error is not finite nothing is known but that the mesh is too
/// coarse: every element is halved.
[[nodiscard]] Mesh equidistribute(const Mesh& mesh,
                                  std::span<const double> errors,
                                  double target);

/// The same for elements of another degree. On an element of length h the error
/// is size · (h/ρ)^(2p+1) for all degrees p alike, ρ being the length on which
/// the solution varies there; ρ follows from the errors at the old degree.
///
/// \param size  what an element errs by if it is as long as ρ; it does not
///              matter if the degree stays
[[nodiscard]] Mesh equidistribute(const Mesh& mesh,
                                  std::span<const double> errors, double target,
                                  int degree, double size);

/// A mesh of `count` elements whose lengths follow those of `mesh`.
[[nodiscard]] Mesh stretch(const Mesh& mesh, int count);

}  // namespace brachisto
