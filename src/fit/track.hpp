// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The track on which times were measured.

#pragma once

#include "brachisto/trajectory/motion.hpp"
#include "model/plane_curve.hpp"

namespace brachisto::fit {

/// The path of the centre of a motion as a curve of its own, on which other
/// bodies may be put: through a fine sample of it, to the fourth order where
/// its curvature is smooth.
[[nodiscard]] PlaneCurvePtr held_path(const Motion& motion);

}  // namespace brachisto::fit
