// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Units in which the numbers of a scene are of order one.

#pragma once

#include "brachisto/model/scene.hpp"

namespace brachisto {

/// A system of units of length and time.
struct Units {
  double length = 1.0;  ///< [m]
  double time = 1.0;    ///< [s]

  [[nodiscard]] double speed() const { return length / time; }
  /// A number of SI in these units.
  [[nodiscard]] double measured(double number, Dimension dimension) const;
};

/// Natural units of a scene: the larger of L and H as the unit of length, and
/// the time for which 2 g = 1, so that w² = E. Solving in them makes results
/// free of units and of g but for rounding.
[[nodiscard]] Units natural_units(const Scene& scene);

/// The same scene in a unit of length [m] and the time for which 2 g = 1.
[[nodiscard]] Scene in_units_of(double length, const Scene& scene);

/// The same scene, its numbers measured in natural_units(scene).
[[nodiscard]] Scene in_natural_units(const Scene& scene);

/// A scene as it is asked for and as it is solved.
struct PosedScene {
  explicit PosedScene(const Scene& original);

  Scene asked;    ///< in SI units
  Scene scene;    ///< the same without_whole_turns()
  Scene natural;  ///< `scene` in natural units
  Units units;    ///< those of `natural`
};

}  // namespace brachisto
