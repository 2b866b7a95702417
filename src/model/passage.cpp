// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/passage.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "brachisto/math/index.hpp"
#include "model/start_under_limits.hpp"

namespace brachisto {

namespace {

/// Where the centre starts, if no slope is left to the path.
std::optional<Point> known_start(const Scene& scene,
                                 const std::vector<PathInequality>& limits) {
  if (contact_radius(scene) == 0.0) return Point{0.0, 0.0};
  if (scene.world.start_speed > 0.0 || scene.contact == Contact::Optimal ||
      bound_valleys(limits)) {
    return std::nullopt;
  }
  const auto slope = start_angle_under(scene, limits);
  if (!slope) return std::nullopt;
  const TurningPoint<double> at = resting_at(scene, *slope);
  return Point{at.x, at.z};
}

class Squares {
 public:
  Squares(const Scene& scene, const std::vector<PathInequality>& limits)
      : scene_(scene),
        limits_(limits),
        start_(known_start(scene, limits)),
        side_(3.0 * (std::max(scene.L, scene.H) + contact_radius(scene)) /
              kAcross),
        left_(0.5 * (scene.L - kAcross * side_)),
        top_(0.5 * (scene.H - kAcross * side_)) {}

  [[nodiscard]] bool joins() {
    const double r = contact_radius(scene_);
    seen_.assign(at(kAcross) * at(kAcross), false);
    std::vector<int> next;
    const auto reach = [&](int i, int k) {
      const int square = i + kAcross * k;
      if (seen_[at(square)] || !is_open(i, k)) return;
      seen_[at(square)] = true;
      next.push_back(square);
    };
    // Beyond the edge one comes from any open square to any other, but past a
    // floor that is below all and where energy ends that is above all only on
    // the same side.
    const bool around = !energy_ends_above() || !floor_ends_below();
    const auto go_outside = [&](bool left) {
      for (int k = 0; k < kAcross; ++k) {
        if (around || left) reach(0, k);
        if (around || !left) reach(kAcross - 1, k);
        if (!around) continue;
        reach(k, 0);
        reach(k, kAcross - 1);
      }
    };
    for (int i = 0; i < kAcross; ++i) {
      for (int k = 0; k < kAcross; ++k) {
        const bool begins = start_ ? distance(i, k, *start_) <= half_diagonal()
                                   : lies_on(i, k, {0.0, 0.0}, r);
        if (begins) reach(i, k);
      }
    }
    while (!next.empty()) {
      const int i = next.back() % kAcross, k = next.back() / kAcross;
      next.pop_back();
      if (lies_on(i, k, {scene_.L, scene_.H}, r)) return true;
      if (i == 0 || i == kAcross - 1 ||
          (around && (k == 0 || k == kAcross - 1))) {
        go_outside(i == 0);
      }
      for (int di = -1; di <= 1; ++di) {
        for (int dk = -1; dk <= 1; ++dk) {
          const int a = std::clamp(i + di, 0, kAcross - 1);
          const int b = std::clamp(k + dk, 0, kAcross - 1);
          reach(a, b);
        }
      }
    }
    return false;
  }

 private:
  static constexpr int kAcross = 400;

  [[nodiscard]] Point centre(int i, int k) const {
    return {left_ + (i + 0.5) * side_, top_ + (k + 0.5) * side_};
  }
  [[nodiscard]] double half_diagonal() const {
    return side_ / std::numbers::sqrt2;
  }
  [[nodiscard]] double distance(int i, int k, Point from) const {
    return brachisto::distance(centre(i, k), from);
  }
  [[nodiscard]] bool lies_on(int i, int k, Point about, double radius) const {
    return std::abs(distance(i, k, about) - radius) <= half_diagonal();
  }
  /// Distances change by no more than the place does.
  [[nodiscard]] bool is_open(int i, int k) const {
    const Point here = centre(i, k);
    TurningPoint<double> place{};
    place.x = here.x;
    place.z = here.z;
    for (const PathInequality& limit : limits_) {
      if (limit.bounds_control()) continue;
      if (value_of(limit, ContactForce<double>{}, place) - limit.lower <
          -half_diagonal()) {
        return false;
      }
    }
    return !energy_ends(here.z);
  }
  /// E = z − z_0 + r η (sin θ − sin θ_m), with sin θ at most 1.
  [[nodiscard]] bool energy_ends(double z) const {
    if (!scene_.world.ordinary() || !start_) return false;
    const Body& body = scene_.body;
    const double most =
        body.radius * body.eta_m * (1.0 - std::sin(body.theta_m));
    return z - start_->z + most < -half_diagonal();
  }
  [[nodiscard]] bool energy_ends_above() const {
    return energy_ends(centre(0, 0).z);
  }
  [[nodiscard]] bool floor_ends_below() const {
    const double lowest = centre(0, kAcross - 1).z;
    return std::ranges::any_of(limits_, [&](const PathInequality& limit) {
      return limit.kind == PathInequality::Kind::Floor &&
             limit.number - lowest < -half_diagonal();
    });
  }

  const Scene& scene_;
  const std::vector<PathInequality>& limits_;
  std::optional<Point> start_;
  double side_, left_, top_;
  std::vector<bool> seen_;
};

}  // namespace

bool way_is_open(const Scene& scene,
                 const std::vector<PathInequality>& limits) {
  const bool obstacles = std::ranges::any_of(
      limits,
      [](const PathInequality& limit) { return !limit.bounds_control(); });
  return !obstacles || Squares(scene, limits).joins();
}

}  // namespace brachisto
