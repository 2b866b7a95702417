// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A grid that may be bent.

#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "report/svg.hpp"

namespace brachisto::report {

/// Values at the nodes of a grid. Node (i, j) is number i · ny + j.
struct Lattice {
  std::size_t nx = 0, ny = 0;
  std::vector<Pixel> nodes;
  std::vector<double> values;  ///< NaN where there is none

  [[nodiscard]] std::size_t at(std::size_t i, std::size_t j) const {
    return i * ny + j;
  }
};

/// The quadrilaterals around the nodes of a grid: each corner is the mean of
/// the four nodes about it. On the border they end at the nodes, so that all
/// cells together fill the grid and no more.
class Cells {
 public:
  explicit Cells(const Lattice& lattice);

  /// Corner between the nodes i − 1 and i, j − 1 and j.
  [[nodiscard]] Pixel corner(std::size_t i, std::size_t j) const {
    return corners_[i * (ny_ + 1) + j];
  }
  [[nodiscard]] std::array<Pixel, 4> outline(std::size_t i,
                                             std::size_t j) const {
    return {corner(i, j), corner(i + 1, j), corner(i + 1, j + 1),
            corner(i, j + 1)};
  }
  [[nodiscard]] const std::vector<Pixel>& corners() const { return corners_; }
  [[nodiscard]] std::vector<Pixel>& corners() { return corners_; }

 private:
  std::size_t ny_;
  std::vector<Pixel> corners_;
};

}  // namespace brachisto::report
