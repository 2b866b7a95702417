// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The least time between fixed end points as a nonlinear program in the
/// paper's own variables.

#pragma once

#include <array>
#include <span>
#include <vector>

#include "transcription/transcription.hpp"

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
/// σ_j². VariableLayout tells the order of all of them.
///
/// A point is refused unless all pieces have r Δθ > 0 (S > 0 without θ), A > 0,
/// and E > 0 at all nodes.
class ArcLength final : public Transcription {
 public:
  /// \param scene  valid, in units of the caller's choice
  /// \param num_intervals  N ≥ 2
  /// \param phi    end angle φ [rad]; without effect with Contact::Centre
  ArcLength(const Scene& scene, int num_intervals, double phi);

  [[nodiscard]] int num_intervals() const { return layout().num_points(); }
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

  /// Along the path: unknowns and multipliers of one node after the other, S
  /// last.
  [[nodiscard]] nlp::EliminationOrder elimination_order() const override;
  /// A link for each piece, with nothing inside: a node and the multipliers of
  /// the piece that leads to it are a separator; S is the border.
  [[nodiscard]] nlp::ChainStructure chain_structure() const override;

  /// The problem is moved to x.
  [[nodiscard]] std::optional<End> end(std::span<const double> x,
                                       std::span<const double> lambda) override;
  /// Minus the derivatives of the Lagrangian with respect to the fixed x_N and
  /// z_N, at the current point.
  [[nodiscard]] Costates end_costates(
      std::span<const double> lambda) const override;
  /// What rounding of the nodes alone leaves: lengths of order one known to ε,
  /// divided by those of pieces, S/N on average.
  [[nodiscard]] double rounding(std::span<const double> x) const override;

  /// Where σ is in the middle of a piece: rotation, mean speed, slope angle and
  /// the costates of 𝓗 there.
  struct PieceState {
    double theta, w, beta;
    Costates p;  ///< p_θ is not set
  };
  /// Of the piece that leads to `node`, at the current point. ∂𝓗/∂β = 0 holds
  /// on each of them if it is stationary.
  /// \param end  the costates at the end, end_costates()
  [[nodiscard]] PieceState piece_state(int node, std::span<const double> lambda,
                                       const Costates& end) const;

  /// Multipliers that make the current point as stationary as it can be, given
  /// the costates at the end: the no-slip multiplier of each piece from the
  /// momentum along it, which is carried from the end to the start, and those
  /// of the places from what is then left.
  [[nodiscard]] std::vector<double> multipliers(double p_x, double p_z) const;

 private:
  /// w = √(2 g E) at a node and what its derivatives by z and θ are made of;
  /// zero at the start, which is fixed.
  struct Speed {
    double w = 0.0;
    double by_E = 0.0;     ///< g / w
    double E_theta = 0.0;  ///< ∂E/∂θ
    double E_theta_theta = 0.0;

    /// By x, z, θ.
    [[nodiscard]] std::array<double, 3> by() const {
      return {0.0, by_E, by_E * E_theta};
    }
    /// The lower triangle of the second ones.
    [[nodiscard]] std::array<double, 6> by_by() const {
      const double by_E_E = -by_E * by_E / w;
      return {0.0,
              0.0,
              by_E_E,
              0.0,
              by_E_E * E_theta,
              by_E_E * E_theta * E_theta + by_E * E_theta_theta};
    }
  };
  /// What f, g and their derivatives share.
  struct Piece {
    double dx, dz, length;        ///< Δx, Δz, r Δθ
    double sin_theta, cos_theta;  ///< in the middle
    double root;                  ///< r Δθ √A
    double inverse_speed;         ///< 2 / (w_{j−1} + w_j)
  };
  /// By Δx, Δz, r Δθ, the rotation in the middle, and the sum of w at the ends.
  struct Five {
    double x, z, length, theta, w;

    friend Five operator*(double factor, const Five& a) {
      return {factor * a.x, factor * a.z, factor * a.length, factor * a.theta,
              factor * a.w};
    }
    friend Five operator+(const Five& a, const Five& b) {
      return {a.x + b.x, a.z + b.z, a.length + b.length, a.theta + b.theta,
              a.w + b.w};
    }
  };
  using Second = std::array<Five, 5>;
  /// What x, z and θ of one of its nodes change of a piece: x changes Δx; z
  /// changes Δz and w; θ changes r Δθ, the rotation in the middle and w.
  struct Influence {
    double sign;         ///< of Δx by x and of Δz by z
    double turn, share;  ///< of r Δθ and of the rotation, by θ
    double w_z, w_theta;

    /// Derivatives by x, z and θ from those by the five.
    [[nodiscard]] std::array<double, 3> of(const Five& by) const {
      return {sign * by.x, sign * by.z + w_z * by.w,
              turn * by.length + share * by.theta + w_theta * by.w};
    }
    [[nodiscard]] std::array<Five, 3> of(const Second& by) const {
      return {sign * by[0], sign * by[1] + w_z * by[4],
              turn * by[2] + share * by[3] + w_theta * by[4]};
    }
  };

  bool evaluate() override;
  [[nodiscard]] double do_eval_f() const override;
  void do_eval_grad_f(std::span<double> grad_f) const override;
  void do_eval_g(std::span<double> g) const override;
  void put_jac_g(Entries& put) const override;
  void put_hess_lag(double objective_factor, std::span<const double> lambda,
                    Entries& put) const override;

  /// θ − θ_m in the middle of the piece that leads to `node`.
  [[nodiscard]] double turned(int node) const;
  bool set_nodes();
  bool set_pieces();
  /// Derivatives of the time of the piece that leads to `node`.
  [[nodiscard]] Five time_slopes(int node) const;
  /// That by the sum of w alone, and all second ones, times the objective
  /// factor.
  [[nodiscard]] double by_sum_of_w(int node, double objective_factor) const;
  [[nodiscard]] Second second(int node, double objective_factor) const;
  /// Of its own node or the one before on a piece.
  [[nodiscard]] Influence influence(int piece, int node) const;
  /// r Δθ by S; without θ alone.
  [[nodiscard]] double length_by_S(int piece) const;

  double reference_length_;
  std::vector<Speed> speeds_;  ///< of the nodes
  std::vector<Piece> pieces_;  ///< entry 0 is not used
};

}  // namespace brachisto
