// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How the time of an answer changes with its scene.

#pragma once

#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "math/dense.hpp"
#include "model/scene_coordinate.hpp"

namespace brachisto {

/// Derivative of the time by one number.
struct TimeRate {
  double total = 0.0;  ///< all that the conditions determine moving along
  /// The slopes at A and B that the places of the centre follow from held.
  double at_fixed_contacts = 0.0;
};

/// The open conditions of each unknown as columns.
template <class Rates>
[[nodiscard]] Eigen::MatrixXd jacobian_of(const std::vector<Rates>& rates) {
  const auto n = static_cast<Eigen::Index>(rates.size());
  Eigen::MatrixXd jacobian(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    jacobian.col(i) = rates[static_cast<std::size_t>(i)].open;
  }
  return jacobian;
}

/// The rate of the time by one number where unknowns move along so that the
/// open conditions go on to hold.
///
/// \param direct    by the number, the unknowns held: `time`, and `open` of the
///                  conditions
/// \param unknowns  the same by each of them
template <class Rates>
[[nodiscard]] double closed_rate(const Rates& direct,
                                 const std::vector<Rates>& unknowns) {
  double time = direct.time;
  if (unknowns.empty()) return time;
  const Eigen::VectorXd follow =
      math::solve_square(jacobian_of(unknowns), -direct.open);
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    time += follow[static_cast<Eigen::Index>(i)] * unknowns[i].time;
  }
  return time;
}

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
  /// Those that will be asked for, which cost less together.
  virtual void expect(std::span<const SceneCoordinate>) {}
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
