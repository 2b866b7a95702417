// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/detour.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <optional>

#include "brachisto/math/index.hpp"
#include "math/portable_random.hpp"
#include "model/energy.hpp"
#include "refinement/limit_relaxation.hpp"

namespace brachisto {

namespace {

/// The places of a path of the centre, with the speeds that it falls with.
std::optional<RoughPath> rolled(const Scene& scene,
                                const std::vector<Point>& centre,
                                const TurningPoint<double>& start) {
  constexpr double kSteepest = 0.95 * std::numbers::pi;
  // Of the fall from A to B: it may pass where no body comes.
  constexpr double kLeastFall = 0.02;
  RoughPath path;
  path.rolling_time = 0.0;
  std::vector<double> u{0.0};
  std::vector<TurningPoint<double>> all{start};
  double s = 0.0;
  for (std::size_t i = 1; i < centre.size(); ++i) {
    const double dx = centre[i].x - centre[i - 1].x;
    const double dz = centre[i].z - centre[i - 1].z;
    const double ds = std::hypot(dx, dz);
    s += ds;
    TurningPoint<double> here{};
    here.x = centre[i].x;
    here.z = centre[i].z;
    here.beta = std::atan2(dz, dx);
    if (std::abs(here.beta) > kSteepest) return std::nullopt;
    const double radius = scene.body.radius;
    const double theta = scene.body.theta_m + (radius > 0.0 ? s / radius : 0.0);
    const double share = std::min(1.0, s / scene.H);
    const double E =
        energy_height(scene.body, here.z - centre.front().z, theta);
    here.theta = theta;
    here.w = std::hypot(
        start.w,
        fall_speed(scene.gravity, std::max(E, kLeastFall * share * scene.H)));
    const double du = 2.0 * ds / (here.w + all.back().w);
    here.q = (here.beta - all.back().beta) / du;
    u.push_back(u.back() + du);
    all.push_back(here);
  }
  path.rolling_time = u.back();
  // At equal times.
  std::size_t i = 1;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const double wanted = path.rolling_time * static_cast<double>(k) /
                          static_cast<double>(all.size() - 1);
    while (i + 1 < u.size() && u[i] < wanted) ++i;
    const double t =
        std::clamp((wanted - u[i - 1]) / (u[i] - u[i - 1]), 0.0, 1.0);
    const auto mean = [&](double TurningPoint<double>::*state) {
      return all[i - 1].*state + t * (all[i].*state - all[i - 1].*state);
    };
    using At = TurningPoint<double>;
    path.places.push_back({mean(&At::x), mean(&At::z), mean(&At::theta),
                           mean(&At::w), mean(&At::beta), mean(&At::q)});
  }
  return path;
}

/// Places of the centre, close together at rest, and the length up to each.
struct Line {
  std::vector<Point> centre;
  std::vector<double> length{0.0};
};
constexpr int kPlaces = 400;
Line line_of(const ExtremalCurve& free) {
  Line out;
  for (int i = 0; i <= kPlaces; ++i) {
    const double sigma = static_cast<double>(i) / kPlaces;
    const TurningPoint<double> at = turning_point(free, sigma);
    if (i > 0) {
      out.length.push_back(out.length.back() +
                           distance(out.centre.back(), {at.x, at.z}));
    }
    out.centre.push_back({at.x, at.z});
  }
  return out;
}

/// Where a line passes a disc next to its centre, and how far off.
struct Passage {
  std::size_t nearest = 0;
  Point normal;       ///< of the line, to its left, which is over it
  double over = 0.0;  ///< so far along the normal the disc's centre is below

  Passage(const Line& line, const PathInequality& disc) {
    const std::vector<Point>& centre = line.centre;
    for (std::size_t i = 1; i < centre.size(); ++i) {
      if (distance(centre[i], disc.place) <
          distance(centre[nearest], disc.place)) {
        nearest = i;
      }
    }
    if (at_an_end(line)) return;
    const Point before = centre[nearest - 1], after = centre[nearest + 1];
    const double chord = distance(before, after);
    normal = {(after.z - before.z) / chord, -(after.x - before.x) / chord};
    const Point from = centre[nearest];
    over =
        (from.x - disc.place.x) * normal.x + (from.z - disc.place.z) * normal.z;
  }
  [[nodiscard]] bool at_an_end(const Line& line) const {
    return nearest == 0 || nearest + 1 == line.centre.size();
  }
  [[nodiscard]] bool is_near(const Line& line,
                             const PathInequality& disc) const {
    constexpr double kNear = 2.0;
    return !at_an_end(line) &&
           distance(line.centre[nearest], disc.place) <= kNear * disc.number;
  }
};

/// Bends a line past a disc on a side: a bump as long as the disc reaches and
/// the line is moved, none at A and B. Nothing where it passes there already.
void bend(Line& line, const Passage& passage, double reach, bool over) {
  constexpr double kRoom = 1.05;
  const double side = over ? 1.0 : -1.0;
  const double shift = kRoom * reach - side * passage.over;
  if (!(shift > 0.0)) return;
  const double width = 0.7 * (reach + shift);
  const double here = line.length[passage.nearest], all = line.length.back();
  for (std::size_t i = 0; i < line.centre.size(); ++i) {
    const double off = (line.length[i] - here) / width;
    const double room = line.length[i] < here
                            ? line.length[i] / here
                            : (all - line.length[i]) / (all - here);
    const double bump =
        side * shift * std::exp(-off * off) * std::min(1.0, room);
    line.centre[i].x += bump * passage.normal.x;
    line.centre[i].z += bump * passage.normal.z;
  }
  for (std::size_t i = 1; i < line.centre.size(); ++i) {
    line.length[i] =
        line.length[i - 1] + distance(line.centre[i - 1], line.centre[i]);
  }
}

/// The discs that a line passes near.
std::vector<PathInequality> near_discs(
    const Line& line, const std::vector<PathInequality>& limits) {
  std::vector<PathInequality> out;
  std::ranges::copy_if(limits, std::back_inserter(out),
                       [&](const PathInequality& limit) {
                         return limit.kind == PathInequality::Kind::Disc &&
                                Passage(line, limit).is_near(line, limit);
                       });
  return out;
}

}  // namespace

TurningPoint<double> RoughPath::at(double sigma) const {
  const double place = sigma * static_cast<double>(places.size() - 1);
  const auto i = std::min(places.size() - 2, static_cast<std::size_t>(place));
  const double t = place - static_cast<double>(i);
  const auto mean = [&](double TurningPoint<double>::*state) {
    return places[i].*state + t * (places[i + 1].*state - places[i].*state);
  };
  using At = TurningPoint<double>;
  return {mean(&At::x), mean(&At::z),    mean(&At::theta),
          mean(&At::w), mean(&At::beta), mean(&At::q)};
}

std::vector<RoughPath> other_ways(const Scene& scene, const ExtremalCurve& free,
                                  const std::vector<PathInequality>& limits) {
  constexpr double kSag = 0.25;
  const Line line = line_of(free);
  std::vector<RoughPath> out;
  const auto add = [&](const std::vector<Point>& centre) {
    if (auto path = rolled(scene, centre, turning_point(free, 0.0))) {
      out.push_back(*std::move(path));
    }
  };
  for (const PathInequality& disc : near_discs(line, limits)) {
    const Passage passage(line, disc);
    Line bent = line;
    bend(bent, passage, disc.number, passage.over <= 0.0);
    add(bent.centre);
  }
  const Point from = line.centre.front(), to = line.centre.back();
  for (const double sag : {0.0, kSag * distance(from, to)}) {
    std::vector<Point> bow;
    for (int i = 0; i <= kPlaces; ++i) {
      const double t = std::pow(static_cast<double>(i) / kPlaces, 2);
      bow.push_back({from.x + t * (to.x - from.x),
                     from.z + t * (to.z - from.z) + 4.0 * sag * t * (1.0 - t)});
    }
    add(bow);
  }
  return out;
}

std::size_t discs_near(const ExtremalCurve& free,
                       const std::vector<PathInequality>& limits) {
  return near_discs(line_of(free), limits).size();
}

std::vector<RoughPath> ways_past_discs(
    const Scene& scene, const ExtremalCurve& free,
    const std::vector<PathInequality>& limits) {
  const Line line = line_of(free);
  std::vector<PathInequality> discs = near_discs(line, limits);
  if (discs.size() > kMostDiscs) {
    discs.erase(discs.begin() + kMostDiscs, discs.end());
  }
  std::vector<RoughPath> out;
  if (discs.empty()) return out;
  for (unsigned sides = 0; sides < 1U << discs.size(); ++sides) {
    Line bent = line;
    for (std::size_t i = 0; i < discs.size(); ++i) {
      const Passage passage(bent, discs[i]);
      if (passage.at_an_end(bent)) continue;
      bend(bent, passage, discs[i].number, (sides >> i & 1U) != 0);
    }
    if (auto path = rolled(scene, bent.centre, turning_point(free, 0.0))) {
      out.push_back(*std::move(path));
    }
  }
  return out;
}

std::vector<RoughPath> waves(const Scene& scene, const ExtremalCurve& free,
                             int count) {
  constexpr int kWaves = 4, kMostTries = 20;
  constexpr std::uint64_t kSeed = 1;
  constexpr double kHeight = 0.3;  // of the first one, in H
  SplitMix64 random(SplitMix64::scrambled(kSeed));
  const Line line = line_of(free);
  std::vector<RoughPath> out;
  for (int i = 0; i < kMostTries && std::ssize(out) < count; ++i) {
    std::array<double, kWaves> heights{};
    for (int k = 0; k < kWaves; ++k) {
      heights[at(k)] = random.uniform(-1.0, 1.0) * kHeight * scene.H / (k + 1);
    }
    Line wavy = line;
    for (std::size_t j = 0; j < wavy.centre.size(); ++j) {
      const double share = line.length[j] / line.length.back();
      for (int k = 0; k < kWaves; ++k) {
        wavy.centre[j].z +=
            heights[at(k)] * std::sin((k + 1) * std::numbers::pi * share);
      }
    }
    if (auto path = rolled(scene, wavy.centre, turning_point(free, 0.0))) {
      out.push_back(*std::move(path));
    }
  }
  return out;
}

}  // namespace brachisto
