// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The path of the centre on a given path of a scene.

#pragma once

#include "brachisto/model/scene.hpp"
#include "model/plane_curve.hpp"

namespace brachisto {

/// The path of the centre that scene.path means.
///
/// A track leads from A to B, and the centre runs beside it at the distance r,
/// or beside the path that another centre took at what their radii differ by.
/// A curve of the centre with Contact::Smooth starts where the body touches the
/// track at A, and ends where it touches it at B: at C_B(φ), φ being the slope
/// angle that the curve itself has there, the root nearest to level if there
/// are several. Of a cycloid that is the extremal of the uniform cylinder.
///
/// \param scene  one with a path that satisfies validate()
/// \throws std::invalid_argument  if there is no such curve; what() says why
[[nodiscard]] PlaneCurvePtr centre_curve(const Scene& scene);

}  // namespace brachisto
