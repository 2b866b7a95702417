// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How the time of an answer changes with its scene.

#pragma once

#include <limits>
#include <memory>

#include "model/scene_coordinate.hpp"

namespace brachisto {

/// Derivative of the time by one number.
struct TimeRate {
  double total = 0.0;  ///< all that the conditions determine moving along
  /// The slopes at A and B that the places of the centre follow from held.
  double at_fixed_contacts = 0.0;
};

/// An answer as the root of its conditions, which are explicit in the scene:
/// so its derivatives follow from one solution with their Jacobian each. Units
/// are those of the scene.
class TimeRates {
 public:
  virtual ~TimeRates() = default;

  /// Of the body with θ, even if its centre of mass lies on the axis.
  [[nodiscard]] virtual const Scene& scene() const = 0;
  [[nodiscard]] virtual double time() const = 0;
  /// False if the conditions are singular: then there are no derivatives.
  [[nodiscard]] virtual bool regular() const = 0;
  /// \pre regular()
  [[nodiscard]] virtual TimeRate by(SceneCoordinate coordinate) = 0;
  /// dφ/dκ for a kink κ = φ − β_end asked for at a smooth contact, NaN if there
  /// is none: 0 where the path ceases to be a minimum between its fixed ends, ∞
  /// where the branch turns.
  [[nodiscard]] virtual double contact_response() {
    return std::numeric_limits<double>::quiet_NaN();
  }
  /// The same answer of a scene next to this one; null if it is not found.
  [[nodiscard]] virtual std::unique_ptr<TimeRates> next(
      SceneCoordinate coordinate, double by) = 0;

 protected:
  TimeRates() = default;
  TimeRates(const TimeRates&) = default;
  TimeRates& operator=(const TimeRates&) = default;
};

}  // namespace brachisto
