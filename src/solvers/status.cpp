// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/solvers/status.hpp"

#include <array>

namespace brachisto {

namespace {

struct Words {
  std::string_view name, sentence;
};

/// In the order of Status.
constexpr std::array kWords{
    Words{"solved", "The optimality conditions hold to the wanted tolerance."},
    Words{"not_converged",
          "The iteration stopped before the optimality conditions held."},
    Words{"not_evaluable",
          "The iteration ran into points where the body would not move on "
          "(w ≤ 0, U ≤ 0 or A ≤ 0)."},
    Words{"iteration_limit", "The limit on iterations was reached."},
    Words{"time_limit", "The limit on wall-clock time was reached."},
    Words{"interrupted", "The solve was interrupted."},
    Words{"out_of_memory", "There is not enough memory."},
    Words{"no_admissible_path",
          "No path satisfies the conditions of the scene."},
    Words{
        "not_reached",
        "No extremal was followed from the cycloid to the scene; there may be "
        "one."},
    Words{"no_smooth_contact",
          "Under the limits no slope at B was found with which a track goes on "
          "there as its end was built."},
    Words{"no_fastest_track",
          "Under the limits tracks that turn ever more sharply at A are ever "
          "faster."},
    Words{"infeasible",
          "The solver ended at a path that violates the limits at any penalty; "
          "other paths may keep them."},
    Words{"stalled", "The body does not reach the end of the given path."},
    Words{"internal_error", "The solver reported an internal error."}};
static_assert(kWords.size() ==
              static_cast<std::size_t>(Status::InternalError) + 1);

}  // namespace

std::string_view name(Status status) {
  return kWords.at(static_cast<std::size_t>(status)).name;
}

std::string_view describe(Status status) {
  return kWords.at(static_cast<std::size_t>(status)).sentence;
}

Status stopped_by(const StopCondition& stop) {
  return stop.interrupted() ? Status::Interrupted : Status::TimeLimit;
}

std::string_view name(LinearSolver solver) {
  constexpr std::array<std::string_view, 3> kNames{"auto", "chain", "mumps"};
  return kNames.at(static_cast<std::size_t>(solver));
}

}  // namespace brachisto
