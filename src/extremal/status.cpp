// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/extremal/status.hpp"

namespace brachisto {

std::string_view describe(ExtremalStatus status) {
  switch (status) {
    case ExtremalStatus::Solved:
      return "solved to the accuracy asked for";
    case ExtremalStatus::AccuracyNotReached:
      return "an extremal was found, with fewer digits than asked for";
    case ExtremalStatus::NoCycloid:
      return "no path exists for a centred body, from which to start";
    case ExtremalStatus::BranchTurnsBack:
      return "the branch of extremals from the cycloid turns back before η_m";
    case ExtremalStatus::StepTooSmall:
      return "the continuation from the cycloid got stuck before η_m";
    case ExtremalStatus::NewtonFailed:
      return "Newton's method did not converge";
    case ExtremalStatus::BadGuess:
      return "the equations cannot be integrated from the guess";
    case ExtremalStatus::Loop:
      return "the extremal found has a loop, which is no track";
    case ExtremalStatus::Stalls:
      return "the body comes to rest on the extremal found";
    case ExtremalStatus::NotMinimal:
      return "the Hamiltonian is not minimal along the extremal found";
    case ExtremalStatus::TimeLimit:
      return "the time allowed ran out";
    case ExtremalStatus::Interrupted:
      return "stopped from outside";
  }
  return "unknown status";
}

}  // namespace brachisto
