// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "design/best_track.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "design/closed_times.hpp"
#include "design/gather_designs.hpp"

namespace brachisto {

namespace {

/// The quickest body that may be shown: the best, or where none is feasible the
/// quickest there is.
const DesignMinimum* shown(const DesignAnswer& answer) {
  if (answer.best) return &*answer.best;
  for (const DesignMinimum& minimum : answer.minima) {
    if (minimum.verified) return &minimum;
  }
  return nullptr;
}

}  // namespace

std::vector<DesignMinimum> reached_by(const std::vector<DesignSearch>& all) {
  std::vector<DesignMinimum> reached;
  for (const DesignSearch& search : all) {
    if (search.reached && search.stopped) reached.push_back(*search.reached);
  }
  std::ranges::stable_sort(reached, {}, &DesignMinimum::tau);
  return reached;
}

Solution solve_best(const Scene& stated, const SolveOptions& stated_options,
                    const std::vector<DesignMinimum>& reached,
                    const std::atomic<int>* interrupt,
                    WallClock::time_point end, DesignAnswer& answer) {
  // Of the limit of time, for a solve that comes when it is over.
  constexpr double kLeast = 0.1;
  SolveOptions options = stated_options;
  const auto track_of = [&](const DesignMinimum& minimum) {
    const double left = seconds_until(end);
    options.limits.seconds =
        std::max(left, kLeast * stated_options.limits.seconds);
    Scene scene = stated;
    scene.body = minimum.body;
    Solution solution = solve(scene, options, {.interrupt = interrupt});
    solution.options = stated_options;
    return solution;
  };
  if (!answer.best) {
    for (DesignMinimum minimum : reached) {
      Solution solution = track_of(minimum);
      minimum.feasible = solution.verified() && solution.feasible();
      if (solution.verified() &&
          (minimum.feasible || !answer.plan.require_feasible)) {
        minimum.tau = solution.motion()->tau();
        minimum.verified = true;
        answer.best = minimum;
        answer.minima.push_back(minimum);
        std::ranges::stable_sort(answer.minima, {}, &DesignMinimum::tau);
        return solution;
      }
      if (seconds_until(end) <= 0.0) break;
    }
  }
  if (const DesignMinimum* minimum = shown(answer)) return track_of(*minimum);
  Solution solution;
  solution.scene = stated;
  solution.options = stated_options;
  solution.status = answer.stopped ? Status::TimeLimit : Status::NotConverged;
  solution.message =
      answer.stopped ? fmt::format(
                           "the limit of {:g} s was reached before a "
                           "search had come to a verified body",
                           stated_options.limits.seconds)
      : answer.minima.empty()
          ? "no search came to a minimum"
          : "no search came to a minimum on the principal branch";
  return solution;
}

std::string cut_short(const SolveOptions& options, const DesignAnswer& answer,
                      int starts) {
  return fmt::format(
      "the limit of {:g} s was reached when {} of {} searches had ended: this "
      "is the quickest body so far",
      options.limits.seconds, answer.searches, starts);
}

Designed find_design(const Scene& scene, const SolveOptions& options,
                     const DesignPlan& plan,
                     const std::atomic<int>* interrupt) {
  const double limit = options.limits.seconds;
  const WallClock::time_point end = seconds_from_now(limit),
                              searched =
                                  seconds_from_now(kShareOfSearches * limit);
  const int first = plan.start.value_or(1),
            last = plan.start.value_or(plan.starts);
  Designed out;
  std::vector<DesignSearch> searches;
  bool all = true;
  try {
    for (int start = first; start <= last && all; ++start) {
      all = seconds_until(searched) > 0.0;
      if (!all) break;
      searches.push_back(search_design(scene, options_until(options, searched),
                                       plan, start, interrupt));
    }
  } catch (const Stopped&) {
    all = false;
  }
  const std::vector<DesignMinimum> reached = reached_by(searches);
  out.answer = gather_designs(plan, std::move(searches));
  out.answer.stopped = out.answer.stopped || !all;
  if (interrupt != nullptr && interrupt->load() != 0) {
    out.solution.scene = scene;
    out.solution.options = options;
    out.solution.status = Status::Interrupted;
    out.solution.message = "stopped before all searches had ended";
    return out;
  }
  out.solution =
      solve_best(scene, options, reached, interrupt, end, out.answer);
  if (out.answer.stopped && out.solution.verified()) {
    out.solution.warnings.push_back(
        cut_short(options, out.answer, last - first + 1));
  }
  return out;
}

}  // namespace brachisto
