// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "design/gather_designs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
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

}  // namespace brachisto
