// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Integration along an arc under limits, with the derivatives of its end.

#pragma once

#include <Eigen/Core>
#include <functional>

#include "extremal/adaptive_integration.hpp"
#include "extremal/limited_flow.hpp"

namespace brachisto::limited {

/// Where a piece of an arc ends.
struct PieceEnd {
  static constexpr auto kRows = static_cast<int>(kSize);

  State y;
  double t = 0.0;  ///< ∫√A du along the piece
  State rates;     ///< dy/du
  double time_rate = 0.0;
  Eigen::Matrix<double, kRows, kRows> by_start;  ///< ∂y/∂(y at the start)
  Eigen::Matrix<double, 1, kRows> time_by_start;
  int steps = 0;
};

/// Which numbers the error control looks at.
enum class Judged { StatesAlone, StatesAndCostates };

/// Integrates from a state over `span` by the pair of orders 7 and 8 that the
/// indirect method has for free motion; the derivatives are those of the steps
/// taken.
///
/// \param step  [in,out] step to try first, 0: any; the last one taken
/// \return false if the steps become too small
[[nodiscard]] bool integrate_piece(const LimitedFlow& flow, const State& start,
                                   double span, Judged judged,
                                   const shooting::StepControl& control,
                                   double& step, PieceEnd& end);

/// The same without derivatives; tells of every step, u from the start of the
/// piece.
[[nodiscard]] bool follow_piece(
    const LimitedFlow& flow, const State& start, double span, Judged judged,
    const shooting::StepControl& control,
    const std::function<void(double u, const State&)>& on_step);

/// One step of length `span`, unchecked: for interpolation.
[[nodiscard]] State step_from(const LimitedFlow& flow, const State& start,
                              double span);

}  // namespace brachisto::limited
