// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Signs of a figure and what they mean.

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "report/plot_frame.hpp"
#include "report/sweep_scenes.hpp"

namespace brachisto::report {

/// What is the same for all scenes of a figure, above its plot.
void draw_heading(Svg& svg, const PlotArea& area, const SweepTable& table,
                  const std::vector<std::size_t>& fixed, const Scenes& scenes);

/// The same after a few words, as plain text.
[[nodiscard]] std::string document_title(std::string_view what,
                                         const SweepTable& table,
                                         const std::vector<std::size_t>& fixed,
                                         const Scenes& scenes);

/// The pattern of failed scenes, to be filled with as "url(#id)".
void define_hatch(Svg& svg, std::string_view id);

/// A cross.
void draw_cross(Svg& svg, Pixel at, std::string_view attributes);

/// A ring that is seen on every colour.
void draw_ring(Svg& svg, Pixel at, std::string_view attributes);

/// A black line with white sides, which is seen on every colour, along path
/// data.
void draw_edge(Svg& svg, std::string_view path);

/// Lines of text below a plot, a sign before each.
class Legend {
 public:
  /// \param first  left end of the first line
  Legend(Svg& svg, Pixel first) : svg_(svg), at_(first) {}

  void swatch(std::string_view attributes, std::string_view markup);
  void ring(std::string_view markup);
  void cross(std::string_view markup);
  void dot(std::string_view attributes, std::string_view markup);

  /// A black line with white sides.
  void edge(std::string_view markup);

  /// The smallest τ and where, by these columns.
  void minimum(const SweepTable& table, const std::vector<std::size_t>& columns,
               std::size_t scene);

  /// Where the next line would be.
  [[nodiscard]] double bottom() const { return at_.y; }

 private:
  void entry(std::string_view markup);
  [[nodiscard]] Pixel sign() const { return {at_.x + 11.0, at_.y - 5.0}; }

  Svg& svg_;
  Pixel at_;
};

}  // namespace brachisto::report
