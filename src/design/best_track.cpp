// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "design/best_track.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "design/closed_times.hpp"
#include "design/design_space.hpp"

namespace brachisto {

namespace {

/// Minima that agree to this, relative to τ, and in traits, are one; where the
/// margins that hold them are known to fewer digits, as the edge of a branch is
/// and forces are on the meshes that searches have, to a hundred times as much.
constexpr double kOneTau = 1e-8;
constexpr double kOnePlace = 1e-5;
constexpr double kAtMargins = 100.0;

/// Whether only the end that a design has without a bound of its own holds
/// η_m back.
bool runs_away(const DesignPlan& plan, const DesignMinimum& minimum) {
  return !plan.bounds[static_cast<std::size_t>(BodyKey::EtaM)] &&
         std::ranges::any_of(minimum.bounds_active, [](const auto& held) {
           return held.name == name(BodyKey::EtaM) &&
                  held.bound == kLargestOffset;
         });
}

bool is_held_by_a_margin(const DesignMinimum& minimum) {
  return std::ranges::any_of(minimum.bounds_active, [](const auto& held) {
    return std::ranges::find(kMargins, held.name) != kMargins.end();
  });
}

bool same(const DesignMinimum& a, const DesignMinimum& b) {
  const bool at_margins = is_held_by_a_margin(a) && is_held_by_a_margin(b) &&
                          a.feasible == b.feasible;
  const double digits = at_margins ? kAtMargins : 1.0;
  return std::abs(a.tau / b.tau - 1.0) <= digits * kOneTau &&
         (traits_of(a.body) - traits_of(b.body)).norm() <= digits * kOnePlace;
}

}  // namespace

DesignAnswer gather_designs(const DesignPlan& plan,
                            std::vector<DesignSearch> searches) {
  DesignAnswer out;
  out.plan = plan;
  for (DesignSearch& search : searches) {
    // A search that was led astray may come to one minimum twice.
    std::vector<std::size_t> reached;
    for (DesignMinimum& minimum : search.minima) {
      const auto known = std::ranges::find_if(
          out.minima,
          [&](const DesignMinimum& other) { return same(minimum, other); });
      const auto index = static_cast<std::size_t>(known - out.minima.begin());
      if (known == out.minima.end()) out.minima.push_back(std::move(minimum));
      if (std::ranges::count(reached, index) > 0) continue;
      reached.push_back(index);
      ++out.minima[index].found_from;
    }
    std::ranges::move(search.paths, std::back_inserter(out.paths));
    for (std::string& reason : search.lost) {
      out.lost.push_back({search.number, std::move(reason)});
    }
    out.stopped = out.stopped || search.stopped;
    if (!search.stopped) {
      ++out.searches;
      out.starts += search.starts;
    }
    out.solves += search.solves;
    out.cpu_seconds += search.cpu_seconds;
  }
  std::ranges::stable_sort(out.minima, {}, &DesignMinimum::tau);
  // Of bodies that were passed the quickest stands for all.
  bool one = false;
  std::erase_if(out.minima, [&](const DesignMinimum& minimum) {
    if (minimum.stationary) return false;
    const bool more = one || !minimum.verified;
    one = one || !more;
    return more;
  });
  for (DesignMinimum& minimum : out.minima) {
    if (!runs_away(plan, minimum)) continue;
    minimum.remarks.push_back(fmt::format(
        "it leans on η_m = {}, where a design ends that states no bound: "
        "towards η_m = 1, k = 0 bodies grow ever quicker, and there is no "
        "quickest one; state design.bounds.eta_m",
        kLargestOffset));
  }
  const auto best =
      std::ranges::find_if(out.minima, [&](const DesignMinimum& minimum) {
        return minimum.verified && !runs_away(plan, minimum) &&
               (minimum.feasible || !plan.require_feasible);
      });
  if (best != out.minima.end()) out.best = *best;
  return out;
}

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
