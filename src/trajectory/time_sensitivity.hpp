// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How the times of a motion on a given path depend on numbers of its body.

#pragma once

#include <array>
#include <vector>

#include "trajectory/prescribed_motion.hpp"

namespace brachisto {

/// What a motion on a given path depends on and its path does not.
enum class MotionNumber {
  Loss,     ///< c, or μ of a bead
  Inertia,  ///< k
};
inline constexpr std::size_t kMotionNumbers = 2;

/// A time, and its derivatives by each MotionNumber [s].
struct SensitiveTime {
  double t = 0.0;
  std::array<double, kMotionNumbers> by{};
};

/// ∂t/∂p at the places q of a path, p being a number of the body. On the path
///
///     d(½ v²)/dq = v̇ ds/dq,  dt = ds/v
///
/// with v̇(s, v; p) from the equation of motion, so that e = ∂(½ v²)/∂p is the
/// solution of the linear equation
///
///     de/dq = (∂v̇/∂p + ∂v̇/∂v e/v) ds/dq,  e(0) = 0,
///     d/dq ∂t/∂p = −e/v³ ds/dq.
///
/// Its coefficients are exact, by jets; it is solved by collocation at the
/// Gauss points of the motion's own cells. From rest v ~ q and e ~ q²: all of
/// it is smooth where t is.
class TimeSensitivity {
 public:
  /// \param motion  one that arrives; must outlive this
  explicit TimeSensitivity(const PrescribedMotion& motion);

  /// At a place q ∈ [0, 1].
  [[nodiscard]] SensitiveTime at(double q) const;

 private:
  using Numbers = std::array<double, kMotionNumbers>;
  /// Derivatives by each number.
  struct State {
    Numbers energy{};  ///< of ½ v² [m²/s²]
    Numbers time{};    ///< [s]
  };
  /// From the start of a cell by a step.
  [[nodiscard]] State advance(const State& from,
                              const PrescribedMotion::Step& step) const;

  const PrescribedMotion& motion_;
  std::vector<State> cells_{State{}};  ///< at their starts, and at the end
};

}  // namespace brachisto
