// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/friction_share.hpp"

#include <algorithm>
#include <cmath>

#include "brachisto/math/minima.hpp"
#include "brachisto/math/roots.hpp"
#include "brachisto/math/stop_condition.hpp"

namespace brachisto {

namespace {

double excess(const TrajectoryPoint& at, double mu) {
  return std::abs(at.motion.R_t) - mu * at.motion.R_n;
}

/// The rows, and those between them where the excess changes its sign and back.
std::vector<TrajectoryPoint> with_hidden_extremes(
    const Motion& motion, const std::vector<TrajectoryPoint>& rows, double mu) {
  std::vector<TrajectoryPoint> out = rows;
  for (const double sign : {1.0, -1.0}) {
    std::vector<math::Sample> samples;
    samples.reserve(rows.size());
    for (const TrajectoryPoint& row : rows) {
      samples.push_back({row.sigma, sign * excess(row, mu)});
    }
    for (const math::Sample& found :
         math::minima_below(0.0, samples, [&](double sigma) {
           return sign * excess(motion.at(sigma), mu);
         })) {
      out.push_back(motion.at(found.at));
    }
  }
  std::sort(out.begin(), out.end(),
            [](const TrajectoryPoint& a, const TrajectoryPoint& b) {
              return a.sigma < b.sigma;
            });
  return out;
}

}  // namespace

double friction_share(const Motion& motion,
                      const std::vector<TrajectoryPoint>& samples, double mu) {
  const std::vector<TrajectoryPoint> rows =
      with_hidden_extremes(motion, samples, mu);
  // NaN counts as too much. At the start both forces may vanish: then the first
  // step counts like its end.
  const auto above = [&](const TrajectoryPoint& at) {
    return !(excess(at, mu) <= 0.0);
  };
  double time = 0.0;
  bool before = above(rows.front());
  for (std::size_t i = 1; i < rows.size(); ++i) {
    check_stop(i);
    const double step = rows[i].t - rows[i - 1].t;
    const bool after = above(rows[i]);
    const double ends[] = {excess(rows[i - 1], mu), excess(rows[i], mu)};
    if (before == after) {
      if (after) time += step;
    } else if (ends[0] == 0.0 || ends[1] == 0.0 ||
               std::isnan(ends[0] + ends[1])) {
      if (after) time += step;
    } else {
      const double change = math::find_root(
          [&](double sigma) { return excess(motion.at(sigma), mu); },
          rows[i - 1].sigma, rows[i].sigma, ends[0], ends[1]);
      const double t = motion.at(change).t;
      time += after ? rows[i].t - t : t - rows[i - 1].t;
    }
    before = after;
  }
  return time / rows.back().t;
}

}  // namespace brachisto
