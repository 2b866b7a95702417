// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A solution of a rolling_time problem as functions of σ.

#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "brachisto/nlp/problem.hpp"
#include "model/world_hamiltonian.hpp"
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

/// A place t ∈ [0, 1] of an element with the bases there, which are the same in
/// all elements: a loop over elements makes it once.
struct ElementPlace {
  ElementPlace(const CollocationScheme& scheme, double place);

  double t;
  std::array<double, kLargestDegree + 1> nodes{};   ///< ℓ_n(t) of the nodes
  std::array<double, kLargestDegree + 1> slopes{};  ///< ℓ_n'(t)
  std::array<double, kLargestDegree> points{};  ///< of the collocation points
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
  /// one side of a field's surface, with the field of that side alone, which
  /// is smooth up to both ends of the element.
  [[nodiscard]] const Scene& scene_in(int element) const;
  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  [[nodiscard]] double rolling_time() const { return U_; }
  [[nodiscard]] double transit_time() const { return nodes_.back()[kT]; }
  [[nodiscard]] double arc_length() const { return nodes_.back()[kS]; }
  /// At the end.
  [[nodiscard]] double p_x() const { return p_x_; }
  [[nodiscard]] double p_z() const { return p_z_; }

  /// At a place of an element.
  [[nodiscard]] ExtremalPoint at(int element, const ElementPlace& place) const;
  [[nodiscard]] ExtremalPoint at(int element, double t) const {
    return at(element, ElementPlace(*scheme_, t));
  }
  /// All but β, which is left at 0: what costs no search for a minimum.
  [[nodiscard]] ExtremalPoint without_slope(int element,
                                            const ElementPlace& place) const;
  [[nodiscard]] ExtremalPoint without_slope(double sigma) const;
  /// The coefficient of tᵖ of w in an element.
  [[nodiscard]] double leading_w(int element) const;
  /// Derivatives of the polynomials by t ∈ [0, 1], of x, z, θ, w and the
  /// costates p_x, p_z, p_θ, p_w.
  [[nodiscard]] std::array<double, 8> rates(int element,
                                            const ElementPlace& place) const;
  /// At σ ∈ [0, 1].
  [[nodiscard]] ExtremalPoint at(double sigma) const;
  /// The polynomial of degree p − 1 through the slopes at the collocation
  /// points of an element.
  [[nodiscard]] double interpolated_slope(int element,
                                          const ElementPlace& place) const;
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

  /// The values of a node stand side by side, for all are combined with the
  /// same weights; θ and p_θ are 0 if the problem has none.
  enum Value : std::size_t { kX, kZ, kTheta, kW, kPTheta, kPW, kS, kT, kCount };
  using Node = std::array<double, kCount>;

  Scene scene_;
  Mesh mesh_;
  const CollocationScheme* scheme_;
  double U_;
  double p_x_, p_z_;  ///< at the end
  std::vector<Node> nodes_;
  /// p_x and p_z of the nodes; empty where they are constant.
  std::vector<std::array<double, 2>> pulls_;
  bool has_theta_;
  std::vector<double> beta_points_, w_points_;
  /// With such a surface: the scenes of both sides, and what each element sees.
  std::vector<Scene> sides_;
  std::vector<std::optional<FieldSide>> side_;
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
/// Of their absolute values: errors of either sign may cancel in T; along the
/// path they do not.
[[nodiscard]] double sum_of_errors(std::span<const double> element_errors);

}  // namespace brachisto
