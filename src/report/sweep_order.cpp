// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/sweep_plots.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "report/key_label.hpp"

namespace brachisto::report {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A place in a map whose sides are 1 long.
struct Place {
  double x, y;
};

double cross(Place a, Place b, Place c) {
  return (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
}

/// Where a map puts scenes along one direction, from 0 to 1.
std::vector<double> places(const SweepColumn& column, const Scenes& scenes) {
  const Scale scale = scale_of(column, scenes);
  std::vector<double> out;
  Extent extent;
  for (const std::size_t scene : scenes) {
    const double number = shown_number(column, scene);
    out.push_back(scale == Scale::Logarithmic ? std::log(number) : number);
    extent.include(out.back());
  }
  for (double& place : out) {
    place = (place - extent.low) / extent.width();
  }
  return out;
}

/// Whether all quadrilaterals between the scenes are convex and turn the same
/// way. What has no place does not count.
bool is_mesh(const SweepTable& table, const SweepMap& map,
             const Scenes& scenes) {
  constexpr double kNothing = 1e-12;  // of the area of the map
  const std::vector<double> x = places(table.columns[map.first], scenes);
  const std::vector<double> y = places(table.columns[map.second], scenes);
  double sense = 0.0;
  for (std::size_t i = 0; i + 1 < map.n_first; ++i) {
    for (std::size_t j = 0; j + 1 < map.n_second; ++j) {
      const std::size_t node = i * map.n_second + j;
      std::array<Place, 4> corners{};
      std::size_t c = 0;
      for (const std::size_t at :
           {node, node + map.n_second, node + map.n_second + 1, node + 1}) {
        corners[c++] = {x[at], y[at]};
      }
      std::array<double, 4> turns{};
      for (c = 0; c < 4; ++c) {
        turns[c] =
            cross(corners[c], corners[(c + 1) % 4], corners[(c + 2) % 4]);
      }
      const double area =
          0.25 * std::accumulate(turns.begin(), turns.end(), 0.0);
      if (!std::isfinite(area)) continue;
      if (sense == 0.0) sense = area > 0.0 ? 1.0 : -1.0;
      if (sense * area < kNothing ||
          std::ranges::any_of(
              turns, [&](double turn) { return sense * turn < -kNothing; })) {
        return false;
      }
    }
  }
  return sense != 0.0;
}

/// The indices of an axis, by the mean of the finite numbers that the scenes
/// `scene(index, k)` have, k < others.
std::vector<std::size_t> order_along(
    const SweepColumn& column, std::size_t count, std::size_t others,
    const std::function<std::size_t(std::size_t, std::size_t)>& scene) {
  std::vector<double> mean(count, kInfinity);
  for (std::size_t i = 0; i < count; ++i) {
    double sum = 0.0, found = 0.0;
    for (std::size_t k = 0; k < others; ++k) {
      const double number = column.numbers[scene(i, k)];
      if (!std::isfinite(number)) continue;
      sum += number;
      ++found;
    }
    if (found > 0.0) mean[i] = sum / found;
  }
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(
      order, [&](std::size_t a, std::size_t b) { return mean[a] < mean[b]; });
  return order;
}

}  // namespace

Scenes sorted_by(const SweepColumn& column, Scenes scenes) {
  if (!column.numeric()) return scenes;
  const auto number = [&](std::size_t scene) {
    const double value = column.numbers[scene];
    return std::isnan(value) ? kInfinity : value;
  };
  std::ranges::stable_sort(scenes, [&](std::size_t a, std::size_t b) {
    return number(a) < number(b);
  });
  return scenes;
}

bool distinct(const SweepColumn& column, const Scenes& scenes) {
  if (!column.numeric()) {
    return distinct_words(column, scenes).size() == scenes.size();
  }
  std::vector<double> numbers;
  for (const std::size_t scene : scenes) {
    const double number = column.numbers[scene];
    if (!std::isnan(number)) numbers.push_back(number);
  }
  std::ranges::sort(numbers);
  return std::ranges::adjacent_find(numbers) == numbers.end();
}

std::optional<Scenes> in_map_order(const SweepTable& table,
                                   const SweepMap& map) {
  if (is_mesh(table, map, map.scenes)) return map.scenes;
  const auto scene = [&](std::size_t i, std::size_t j) {
    return map.scenes[i * map.n_second + j];
  };
  const auto rows =
      order_along(table.columns[map.first], map.n_first, map.n_second, scene);
  const auto columns =
      order_along(table.columns[map.second], map.n_second, map.n_first,
                  [&](std::size_t j, std::size_t i) { return scene(i, j); });
  Scenes sorted;
  for (const std::size_t i : rows) {
    for (const std::size_t j : columns) sorted.push_back(scene(i, j));
  }
  if (!is_mesh(table, map, sorted)) return std::nullopt;
  return sorted;
}

}  // namespace brachisto::report
