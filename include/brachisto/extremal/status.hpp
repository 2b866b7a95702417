// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How the search for an extremal ended.

#pragma once

#include <string_view>

namespace brachisto {

enum class ExtremalStatus {
  Solved,              ///< A regular extremal, as accurate as asked for.
  AccuracyNotReached,  ///< An extremal with fewer digits than asked for.
  NoCycloid,           ///< η = 0 has no answer from which to continue.
  BranchTurnsBack,     ///< The branch from the cycloid has a fold below η_m.
  StepTooSmall,        ///< The continuation got stuck between 0 and η_m.
  NewtonFailed,        ///< Newton's method did not converge from the guess.
  BadGuess,            ///< The guess cannot be integrated at all.
  Loop,                ///< The extremal found leaves slopes of [−π, π].
  Stalls,              ///< The extremal found comes to rest on its way.
  NotMinimal,          ///< ∂²𝓗/∂β² > 0 fails on the extremal found.
  TimeLimit,           ///< The seconds allowed ran out.
  Interrupted,         ///< Told to stop from outside.
};

/// One sentence for people.
[[nodiscard]] std::string_view describe(ExtremalStatus status);

}  // namespace brachisto
