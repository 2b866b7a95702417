// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The path that a centre took, as a curve on which other bodies may be put.

#pragma once

#include "brachisto/trajectory/motion.hpp"
#include "model/plane_curve.hpp"

namespace brachisto {

/// The given one, if it was given; otherwise by a spline of the slopes of a
/// fine sample, to the fourth order where its curvature is smooth and to the
/// second where it jumps, and bent by as little so that the track ends at B.
[[nodiscard]] PlaneCurvePtr held_path(const Motion& motion);

}  // namespace brachisto
