// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Where each unknown and each constraint of a problem along a path stands.

#pragma once

#include <array>
#include <bitset>
#include <cstddef>

namespace brachisto::ocp {

/// A group of unknowns for each node along the path, its states and behind them
/// the control of the point that follows, and one global unknown last; a group
/// of constraints for each point, which leads from node to node: a defect of
/// each state, then the limits. So what couples lies close together. More rows
/// may follow.
///
/// A state of the description on which nothing depends can be absent.
class Layout {
 public:
  static constexpr int kMostStates = 8;
  using States = std::bitset<kMostStates>;

  /// \param has_control  false: all along the path are states, and the first
  ///                     node is given
  /// \param num_rows     constraints of a point
  Layout(int num_points, States absent, int num_states, bool has_control,
         int num_rows)
      : num_points_(num_points),
        absent_(absent),
        num_states_(num_states),
        num_controls_(has_control ? 1 : 0),
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
  /// Collocation points or pieces.
  [[nodiscard]] int num_points() const { return num_points_; }
  /// The start included.
  [[nodiscard]] int num_nodes() const { return num_points_ + 1; }
  [[nodiscard]] int num_variables() const {
    return num_points_ * stride() + num_controls_ * num_states_ + 1;
  }
  /// From a node's unknowns to the next one's.
  [[nodiscard]] int stride() const { return num_states_ + num_controls_; }
  /// Index of a state at a node.
  [[nodiscard]] int state(int node, int state) const {
    return stride() * (node - first_node()) +
           offsets_[static_cast<std::size_t>(state)];
  }
  /// Index of the control at a collocation point.
  [[nodiscard]] int control(int point) const {
    return stride() * point + num_states_;
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
