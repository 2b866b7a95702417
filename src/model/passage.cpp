// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/passage.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/index.hpp"
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
      highest_.push_back(highest_in(step, steps));
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
      if (lies_on(here.i, here.k, {scene_.L, scene_.H}, r)) return true;
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
    return static_cast<int>(highest_.size());
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
           !energy_ends(centre(state.i, state.k).z, highest_[at(state.step)]);
  }
  /// The largest sin θ on a step of the turn.
  [[nodiscard]] double highest_in(int step, int steps) const {
    constexpr double kTurn = 2.0 * std::numbers::pi, kTop = 0.25 * kTurn;
    if (steps == 1) return 1.0;
    const double from = scene_.body.theta_m + kTurn * step / steps;
    const double to = scene_.body.theta_m + kTurn * (step + 1) / steps;
    const double top = kTop + kTurn * std::ceil((from - kTop) / kTurn);
    return top <= to ? 1.0 : std::max(std::sin(from), std::sin(to));
  }
  /// E = z − z_0 + r η (sin θ − sin θ_m).
  [[nodiscard]] bool energy_ends(double z, double sin_theta) const {
    if (!scene_.world.ordinary() || !start_) return false;
    const Body& body = scene_.body;
    const double most =
        body.radius * body.eta_m * (sin_theta - std::sin(body.theta_m));
    return z - start_->z + most < -half_diagonal();
  }
  [[nodiscard]] bool energy_ends_above() const {
    return energy_ends(centre(0, 0).z, 1.0);
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
  int across_;
  double side_ = 0.0, left_ = 0.0, top_ = 0.0, floor_;
  std::vector<bool> obstructed_;  ///< by square
  std::vector<double> highest_;   ///< sin θ, by step of the turn
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
                       scene.world.ordinary() && contact_radius(scene) > 0.0;
  return Squares(scene, limits, start, false).joins() &&
         (!turning || Squares(scene, limits, start, true).joins());
}

}  // namespace brachisto
