// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/passage.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <ranges>
#include <utility>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/index.hpp"
#include "model/field.hpp"
#include "model/start_under_limits.hpp"

namespace brachisto {

namespace {

/// Where the centre starts, if no slope is left to the path.
std::optional<Point> known_start(const Scene& scene,
                                 const std::vector<PathInequality>& limits) {
  if (contact_radius(scene) == 0.0) return Point{0.0, 0.0};
  const auto slope = known_start_slope(scene, limits);
  if (!slope) return std::nullopt;
  const TurningPoint<double> at = resting_at(scene, *slope);
  return Point{at.x, at.z};
}

/// Whether a place alone bounds the energy that is left there.
bool has_bounded_energy(const World& world) {
  const bool by_distance =
      turning_centre(world) && !world.side && world.field_share == 1.0;
  return world.start_speed == 0.0 && (!world.field_varies() || by_distance);
}

/// States of a path: the square that its centre is in, and how far it has come
/// round, in steps of its length no longer than a side. Within one of them it
/// comes to a neighbour at most.
class Squares {
 public:
  /// \param turning  whether its energy depends on how far the body has turned;
  ///                 else it has the most that any θ gives it
  Squares(const Scene& scene, const std::vector<PathInequality>& limits,
          std::optional<Point> start, bool turning)
      : scene_(scene),
        start_(start),
        across_(kMostAcross),
        floor_(floor_of(limits)) {
    while (turning && num_states(scene, across_) > kMostStates) --across_;
    side_ = side(scene, across_);
    left_ = 0.5 * (scene.L - across_ * side_);
    top_ = 0.5 * (scene.H - across_ * side_);
    for (int k = 0; k < across_; ++k) {
      for (int i = 0; i < across_; ++i) {
        obstructed_.push_back(is_obstructed(limits, centre(i, k)));
      }
    }
    const int steps = turning ? steps_of_turn(scene, across_) : 1;
    for (int step = 0; step < steps; ++step) {
      sectors_.push_back(sector(step, steps));
    }
    deepest_ = turning_centre(scene.world);
    if (start && has_bounded_energy(scene.world)) {
      const InPlane<double> mass =
          place_of_mass(scene.body, start->x, start->z, scene.body.theta_m);
      mass_at_start_ = Point{mass.x, mass.z};
    }
  }

  [[nodiscard]] bool joins() {
    const double r = contact_radius(scene_);
    seen_.assign(at(across_ * across_ * num_steps()), false);
    std::vector<int> next;
    const auto reach = [&](const State& to) {
      const int index = index_of(to);
      if (seen_[at(index)] || !is_open(to)) return;
      seen_[at(index)] = true;
      next.push_back(index);
    };
    // Beyond the edge one comes from any open square to any other, turned by
    // anything, but past a floor that is below all and where energy ends that
    // is above all only on the same side.
    const bool around = !energy_ends_above() || !floor_ends_below();
    bool been_left = false, been_right = false;
    const auto go_outside = [&](bool left) {
      if (std::exchange(left ? been_left : been_right, true)) return;
      for (int step = 0; step < num_steps(); ++step) {
        for (int k = 0; k < across_; ++k) {
          reach({left ? 0 : across_ - 1, k, step});
          if (!around) continue;
          reach({k, 0, step});
          reach({k, across_ - 1, step});
        }
      }
    };
    for (int i = 0; i < across_; ++i) {
      for (int k = 0; k < across_; ++k) {
        const bool begins = start_ ? distance(i, k, *start_) <= half_diagonal()
                                   : lies_on(i, k, {0.0, 0.0}, r);
        if (begins) reach({i, k, 0});
      }
    }
    // Within the first step, beside where it starts.
    for (const int begin : std::vector<int>(next)) {
      each_neighbour(state(begin), 0, reach);
    }
    for (int turn = 0; !next.empty(); ++turn) {
      check_stop(turn);
      const State here = state(next.back());
      next.pop_back();
      // Within the step that it has begun.
      bool arrives = false;
      each_neighbour(here, here.step, [&](const State& end) {
        arrives = arrives || (lies_on(end.i, end.k, {scene_.L, scene_.H}, r) &&
                              is_open(end));
      });
      if (arrives) return true;
      const bool left = here.i == 0, right = here.i == across_ - 1;
      const bool beyond = here.k == 0 || here.k == across_ - 1;
      if (left || (around && (right || beyond))) go_outside(true);
      if (right || (around && (left || beyond))) go_outside(false);
      each_neighbour(here, (here.step + 1) % num_steps(), reach);
    }
    return false;
  }

 private:
  static constexpr int kMostAcross = 400;
  /// With fewer squares, which are larger, a proof is one too.
  static constexpr int kMostStates = 5'000'000;

  static double side(const Scene& scene, int across) {
    return 3.0 * (std::max(scene.L, scene.H) + contact_radius(scene)) / across;
  }
  static int steps_of_turn(const Scene& scene, int across) {
    const double turn = 2.0 * std::numbers::pi * contact_radius(scene);
    return std::max(1, static_cast<int>(std::ceil(turn / side(scene, across))));
  }
  static int num_states(const Scene& scene, int across) {
    return across * across * steps_of_turn(scene, across);
  }

  struct State {
    int i, k;  ///< of the square, to the right and down
    int step;  ///< of the turn
  };

  [[nodiscard]] int num_steps() const {
    return static_cast<int>(sectors_.size());
  }
  [[nodiscard]] int index_of(const State& state) const {
    return state.i + across_ * (state.k + across_ * state.step);
  }
  [[nodiscard]] State state(int index) const {
    return {index % across_, index / across_ % across_,
            index / (across_ * across_)};
  }
  template <class Reach>
  void each_neighbour(const State& of, int step, Reach&& reach) const {
    for (int k = std::max(0, of.k - 1); k <= of.k + 1 && k < across_; ++k) {
      for (int i = std::max(0, of.i - 1); i <= of.i + 1 && i < across_; ++i) {
        reach({i, k, step});
      }
    }
  }

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
  [[nodiscard]] bool is_obstructed(const std::vector<PathInequality>& limits,
                                   Point here) const {
    TurningPoint<double> place{};
    place.x = here.x;
    place.z = here.z;
    return std::ranges::any_of(limits, [&](const PathInequality& limit) {
      return !limit.bounds_control() &&
             value_of(limit, ContactForce<double>{}, place) - limit.lower <
                 -half_diagonal();
    });
  }
  [[nodiscard]] bool is_open(const State& state) const {
    return !obstructed_[at(state.i + across_ * state.k)] &&
           !energy_ends(centre(state.i, state.k), state.step);
  }
  /// Unit vectors from the centre to the mass where a step of the turn begins
  /// and ends; on the only step it is anywhere.
  struct Sector {
    Point from, to;
  };
  [[nodiscard]] Point to_mass(double theta) const {
    return {std::cos(theta), std::sin(theta)};
  }
  [[nodiscard]] Sector sector(int step, int steps) const {
    constexpr double kTurn = 2.0 * std::numbers::pi;
    const double from = scene_.body.theta_m + kTurn * step / steps;
    return {to_mass(from), to_mass(from + kTurn / steps)};
  }
  /// The largest part that any of them has along a unit vector.
  [[nodiscard]] double most_along(Point d, int step) const {
    if (num_steps() == 1) return 1.0;
    const auto& [from, to] = sectors_[at(step)];
    const bool between =
        from.x * d.z - from.z * d.x >= 0.0 && d.x * to.z - d.z * to.x >= 0.0;
    return between
               ? 1.0
               : std::max(from.x * d.x + from.z * d.z, to.x * d.x + to.z * d.z);
  }
  /// Whether it does wherever in a square the centre is: the potential of the
  /// mass would be higher than where it rested, and neither air nor losses give
  /// any energy. A field with a centre is the lower the nearer that is.
  [[nodiscard]] bool energy_ends(Point here, int step) const {
    if (!mass_at_start_) return false;
    const double r_m = scene_.body.radius * scene_.body.eta_m;
    Point lowest = here;
    if (deepest_) {
      const double far = brachisto::distance(here, *deepest_);
      if (far == 0.0) return false;
      const Point d{(deepest_->x - here.x) / far, (deepest_->z - here.z) / far};
      const double along = r_m * most_along(d, step);
      const double of_mass =
          std::sqrt(std::max(0.0, far * far + r_m * r_m - 2.0 * far * along));
      // far − of_mass, of which the centre may be far away.
      const double nearer =
          (2.0 * far * along - r_m * r_m) / (far + of_mass) + half_diagonal();
      const double by = std::min(far, nearer);
      lowest = {here.x + by * d.x, here.z + by * d.z};
    } else {
      lowest.z += r_m * most_along({0.0, 1.0}, step) + half_diagonal();
    }
    return potential_fall(scene_, *mass_at_start_, lowest) < 0.0;
  }
  /// In all of the half-plane above the squares.
  [[nodiscard]] bool energy_ends_above() const {
    // Nearer than that the mass may come to it from more than one place.
    const double r_m = scene_.body.radius * scene_.body.eta_m;
    if (deepest_ && deepest_->z - r_m <= top_) return false;
    const Point nearest{deepest_ ? deepest_->x : left_, top_};
    return std::ranges::all_of(std::views::iota(0, num_steps()), [&](int step) {
      return energy_ends(nearest, step);
    });
  }
  [[nodiscard]] bool floor_ends_below() const {
    return floor_ - centre(0, across_ - 1).z < -half_diagonal();
  }
  /// The lowest that a centre may be.
  [[nodiscard]] static double floor_of(
      const std::vector<PathInequality>& limits) {
    double out = std::numeric_limits<double>::infinity();
    for (const PathInequality& limit : limits) {
      if (limit.kind == PathInequality::Kind::Floor) {
        out = std::min(out, limit.number);
      }
    }
    return out;
  }

  const Scene& scene_;
  std::optional<Point> start_;
  std::optional<Point> mass_at_start_;  ///< if energy is known to end
  std::optional<Point> deepest_;        ///< where the field is turned about
  int across_;
  double side_ = 0.0, left_ = 0.0, top_ = 0.0, floor_;
  std::vector<bool> obstructed_;  ///< by square
  std::vector<Sector> sectors_;   ///< by step of the turn
  std::vector<bool> seen_;        ///< by state
};

}  // namespace

bool way_is_open(const Scene& scene,
                 const std::vector<PathInequality>& limits) {
  const bool obstacles = std::ranges::any_of(
      limits,
      [](const PathInequality& limit) { return !limit.bounds_control(); });
  if (!obstacles) return true;
  const std::optional<Point> start = known_start(scene, limits);
  // Only of energy from a known place the turn tells more.
  const bool turning = start && scene.body.off_centred() &&
                       has_bounded_energy(scene.world) &&
                       contact_radius(scene) > 0.0;
  return Squares(scene, limits, start, false).joins() &&
         (!turning || Squares(scene, limits, start, true).joins());
}

}  // namespace brachisto
