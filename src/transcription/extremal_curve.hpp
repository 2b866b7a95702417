// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A solution of a rolling_time problem as functions of σ.

#pragma once

#include <optional>
#include <vector>

#include "brachisto/nlp/problem.hpp"
#include "model/world_hamiltonian.hpp"
#include "transcription/costates.hpp"
#include "transcription/rolling_time.hpp"

namespace brachisto {

/// States, costates and slope at one σ, in the units of the problem's scene.
struct ExtremalPoint {
  Point centre;        ///< (x_c, z_c)
  double theta = 0.0;  ///< θ, also for a body that the problem gives none
  double w = 0.0;      ///< √(2 g E)
  double s = 0.0;      ///< arc length of the centre's path
  double t = 0.0;      ///< time
  Costates p;
  double beta = 0.0;  ///< slope angle, continuous along the path

  [[nodiscard]] MovingState state() const { return {centre, theta, w}; }
};

/// The collocation polynomials of a solution, of order 2p at element ends and
/// p + 1 between them. The slope angle is not interpolated: it is the minimum
/// of 𝓗 at the interpolated states and costates, NaN where that is not found
/// because the mesh is much too coarse. Costs O(p) per evaluation.
class ExtremalCurve {
 public:
  /// \param point  x and λ of a solution of `problem`
  ExtremalCurve(const RollingTime& problem, const PrimalDual& point);

  [[nodiscard]] const Scene& scene() const { return scene_; }
  /// The scene as element e sees it: where all its collocation points lie on
  /// one side of a sphere's surface, with the field of that side alone, which
  /// is smooth up to both ends of the element.
  [[nodiscard]] const Scene& scene_in(int element) const;
  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  [[nodiscard]] double rolling_time() const { return U_; }
  [[nodiscard]] double transit_time() const { return nodes_.t.back(); }
  [[nodiscard]] double arc_length() const { return nodes_.s.back(); }
  /// At the end.
  [[nodiscard]] double p_x() const { return costates_.p_x; }
  [[nodiscard]] double p_z() const { return costates_.p_z; }

  /// At the place t ∈ [0, 1] of element e.
  [[nodiscard]] ExtremalPoint at(int element, double t) const;
  /// At σ ∈ [0, 1].
  [[nodiscard]] ExtremalPoint at(double sigma) const;
  /// The polynomial of degree p − 1 through the slopes at the collocation
  /// points of element e, at t ∈ [0, 1].
  [[nodiscard]] double interpolated_slope(int element, double t) const;
  [[nodiscard]] double interpolated_slope(double sigma) const;
  /// At node 0 … N p.
  [[nodiscard]] ExtremalPoint at_node(int node) const;

  /// β at the collocation points, each reduced by multiples of 2π to lie next
  /// to its neighbour, from the start on; N p values.
  [[nodiscard]] const std::vector<double>& continuous_slope() const {
    return beta_points_;
  }
  /// w at the collocation points; N p values.
  [[nodiscard]] const std::vector<double>& w_at_points() const {
    return w_points_;
  }

 private:
  void find_sides();

  struct Nodes {
    std::vector<double> x, z, theta, w, s, t;
  };

  Scene scene_;
  Mesh mesh_;
  const CollocationScheme* scheme_;
  double U_;
  Nodes nodes_;
  CostateSolution costates_;
  std::vector<double> beta_points_, w_points_;
  /// With a sphere: the scenes of both sides, and what each element sees.
  std::vector<Scene> sides_;
  std::vector<std::optional<SphereSide>> side_;
};

/// Share of each element in the error of T between the given end points.
///
/// Between collocation points the Hamiltonian of a discrete solution is not
/// zero, and its integral is the error: with exact end points
///
///     T − T_h = U ∫₀¹ 𝓗(x_h, p_h, β_h) dσ + O(h^(2p+2)).
///
/// For the continuous Lagrangian U ∫ 𝓗 dσ − ∫ p·x' dσ is stationary at the
/// extremal, where it is T; at the discrete solution it differs from T only by
/// the square of the error between nodes. The discrete solution makes the same
/// expression stationary with Gauss's rule in place of the integrals, which is
/// exact for p·x' and gives zero for 𝓗, so that T_h = −∫ p_h·x_h' dσ.
///
/// The sum of Gauss's rule is zero over the whole path but not over an element;
/// taking it off each share leaves the total as it is and the shares free of a
/// drift that belongs to no element.
///
/// \return U (∫_e 𝓗 dσ − h_e Σ_j b_j 𝓗_j) of each element, with signs, in the
///         units of the curve
[[nodiscard]] std::vector<double> element_errors(const ExtremalCurve& curve);

}  // namespace brachisto
