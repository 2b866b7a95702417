// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Meshes for paths that pass the surface on which a field has a
/// kink: with element ends there every element sees a smooth field, and
/// collocation keeps its order.

#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "brachisto/ocp/mesh.hpp"
#include "transcription/extremal_curve.hpp"
#include "transcription/limited_curve.hpp"

namespace brachisto {

/// σ where a path passes the surface of the scene's field, ascending; nothing
/// where there is none.
///
/// \param mesh     on whose elements the path is smooth
/// \param heavy_at  the centre of mass at σ
[[nodiscard]] std::vector<double> surface_passages(
    const Scene& scene, const Mesh& mesh,
    const std::function<Point(double)>& heavy_at);

/// Of a curve, which may have been found in another field.
[[nodiscard]] std::vector<double> surface_passages(const Scene& scene,
                                                   const ExtremalCurve& curve);
/// Of a curve under limits.
[[nodiscard]] std::vector<double> surface_passages(const LimitedCurve& curve);

/// The mesh with an element end at each of these ascending σ: the nearest one
/// is moved there where it is near, otherwise there is one more.
///
/// \param as_many  elements as before: ends are moved however far they are, as
///                 long as there are ends between A and B for all places
[[nodiscard]] Mesh with_ends_at(Mesh mesh, const std::vector<double>& places,
                                bool as_many = false);

/// On which side of the surface the middle of each element lies; nothing where
/// there is no surface.
[[nodiscard]] std::vector<FieldSide> sides_of_elements(
    const ExtremalCurve& curve, const Mesh& mesh);

/// Elements that begin on another side than the one before ends on.
[[nodiscard]] std::vector<int> elements_beyond(
    const std::vector<FieldSide>& sides);

/// The mesh with the beginnings of these elements at other places, the others
/// between them in proportion: its lengths are linear in each place.
[[nodiscard]] Mesh with_beginnings_at(const Mesh& mesh,
                                      const std::vector<int>& elements,
                                      const std::vector<double>& places);

/// Moves element ends to where the path passes the surface, from solution to
/// solution, for the path depends on where they are: in between a field is
/// taken for its continuation from the other side, and the costates, whose
/// rates jump on the surface, are off by the distance; so is the slope at the
/// end, and with it a smooth contact and T.
class SurfaceEnds {
 public:
  /// What a solution says of the ends of its mesh.
  void learn(const ExtremalCurve& solution);
  /// The mesh with ends where the next solution should pass.
  /// \param as_many  see with_ends_at()
  [[nodiscard]] Mesh fit(Mesh mesh, bool as_many) const {
    return with_ends_at(std::move(mesh), next_, as_many);
  }
  /// Whether the ends of the last solution were where it passes, as well as
  /// rounding allows.
  [[nodiscard]] bool settled() const { return settled_; }
  /// What the distance between the two means for its T, relative.
  [[nodiscard]] double error() const { return error_; }

 private:
  struct Solution {
    std::vector<double> ends, passages;
    double apart = 0.0;  ///< largest distance of an end from its passage
    double T = 0.0;
  };
  std::optional<Solution> last_;
  std::vector<double> next_;
  bool settled_ = true;
  double error_ = 0.0;
};

}  // namespace brachisto
