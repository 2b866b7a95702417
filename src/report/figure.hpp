// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Static pictures: a table, a short gnuplot script, and what gnuplot makes of
/// them.

#pragma once

#include <atomic>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "brachisto/report/result.hpp"

namespace brachisto::report {

/// Where scenes of a sweep lie on a picture, in pixels from its upper left.
struct SceneCells {
  struct Cell {
    std::size_t scene;
    double x, y;
  };
  std::vector<Cell> cells = {};  ///< row by row
  std::size_t per_row = 0;       ///< of rows that are alike; 0: there are none
  bool meet = false;  ///< areas of a map between neighbours, not dots
};

/// A range of an axis and where it lies on the picture [px].
struct PixelScale {
  double low, high;
  double from, to;
  bool logarithmic = false;

  [[nodiscard]] double operator()(double value) const;
};

/// A picture before it is drawn.
struct Figure {
  std::string name;   ///< of its files, without ending
  std::string table;  ///< CSV; the first row names the columns
  /// gnuplot commands. `data` stands for the table, `part(p, c)` for the value
  /// in column c of the rows whose column `part` is p, NaN in all others.
  std::string commands;
  double width = 720.0, height = 480.0;  ///< [px]
  std::string title = {};  ///< plain: for those who cannot see the picture
  int frame_delay = 4;     ///< of a picture that moves [1/100 s]
  SceneCells scenes = {};  ///< of a sweep
};

/// Gif is a picture that moves: `commands` draw it frame by frame.
enum class Format { Svg, Gif };

/// What is to be written of a figure: `<name>.csv`, `<name>.gp` and, unless it
/// is missing, the picture; or of a page with figures.
struct DrawnFiles {
  std::vector<OutputFile> files;
  std::string missing;  ///< why pictures are missing; empty if none is
};

/// Has gnuplot draw it, a child process that reads nothing but what it is given
/// here, and is stopped after a minute; it needs 0.1 s.
/// \param interrupt  nonzero: stop; may be null
/// \throws Stopped
[[nodiscard]] DrawnFiles draw(const Figure& figure, Format format,
                              const std::atomic<int>* interrupt);

/// For a string of gnuplot within single quotes that shows the text as it is,
/// in enhanced text as well.
[[nodiscard]] std::string gnuplot_escaped(std::string_view text);

}  // namespace brachisto::report
