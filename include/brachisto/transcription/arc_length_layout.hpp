// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Where each unknown and each constraint of an arc_length problem stands.

#pragma once

#include <string>

namespace brachisto {

/// Layout of unknowns and constraints on N intervals. The start, node 0, is no
/// unknown. The unknowns are, in this order,
///
///     x_1 z_1 [θ_1]  x_2 z_2 [θ_2]  …  x_N z_N [θ_N]  S,
///
/// and the constraints, those of interval j, which leads to node j, beside it,
///
///     no slip of 1  [place of 1]  no slip of 2  [place of 2]  …
///
/// A body whose centre of mass lies on its axis has no θ and no place rows. So
/// node j owns `variables_per_node()` consecutive unknowns and
/// `constraints_per_node()` consecutive constraints, which couple it with node
/// j − 1, node j + 1 and S alone.
class ArcLengthLayout {
 public:
  ArcLengthLayout(int num_intervals, bool has_theta)
      : num_intervals_(num_intervals), has_theta_(has_theta) {}

  [[nodiscard]] bool has_theta() const { return has_theta_; }
  [[nodiscard]] int num_intervals() const { return num_intervals_; }
  /// The start included.
  [[nodiscard]] int num_nodes() const { return num_intervals_ + 1; }
  [[nodiscard]] int variables_per_node() const { return has_theta_ ? 3 : 2; }
  [[nodiscard]] int constraints_per_node() const { return has_theta_ ? 2 : 1; }
  [[nodiscard]] int num_variables() const {
    return variables_per_node() * num_intervals_ + 1;
  }
  [[nodiscard]] int num_constraints() const {
    return constraints_per_node() * num_intervals_;
  }

  /// Index at node 1 … N.
  [[nodiscard]] int x(int node) const {
    return variables_per_node() * (node - 1);
  }
  [[nodiscard]] int z(int node) const { return x(node) + 1; }
  /// \pre has_theta()
  [[nodiscard]] int theta(int node) const { return x(node) + 2; }
  [[nodiscard]] int arc_length() const { return num_variables() - 1; }
  /// Of the interval that leads to node 1 … N.
  [[nodiscard]] int no_slip(int node) const {
    return constraints_per_node() * (node - 1);
  }
  /// θ_j − θ_m = (S/r) σ_j². \pre has_theta()
  [[nodiscard]] int place(int node) const { return no_slip(node) + 1; }

  /// "x[3]", "theta[3]", "S".
  [[nodiscard]] std::string variable_name(int index) const;
  /// "no slip[3]", "place[3]".
  [[nodiscard]] std::string constraint_name(int index) const;

 private:
  int num_intervals_;
  bool has_theta_;
};

}  // namespace brachisto
