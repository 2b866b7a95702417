// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Peaks and valleys of a track, in numbers.

#pragma once

#include <vector>

#include "brachisto/trajectory/motion.hpp"

namespace brachisto::reproduction {

/// Where a track bends most, one way or the other.
struct Bend {
  double x = 0.0;      ///< x_b [m]
  double theta = 0.0;  ///< of the body there [rad]
};

/// A peak: a stretch on which the track turns downwards, dβ/ds > 0.
struct Peak {
  double turn = 0.0;  ///< by how much β rises on it [rad]
  Bend top;           ///< largest κ_b of it
};

struct PeaksAndValleys {
  std::vector<Peak> peaks;
  std::vector<Bend> valleys;  ///< least κ_b between one peak and the next

  /// How pronounced they are: the angle by which the track turns downwards in
  /// all [rad]. 0 for a track that only turns upwards, such as a cycloid's.
  [[nodiscard]] double turn() const;
};

/// Those of a motion's track, in the order in which the body comes to them.
/// Stretches that turn by less than a millionth of a degree are rounding.
[[nodiscard]] PeaksAndValleys peaks_and_valleys(const Motion& motion);

}  // namespace brachisto::reproduction
