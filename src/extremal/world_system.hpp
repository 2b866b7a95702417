// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Pontryagin's conditions in another world as a square system of equations.

#pragma once

#include <Eigen/Core>

#include "extremal/world_flow.hpp"

namespace brachisto::worlds {

/// Unknowns: states and costates where arcs begin, and at B; U, φ, and where
/// slope_at_A_is_open() the slope α at A.
///
/// Equations: arcs fit together, and
///
/// - at A: (x, z) = C_A(α), θ = θ_m, w = v₀ √A(θ_m, α), 𝓗 = 0, which stays so
///   and at rest says p_w = −√A/(G·(…)); and β = α if α is an unknown;
/// - at B: (x, z) = C_B(φ), p_θ = p_w = 0, β = φ.
class WorldSystem {
 public:
  /// \param natural  in natural units; must outlive this
  WorldSystem(const Scene& natural, int num_arcs);

  struct Linearisation {
    Eigen::VectorXd residual;
    Eigen::MatrixXd jacobian;
    double transit_time = 0.0;
    Eigen::RowVectorXd time_gradient;
    int steps = 0;
  };
  /// False where an arc cannot be integrated.
  [[nodiscard]] bool evaluate(const Eigen::VectorXd& point,
                              const shooting::StepControl& control,
                              Linearisation& out) const;
  /// Tells of the path through the arcs, u and t counted from the start; false
  /// if it cannot be integrated.
  [[nodiscard]] bool follow(
      const Eigen::VectorXd& point, const shooting::StepControl& control,
      const std::function<void(const Passed&)>& tell) const;

  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] int num_arcs() const { return num_arcs_; }
  [[nodiscard]] int num_unknowns() const {
    return of_slope() + (open_ ? 1 : 0);
  }
  /// Where the unknowns stand.
  [[nodiscard]] static int of_node(int node) { return ArcEnd::kWidth * node; }
  [[nodiscard]] int of_duration() const { return of_node(num_arcs_ + 1); }
  [[nodiscard]] int of_phi() const { return of_duration() + 1; }
  [[nodiscard]] int of_slope() const { return of_phi() + 1; }
  [[nodiscard]] bool open() const { return open_; }
  [[nodiscard]] State node(const Eigen::VectorXd& point, int i) const;
  /// Near which the slope at A is searched.
  [[nodiscard]] double slope_near(const Eigen::VectorXd& point) const;

 private:
  const Scene& scene_;
  WorldFlow flow_;
  int num_arcs_;
  bool open_;
  double rest_angle_;  ///< start angle, unless it is open
};

}  // namespace brachisto::worlds
