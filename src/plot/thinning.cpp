// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "plot/thinning.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string_view>
#include <utility>

#include "brachisto/math/clock.hpp"

namespace brachisto::plot {

namespace {

using report::Extent;

/// What is compared between rows: a column in units of what is visible of it.
struct Compared {
  const std::vector<double>* values;
  Extent range;  ///< what lies outside is not looked at
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
    return Extent{low, high};
  };
  const Extent x = extent("x_b"), z = extent("z_b");
  const double size = std::max(x.width(), z.width());
  for (const std::string_view place : {"x_b", "z_b"}) {
    const Extent range = extent(place);
    all.push_back({&table[place], {range.low, range.low + size}});
  }
  if (body.rolls()) {
    const double turn = size / body.radius;  // [rad] that are seen as much
    const Extent beta = extent("beta");
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

/// The row of a table that fewer rows of the same motion miss by the most.
struct Miss {
  std::size_t row = 0;
  double distance = 0.0;  ///< of the centre or the contact [m]
};

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

}  // namespace

Extent shown_range(const TrajectoryTable& table,
                   const std::vector<double>& values) {
  constexpr double kStart = 0.02, kOutside = 0.01, kAll = 3.0;
  const std::vector<double>& t = table.time();
  std::vector<double> sorted;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (t[i] >= kStart * t.back() && std::isfinite(values[i])) {
      sorted.push_back(values[i]);
    }
  }
  if (sorted.empty()) return {0.0, 0.0};
  std::ranges::sort(sorted);
  const Extent all{sorted.front(), sorted.back()};
  const auto outside =
      static_cast<std::size_t>(kOutside * static_cast<double>(sorted.size()));
  const Extent most{sorted[outside], sorted[sorted.size() - 1 - outside]};
  return all.width() <= kAll * most.width() ? all : most;
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

namespace {

using report::Json;

/// In the order of the lists. web/sweep.js has the same.
constexpr std::array<std::string_view, 6> kLists{"t",    "x_c", "z_c",
                                                 "beta", "v_c", "theta"};

std::size_t num_kept(const Body& body) {
  return body.rolls() ? kLists.size() : kLists.size() - 1;
}

/// A power of ten that is at most a hundred-thousandth of the range, or of a
/// tenth of the values if they are nearly alike.
double step_of(const std::vector<double>& values) {
  constexpr double kResolution = 1e-5, kAlike = 0.1;
  const auto [low, high] = std::ranges::minmax(values);
  const double most = std::max(std::abs(low), std::abs(high));
  const double scale = std::max(high - low, kAlike * most);
  return scale > 0.0
             ? std::pow(10.0, std::floor(std::log10(kResolution * scale)))
             : 1.0;
}

/// Rows whose times differ by a step, the last one among them.
std::vector<std::size_t> distinct_rows(const std::vector<double>& times,
                                       double step) {
  const auto rounded = [&](std::size_t row) {
    return std::llround(times[row] / step);
  };
  std::vector<std::size_t> rows{0};
  for (std::size_t row = 1; row < times.size(); ++row) {
    if (rounded(row) > rounded(rows.back())) {
      rows.push_back(row);
    } else if (row + 1 == times.size() && rows.size() > 1) {
      rows.back() = row;
    }
  }
  return rows;
}

/// The steps and the rows.
Json rounded(const TrajectoryTable& few, const Body& body) {
  Json track;
  const double step = step_of(few.time());
  const TrajectoryTable table = few.with_rows(distinct_rows(few.time(), step));
  for (std::size_t c = 0; c < num_kept(body); ++c) {
    const std::vector<double>& values = table[kLists[c]];
    const double unit = c == 0 ? step : step_of(values);
    track["steps"].push_back(unit);
    Json moves = Json::array();
    std::int64_t before = 0;
    for (const double value : values) {
      const std::int64_t now = std::llround(value / unit);
      moves.push_back(now - before);
      before = now;
    }
    track["rows"].push_back(std::move(moves));
  }
  return track;
}

/// The times between which R_n ≤ 0, on straight lines between rows. Where the
/// body starts R_n may be 0.
Json lifts_of(const TrajectoryTable& table) {
  const std::vector<double>&t = table.time(), &force = table["R_n"];
  const auto lifted = [&](std::size_t row) {
    return row > 0 && row < t.size() && force[row] <= 0.0;
  };
  const auto zero = [&](std::size_t i) {
    const double share = force[i] / (force[i] - force[i + 1]);
    return std::isfinite(share) ? std::lerp(t[i], t[i + 1], share) : t[i + 1];
  };
  Json lifts = Json::array();
  for (std::size_t row = 1; row < t.size(); ++row) {
    if (!lifted(row)) continue;
    const double from = force[row - 1] > 0.0 ? zero(row - 1) : t[row - 1];
    while (lifted(row + 1)) ++row;
    lifts.push_back({from, row + 1 < t.size() ? zero(row) : t[row]});
  }
  return lifts;
}

/// Rounded upwards: it is a bound.
double two_digits(double error) {
  if (!(error > 0.0)) return 0.0;
  const double unit = std::pow(10.0, std::floor(std::log10(error)) - 1.0);
  return std::ceil(error / unit) * unit;
}

}  // namespace

Json kept_track(const TrajectoryTable& table, const Body& body) {
  const auto [left, right] = std::ranges::minmax(table["x_b"]);
  const auto [top, bottom] = std::ranges::minmax(table["z_b"]);
  const double most = kKeptError * std::max(right - left, bottom - top);
  // Again and again the row that is missed by the most.
  std::vector<std::size_t> rows{0, table.size() - 1};
  while (rows.size() < kMostKeptRows) {
    const Miss miss = worst_miss(table, table.with_rows(rows), body);
    if (!(miss.distance > most)) break;
    rows.insert(std::ranges::upper_bound(rows, miss.row), miss.row);
  }
  Json track = rounded(table.with_rows(rows), body);
  track["of_rows"] = table.size();
  track["path_error"] = two_digits(
      worst_miss(table, *read_kept_track(track, body), body).distance);
  track["lifts"] = lifts_of(table);
  return track;
}

std::optional<TrajectoryTable> read_kept_track(const Json& track,
                                               const Body& body) {
  try {
    std::vector<TableColumn> columns{{"u", {}}};
    for (std::size_t c = 0; c < num_kept(body); ++c) {
      const double step = track.at("steps").at(c);
      std::int64_t now = 0;
      TableColumn column{std::string(kLists[c]), {}};
      for (const Json& move : track.at("rows").at(c)) {
        now += move.get<std::int64_t>();
        column.values.push_back(static_cast<double>(now) * step);
      }
      columns.push_back(std::move(column));
    }
    const std::vector<double> t = columns[1].values;
    const auto fits = [&](const TableColumn& column) {
      return column.values.size() == t.size();
    };
    if (t.size() < 2 ||
        !std::ranges::all_of(columns.begin() + 1, columns.end(), fits) ||
        std::ranges::adjacent_find(t, std::greater_equal<>{}) != t.end()) {
      return std::nullopt;
    }
    columns[0].values = t;
    // r ω = v_c; a bead has neither angle.
    const double none = std::numeric_limits<double>::quiet_NaN();
    TableColumn omega{"omega", columns[5].values};
    for (double& value : omega.values) {
      value = body.rolls() ? value / body.radius : none;
    }
    if (!body.rolls()) columns.push_back({"theta", omega.values});
    columns.push_back(std::move(omega));
    return TrajectoryTable(std::move(columns));
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace brachisto::plot
