// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What a track that can be built and rolled has to keep to.

#pragma once

#include <optional>
#include <vector>

#include "brachisto/model/body.hpp"

namespace brachisto {

/// How sharply a path may turn, both bounds positive [1/m].
struct CurvatureLimit {
  enum class Of { Track, Centre };

  std::optional<double> hump;    ///< downwards: κ ≤ hump
  std::optional<double> valley;  ///< upwards: κ ≥ −valley
  Of of = Of::Track;
};

/// A disc that the body must not touch.
struct Disc {
  Point centre;         ///< [m]
  double radius = 0.0;  ///< [m]
};

/// All that lies behind the line through a point, which the body must not
/// touch: the normal points to where it may be.
struct HalfPlane {
  Point point;          ///< [m]
  double normal = 0.0;  ///< angle from +x towards +z [rad]
};

/// Limits on request. None of them is there unless it is asked for.
struct PathLimits {
  std::optional<double> friction;    ///< |R_t| ≤ μ R_n
  std::optional<double> normal_min;  ///< R_n ≥ this [m g]
  std::optional<double> normal_max;  ///< R_n ≤ this [m g]
  CurvatureLimit curvature;
  std::optional<double> fold_margin;  ///< 1 − r κ_c ≥ this, in [0, 1)
  std::optional<double> floor;        ///< no part of the body below z = D [m]
  std::vector<Disc> discs;
  std::vector<HalfPlane> half_planes;

  [[nodiscard]] bool any() const {
    return friction || normal_min || normal_max || curvature.hump ||
           curvature.valley || fold_margin || floor || !discs.empty() ||
           !half_planes.empty();
  }
};

}  // namespace brachisto
