// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// within_limits().

#pragma once

#include <functional>

#include "brachisto/math/stop_condition.hpp"
#include "brachisto/study/solve.hpp"

namespace brachisto {

/// Does the work that fills `out`, with `stop` in force. If that was met, or
/// memory ran out, `out` says so and has no answer.
void within_limits(Solution& out, const StopCondition& stop,
                   const std::function<void()>& work);

}  // namespace brachisto
