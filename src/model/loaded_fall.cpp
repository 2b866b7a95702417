// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/loaded_fall.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/index.hpp"
#include "math/angle.hpp"
#include "math/interval.hpp"
#include "model/energy.hpp"
#include "model/inertia.hpp"
#include "model/start_under_limits.hpp"

namespace brachisto {

namespace {

using math::Interval;
using math::kTurn;

constexpr double kNone = std::numeric_limits<double>::infinity();

/// κ ≤ constant + by_energy/E, or the same of −κ.
struct CurvatureBound {
  double constant, by_energy;
  /// The most that it lets κ be.
  [[nodiscard]] double over(const Interval& E) const {
    return constant + by_energy / (by_energy > 0.0 ? E.lower : E.upper);
  }
};

/// One side of a limit of forces, sign · (value − bound) ≥ 0.
struct ForceRow {
  PathInequality limit;
  double sign, bound;

  [[nodiscard]] Interval value(const ContactForce<Interval>& force,
                               const TurningPoint<Interval>& at) const {
    return (value_of(limit, force, at) - bound) * sign;
  }
};

std::vector<ForceRow> force_rows(const std::vector<PathInequality>& limits) {
  std::vector<ForceRow> rows;
  for (const PathInequality& limit : limits) {
    if (!limit.bounds_force()) continue;
    if (std::isfinite(limit.lower)) rows.push_back({limit, 1.0, limit.lower});
    if (std::isfinite(limit.upper)) rows.push_back({limit, -1.0, limit.upper});
  }
  return rows;
}

/// The greatest value over any stretch of a row of numbers that is closed to a
/// ring.
class Greatest {
 public:
  explicit Greatest(std::vector<double> values) {
    levels_.push_back(std::move(values));
    const std::size_t n = levels_.front().size();
    for (std::size_t length = 1; 2 * length <= n; length *= 2) {
      const std::vector<double>& below = levels_.back();
      std::vector<double> next(n);
      for (std::size_t i = 0; i < n; ++i) {
        next[i] = std::max(below[i], below[(i + length) % n]);
      }
      levels_.push_back(std::move(next));
    }
  }
  [[nodiscard]] double over(int first, int count) const {
    const int n = static_cast<int>(levels_.front().size());
    count = std::min(count, n);
    std::size_t level = 0;
    while ((2 << level) <= count) ++level;
    const auto wrapped = [&](int i) { return at(((i % n) + n) % n); };
    return std::max(levels_[level][wrapped(first)],
                    levels_[level][wrapped(first + count - (1 << level))]);
  }

 private:
  std::vector<std::vector<double>> levels_;  ///< of 1, 2, 4, … values
};

/// What bounds κ to one side, by δ.
class SideOfForce {
 public:
  /// \param side  1: κ from above, −1: from below
  SideOfForce(const Scene& scene, const ForceRow& row, double side)
      : row_(row) {
    std::vector<double> constant, most, least;
    for (int i = 0; i < kCells; ++i) {
      const Interval delta(kTurn * i / kCells, kTurn * (i + 1) / kCells);
      const TurningPoint<Interval> at{0.0, 0.0, delta, 0.0, 0.0, 0.0};
      const auto forms = ForceForms<Interval>::of(
          scene, pull_on(scene, at.x, at.z, at.theta), at.theta, at.beta);
      const double by = 2.0 * scene.gravity * row.sign;
      const Interval by_energy = value_of(row.limit, forms.by_ww, at) * by;
      const Interval by_bend = value_of(row.limit, forms.by_wq, at) * -by;
      const Interval per = by_bend * side;
      const bool bounds = per.lower > 0.0;
      constant.push_back(bounds ? (by_energy / per).upper : kNone);
      most.push_back(bounds ? 1.0 / per.lower : kNone);
      least.push_back(bounds ? -1.0 / per.upper : kNone);
    }
    any_ = std::ranges::any_of(constant, [](double c) { return c < kNone; });
    tables_ = {Greatest(std::move(constant)), Greatest(std::move(most)),
               Greatest(std::move(least))};
  }
  [[nodiscard]] bool any() const { return any_; }

  /// \param at_rest  forces with E = 0
  [[nodiscard]] CurvatureBound over(
      const TurningPoint<Interval>& at,
      const ContactForce<Interval>& at_rest) const {
    const Interval delta = at.theta - at.beta;
    const int first = static_cast<int>(std::floor(delta.lower / kCell));
    const int last = static_cast<int>(std::floor(delta.upper / kCell));
    const double constant = tables_[0].over(first, last - first + 1);
    if (constant == kNone) return {kNone, 0.0};
    const double left = row_.value(at_rest, at).upper;
    return {constant,
            left * (left > 0.0 ? tables_[1].over(first, last - first + 1)
                               : -tables_[2].over(first, last - first + 1))};
  }

 private:
  static constexpr int kCells = 2048;
  static constexpr double kCell = kTurn / kCells;

  ForceRow row_;
  bool any_ = false;
  /// Of c_1/c_2, 1/c_2 and −1/c_2.
  std::vector<Greatest> tables_;
};

class HighestEnergies {
 public:
  HighestEnergies(const Scene& scene, const std::vector<PathInequality>& limits)
      : scene_(scene),
        limits_(limits),
        rows_(force_rows(limits)),
        turned_(scene.body.radius * kTurn / kSteps) {
    for (const ForceRow& row : rows_) {
      for (const double side : {1.0, -1.0}) {
        SideOfForce bound(scene, row, side);
        if (bound.any()) (side > 0.0 ? up_ : down_).push_back(std::move(bound));
      }
    }
    for (const PathInequality& limit : limits) {
      if (limit.kind == PathInequality::Kind::Hump) {
        hump_ = std::min(hump_, limit.number);
      }
      if (limit.kind == PathInequality::Kind::Valley) {
        valley_ = std::min(valley_, limit.number);
      }
    }
    within_step_ = turned_ * (1.0 + scene.body.eta_m);
    counted_ = std::max(0.02 * scene.H, 3.0 * within_step_);
  }

  [[nodiscard]] bool can_say() const {
    const bool up = hump_ < kNone || !up_.empty();
    const bool down = valley_ < kNone || !down_.empty();
    return up && down && !(up_.empty() && down_.empty());
  }

  [[nodiscard]] bool lead_to_B() {
    constexpr int kMostTurns = 60;
    highest_.assign(at(kSteps), std::vector<Energy>(kSlopes, {floor(), true}));
    for (int j = 0; j < kSlopes; ++j) {
      Energy& here = highest_.front()[at(j)];
      here.height = std::max(here.height, energy_of_push(slopes(j)).upper);
    }
    lowest_start_ = lowest_start();
    int unchanged = 0;
    for (int step = 0; unchanged < kSteps; ++step) {
      check_stop();
      if (step >= kMostTurns * kSteps) return true;
      raised_ = false;
      if (comes_to_B_from(step % kSteps)) return true;
      unchanged = raised_ ? 0 : unchanged + 1;
    }
    return false;
  }

 private:
  static constexpr int kSteps = 384, kSlopes = 768;
  static constexpr double kSlope = kTurn / kSlopes;
  /// Energies are looked at from each to this share of it.
  static constexpr double kSlower = 0.1;

  /// The highest at a slope and a turn, and whether it was raised since it was
  /// carried on.
  struct Energy {
    double height;
    bool raised;
  };
  using Bounds = std::vector<CurvatureBound>;
  /// How far a slope turns within a step at most, by level.
  struct Way {
    int up = 0, down = 0;
  };
  /// What holds within a step from a slope on.
  struct Cell {
    Interval E, beta;  ///< that it may come to
    Bounds up, down;
    double gain = 0.0;    ///< of E
    double most = kNone;  ///< E from which no curvature keeps all limits
  };

  [[nodiscard]] static Interval slopes(int j) {
    return {-std::numbers::pi + j * kSlope,
            -std::numbers::pi + (j + 1) * kSlope};
  }
  [[nodiscard]] Interval turns(int i) const {
    const double from = scene_.body.theta_m + kTurn * i / kSteps;
    return {from, from + kTurn / kSteps};
  }

  /// E at the start.
  [[nodiscard]] Interval energy_of_push(const Interval& beta) const {
    const double v = scene_.world.start_speed;
    return inertia_factor(scene_.body, Interval(scene_.body.theta_m), beta) *
           (v * v / (2.0 * scene_.gravity));
  }
  /// The least height of a centre at its start above A and of its E together,
  /// r cos β₀ + E₀: of the slopes on which it begins to roll and keeps the
  /// limits; of all where it is pushed, for there the bend counts.
  [[nodiscard]] double lowest_start() const {
    const double r = contact_radius(scene_);
    if (scene_.world.start_speed > 0.0) {
      double least = kNone;
      for (int j = 0; j < kSlopes; ++j) {
        const Interval beta = slopes(j);
        least =
            std::min(least, r * cos(beta).lower + energy_of_push(beta).lower);
      }
      return least;
    }
    if (r == 0.0) return 0.0;
    if (const auto beta = known_start_slope(scene_, limits_)) {
      return r * std::cos(*beta);
    }
    double least = 1.0;
    for (int j = 0; j < kSlopes; ++j) {
      const Interval beta = slopes(j);
      const TurningPoint<Interval> at{0.0, 0.0,  scene_.body.theta_m,
                                      0.0, beta, 0.0};
      const ContactForce<Interval> force = lossless_contact_force(scene_, at);
      const auto holds = [&](const ForceRow& row) {
        return row.value(force, at).upper >= 0.0;
      };
      if (energy_slope(scene_.body, at.theta, beta).upper >= 0.0 &&
          std::ranges::all_of(rows_, holds)) {
        least = std::min(least, cos(beta).lower);
      }
    }
    return r * least;
  }

  [[nodiscard]] static double least(const Bounds& bounds, const Interval& E) {
    double out = kNone;
    for (const CurvatureBound& bound : bounds) {
      out = std::min(out, bound.over(E));
    }
    return out;
  }
  /// The most E at the beginning of a step at which a curvature may reach a
  /// value within it: constant + by/E ≥ it.
  [[nodiscard]] double most_energy(const CurvatureBound& bound,
                                   double curvature) const {
    const double more = bound.constant - curvature;
    if (more >= 0.0) {
      return more * here_.E.upper + bound.by_energy >= 0.0 ? kNone : 0.0;
    }
    return bound.by_energy > 0.0
               ? within_step_ + bound.by_energy / (curvature - bound.constant)
               : 0.0;
  }
  [[nodiscard]] double most_energy(const Bounds& bounds,
                                   double curvature) const {
    double out = kNone;
    for (const CurvatureBound& bound : bounds) {
      out = std::min(out, most_energy(bound, curvature));
    }
    return out;
  }

  [[nodiscard]] double floor() const { return counted_ + within_step_; }

  /// So far beyond the slopes of a cell it is looked, at a level.
  static constexpr double kNearest = 0.005;
  static constexpr int kLevels = 11;  ///< to a whole turn
  [[nodiscard]] static double beyond(int level) {
    return std::ldexp(kNearest, level);
  }
  /// What turns the body to one side from a cell, at each level, if it was
  /// asked for. It is the same for all E.
  struct Side {
    double sign;
    std::array<std::optional<Bounds>, kLevels> bounds = {};
  };
  const Bounds& bounds_at(Side& side, int level, const Interval& theta,
                          const Interval& slopes) const {
    std::optional<Bounds>& out = side.bounds[at(level)];
    if (out) return *out;
    const double by = beyond(level);
    const Interval beta(slopes.lower - (side.sign < 0.0 ? by : 0.0),
                        slopes.upper + (side.sign > 0.0 ? by : 0.0));
    const TurningPoint<Interval> place{0.0, 0.0, theta, 0.0, beta, 0.0};
    const ContactForce<Interval> at_rest =
        lossless_contact_force(scene_, place);
    out.emplace();
    const double curvature = side.sign > 0.0 ? hump_ : valley_;
    if (curvature < kNone) out->push_back({curvature, 0.0});
    for (const SideOfForce& force : side.sign > 0.0 ? up_ : down_) {
      const CurvatureBound found = force.over(place, at_rest);
      if (found.constant < kNone) out->push_back(found);
    }
    return *out;
  }
  /// What turns the body to one side within a step; nothing if that may be more
  /// than a turn. It holds as far beyond its slopes as it lets it: along the
  /// last stretch of a way that ends there.
  /// \param level  [in,out] how far that is, from the next one below on
  const Bounds& look(Side& side, int& level, const Interval& theta,
                     const Interval& slopes) const {
    static const Bounds kAnything;
    for (level = std::max(0, level - 1); level < kLevels; ++level) {
      const Bounds& found = bounds_at(side, level, theta, slopes);
      if (turned_ * least(found, here_.E) <= beyond(level)) return found;
    }
    return kAnything;
  }
  /// What holds within a step from a slope on.
  /// \param E    at its beginning
  /// \param way  that of the slope before this one, with the like
  void look_at(Side& up, Side& down, const Interval& theta,
               const Interval& slopes, const Interval& E, Way& way) {
    Cell& out = here_;
    out.E = {E.lower - within_step_, E.upper + within_step_};
    out.up = look(up, way.up, theta, slopes);
    out.down = look(down, way.down, theta, slopes);
    out.beta = {slopes.lower - beyond(way.down), slopes.upper + beyond(way.up)};
    out.most = kNone;
    for (const CurvatureBound& a : out.up) {
      for (const CurvatureBound& b : out.down) {
        const CurvatureBound both{a.constant + b.constant,
                                  a.by_energy + b.by_energy};
        out.most = std::min(out.most, most_energy(both, 0.0));
      }
    }
    out.gain = turned_ * sin(out.beta).upper +
               scene_.body.radius * scene_.body.eta_m *
                   (std::sin(theta.upper) - std::sin(theta.lower));
  }

  /// Carries the energies of a step on that were raised, unless B is among what
  /// they come to within it.
  bool comes_to_B_from(int i) {
    const Body& body = scene_.body;
    const Interval theta = turns(i);
    const double at_B =
        scene_.H + lowest_start_ +
        body.radius * body.eta_m * (sin(theta).lower - std::sin(body.theta_m));
    // At any slope.
    if (floor() >= at_B - contact_radius(scene_)) return true;
    std::vector<Energy>& next = highest_[at((i + 1) % kSteps)];
    for (int j = 0; j < kSlopes; ++j) {
      Energy& now = highest_[at(i)][at(j)];
      if (!std::exchange(now.raised, false)) continue;
      Side up{1.0}, down{-1.0};
      std::size_t range = 0;
      for (double fast = now.height; fast > counted_; fast *= kSlower) {
        const Interval E(std::max(counted_, kSlower * fast), fast);
        if (range == ways_.size()) ways_.emplace_back();
        look_at(up, down, theta, slopes(j), E, ways_[range++]);
        const double over_B = contact_radius(scene_) * cos(here_.beta).upper;
        if (fast + within_step_ >= at_B - over_B) return true;
        carry(next, j, std::min(fast, here_.most));
      }
    }
    return false;
  }
  /// To the slopes that the limits let a body turn to in a step.
  void carry(std::vector<Energy>& next, int j, double from) {
    constexpr double kRaise = 1e-4;
    if (!(from + here_.gain > floor())) return;
    const auto reach = [&](int k, double most) {
      const double E = std::min(from, most) + here_.gain;
      if (E > next[at(k)].height) {
        next[at(k)] = {E + kRaise * scene_.H, true};
        raised_ = true;
      }
      return most + here_.gain > floor();
    };
    reach(j, kNone);
    for (int k = j + 1; k < kSlopes; ++k) {
      const double curvature = (k - j - 1) * kSlope / turned_;
      if (!reach(k, most_energy(here_.up, curvature))) break;
    }
    for (int k = j; k-- > 0;) {
      const double curvature = (j - k - 1) * kSlope / turned_;
      if (!reach(k, most_energy(here_.down, curvature))) break;
    }
  }

  const Scene& scene_;
  const std::vector<PathInequality>& limits_;
  std::vector<ForceRow> rows_;
  std::vector<SideOfForce> up_, down_;
  double hump_ = kNone, valley_ = kNone;
  double turned_;       ///< length of a step
  double within_step_;  ///< by which E changes within one at most
  double counted_;      ///< E below which nothing is asked
  double lowest_start_ = 0.0;
  std::vector<std::vector<Energy>> highest_;  ///< by step of the turn and slope
  bool raised_ = false;                       ///< any, in the last step
  Cell here_;
  std::vector<Way> ways_;  ///< by range of E
};

}  // namespace

bool comes_down(const Scene& scene, const std::vector<PathInequality>& limits) {
  if (!scene.body.off_centred() || scene.world.changes_rates()) return true;
  HighestEnergies energies(scene, limits);
  return !energies.can_say() || energies.lead_to_B();
}

}  // namespace brachisto
