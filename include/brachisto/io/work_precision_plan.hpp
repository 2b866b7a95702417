// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Which methods to run on which meshes, to see what accuracy costs.

#pragma once

#include <vector>

namespace brachisto {

/// A way to solve the paper's discrete system.
enum class DiscreteArm {
  Rest,     ///< hybrid, A as the zero level of the energy
  Release,  ///< hybrid, the first node as the zero level
  Newton,   ///< exact derivatives, dense
  Lifted,   ///< the same steps from a sparse system
};

/// A method, and so a line of a work–precision diagram.
struct ComparedMethod {
  enum class Kind { RollingTime, ArcLength, Extremal, DiscreteSystem };

  Kind kind = Kind::RollingTime;
  int degree = 0;                          ///< p, of RollingTime alone
  DiscreteArm arm = DiscreteArm::Release;  ///< of DiscreteSystem alone

  friend bool operator==(const ComparedMethod&,
                         const ComparedMethod&) = default;
};

/// A method as collocation of degree p.
[[nodiscard]] constexpr ComparedMethod rolling_time(int degree) {
  return {.kind = ComparedMethod::Kind::RollingTime, .degree = degree};
}
/// A method as an arm of the discrete system.
[[nodiscard]] constexpr ComparedMethod discrete_system(DiscreteArm arm) {
  return {.kind = ComparedMethod::Kind::DiscreteSystem, .arm = arm};
}

/// The section `work_precision` of a problem file.
struct WorkPrecisionPlan {
  std::vector<ComparedMethod> methods{rolling_time(1),
                                      rolling_time(2),
                                      rolling_time(3),
                                      rolling_time(4),
                                      rolling_time(5),
                                      rolling_time(6),
                                      {.kind = ComparedMethod::Kind::ArcLength},
                                      {.kind = ComparedMethod::Kind::Extremal},
                                      discrete_system(DiscreteArm::Rest),
                                      discrete_system(DiscreteArm::Release)};
  /// Elements of rolling_time, pieces of arc_length, nodes of fsolve.
  std::vector<int> meshes{10, 20, 40, 80};
  int repetitions = 5;              ///< ≥ 1
  double seconds_per_point = 60.0;  ///< wall clock, > 0
};

}  // namespace brachisto
