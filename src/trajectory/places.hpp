// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The places of a path under limits as variables of the second order.

#pragma once

#include <optional>

#include "transcription/limited_curve.hpp"

namespace brachisto {

/// Where the path touches a limit and where one takes the control over from
/// another are variables too, which a mesh that ends its elements there holds
/// fixed. With K the KKT matrix of fixed places, B the derivatives of its
/// residual by them and C their own ones, Haynsworth's formula gives all of
/// them together as many positive eigenvalues as K and S = C − BᵀK⁻¹B have.
///
/// - From a bound on one side the control jumps to one on the other where T is
///   least: a minimum has one more positive eigenvalue for each, unless
///   the other is touched there: both keep to one value then, with one slope,
///   so exchanged over a length δ the controls change T by O(δ³) alone.
/// - Of two bounds on the same side the narrower one holds, and T is greatest
///   where they cross; of a value that is touched the largest one along the
///   path is to keep the limit, L_tt = λ c'' < 0. A minimum has none more for
///   these.
///
/// \return how many positive eigenvalues K has at a minimum less its number of
///         variables; nothing if λ c'' > 0 or if it cannot be told. 0 of a path
///         without such places, and where K is singular.
[[nodiscard]] std::optional<int> positive_by_places(const LimitedCurve& curve);

}  // namespace brachisto
