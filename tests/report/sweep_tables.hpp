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
#include <vector>

#include "brachisto/study/sweep_table.hpp"

namespace brachisto::testing {

inline constexpr double kDegree = std::numbers::pi / 180.0;

/// An axis of one column that runs evenly from `from` to `to`.
struct Range {
  std::string key;
  double from, to;
  std::size_t count;
};

/// The product of some ranges; τ of each scene as a function of its values, all
/// scenes verified and feasible.
inline SweepTable sweep_over(
    const std::vector<Range>& ranges,
    const std::function<double(const std::vector<double>&)>& tau) {
  SweepTable table;
  table.title = "A sweep";
  std::size_t scenes = 1;
  for (const Range& range : ranges) {
    table.axes.push_back({{table.columns.size()}, range.count, true});
    table.columns.push_back({range.key, {}, {}});
    scenes *= range.count;
  }
  for (std::size_t scene = 0; scene < scenes; ++scene) {
    std::vector<double> values(ranges.size());
    std::size_t rest = scene;
    for (std::size_t a = ranges.size(); a-- > 0;) {
      const Range& range = ranges[a];
      const double share = range.count == 1
                               ? 0.0
                               : static_cast<double>(rest % range.count) /
                                     static_cast<double>(range.count - 1);
      values[a] = std::lerp(range.from, range.to, share);
      rest /= range.count;
    }
    for (std::size_t a = 0; a < ranges.size(); ++a) {
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
