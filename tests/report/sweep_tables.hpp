// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Sweeps whose outcome is a formula.

#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "report/sweep_table.hpp"

namespace brachisto::testing {

inline constexpr double kDegree = std::numbers::pi / 180.0;

/// An axis of one column that runs evenly from `from` to `to`.
struct Range {
  std::string key;
  double from, to;
  std::size_t count;
};

/// An axis of one column with these values.
struct List {
  std::string key;
  std::vector<double> values;
};

/// The product of some lists; τ of each scene as a function of its values, all
/// scenes verified and feasible.
inline SweepTable list_over(
    const std::vector<List>& lists,
    const std::function<double(const std::vector<double>&)>& tau) {
  SweepTable table;
  table.title = "A sweep";
  std::size_t scenes = 1;
  for (const List& list : lists) {
    table.axes.push_back({{table.columns.size()}, list.values.size(), true});
    table.columns.push_back({list.key, {}, {}});
    scenes *= list.values.size();
  }
  for (std::size_t scene = 0; scene < scenes; ++scene) {
    std::vector<double> values(lists.size());
    std::size_t rest = scene;
    for (std::size_t a = lists.size(); a-- > 0;) {
      values[a] = lists[a].values[rest % lists[a].values.size()];
      rest /= lists[a].values.size();
    }
    for (std::size_t a = 0; a < lists.size(); ++a) {
      table.columns[a].numbers.push_back(values[a]);
    }
    SweepOutcome outcome;
    outcome.state = SweepOutcome::State::Verified;
    outcome.status = "solved";
    outcome.feasible = true;
    outcome.tau = tau(values);
    outcome.transit_time = 0.25 * outcome.tau;
    outcome.estimated_error = 1e-11;
    outcome.end_angle = 1.0;
    table.outcomes.push_back(outcome);
  }
  return table;
}

/// The same for ranges.
inline SweepTable sweep_over(
    const std::vector<Range>& ranges,
    const std::function<double(const std::vector<double>&)>& tau) {
  std::vector<List> lists;
  for (const Range& range : ranges) {
    List list{range.key, {}};
    for (std::size_t i = 0; i < range.count; ++i) {
      const double share =
          range.count == 1
              ? 0.0
              : static_cast<double>(i) / static_cast<double>(range.count - 1);
      list.values.push_back(std::lerp(range.from, range.to, share));
    }
    lists.push_back(std::move(list));
  }
  return list_over(lists, tau);
}

inline void fail(SweepTable& table, std::size_t scene,
                 const std::string& message = "it did not converge") {
  table.outcomes[scene] = {};
  table.outcomes[scene].state = SweepOutcome::State::Failed;
  table.outcomes[scene].status = "max_iterations";
  table.outcomes[scene].message = message;
}

inline std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos;
       at = text.find(part, at + part.size())) {
    ++found;
  }
  return found;
}

}  // namespace brachisto::testing
