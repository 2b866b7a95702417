// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/arc_fit.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "brachisto/math/clock.hpp"
#include "refinement/junction_steps.hpp"

namespace brachisto {

namespace {

using Vector = Eigen::VectorXd;

class Fit {
 public:
  Fit(const LimitedCurve& nearby, PathSetting setting, int degree,
      const MeshOptions& options, double boldness)
      : scene_(nearby.problem().scene()),
        degree_(degree),
        options_(options),
        now_(std::move(setting)),
        nearby_(nearby),
        boldest_(boldness * kRestorable) {}

  ArcFit run() {
    const StopScope scope(options_.ipopt.stop);
    try {
      while (iterate() == Outcome::Vanished) {
      }
    } catch (const Stopped&) {
      if (!options_.ipopt.stop.met()) throw;
      out_.path.reset();
      out_.message = "stopped";
    }
    return std::move(out_);
  }

  /// Whether the iteration went on for long, or nowhere, to no end.
  [[nodiscard]] bool lost() const { return lost_; }

 private:
  enum class Outcome { Found, Failed, Vanished };

  [[nodiscard]] std::size_t num_junctions() const {
    return now_.arcs.size() - 1;
  }

  Outcome fail(std::string message) {
    out_.message = std::move(message);
    return Outcome::Failed;
  }

  /// Moves junctions and ends along a step, which becomes what was done: less
  /// where a slope would turn or an arc would shrink too fast.
  void move(Vector& step, PathSetting& setting) const {
    constexpr double kLeft = 0.4, kLongest = 0.1;
    const auto m = static_cast<Eigen::Index>(num_junctions());
    const Eigen::Index end = m + (end_is_sought(scene_) ? 1 : 0);
    const Eigen::Index slopes =
        end + (start_is_sought(scene_, setting.ends) ? 1 : 0);
    double all = 1.0;
    for (Eigen::Index i = m; i < slopes; ++i) {
      all = std::min(all, kLongest / (std::abs(step[i]) + 1e-300));
    }
    step *= all;
    // Neighbours that move together may do so; one that would run into another
    // pushes it along.
    std::vector<double> least;
    for (std::size_t i = 0; i < setting.arcs.size(); ++i) {
      least.push_back(kLeft * length_of(setting.arcs, i));
    }
    double begin = 0.0;
    for (Eigen::Index i = 0; i < m; ++i) {
      const auto arc = static_cast<std::size_t>(i);
      begin = std::max(setting.arcs[arc].end + step[i], begin + least[arc]);
      step[i] = begin - setting.arcs[arc].end;
    }
    double behind = 1.0;
    for (Eigen::Index i = m; i-- > 0;) {
      const auto arc = static_cast<std::size_t>(i);
      behind =
          std::min(setting.arcs[arc].end + step[i], behind - least[arc + 1]);
      step[i] = behind - setting.arcs[arc].end;
      setting.arcs[arc].end = behind;
    }
    if (end > m) setting.ends.phi += step[m];
    if (slopes > end) *setting.ends.start += step[end];
  }
  /// Of an arc.
  [[nodiscard]] double growth(const Vector& step, std::size_t arc) const {
    const auto i = static_cast<Eigen::Index>(arc);
    return (arc < num_junctions() ? step[i] : 0.0) -
           (arc > 0 ? step[i - 1] : 0.0);
  }

  Outcome iterate() {
    constexpr int kMostSteps = 60;
    constexpr double kRounding = 1e-14, kSmallest = 1e-13;
    ++out_.passes;
    const auto ends = with_start(now_.ends, scene_, now_.limits,
                                 holds_control(now_.arcs.front(), now_.limits));
    if (!ends) return fail("at rest no direction keeps the limits");
    now_.ends = *ends;
    PathSystem system(scene_, now_, degree_);
    PrimalDual start = prolong(nearby(), system.problem());
    exchange_multipliers(system.problem(), [&](double& touch, int row) {
      start.lambda[static_cast<std::size_t>(row)] = touch;
    });
    if (!system.move_to(now_, std::move(start))) {
      return fail("the arcs have no start");
    }
    steps_ = {};
    drift_ = std::numeric_limits<double>::infinity();
    restorable_ = kRestorable;
    double last_left = std::numeric_limits<double>::infinity();
    int stalled = 0;  // steps after which as much was left
    for (int i = 0; i < kMostSteps; ++i) {
      const double left = largest(system.open());
      if (!std::isfinite(left)) return fail("a junction has no slope");
      // What is left after one step may be of another kind than before it, and
      // T feels an open slope at A in the first order.
      if (left <= kClosed && left > 0.5 * last_left) ++stalled;
      last_left = left;
      const bool settled =
          left <= kClosed && (stalled > 1 || left <= kSmallest);
      if (settled && is_solved(system)) break;
      // Moved by rounding, junctions would disturb the rest for ever, and what
      // other factors leave of it may be more than rounding.
      if (settled) drift_ = std::numeric_limits<double>::infinity();
      if (!linearise(system)) {
        if (drop_shortest(system)) return Outcome::Vanished;
        return fail("the optimality conditions of the arcs are singular");
      }
      // If it released one more of them.
      if (system.open().size() != steps_.size()) steps_ = {};
      ++out_.newton_steps;
      out_.work +=
          system.problem().num_variables() + system.problem().num_constraints();
      const PathRates newton = system.newton(left_by_factors());
      if (!newton.open.allFinite()) {
        return fail(
            "no solution of the optimality conditions of the arcs was found");
      }
      Vector step = Vector::Zero(newton.open.size());
      // What is less than that follows from the residuals, or is rounding.
      const bool together =
          !settled && system.residual() <= kNear &&
          left > std::max(kRounding, 1e-3 * system.residual());
      if (together) {
        const auto wanted = steps_.step(system, system.open() + newton.open);
        if (!wanted) break;
        step = *wanted;
        if (drop_vanishing(step, system)) return Outcome::Vanished;
      }
      const double before = system.residual();
      const bool moves_junctions = !step.isZero();
      if (advance(system, newton, step)) {
        if (together) {
          steps_.went(step);
        } else {
          learn_what_is_restored(before, system.residual());
        }
        continue;
      }
      // Next to the solution junctions may be right to rounding, and the rest
      // not yet.
      if (moves_junctions) {
        step.setZero();
        if (advance(system, newton, step)) {
          steps_.went({});
          continue;
        }
      }
      // Factors of this place may do what those of another did not.
      if (drift_ == 0.0 || is_closed(system)) break;
      drift_ = std::numeric_limits<double>::infinity();
      last_left = std::numeric_limits<double>::infinity();
      steps_ = {};
    }
    if (!is_closed(system) && !is_down_to_rounding(system)) {
      lost_ = true;
      return fail(
          fmt::format("junctions and contacts were not found: {:.1e} is left",
                      std::max(system.residual(), largest(system.open()))));
    }
    polish(system);
    const double missed = is_closed(system) ? 0.0
                                            : system.cost_of_residuals() /
                                                  system.problem().eval_f();
    LimitedCurve curve = std::move(system).take_curve();
    exchange_multipliers(curve.problem(), [&](double& touch, int row) {
      touch = curve.point().lambda[static_cast<std::size_t>(row)];
    });
    const ContactMismatch mismatch = mismatch_of(curve, now_.ends);
    out_.path.emplace(
        FittedPath{now_.arcs, now_.ends, std::move(curve), mismatch, missed});
    return Outcome::Found;
  }

  /// exchange(multiplier of a touch, its constraint).
  template <class Exchange>
  void exchange_multipliers(const LimitedTime& problem, Exchange&& exchange) {
    const std::vector<int> rows = touched_rows(now_.arcs, problem);
    std::size_t next = 0;
    for (Arc& arc : now_.arcs) {
      if (arc.touch) exchange(arc.touch->multiplier, rows[next++]);
    }
  }

  /// Factors serve for other arcs that are nearly the same: what they leave of
  /// the residual is taken on by the next step. False if new ones are singular.
  [[nodiscard]] bool linearise(PathSystem& system) {
    constexpr double kSame = 1e-3, kSmall = 1e-4;
    if (drift_ <= kSame && system.residual() <= kSmall) return true;
    drift_ = 0.0;
    return system.linearise();
  }
  /// Of a right-hand side.
  [[nodiscard]] double left_by_factors() const {
    constexpr double kOfNewOnes = 1e-6, kOfOthers = 1e-2;
    return drift_ == 0.0 ? kOfNewOnes : kOfOthers;
  }
  /// By how much elements and slopes are others since.
  [[nodiscard]] double drift_from(const PathSetting& before) const {
    double most = std::abs(now_.ends.phi - before.ends.phi);
    if (now_.ends.start) {
      most = std::max(most, std::abs(*now_.ends.start - *before.ends.start));
    }
    for (std::size_t i = 0; i < now_.arcs.size(); ++i) {
      const double ratio = length_of(now_.arcs, i) / length_of(before.arcs, i);
      most = std::max(most, std::abs(ratio - 1.0));
    }
    return most;
  }

  /// Newton's step, with another of the junctions and slopes, which becomes
  /// what was done of it; shorter until the optimality conditions come nearer,
  /// or stay near enough for the next step to restore them.
  bool advance(PathSystem& system, const PathRates& newton, Vector& step) {
    // Of rounding there are a few draws.
    const int halvings = step.isZero() && is_solved(system) ? 2 : 6;
    constexpr double kMoved = 1e-5;  // along the arcs
    const PathSetting from = now_;
    const PrimalDual start = system.point();
    const double residual = system.residual();
    const Vector wanted = step;
    double length = 1.0;
    for (int k = 0; k <= halvings; ++k, length *= 0.5) {
      now_ = from;
      step = length * wanted;
      if (!wanted.isZero()) move(step, now_);
      PrimalDual point = start;
      move_along(point, newton.point, length);
      steps_.follow(step, point);
      if (!system.move_to(now_, std::move(point)) ||
          !system.open().allFinite()) {
        continue;
      }
      const double next = system.residual();
      if (next < residual || (residual > kNear && next < 2.0 * residual) ||
          (!wanted.isZero() && next <= restorable_)) {
        drift_ += std::max(drift_from(from), kMoved);
        return true;
      }
    }
    now_ = from;
    // Where it was before it is not refused.
    static_cast<void>(system.move_to(from, start));
    return false;
  }
  /// What may be left of open conditions.
  static constexpr double kClosed = 1e-10;
  /// Residuals at which junctions are moved.
  static constexpr double kNear = 1e-2;
  /// After which they are found to fall again.
  static constexpr double kRestorable = 0.5;

  /// How far junctions may be moved at once shows in how well the conditions
  /// are met again after it: multipliers, and with them residuals, are large
  /// where many limits hold one after the other.
  void learn_what_is_restored(double before, double after) {
    constexpr double kWell = 1e-2, kPoor = 0.3, kFactor = 4.0;
    if (after <= kWell * before) {
      restorable_ = std::min(kFactor * restorable_, boldest_);
    } else if (after > kPoor * before) {
      restorable_ = std::max(restorable_ / kFactor, kNear);
    }
  }

  /// To rounding: certificates weigh residuals by the lengths of elements, and
  /// junctions that move by rounding disturb them.
  void polish(PathSystem& system) {
    constexpr int kMostSteps = 5;
    steps_ = {};
    for (int i = 0; i < kMostSteps && linearise(system); ++i) {
      const double before = system.residual();
      Vector none = Vector::Zero(system.open().size());
      ++out_.newton_steps;
      if (!advance(system, system.newton(left_by_factors()), none)) return;
      if (system.residual() > 0.5 * before) return;
    }
  }

  /// Whether all is that is not open.
  [[nodiscard]] static bool is_solved(const PathSystem& system) {
    constexpr double kResidual = 1e-12;
    constexpr double kLeast = 10.0, kMost = 1e3;
    // What is summed up in a residual, and rounded.
    double terms = kLeast;
    for (const double lambda : system.point().lambda) {
      terms = std::clamp(std::abs(lambda), terms, kMost);
    }
    return system.residual() <= kResidual * terms;
  }
  [[nodiscard]] static bool is_closed(const PathSystem& system) {
    return is_solved(system) && largest(system.open()) <= kClosed;
  }
  /// Whether what is left is rounding where no step leaves less: terms of a
  /// force are large where a body is small or a path bends much.
  [[nodiscard]] static bool is_down_to_rounding(const PathSystem& system) {
    constexpr double kUnits = 256.0, kMost = 1e-9;
    const double left = std::max(system.residual(), largest(system.open()));
    return left <= kMost && left <= kUnits * system.rounding();
  }
  /// Zero of nothing; what is not a number stays, which the norm passes over.
  [[nodiscard]] static double largest(const Vector& open) {
    if (!open.allFinite()) return std::numeric_limits<double>::quiet_NaN();
    return open.size() == 0 ? 0.0 : open.lpNorm<Eigen::Infinity>();
  }
  [[nodiscard]] const LimitedCurve& nearby() const {
    return kept_ ? *kept_ : nearby_;
  }

  /// Along an arc as short as that conditions may be singular.
  static constexpr double kNone = 1e-6;

  /// Leaves out a short arc whose ends want to pass each other again and again.
  bool drop_vanishing(const Vector& step, const PathSystem& system) {
    constexpr double kShort = 0.03, kLeast = 1e-8;
    constexpr int kPatience = 3;
    const std::vector<Arc>& arcs = now_.arcs;
    crossings_.resize(arcs.size());
    for (std::size_t i = 0; arcs.size() > 1 && i < arcs.size(); ++i) {
      const double length = length_of(arcs, i);
      const bool crosses = length < kShort && length + growth(step, i) <= 0.0;
      crossings_[i] = crosses ? crossings_[i] + 1 : 0;
      if (length <= (crosses ? kNone : kLeast) || crossings_[i] >= kPatience) {
        drop(i, system);
        return true;
      }
    }
    return false;
  }
  /// Leaves out one where conditions are singular.
  bool drop_shortest(const PathSystem& system) {
    const std::vector<Arc>& arcs = now_.arcs;
    std::size_t shortest = 0;
    for (std::size_t i = 1; i < arcs.size(); ++i) {
      if (length_of(arcs, i) < length_of(arcs, shortest)) shortest = i;
    }
    if (arcs.size() == 1 || length_of(arcs, shortest) > kNone) return false;
    drop(shortest, system);
    return true;
  }
  void drop(std::size_t arc, const PathSystem& system) {
    crossings_.clear();
    exchange_multipliers(system.problem(), [&](double& touch, int row) {
      touch = system.point().lambda[static_cast<std::size_t>(row)];
    });
    leave_out(now_.arcs, arc);
    kept_.emplace(system.curve());
  }

  const Scene& scene_;
  int degree_;
  const MeshOptions& options_;
  PathSetting now_;
  const LimitedCurve& nearby_;
  std::optional<LimitedCurve> kept_;
  JunctionSteps steps_;
  bool lost_ = false;
  double drift_ = 0.0;  ///< since the system was factorised
  double boldest_;
  double restorable_ =
      kRestorable;  ///< residual after which it is found to fall again
  std::vector<int> crossings_;  ///< of each arc's ends, one after the other
  ArcFit out_;
};

}  // namespace

ArcFit fit_arcs(const LimitedCurve& nearby, PathSetting setting, int degree,
                const MeshOptions& options) {
  constexpr double kBold = 100.0;
  Fit careful(nearby, setting, degree, options, 1.0);
  ArcFit first = careful.run();
  if (first.path || !careful.lost() || options.ipopt.stop.met()) return first;
  ArcFit bold = Fit(nearby, std::move(setting), degree, options, kBold).run();
  if (!bold.path) bold.message = std::move(first.message);
  bold.passes += first.passes;
  bold.newton_steps += first.newton_steps;
  bold.work += first.work;
  return bold;
}

std::optional<FittedPath> path_on_arcs(const Scene& scene,
                                       std::vector<Arc> arcs,
                                       const LimitedEnds& ends, int degree,
                                       PrimalDual point) {
  const std::vector<PathInequality> limits =
      inequalities(scene.body, scene.limits);
  double begin = 0.0;
  const auto fits = [&](const Arc& arc) {
    const bool behind = arc.end > std::exchange(begin, arc.end);
    return behind && arc.elements() >= 1 && arc.cuts.front() == 0.0 &&
           arc.cuts.back() == 1.0 &&
           std::ranges::is_sorted(arc.cuts, std::less_equal<>()) &&
           arc.held.size() == limits.size() &&
           (!arc.touch || arc.touch->limit < limits.size());
  };
  if (arcs.empty() || !std::ranges::all_of(arcs, fits) || begin != 1.0) {
    return std::nullopt;
  }
  const PathSetting setting{limits, arcs, ends};
  PathSystem system(scene, setting, degree);
  if (point.x.size() != at(system.problem().num_variables()) ||
      point.lambda.size() != at(system.problem().num_constraints()) ||
      !system.move_to(setting, std::move(point))) {
    return std::nullopt;
  }
  LimitedCurve curve = std::move(system).take_curve();
  const ContactMismatch mismatch = mismatch_of(curve, ends);
  return FittedPath{std::move(arcs), ends, std::move(curve), mismatch};
}

}  // namespace brachisto
