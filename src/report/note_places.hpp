// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Where the words of notes stand when there are many of them.

#pragma once

#include <vector>

#include "report/chart.hpp"
#include "report/figure.hpp"

namespace brachisto::report {

/// A plot in pixels from its upper left, and its size.
struct PlotPixels {
  PixelScale x, y;
};

/// The notes with words that lie within the plot and on no other words and no
/// mark, as near to their own marks as the notes before leave room; what finds
/// no room stays where it was.
[[nodiscard]] std::vector<Note> apart(std::vector<Note> notes,
                                      const PlotPixels& plot);

}  // namespace brachisto::report
