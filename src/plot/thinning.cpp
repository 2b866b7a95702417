// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "plot/thinning.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "brachisto/math/stop_condition.hpp"

namespace brachisto::plot {

namespace {

/// What is compared between rows: a column in units of what is visible of it.
struct Compared {
  const std::vector<double>* values;
  ShownRange range;  ///< what lies outside is not looked at
};

/// The slope angle turns the contact about the centre, θ the body: what they
/// are off by is judged on the rim, within the size of the track.
std::vector<Compared> compared(const TrajectoryTable& table, const Body& body,
                               const std::vector<ShownCurve>& curves) {
  std::vector<Compared> all;
  for (const ShownCurve& curve : curves) {
    all.push_back({&table[curve.column], curve.range});
  }
  const auto extent = [&](std::string_view name) {
    const auto [low, high] = std::ranges::minmax(table[name]);
    return ShownRange{low, high};
  };
  const ShownRange x = extent("x_b"), z = extent("z_b");
  const double size = std::max(x.width(), z.width());
  for (const std::string_view place : {"x_b", "z_b"}) {
    const ShownRange range = extent(place);
    all.push_back({&table[place], {range.low, range.low + size}});
  }
  if (body.rolls()) {
    const double turn = size / body.radius;  // [rad] that are seen as much
    const ShownRange beta = extent("beta");
    all.push_back({&table["beta"], {beta.low, beta.low + turn}});
  }
  return all;
}

/// Whether straight lines between two rows miss none of those between by more
/// than a share of the range. Of very many some are looked at.
bool close(const TrajectoryTable& table, const std::vector<Compared>& all,
           std::size_t from, std::size_t to, double share) {
  constexpr std::size_t kLooked = 24;
  const std::vector<double>& t = table.time();
  const std::size_t step = std::max<std::size_t>(1, (to - from) / kLooked);
  for (std::size_t row = from + 1; row < to; row += step) {
    const double s = (t[row] - t[from]) / (t[to] - t[from]);
    for (const Compared& one : all) {
      const std::vector<double>& values = *one.values;
      const double value = values[row];
      if (!(value >= one.range.low && value <= one.range.high)) continue;
      const double line = std::lerp(values[from], values[to], s);
      // Written so that a NaN is not close.
      if (!(std::abs(line - value) <= share * one.range.width())) return false;
    }
  }
  return true;
}

/// From each row the farthest that is close, looked for in steps that double
/// and then by halves.
std::vector<std::size_t> chosen(const TrajectoryTable& table,
                                const std::vector<Compared>& all, double share,
                                std::size_t most) {
  const std::size_t last = table.size() - 1;
  std::vector<std::size_t> rows{0};
  while (rows.back() < last && rows.size() <= most) {
    check_stop();
    const std::size_t from = rows.back();
    std::size_t good = from + 1, step = 1;
    while (good < last) {
      const std::size_t next = std::min(good + step, last);
      if (!close(table, all, from, next, share)) break;
      good = next;
      step *= 2;
    }
    for (; step > 0; step /= 2) {
      const std::size_t next = good + step;
      if (next <= last && close(table, all, from, next, share)) good = next;
    }
    rows.push_back(good);
  }
  return rows;
}

/// So many of n rows, the first and the last among them.
std::vector<std::size_t> evenly(std::size_t n, std::size_t count) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < count; ++i) {
    rows.push_back(i * (n - 1) / (count - 1));
  }
  return rows;
}

double distance(Point a, Point b) {
  return std::hypot(a.x - b.x, a.z - b.z);
}

}  // namespace

ShownRange shown_range(const TrajectoryTable& table,
                       const std::vector<double>& values) {
  constexpr double kStart = 0.02, kOutside = 0.01, kAll = 3.0;
  const std::vector<double>& t = table.time();
  std::vector<double> sorted;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (t[i] >= kStart * t.back() && std::isfinite(values[i])) {
      sorted.push_back(values[i]);
    }
  }
  if (sorted.empty()) return {};
  std::ranges::sort(sorted);
  const ShownRange all{sorted.front(), sorted.back()};
  const auto outside =
      static_cast<std::size_t>(kOutside * static_cast<double>(sorted.size()));
  const ShownRange most{sorted[outside], sorted[sorted.size() - 1 - outside]};
  return all.width() <= kAll * most.width() ? all : most;
}

Miss worst_miss(const TrajectoryTable& table, const TrajectoryTable& few,
                const Body& body) {
  Miss worst;
  for (std::size_t i = 0; i < table.size(); ++i) {
    check_stop();
    const Pose pose = few.pose(table.time()[i]);
    const double miss = std::max(
        distance(pose.centre, {table["x_c"][i], table["z_c"][i]}),
        distance(pose.contact(body), {table["x_b"][i], table["z_b"][i]}));
    if (miss > worst.distance) worst = {i, miss};
  }
  return worst;
}

ThinnedTable thinned(const TrajectoryTable& table, const Body& body,
                     const std::vector<ShownCurve>& curves, std::size_t most) {
  const std::size_t n = table.size();
  std::vector<std::size_t> rows(n);
  std::iota(rows.begin(), rows.end(), 0);
  if (n > most) {
    const std::vector<Compared> all = compared(table, body, curves);
    constexpr double kFinest = 1e-5, kCoarser = 1.5;
    for (double share = kFinest; share < kCoarsest && rows.size() > most;
         share *= kCoarser) {
      rows = chosen(table, all, share, most);
    }
    if (rows.size() > most) rows = evenly(n, most);
  }
  ThinnedTable out{table.with_rows(rows), n, 0.0, 0.0};
  if (rows.size() == n) return out;
  out.path_error = worst_miss(table, out.table, body).distance;
  for (const ShownCurve& curve : curves) {
    const std::vector<double>& values = table[curve.column];
    if (!(curve.range.width() > 0.0)) continue;
    for (std::size_t i = 0; i < n; ++i) {
      const double value = values[i];
      if (!(value >= curve.range.low && value <= curve.range.high)) continue;
      const double off =
          std::abs(out.table.value(curve.column, table.time()[i]) - value);
      // What is not known at a row beside is not drawn there.
      if (off > 0.0) {
        out.curve_error = std::max(out.curve_error, off / curve.range.width());
      }
    }
  }
  return out;
}

}  // namespace brachisto::plot
