// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Which figures a sweep needs.

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/figure.hpp"
#include "report/scale.hpp"
#include "report/sweep_scenes.hpp"

namespace brachisto::report {

/// A picture and what it shows.
struct SweepDrawing {
  Figure figure;
  std::string caption;  ///< HTML
};

/// Drawings of the same scenes.
struct SweepFigure {
  std::string name;  ///< that those of its drawings begin with
  /// Columns that are the same for all its scenes, but not for all of the
  /// sweep.
  std::vector<std::size_t> fixed;
  Scenes scenes;
  ValueRange tau{0.0, 1.0};  ///< that colours or the vertical axis stand for
  std::vector<SweepDrawing> drawings;
};

/// The figures, and what is to be said of all of them.
struct SweepFigures {
  std::vector<SweepFigure> figures;
  std::vector<std::string> remarks;  ///< sentences of HTML
};

/// Two ordered numeric axes, those that change fastest, make maps; if one has
/// few values, also a family of curves. One makes curves, with an axis of few
/// words as family. A sample that is not ordered, or words alone, make a plot
/// of dots for each column; one of two numbers also has them as coloured dots.
/// Other axes give figures of their own for each combination of their values.
///
/// Lists are drawn in the order of their values. Where that does not make a
/// map, as values are there twice or depend on one another so that cells would
/// overlap, there are only curves, or dots.
///
/// All figures have one range of τ, unless most would show little then. Figures
/// of too many scenes, and too many figures, are left out.
[[nodiscard]] SweepFigures sweep_figures(const SweepTable& table);

}  // namespace brachisto::report
