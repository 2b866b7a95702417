// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Integration of Hamilton's equations over one arc, with or without the
/// derivatives of its end.

#pragma once

#include <Eigen/Core>
#include <vector>

#include "extremal/adaptive_integration.hpp"
#include "extremal/canonical_flow.hpp"
#include "extremal/extremal_path.hpp"

namespace brachisto::shooting {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Where an arc ends.
struct ArcEnd {
  State y;
  double t = 0.0;     ///< ∫√A du over the arc
  double beta = 0.0;  ///< continuous along the arc
  State rates;        ///< dy/du
  int steps = 0;

  Matrix6 by_start;                          ///< ∂y/∂(y at the start)
  Eigen::Matrix<double, 6, 3> by_parameter;  ///< ∂y/∂(p_x, p_z, η)
};

/// Integrates from u = 0 to `span` with an embedded Runge–Kutta pair of orders
/// 7 and 8 (Fehlberg 1968), the derivatives along with the path: they are the
/// exact derivatives of the steps taken.
///
/// \param near       slope angle near the start, which selects β
/// \param step       [in,out] step to try first; the last one taken
/// \return false if there is no slope, or the steps become too small
[[nodiscard]] bool integrate_arc(const CanonicalFlow& flow, const State& start,
                                 double near, double span,
                                 const StepControl& control, double& step,
                                 ArcEnd& end);

/// The same without derivatives. Appends the start and the path after every
/// step to `knots`, u and t counted from the start of the arc.
[[nodiscard]] bool integrate_path(const CanonicalFlow& flow, const State& start,
                                  double near, double span,
                                  const StepControl& control, double& step,
                                  ArcEnd& end,
                                  std::vector<ExtremalPath::Knot>& knots);

/// One step of length `span` from a knot, unchecked: for interpolation.
[[nodiscard]] ExtremalPath::Knot step_from(const CanonicalFlow& flow,
                                           const ExtremalPath::Knot& knot,
                                           double span);

}  // namespace brachisto::shooting
