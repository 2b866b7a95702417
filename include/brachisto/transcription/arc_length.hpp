// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The least time between fixed end points as a nonlinear program in the
/// paper's own variables.

#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "brachisto/model/contact.hpp"
#include "brachisto/model/hamiltonian.hpp"
#include "brachisto/model/scene.hpp"
#include "brachisto/nlp/problem.hpp"
#include "brachisto/transcription/arc_length_layout.hpp"

namespace brachisto {

/// A polygon of N straight pieces with nodes at the arc lengths s_j = S σ_j²,
/// σ_j = j/N. Over the places and rotations of its nodes, and S, minimise
///
///     T = Σ_j 2 r Δθ_j √A_j / (w_{j−1} + w_j),  w_j = √(2 g E(z_j, θ_j)),
///
/// subject to no slip, (Δx_j)² + (Δz_j)² = (r Δθ_j)², and r θ_j = S σ_j². A_j
/// is taken in the direction (Δx_j, Δz_j)/(r Δθ_j) of the piece and at the
/// rotation where σ is in its middle, a share (j − 3/4)/(2j − 1) into it. The
/// time of a piece is exact where A and dE/ds are constant: the mean of the
/// speeds at both ends. A body whose centre of mass lies on its axis has no θ:
/// r Δθ_j is replaced by S (σ_j² − σ_{j−1}²) and A is constant.
///
/// x, z and θ are measured from the start, where they are zero, so that they
/// keep their relative accuracy next to it. x_N and z_N are fixed. A no-slip
/// row is divided by twice the length that the piece would have on a straight
/// way to B: it is the error of a length, and so is a place row, r θ_j − S
/// σ_j². ArcLengthLayout tells the order of all of them.
///
/// A point is refused unless all pieces have r Δθ > 0 (S > 0 without θ), A > 0,
/// and E > 0 at all nodes.
class ArcLength final : public nlp::Problem {
 public:
  /// \param scene  valid, in units of the caller's choice
  /// \param num_intervals  N ≥ 2
  /// \param phi    end angle φ [rad]; without effect with Contact::Centre
  ArcLength(const Scene& scene, int num_intervals, double phi);

  /// Moves the end of the centre to C_B(φ).
  void set_end_angle(double phi);

  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] const ArcLengthLayout& layout() const { return layout_; }
  [[nodiscard]] int num_intervals() const { return layout_.num_intervals(); }
  /// j/N.
  [[nodiscard]] double sigma(int node) const {
    return static_cast<double>(node) / num_intervals();
  }
  /// σ_j² − σ_{j−1}² of the piece that leads to `node`.
  [[nodiscard]] double share(int node) const {
    const double n = num_intervals();
    return (2.0 * node - 1.0) / (n * n);
  }
  /// How far into the piece that leads to `node` σ is in its middle, by length.
  [[nodiscard]] static double middle(int node) {
    return (node - 0.75) / (2.0 * node - 1.0);
  }
  /// By what half of a no-slip row is divided.
  [[nodiscard]] double reference_length(int node) const {
    return reference_length_ * share(node);
  }

  [[nodiscard]] int num_variables() const override {
    return layout_.num_variables();
  }
  [[nodiscard]] int num_constraints() const override {
    return layout_.num_constraints();
  }
  [[nodiscard]] std::span<const double> lower() const override {
    return lower_;
  }
  [[nodiscard]] std::span<const double> upper() const override {
    return upper_;
  }
  [[nodiscard]] const nlp::SparsityPattern& jac_g_pattern() const override {
    return jac_g_pattern_;
  }
  [[nodiscard]] const nlp::SparsityPattern& hess_lag_pattern() const override {
    return hess_lag_pattern_;
  }
  /// Along the path: unknowns and multipliers of one node after the other, S
  /// last.
  [[nodiscard]] nlp::EliminationOrder elimination_order() const override;
  /// A link for each piece, with nothing inside: a node and the multipliers of
  /// the piece that leads to it are a separator; S is the border.
  [[nodiscard]] nlp::ChainStructure chain_structure() const override;
  [[nodiscard]] std::string variable_name(int index) const override {
    return layout_.variable_name(index);
  }
  [[nodiscard]] std::string constraint_name(int index) const override {
    return layout_.constraint_name(index);
  }
  [[nodiscard]] std::string refusal() const override;

  /// Minus the derivatives of the Lagrangian with respect to the fixed x_N and
  /// z_N: at a solution −∂T/∂x_end and −∂T/∂z_end, the constant costates of
  /// x and z in the rolling time. By which of the last two nodes' unknowns, of
  /// the last no-slip multiplier and of S they change:
  struct EndCostates {
    struct Costate {
      double value = 0.0;
      std::array<double, 3> by_last{}, by_before{};  ///< x, z, θ
      double by_no_slip = 0.0, by_S = 0.0;
    };
    Costate x, z;
  };
  /// At the current point.
  [[nodiscard]] EndCostates end_costates(std::span<const double> lambda) const;

  /// √(2 g E) at the last node of the current point.
  [[nodiscard]] double end_w() const { return nodes_.w.back(); }
  /// Its derivatives with respect to z_N and θ_N.
  [[nodiscard]] std::array<double, 2> end_w_slopes() const {
    return {nodes_.by_z.back(), nodes_.by_theta.back()};
  }

  /// Where σ is in the middle of a piece: rotation, mean speed, slope angle and
  /// the costates of 𝓗 there.
  struct PieceState {
    int node;  ///< to which the piece leads
    double theta, w, beta;
    Costates p;  ///< p_θ is not set
  };
  /// Of all pieces, at the current point. ∂𝓗/∂β = 0 holds on each of them if
  /// it is stationary.
  [[nodiscard]] std::vector<PieceState> piece_states(
      std::span<const double> lambda) const;

  /// Multipliers that make the current point as stationary as it can be, given
  /// the costates at the end: the no-slip multiplier of each piece from the
  /// momentum along it, which is carried from the end to the start, and those
  /// of the places from what is then left.
  [[nodiscard]] std::vector<double> multipliers(double p_x, double p_z) const;

 private:
  /// w and its derivatives at the nodes; zero at the start, which is fixed.
  struct Nodes {
    std::vector<double> w, by_z, by_theta, by_z_z, by_z_theta, by_theta_theta;
  };
  /// What f, g and their derivatives share, one entry per piece; entry 0 is
  /// not used.
  struct Pieces {
    std::vector<double> dx, dz, length;        ///< Δx, Δz, r Δθ
    std::vector<double> sin_theta, cos_theta;  ///< in the middle
    std::vector<double> root;                  ///< r Δθ √A
    std::vector<double> inverse_speed;         ///< 2 / (w_{j−1} + w_j)
  };
  /// First derivatives of the time of a piece with respect to Δx, Δz, r Δθ, the
  /// rotation in its middle, and w at either end.
  struct Slopes {
    double x, z, length, theta, w;
  };
  /// Second derivatives of the Lagrangian of a piece: of the node before it, of
  /// its own node with that, of its own node. In lower triangles x, z x, z z,
  /// θ x, θ z, θ θ; the square has the rows of its own node.
  struct Block {
    std::array<double, 6> before{}, own{};
    std::array<double, 9> between{};
  };

  bool do_set_point(std::span<const double> x) override;
  [[nodiscard]] std::span<const double> current_point() const override {
    return x_;
  }
  [[nodiscard]] double do_eval_f() const override;
  void do_eval_grad_f(std::span<double> grad_f) const override;
  void do_eval_g(std::span<double> g) const override;
  void do_eval_jac_g(std::span<double> values) const override;
  void do_eval_hess_lag(double objective_factor, std::span<const double> lambda,
                        std::span<double> values) const override;

  void build_patterns();
  bool set_nodes();
  bool set_pieces();
  bool refuse(int node, const char* reason);
  [[nodiscard]] Slopes slopes(int node) const;
  [[nodiscard]] Block block(int node, double objective_factor,
                            double lambda) const;
  /// Derivatives of the time of a piece with respect to w twice, and S and w.
  [[nodiscard]] std::array<double, 2> axisymmetric_curvature(int node) const;

  /// The stencils. Each calls put(row, col, value) for every entry, always in
  /// the same order, so that pattern and values cannot drift apart.
  template <class Put>
  void visit_jac_g(Put&& put) const;
  template <class Put>
  void visit_hess_lag(double objective_factor, std::span<const double> lambda,
                      Put&& put) const;
  template <class Put>
  void visit_axisymmetric_hess_lag(double objective_factor,
                                   std::span<const double> lambda,
                                   Put&& put) const;

  Scene scene_;
  Point start_;
  ArcLengthLayout layout_;
  double reference_length_;
  double constant_root_;  ///< √A without θ
  std::vector<double> lower_, upper_;
  nlp::SparsityPattern jac_g_pattern_, hess_lag_pattern_;

  std::vector<double> x_;  ///< the current point
  Nodes nodes_;
  Pieces pieces_;
  int refused_node_ = -1;
  const char* refused_because_ = "";
};

}  // namespace brachisto
