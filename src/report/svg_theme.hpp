// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Drawings of gnuplot on screens that are dark, and their words in renderers
/// that drop spaces.

#pragma once

#include <string>

#include "report/scale.hpp"

namespace brachisto::report {

/// The ground of dark pages, `--paper` of answer.css there.
inline constexpr Colour kDarkGround{21.0, 23.0, 27.0};

/// L of WCAG 2.1, from 0 of black to 1 of white.
[[nodiscard]] double relative_luminance(const Colour& colour);

/// The contrast of two colours by WCAG 2.1, from 1 to 21.
[[nodiscard]] double contrast(const Colour& one, const Colour& other);

/// The colour of the same hue whose contrast with kDarkGround is that of the
/// given one with white, or white where there is no more contrast; to a unit of
/// each channel. White becomes the ground.
[[nodiscard]] Colour on_dark_ground(const Colour& colour);

/// The drawing with a style that gives its ground, lines and words such colours
/// where a dark scheme is asked for, the ground as the CSS variable `--paper`
/// of a page has it. What is filled keeps its colours, and so do the lines of
/// a map of colours. Spaces in its words are told to be kept.
/// \param svg  as gnuplot 5.4 writes it
[[nodiscard]] std::string with_theme(std::string svg);

}  // namespace brachisto::report
