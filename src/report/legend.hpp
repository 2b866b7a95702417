// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Signs of a figure and what they mean.

#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "report/plot_frame.hpp"
#include "report/sweep_scenes.hpp"

namespace brachisto::report {

/// What is the same for all scenes of a figure, above its plot.
/// \return where the drawing has to begin, 0 or above
double draw_heading(Svg& svg, const PlotArea& area, const SweepTable& table,
                    const std::vector<std::size_t>& fixed,
                    const Scenes& scenes);

/// The same after a few words, as plain text.
[[nodiscard]] std::string document_title(std::string_view what,
                                         const SweepTable& table,
                                         const std::vector<std::size_t>& fixed,
                                         const Scenes& scenes);

/// The pattern of failed scenes, to be filled with as "url(#id)".
void define_hatch(Svg& svg, std::string_view id);

/// A cross.
void draw_cross(Svg& svg, Pixel at, std::string_view attributes);

/// A ring that is seen on every colour, black within if it is to be filled.
void draw_ring(Svg& svg, Pixel at, bool filled,
               std::string_view attributes = "");

/// The signs of the fastest scenes, as Legend::minima() explains them, where
/// they have a place.
void draw_minima(Svg& svg, const SweepDigest& found,
                 const std::function<Pixel(std::size_t)>& place);

/// A black line with white sides, which is seen on every colour, along path
/// data.
void draw_edge(Svg& svg, std::string_view path);

/// Lines of text below a plot, a sign before each.
class Legend {
 public:
  /// \param first  left end of the first line
  /// \param right  where lines end at the latest
  Legend(Svg& svg, Pixel first, double right)
      : svg_(svg), at_(first), right_(right) {}

  void swatch(std::string_view attributes, std::string_view markup);
  void cross(std::string_view markup);
  void dot(std::string_view attributes, std::string_view markup);

  /// A black line with white sides.
  void edge(std::string_view markup);

  /// The fastest feasible scene, with a filled ring, and the fastest of all if
  /// it is infeasible, with an open one; each by the columns that vary.
  void minima(const SweepTable& table, const Scenes& scenes);

  /// Where the next line would be.
  [[nodiscard]] double bottom() const { return at_.y; }

 private:
  void entry(std::string_view markup);
  void minimum(const SweepTable& table, const std::vector<std::size_t>& columns,
               std::size_t scene, const std::string& what);
  [[nodiscard]] Pixel sign() const { return {at_.x + 11.0, at_.y - 5.0}; }

  Svg& svg_;
  Pixel at_;
  double right_;
};

}  // namespace brachisto::report
