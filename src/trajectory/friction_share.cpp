// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/friction_share.hpp"

#include <cmath>

#include "brachisto/math/roots.hpp"
#include "brachisto/math/stop_condition.hpp"

namespace brachisto {

double friction_share(const Motion& motion,
                      const std::vector<TrajectoryPoint>& rows, double mu) {
  const auto excess = [mu](const TrajectoryPoint& at) {
    return std::abs(at.motion.R_t) - mu * at.motion.R_n;
  };
  // NaN counts as too much. At the start both forces may vanish: then the first
  // step counts like its end.
  const auto above = [&](const TrajectoryPoint& at) {
    return !(excess(at) <= 0.0);
  };
  double time = 0.0;
  bool before = above(rows.front());
  for (std::size_t i = 1; i < rows.size(); ++i) {
    check_stop(i);
    const double step = rows[i].t - rows[i - 1].t;
    const bool after = above(rows[i]);
    if (before == after) {
      if (after) time += step;
    } else if (excess(rows[i - 1]) == 0.0 || excess(rows[i]) == 0.0 ||
               std::isnan(excess(rows[i - 1]) + excess(rows[i]))) {
      if (after) time += step;
    } else {
      const double change = math::find_root(
          [&](double sigma) { return excess(motion.at(sigma)); },
          rows[i - 1].sigma, rows[i].sigma, excess(rows[i - 1]),
          excess(rows[i]));
      const double t = motion.at(change).t;
      time += after ? rows[i].t - t : t - rows[i - 1].t;
    }
    before = after;
  }
  return time / rows.back().t;
}

}  // namespace brachisto
