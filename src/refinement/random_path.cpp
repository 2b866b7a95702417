// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/random_path.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "model/contact.hpp"
#include "model/energy.hpp"
#include "model/inertia.hpp"

namespace brachisto {

TurningPoint<double> RandomPath::operator()(double sigma) const {
  const double wanted = sigma * u.back();
  const auto next = std::clamp(std::ranges::upper_bound(u, wanted),
                               u.begin() + 1, u.end() - 1);
  const auto i = static_cast<std::size_t>(next - u.begin());
  const double t = (wanted - u[i - 1]) / (u[i] - u[i - 1]);
  const TurningPoint<double>&a = at[i - 1], &b = at[i];
  return {std::lerp(a.x, b.x, t),         std::lerp(a.z, b.z, t),
          std::lerp(a.theta, b.theta, t), std::lerp(a.w, b.w, t),
          std::lerp(a.beta, b.beta, t),   std::lerp(a.q, b.q, t)};
}

RandomPath random_path(const Scene& scene, double waviness,
                       SplitMix64& random) {
  constexpr int kWaves = 6, kCells = 4000;
  constexpr double kSteepest = 0.6 * std::numbers::pi;
  const double beta_0 = random.uniform(0.3, 1.6);
  const double phi = random.uniform(-1.4, 0.8);
  const Point from = centre_above({0.0, 0.0}, contact_radius(scene), beta_0);
  const Point to = end_of_centre(scene, phi);
  const double reach = std::hypot(to.x - from.x, to.z - from.z);
  const double speed_0 = reach * random.uniform(0.3, 2.0);
  const double speed_1 = reach * random.uniform(0.3, 2.0);
  struct Wave {
    double x, z, phase_x, phase_z;
  };
  std::vector<Wave> waves;
  for (int k = 1; k <= kWaves; ++k) {
    const auto amplitude = [&] {
      return random.uniform(-waviness, waviness) / k;
    };
    const auto phase = [&] {
      return random.uniform(0.0, 2.0 * std::numbers::pi);
    };
    waves.push_back({amplitude(), amplitude(), phase(), phase()});
  }
  const auto place = [&](double t) {
    const double rest = 1.0 - t;
    const double h00 = rest * rest * (1.0 + 2.0 * t), h10 = t * rest * rest;
    const double h01 = 1.0 - h00, h11 = -t * t * rest;
    const double window = 16.0 * t * t * rest * rest;
    Point at{h00 * from.x + h01 * to.x + h10 * speed_0 * std::cos(beta_0) +
                 h11 * speed_1 * std::cos(phi),
             h00 * from.z + h01 * to.z + h10 * speed_0 * std::sin(beta_0) +
                 h11 * speed_1 * std::sin(phi)};
    for (std::size_t k = 0; k < waves.size(); ++k) {
      const double turn = (static_cast<double>(k) + 1.0) * std::numbers::pi * t;
      at.x += window * waves[k].x * std::sin(turn + waves[k].phase_x);
      at.z += window * waves[k].z * std::sin(turn + waves[k].phase_z);
    }
    return at;
  };

  // With t = ζ² the speed, like √s at the start, is smooth in ζ.
  RandomPath path;
  const Body& body = scene.body;
  path.u.push_back(0.0);
  const double pushed = scene.world.start_speed *
                        std::sqrt(inertia_factor(body, body.theta_m, beta_0));
  path.at.push_back({from.x, from.z, body.theta_m, pushed, beta_0, 0.0});
  double s = 0.0;
  for (int i = 1; i <= kCells; ++i) {
    const double zeta = static_cast<double>(i) / kCells;
    const TurningPoint<double>& before = path.at.back();
    const Point here = place(zeta * zeta);
    const double dx = here.x - before.x, dz = here.z - before.z;
    const double ds = std::hypot(dx, dz);
    const double beta = std::atan2(dz, dx);
    s += ds;
    const double theta =
        body.theta_m + (body.radius > 0.0 ? s / body.radius : 0.0);
    const double E = energy_height(body, here.z - from.z, theta);
    const double w = std::sqrt(pushed * pushed + 2.0 * scene.gravity * E);
    if (!(w > 0.0) || std::abs(beta) > kSteepest) return {};
    const double du = 2.0 * ds / (w + before.w);
    path.u.push_back(path.u.back() + du);
    path.at.push_back(
        {here.x, here.z, theta, w, beta, (beta - before.beta) / du});
  }
  return path;
}

RandomPath some_random_path(const Scene& scene, double waviness,
                            SplitMix64& random, int& attempts) {
  RandomPath path;
  while (path.u.empty()) {
    path = random_path(scene, waviness, random);
    ++attempts;
  }
  return path;
}

std::vector<RoughPath> random_ways(const Scene& scene, int count) {
  constexpr double kWaviness = 0.5;  // in L or H, the larger one
  constexpr int kMostTries = 200, kPlaces = 400;
  constexpr std::uint64_t kSeed = 1;
  SplitMix64 random(SplitMix64::scrambled(kSeed));
  std::vector<RoughPath> out;
  for (int i = 0; i < kMostTries && std::ssize(out) < count; ++i) {
    const RandomPath path = random_path(scene, kWaviness, random);
    if (path.u.empty()) continue;
    RoughPath way{path.rolling_time(), {}, {}};
    way.slopes = {path.at.front().beta, path.at.back().beta};
    for (int k = 0; k <= kPlaces; ++k) {
      way.places.push_back(path(static_cast<double>(k) / kPlaces));
    }
    out.push_back(std::move(way));
  }
  return out;
}

namespace {

PrimalDual start_at(
    const LimitedTime& problem, double rolling_time,
    const std::function<TurningPoint<double>(double sigma)>& at) {
  PrimalDual start =
      sample_at_mesh(problem, rolling_time, [&](double sigma) -> LimitedPoint {
        return {.state = at(sigma),
                .multipliers = std::vector<double>(problem.limits().size())};
      });
  start.lambda.clear();
  return start;
}

}  // namespace

PrimalDual start_on(const LimitedTime& problem, const RandomPath& path) {
  return start_at(problem, path.rolling_time(), path);
}

PrimalDual start_on(const LimitedTime& problem, const RoughPath& path) {
  return start_at(problem, path.rolling_time,
                  [&](double sigma) { return path.at(sigma); });
}

}  // namespace brachisto
