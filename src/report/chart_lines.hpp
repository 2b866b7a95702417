// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Curves as lines of pixels.

#pragma once

#include <vector>

#include "report/chart_layout.hpp"

namespace brachisto::report {

/// What is seen of a curve: interrupted where a coordinate is not finite, cut
/// a little beyond the frame, without points that are nearer than half a pixel
/// to the one before.
[[nodiscard]] std::vector<std::vector<Pixel>> visible_lines(
    const std::vector<Datum>& points, const ChartLayout& layout);

}  // namespace brachisto::report
