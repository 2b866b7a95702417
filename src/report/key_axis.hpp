// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A key of a sweep along the horizontal axis of a plot.

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/plot_frame.hpp"
#include "report/sweep_scenes.hpp"

namespace brachisto::report {

/// Numbers on a scale, or words side by side. Scenes of one word are spread
/// about it, by a rule, not at random.
class KeyAxis {
 public:
  KeyAxis(const SweepColumn& column, const Scenes& scenes,
          const PlotArea& area);

  /// Pixel of a scene.
  [[nodiscard]] double operator()(std::size_t scene) const;

  void draw(Svg& svg, const PlotArea& area) const;

  /// How far the axis with its label reaches below the plot [px].
  [[nodiscard]] double depth(const PlotArea& area) const;

 private:
  [[nodiscard]] Axis make_axis(const Scenes& scenes,
                               const PlotArea& area) const;

  const SweepColumn& column_;
  std::vector<std::string> words_;
  Axis axis_;
};

}  // namespace brachisto::report
