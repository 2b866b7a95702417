// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The polynomials of a solution on a mesh by Radau's scheme.

#pragma once

#include <vector>

#include "brachisto/nlp/problem.hpp"
#include "brachisto/ocp/mesh.hpp"
#include "brachisto/posed/statement.hpp"

namespace brachisto::ocp {

/// Scaled states with their slopes by time, controls and costates.
struct PathValues {
  std::vector<double> states, slopes, controls, costates;
  /// States and controls behind them.
  [[nodiscard]] std::vector<double> point() const;
};

/// Next to a junction a polynomial may leave the bounds between points: there
/// the control is taken to be at its bound.
void keep_in_bounds(const Statement& statement,
                    const std::vector<double>& scales, PathValues& values);

class MeshPath {
 public:
  MeshPath(const Mesh& mesh, const Layout& layout, const PrimalDual& point)
      : mesh_(mesh), layout_(layout), point_(point) {}

  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  [[nodiscard]] const Layout& layout() const { return layout_; }
  [[nodiscard]] double duration() const;
  /// At a place of an element; t may lie outside of [0, 1], for extrapolation.
  /// Costates are 0 without multipliers.
  [[nodiscard]] PathValues values(int element, double t) const;
  [[nodiscard]] PathValues values(double sigma) const {
    const Mesh::Place place = mesh_.locate(sigma);
    return values(place.element, place.t);
  }
  /// The unknowns of the same path on another mesh.
  [[nodiscard]] PrimalDual on(const Mesh& mesh, const Layout& layout) const;

 private:
  Mesh mesh_;
  Layout layout_;
  PrimalDual point_;
};

/// Where a collocation point of Radau's scheme is, 0 … 1.
[[nodiscard]] double sigma(const Mesh& mesh, int point);

}  // namespace brachisto::ocp
