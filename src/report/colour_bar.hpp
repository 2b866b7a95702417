// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What the colours of a map mean.

#pragma once

#include <string_view>
#include <vector>

#include "report/colour_map.hpp"
#include "report/plot_frame.hpp"

namespace brachisto::report {

/// Black or white, whichever is better seen on a colour.
[[nodiscard]] std::string_view ink_on(const Colour& ground);

/// The colours from the bottom to the top of an area, with ticks at `levels`.
/// \param id     of the gradient, unique within a page
/// \param label  markup
void draw_colour_bar(Svg& svg, const PlotArea& area, ValueRange range,
                     const std::vector<double>& levels, std::string_view id,
                     std::string_view label);

}  // namespace brachisto::report
