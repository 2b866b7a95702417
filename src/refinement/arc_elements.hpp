// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How many elements there are on each arc, and where arcs are not known yet.

#pragma once

#include <optional>
#include <vector>

#include "refinement/arcs.hpp"
#include "transcription/limited_curve.hpp"

namespace brachisto {

/// Allowed between points, well below what a certificate allows.
inline constexpr double kAllowedExcess = 1e-9;
/// Allowed of a path that exceeds limits itself, on elements however short:
/// half of what a certificate allows. Arcs for less would be too short for
/// their equations.
inline constexpr double kAllowedOfPath = 5e-9;

/// Elements are divided that exceed a limit between their points by more than
/// is allowed, which falls with their length h like h^p. Whether any was.
bool divide_for_limits(const LimitedCurve& curve, double allowed,
                       std::vector<Arc>& arcs);
/// So are those that err too much in T, which falls like h^(2p) at least, or
/// make slopes err, there or elsewhere, which falls like h^p.
///
/// \param finer      on the same elements, by a higher degree
/// \param tolerance  relative, of T
/// \param allowed    to be exceeded by
bool divide(const LimitedCurve& curve, const LimitedCurve& finer,
            double tolerance, double allowed, std::vector<Arc>& arcs);

/// Whether both have the same slopes all along, as far as is asked for.
[[nodiscard]] bool slopes_agree(const LimitedCurve& curve,
                                const LimitedCurve& finer, double tolerance);

/// The same arcs with each element in two.
[[nodiscard]] std::vector<Arc> halved(std::vector<Arc> arcs);

/// The same arcs with elements that grow shorter towards junctions near which a
/// multiplier has the wrong sign: where it vanishes, what the path does in a
/// thin layer behind may turn it. Nothing if none has.
[[nodiscard]] std::optional<std::vector<Arc>> graded_where_signs_err(
    const LimitedCurve& curve, std::vector<Arc> arcs);

/// The same arcs on so many equal elements, or one on each.
[[nodiscard]] std::vector<Arc> with_elements(std::vector<Arc> arcs, int wanted);

/// Elements halved where what holds changes within them or next to them.
[[nodiscard]] Mesh finer_at_changes(const LimitedCurve& curve);

}  // namespace brachisto
