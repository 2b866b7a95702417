// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Where each unknown and each constraint of a transcription stands.

#pragma once

#include <string>

#include "brachisto/ocp/mesh.hpp"

namespace brachisto {

/// Components of the state at a node, in the order in which they are stored. A
/// body whose centre of mass lies on its axis has no θ. β is a state of
/// limited_time alone.
enum class StateComponent { X, Z, Theta, W, Beta };

/// Layout of unknowns and constraints: a group of unknowns for each node along
/// the path, one global unknown last; a group of constraints for each point,
/// which leads from node to node. So what couples lies close together.
///
/// rolling_time: for n_s states (4, or 3 without θ) and N p collocation points
///
///     x_0 z_0 [θ_0] w_0  β_0  x_1 z_1 [θ_1] w_1  β_1  …  β_{Np−1}
///     x_{Np} z_{Np} [θ_{Np}] w_{Np}  U;
///
/// β_c belongs to collocation point c, which need not lie between the nodes c
/// and c + 1 it stands between. The constraints are the defects
///
///     x z [θ] w of point 0,  x z [θ] w of point 1,  …
///
/// arc_length: on N pieces, the start, node 0, being no unknown,
///
///     x_1 z_1 [θ_1]  x_2 z_2 [θ_2]  …  x_N z_N [θ_N]  S;
///
/// the constraints of piece j, which leads to node j, are
///
///     no slip of 1  [place of 1]  no slip of 2  [place of 2]  …,
///
/// place being θ_j − θ_m = (S/r) σ_j².
///
/// limited_time: like rolling_time with β among the states and the control
/// h q = h dβ/du in its place; after the defects of a point stand its limits,
/// and after all of them four rows for the two contacts where their slopes are
/// free, a fifth for the push there, and the limits on forces at rest where
/// β(0) is free.
class VariableLayout : public ocp::Layout {
 public:
  /// Of rolling_time.
  VariableLayout(int num_points, bool has_theta)
      : VariableLayout(num_points, has_theta, has_theta ? 4 : 3, true,
                       has_theta ? 4 : 3) {}
  /// Of arc_length.
  [[nodiscard]] static VariableLayout of_pieces(int num_pieces,
                                                bool has_theta) {
    return {num_pieces, has_theta, has_theta ? 3 : 2, false, has_theta ? 2 : 1};
  }

  /// Of limited_time.
  [[nodiscard]] static VariableLayout with_limits(int num_points,
                                                  bool has_theta,
                                                  int num_limits,
                                                  int num_contact_rows,
                                                  int num_start_rows) {
    const int states = has_theta ? 5 : 4;
    VariableLayout layout(num_points, has_theta, states, true,
                          states + num_limits);
    layout.num_contact_rows_ = num_contact_rows;
    layout.num_start_rows_ = num_start_rows;
    return layout;
  }

  [[nodiscard]] bool has_theta() const { return has(StateComponent::Theta); }
  [[nodiscard]] bool has(StateComponent component) const {
    return has_state(static_cast<int>(component));
  }
  [[nodiscard]] int num_constraints() const {
    return start_row(num_start_rows_);
  }

  using Layout::defect;
  using Layout::state;
  /// Index of a state component at node 0 … N p, of pieces 1 … N.
  /// \pre has_theta() for Theta, rolling_time for W
  [[nodiscard]] int state(int node, StateComponent component) const {
    return state(node, static_cast<int>(component));
  }
  /// Index of β at collocation point 0 … N p − 1, of rolling_time.
  [[nodiscard]] int beta(int point) const { return control(point); }
  /// Index of the global unknown, U or S.
  [[nodiscard]] int rolling_time() const { return last(); }
  [[nodiscard]] int arc_length() const { return last(); }
  /// Index of the defect of a state component at a collocation point.
  [[nodiscard]] int defect(int point, StateComponent component) const {
    return defect(point, static_cast<int>(component));
  }
  /// x, z of the contact at A, then at B, then w of a push at A.
  [[nodiscard]] int contact_row(int number) const {
    return end_of_points() + number;
  }
  [[nodiscard]] int num_contact_rows() const { return num_contact_rows_; }
  /// Of the limits on forces at rest.
  [[nodiscard]] int start_row(int number) const {
    return contact_row(num_contact_rows_) + number;
  }
  [[nodiscard]] int num_start_rows() const { return num_start_rows_; }
  /// Of the piece that leads to node 1 … N.
  [[nodiscard]] int no_slip(int node) const { return num_rows() * (node - 1); }
  /// \pre has_theta()
  [[nodiscard]] int place(int node) const { return no_slip(node) + 1; }

  /// "x[3]", "beta[7]", "U".
  [[nodiscard]] std::string variable_name(int index) const;
  /// "defect of theta[7]", "no slip[3]".
  [[nodiscard]] std::string constraint_name(int index) const;

 private:
  VariableLayout(int num_points, bool has_theta, int num_states,
                 bool has_control, int num_rows)
      : Layout(num_points, has_theta ? 0 : 1 << kTheta, num_states,
               has_control ? 1 : 0, num_rows) {}

  static constexpr int kTheta = static_cast<int>(StateComponent::Theta);
  [[nodiscard]] bool slope_is_state() const {
    return has_controls() && num_states() == (has_theta() ? 5 : 4);
  }
  [[nodiscard]] const char* state_name(int offset) const;

  int num_contact_rows_ = 0, num_start_rows_ = 0;
};

}  // namespace brachisto
