// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Numbers on contour lines.

#pragma once

#include <optional>
#include <vector>

#include "report/plot_frame.hpp"

namespace brachisto::report {

/// Middle and direction of a label.
struct LabelPlace {
  Pixel at;
  double angle;  ///< [°], so that it does not stand on its head
};

/// Finds places for labels: where a line is long and straight enough, within
/// the area and away from all places taken before.
class LabelPlaces {
 public:
  explicit LabelPlaces(const PlotArea& area) : area_(area) {}

  /// Keeps the middle of labels so far away from there.
  void avoid(Pixel at, double distance) { taken_.push_back({at, distance}); }

  /// A place on the line, taken at once; none if the line has no room.
  [[nodiscard]] std::optional<LabelPlace> find(const std::vector<Pixel>& line);

 private:
  [[nodiscard]] bool free(Pixel at) const;

  struct Taken {
    Pixel at;
    double distance;
  };

  PlotArea area_;
  std::vector<Taken> taken_;
};

}  // namespace brachisto::report
