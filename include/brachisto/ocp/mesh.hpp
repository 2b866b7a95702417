// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The mesh: how σ ∈ [0, 1] is cut into elements; the matrices of collocation
/// on one of them; and where the unknowns and the constraints along it stand.

#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <span>
#include <vector>

#include "brachisto/math/polynomial_basis.hpp"

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

/// Each element cut in two.
[[nodiscard]] Mesh halved(const Mesh& mesh);

/// Collocation of degree p on the element [0, 1]: a polynomial of degree p is
/// given by its values at p + 1 nodes, both ends among them, and satisfies the
/// differential equation at p points.
///
/// As Runge–Kutta methods: Gauss's, of order 2p at the element ends, with the
/// Gauss–Lobatto points for nodes; and Radau's IIA, of order 2p − 1, whose
/// nodes are 0 and its points, the last of which is 1.
struct CollocationScheme {
  int degree;
  bool points_are_nodes;            ///< point j is node j + 1
  math::QuadratureRule rule;        ///< the p points and weights b
  math::LagrangeBasis nodes;        ///< through the p + 1 nodes
  math::LagrangeBasis points;       ///< through the p points
  math::SmallMatrix interpolation;  ///< p × (p + 1): nodes → values at points
  math::SmallMatrix derivative;  ///< p × (p + 1): nodes → slopes at points
  math::SmallMatrix integral;    ///< (p + 1) × p: rates at points → integral
                                 ///< from 0 to each node

  CollocationScheme(math::QuadratureRule points, std::vector<double> nodes);
};

/// The largest degree of a scheme: that of problems, and one more to check it.
inline constexpr int kLargestDegree = 12;

/// The scheme of a degree, 1 … kLargestDegree, built once per process.
[[nodiscard]] const CollocationScheme& gauss_scheme(int degree);
[[nodiscard]] const CollocationScheme& radau_scheme(int degree);

}  // namespace brachisto

namespace brachisto::ocp {

/// A group of unknowns for each node along the path, its states and behind them
/// the controls of the point that follows, and one global unknown last; a group
/// of constraints for each point, which leads from node to node: a defect of
/// each state, then the limits. So what couples lies close together. More rows
/// may follow.
///
/// A state of the description on which nothing depends can be absent.
class Layout {
 public:
  static constexpr int kMostStates = 16;
  using States = std::bitset<kMostStates>;

  /// \param num_controls  none: all along the path are states, and the first
  ///                      node is given
  /// \param num_rows      constraints of a point
  Layout(int num_points, States absent, int num_states, int num_controls,
         int num_rows)
      : num_points_(num_points),
        absent_(absent),
        num_states_(num_states),
        num_controls_(num_controls),
        num_rows_(num_rows) {
    for (std::size_t s = 1; s < offsets_.size(); ++s) {
      offsets_[s] = offsets_[s - 1] + (absent[s - 1] ? 0 : 1);
    }
  }

  /// Whether a state of the description has unknowns.
  [[nodiscard]] bool has_state(int state) const {
    return !absent_[static_cast<std::size_t>(state)];
  }
  /// Of a node.
  [[nodiscard]] int num_states() const { return num_states_; }
  /// Of a collocation point.
  [[nodiscard]] int num_controls() const { return num_controls_; }
  /// Collocation points or pieces.
  [[nodiscard]] int num_points() const { return num_points_; }
  /// The start included.
  [[nodiscard]] int num_nodes() const { return num_points_ + 1; }
  [[nodiscard]] int num_variables() const {
    return num_points_ * stride() + (has_controls() ? num_states_ : 0) + 1;
  }
  /// From a node's unknowns to the next one's.
  [[nodiscard]] int stride() const { return num_states_ + num_controls_; }
  /// Index of a state at a node.
  [[nodiscard]] int state(int node, int state) const {
    return stride() * (node - first_node()) +
           offsets_[static_cast<std::size_t>(state)];
  }
  /// Index of a control at a collocation point.
  [[nodiscard]] int control(int point, int control = 0) const {
    return stride() * point + num_states_ + control;
  }
  /// Index of the global unknown.
  [[nodiscard]] int last() const { return num_variables() - 1; }
  /// Index of the defect of a state at a collocation point.
  [[nodiscard]] int defect(int point, int state) const {
    return num_rows_ * point + offsets_[static_cast<std::size_t>(state)];
  }
  /// Index of limit 0 … at a collocation point.
  [[nodiscard]] int limit(int point, int number) const {
    return num_rows_ * point + num_states_ + number;
  }
  [[nodiscard]] int num_limits() const { return num_rows_ - num_states_; }
  /// The first of the rows behind those of points.
  [[nodiscard]] int end_of_points() const { return num_rows_ * num_points_; }

  /// The node in whose group an unknown stands.
  [[nodiscard]] int node_of(int variable) const {
    return variable / stride() + first_node();
  }
  /// True of unknowns but controls; not of the global one.
  [[nodiscard]] bool is_state(int variable) const {
    return variable % stride() < num_states_;
  }
  /// The point to which a constraint belongs.
  [[nodiscard]] int point_of(int constraint) const {
    return constraint / num_rows_;
  }
  /// Which of the limits there it is; negative: a defect.
  /// \pre constraint < end_of_points()
  [[nodiscard]] int limit_of(int constraint) const {
    return constraint % num_rows_ - num_states_;
  }

 protected:
  [[nodiscard]] bool has_controls() const { return num_controls_ > 0; }
  [[nodiscard]] int first_node() const { return has_controls() ? 0 : 1; }
  [[nodiscard]] int num_rows() const { return num_rows_; }

 private:
  int num_points_;
  States absent_;
  int num_states_, num_controls_, num_rows_;
  std::array<int, kMostStates> offsets_{};  ///< of states in their group
};

}  // namespace brachisto::ocp
