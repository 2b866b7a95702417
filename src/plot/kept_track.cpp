// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "plot/kept_track.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plot/thinning.hpp"

namespace brachisto::plot {

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
