// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Where each unknown and each constraint of a rolling_time problem stands.

#pragma once

#include <string>

namespace brachisto {

/// Components of the state at a node, in the order in which they are stored. A
/// body whose centre of mass lies on its axis has no θ.
enum class StateComponent { X, Z, Theta, W };

/// Layout of unknowns and constraints. For n_s states (4, or 3 without θ) and
/// N p collocation points the unknowns are, in this order,
///
///     x_0 z_0 [θ_0] w_0  β_0  x_1 z_1 [θ_1] w_1  β_1  …  β_{Np−1}
///     x_{Np} z_{Np} [θ_{Np}] w_{Np}  U,
///
/// so that what couples lies close together and the one global unknown comes
/// last; β_c belongs to collocation point c, which need not lie between the
/// nodes c and c + 1 it stands between. The constraints are the defects
///
///     x z [θ] w of point 0,  x z [θ] w of point 1,  …
class VariableLayout {
 public:
  VariableLayout(int num_points, bool has_theta)
      : num_points_(num_points), num_states_(has_theta ? 4 : 3) {}

  [[nodiscard]] bool has_theta() const { return num_states_ == 4; }
  [[nodiscard]] int num_states() const { return num_states_; }
  [[nodiscard]] int num_points() const { return num_points_; }
  [[nodiscard]] int num_nodes() const { return num_points_ + 1; }
  [[nodiscard]] int num_variables() const { return stride() * num_nodes(); }
  [[nodiscard]] int num_constraints() const {
    return num_states_ * num_points_;
  }

  /// Index of a state component at node 0 … N p. \pre has_theta() for Theta.
  [[nodiscard]] int state(int node, StateComponent component) const {
    return stride() * node + offset(component);
  }
  /// Index of β at collocation point 0 … N p − 1.
  [[nodiscard]] int beta(int point) const {
    return stride() * point + num_states_;
  }
  /// Index of U.
  [[nodiscard]] int rolling_time() const { return num_variables() - 1; }
  /// Index of the defect of a state component at a collocation point.
  [[nodiscard]] int defect(int point, StateComponent component) const {
    return num_states_ * point + offset(component);
  }

  /// "x[3]", "beta[7]", "U".
  [[nodiscard]] std::string variable_name(int index) const;
  /// "defect of theta[7]".
  [[nodiscard]] std::string constraint_name(int index) const;

 private:
  [[nodiscard]] int stride() const { return num_states_ + 1; }
  [[nodiscard]] int offset(StateComponent component) const {
    const int full = static_cast<int>(component);
    return component == StateComponent::W ? num_states_ - 1 : full;
  }

  int num_points_;
  int num_states_;
};

}  // namespace brachisto
