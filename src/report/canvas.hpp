// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A picture while its commands for gnuplot are written.

#pragma once

#include <fmt/format.h>

#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "report/figure.hpp"
#include "report/scale.hpp"

namespace brachisto::report {

/// A side of a plot.
struct Side {
  std::string label;  ///< rich text with the unit, "R_n [m g]"
  Scale scale = Scale::Linear;
  std::optional<double> low, high;  ///< of the range, in its units; else from
                                    ///< the curves, with a little room
  std::vector<std::string> words = {};  ///< that stand at 0, 1, 2, … instead of
                                        ///< numbers; no markup

  /// Whether the words are more than fit beside one another.
  [[nodiscard]] bool slanted() const;
};

/// How a plot with a title above and a key below is laid out [px].
struct Layout {
  double left, right;    ///< margins of the plot
  double height;         ///< of the plot
  double above;          ///< it, below the titles
  double title_left;     ///< where titles begin
  double to_key;         ///< from the plot
  double key_at;         ///< from the left
  const char* key_side;  ///< of the key that is there: "left", "center"
  int sample;            ///< of a line in the key, in letters
};

/// Rich text as a string of gnuplot.
[[nodiscard]] std::string quoted_words(std::string_view source);

/// Places are in pixels from the upper left, words rich text.
class Canvas {
 public:
  double width = 720.0, height = 0.0;  ///< of the picture

  /// The frame of a plot, its titles, and a key of so many rows; sets height
  /// and title of the picture. Before all that is put, whenever it is called.
  void open(const Layout& layout, const std::string& title,
            const std::string& subtitle, int key_rows);
  /// A side of the plot that is open, 'x' or 'y', and its range.
  /// \param down  whether y grows downwards
  void axis(char name, const Side& side, const Extent& range,
            bool down = false);
  /// Where a scene lies on the plot that is open.
  [[nodiscard]] SceneCells::Cell cell(std::size_t scene, double x,
                                      double y) const {
    return {scene, x_(x), y_(y)};
  }

  template <class... Args>
  void put(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format,
                   std::forward<Args>(args)...);
  }
  void frame(double left, double top, double wide, double high);
  void words(const std::string& text, double x, double y,
             std::string_view style);

  /// One more layer of the next plot.
  /// \param name  for the key; empty: not there
  void layer(std::string_view item, const std::string& name = {});
  /// Plots the layers.
  /// \param nothing  layer without which gnuplot would draw no frame
  void plot(std::string_view command = "plot",
            std::string_view nothing = "NaN");

  [[nodiscard]] Figure figure(std::string name, std::string table) &&;

 private:
  std::string head_, text_, layers_;
  std::string title_;  ///< plain
  double left_ = 0.0, right_ = 0.0, top_ = 0.0, bottom_ = 0.0;
  PixelScale x_{}, y_{};
};

}  // namespace brachisto::report
