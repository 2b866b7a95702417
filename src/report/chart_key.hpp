// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The key of a chart.

#pragma once

#include <string>
#include <vector>

#include "report/chart_layout.hpp"

namespace brachisto::report {

/// A name and what it stands for: a curve or an area.
struct KeyEntry {
  std::string name;
  const Curve* curve = nullptr;
  const Area* area = nullptr;
};

/// Names of a chart, each once for all curves that look the same.
[[nodiscard]] std::vector<KeyEntry> key_entries(const Chart& chart);

/// Columns of equal width, filled from top to bottom, one after the other.
class KeyTable {
 public:
  /// \param width  room [px]
  KeyTable(std::vector<KeyEntry> entries, double width);

  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] double width() const {
    return static_cast<double>(columns_) * column_;
  }
  [[nodiscard]] double height() const {
    return static_cast<double>(rows_) * kLine;
  }
  void draw(Svg& svg, Pixel corner) const;

 private:
  static constexpr double kLine = 20.0;

  std::vector<KeyEntry> entries_;
  std::size_t columns_ = 0, rows_ = 0;
  double column_ = 0.0;  // width [px]
};

/// What is below the plot.
struct ChartFoot {
  KeyTable key;
  Pixel corner;   ///< its upper left
  double bottom;  ///< where the drawing ends
};
[[nodiscard]] ChartFoot chart_foot(const Chart& chart,
                                   const ChartLayout& layout);

}  // namespace brachisto::report
