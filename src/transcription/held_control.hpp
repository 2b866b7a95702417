// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Which limit holds the control on a stretch of the path, and from which side.

#pragma once

#include <vector>

#include "transcription/limited_time.hpp"

namespace brachisto {

/// \pre held at one of them
[[nodiscard]] inline double bound_of(const PathInequality& limit,
                                     nlp::Held where) {
  return where == nlp::Held::AtUpper ? limit.upper : limit.lower;
}

/// Whether no limit holds.
[[nodiscard]] bool is_free(const std::vector<nlp::Held>& held);

/// The limit that holds the control; −1 if none does.
[[nodiscard]] int held_of_control(const std::vector<nlp::Held>& held,
                                  const std::vector<PathInequality>& limits);

/// Whether a limit at a bound keeps the control from growing.
[[nodiscard]] bool holds_from_above(const LimitedTime& problem, int limit,
                                    nlp::Held where,
                                    TurningPoint<double> place);

/// Whether what holds the control on two stretches does so from opposite sides:
/// where one follows the other it jumps.
[[nodiscard]] bool opposite(const LimitedTime& problem,
                            const std::vector<nlp::Held>& one,
                            const std::vector<nlp::Held>& other,
                            const TurningPoint<double>& place);

}  // namespace brachisto
