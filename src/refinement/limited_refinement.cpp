// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/limited_refinement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "math/index.hpp"
#include "model/start_angle.hpp"
#include "model/start_under_limits.hpp"
#include "refinement/limit_relaxation.hpp"
#include "refinement/turn_meshes.hpp"

namespace brachisto {

namespace {

using Inequalities = std::vector<PathInequality>;

/// The free extremal as a start.
PrimalDual sample(const ExtremalCurve& curve, const LimitedTime& problem) {
  using enum StateComponent;
  const VariableLayout& layout = problem.layout();
  const RadauScheme& scheme = problem.scheme();
  PrimalDual out;
  out.x.assign(at(problem.num_variables()), 0.0);
  out.lambda.assign(at(problem.num_constraints()), 0.0);
  out.z_lower.assign(out.x.size(), 0.0);
  out.z_upper.assign(out.x.size(), 0.0);
  const auto put = [&](int node, double sigma) {
    const auto place = turning_point(curve, sigma);
    out.x[at(layout.state(node, X))] = place.x;
    out.x[at(layout.state(node, Z))] = place.z;
    if (layout.has_theta()) out.x[at(layout.state(node, Theta))] = place.theta;
    out.x[at(layout.state(node, W))] = place.w;
    out.x[at(layout.state(node, Beta))] = place.beta;
    return place.q;
  };
  put(0, 0.0);
  for (int c = 0; c < layout.num_points(); ++c) {
    const int e = c / scheme.degree;
    const auto j = at(c % scheme.degree);
    const double sigma = problem.mesh().boundaries[at(e)] +
                         problem.mesh().length(e) * scheme.rule.points[j];
    out.x[at(layout.control(c))] = problem.mesh().length(e) * put(c + 1, sigma);
    const Costates p = curve.at(sigma).p;
    const double b = scheme.rule.weights[j];
    out.lambda[at(layout.defect(c, X))] = -b * p.p_x;
    out.lambda[at(layout.defect(c, Z))] = -b * p.p_z;
    if (layout.has_theta()) {
      out.lambda[at(layout.defect(c, Theta))] = -b * p.p_theta;
    }
    out.lambda[at(layout.defect(c, W))] = -b * p.p_w;
  }
  out.x[at(layout.last())] = curve.rolling_time();
  return out;
}

bool winds(const LimitedCurve& curve) {
  constexpr double kTooSteep = 1.02 * std::numbers::pi;
  const VariableLayout& layout = curve.problem().layout();
  for (int node = 0; node < layout.num_nodes(); ++node) {
    const int beta = layout.state(node, StateComponent::Beta);
    if (std::abs(curve.point().x[at(beta)]) > kTooSteep) return true;
  }
  return false;
}

/// Elements halved where what holds changes within them or next to them.
Mesh finer_at_changes(const LimitedCurve& curve) {
  const LimitedTime& problem = curve.problem();
  const Mesh& mesh = problem.mesh();
  const auto changes = [&](int point) {
    if (point < 1 || point >= problem.layout().num_points()) return false;
    for (int i = 0; i < problem.layout().num_limits(); ++i) {
      if (curve.active(point, i) != curve.active(point - 1, i)) return true;
    }
    return false;
  };
  Mesh next{mesh.degree, {0.0}};
  for (int e = 0; e < mesh.num_elements(); ++e) {
    bool any = false;
    for (int c = e * mesh.degree; c <= (e + 1) * mesh.degree; ++c) {
      any = any || changes(c);
    }
    if (any) {
      next.boundaries.push_back(mesh.boundaries[at(e)] + 0.5 * mesh.length(e));
    }
    next.boundaries.push_back(mesh.boundaries[at(e + 1)]);
  }
  return next;
}

class LimitedSolve {
 public:
  LimitedSolve(const Scene& scene, const Discretisation& wanted,
               const ExtremalCurve& free, double phi,
               const MeshOptions& options)
      : scene_(scene),
        wanted_(wanted),
        free_(free),
        relaxation_(scene, free),
        limits_(inequalities(scene.body, scene.limits)),
        options_(options),
        iterations_(options.ipopt.max_iterations),
        budget_(iterations_) {
    ends_.free_contacts = scene.contact == Contact::Optimal;
    ends_.phi = scene.end_slope.value_or(phi);
    if (start_is_sought(scene_, limits_)) {
      ends_.start = start_angle(scene_.body);
    }
  }

  LimitedRefinement run() {
    solve_and_refine();
    if (record_.passes > 0) out_.meshes.push_back(record_);
    return std::move(out_);
  }

 private:
  void solve_and_refine() {
    // Arcs are found with elements that follow them well, whatever is wanted.
    constexpr int kDegree = 7;
    std::optional<FittedPath> path;
    const bool tightened = tighten();
    if (tightened) path = read_off(kDegree);
    if (out_.status == Status::Infeasible) return;
    const Status status = out_.status;
    const std::string message = out_.message;
    if (!path && loosest_ && !stopped()) path = follow(kDegree);
    if (!path && loosest_ && end_is_sought(scene_) && !stopped() &&
        bracket_contact(tightened)) {
      path = read_off(kDegree);
    }
    if (!path && !stopped() && out_.status != Status::NoSmoothContact) {
      fail(status, message);  // of the first attempt
    }
    const int p = wanted_.degree.value_or(
        wanted_.fixed() ? wanted_.degree_of_fixed() : kDegree);
    if (path && wanted_.fixed()) {
      path = on_fixed_mesh(*path, p);
    } else if (path && p != kDegree) {
      path = fit(path->curve, {limits_, path->arcs, path->ends}, p).path;
    }
    if (path) refine(std::move(path), p);
  }

  // Of the interior-point method, whose solutions are starts.
  static constexpr double kTolerance = 1e-8;
  static constexpr double kComplementarity = 1e-11;

  [[nodiscard]] bool stopped() const { return options_.ipopt.stop.met(); }

  bool fail(Status status, std::string message) {
    out_.status = status;
    out_.message = std::move(message);
    return false;
  }

  // ---- Tightening.

  /// Solves from `start`, keeps the solution if there is one.
  bool solve(const Inequalities& limits, const Mesh& mesh,
             const LimitedEnds& ends,
             const std::function<PrimalDual(const LimitedTime&)>& start,
             int most_iterations) {
    LimitedTime problem(scene_, limits, mesh, ends);
    IpoptOptions ipopt = options_.ipopt;
    ipopt.tolerance = std::max(ipopt.tolerance, kTolerance);
    ipopt.complementarity = kComplementarity;
    ipopt.max_iterations = std::min(budget_, most_iterations);
    SolverResult result = solve_with_ipopt(problem, start(problem), ipopt);
    budget_ = std::max(0, budget_ - result.iterations);
    record_.iterations += result.iterations;
    ++record_.passes;
    record_.degree = mesh.degree;
    record_.elements = mesh.num_elements();
    record_.linear_solver = result.linear_solver;
    out_.log += result.log;
    if (result.status == Status::IterationLimit && budget_ > 0) {
      // Of one of many passes, not of the user.
      result.status = Status::NotConverged;
    }
    if (result.status != Status::Solved) {
      return fail(result.status, std::move(result.message));
    }
    LimitedCurve curve(problem, std::move(result.point));
    if (winds(curve)) {
      return fail(Status::NotConverged, "the path that was found has a loop");
    }
    coarse_.emplace(std::move(curve));
    ends_ = ends;
    return true;
  }
  bool solve_again(const Inequalities& limits, const Mesh& mesh,
                   const LimitedEnds& ends) {
    constexpr int kMostIterations = 100;
    const LimitedCurve before = *coarse_;
    return solve(
        limits, mesh, ends,
        [&](const LimitedTime& problem) { return prolong(before, problem); },
        kMostIterations);
  }
  bool solve_first(const Inequalities& limits, const Mesh& mesh,
                   const LimitedEnds& ends) {
    constexpr int kMostIterations = 300;
    return solve(
        limits, mesh, ends,
        [&](const LimitedTime& problem) { return sample(free_, problem); },
        kMostIterations);
  }

  /// Ends for limits, as the last solution suggests them.
  [[nodiscard]] std::optional<LimitedEnds> next_ends(
      const Inequalities& limits) {
    LimitedEnds ends = ends_;
    if (ends.free_contacts) return ends;
    if (end_is_sought(scene_) && coarse_ && !end_held_) {
      ends.phi = end_slope(*coarse_);
    }
    if (start_is_sought(scene_, limits_)) {
      if (coarse_) ends.start = coarse_->at(0.0).state.beta;
      return ends;
    }
    ends.start = start_angle_under(scene_.body, limits);
    if (!ends.start) return std::nullopt;
    // Where the centre starts does not depend on its direction there.
    ends.start_slope_fixed = true;
    return ends;
  }

  bool tighten() {
    constexpr int kDegree = 4;
    constexpr double kFirstStep = 0.125, kLargestStep = 0.25;
    constexpr double kSmallestStep = 5e-3;
    const Mesh mesh = uniform_mesh(
        kDegree,
        static_cast<int>(24 + 12 * turns(scene_.body, free_.arc_length())));
    double reached = 0.0;
    double step = kFirstStep;
    for (double share = 0.0;;) {
      const Inequalities limits = relaxation_.at(share);
      const auto ends = next_ends(limits);
      if (!ends) {
        return fail(Status::NoAdmissiblePath,
                    "no admissible path: at rest no direction keeps the "
                    "limits of friction and normal force");
      }
      const bool first = !coarse_;
      const bool solved = first ? solve_first(limits, mesh, *ends)
                                : solve_again(limits, mesh, *ends);
      if (stopped()) return false;
      if (solved) {
        reached = share;
        if (first) {
          loosest_ = coarse_;
          loosest_ends_ = ends_;
        }
        if (share >= 1.0) break;
        if (!first) step = std::min(kLargestStep, 1.5 * step);
      } else {
        step *= 0.4;
        if (first || step < kSmallestStep) return none_found(reached);
      }
      share = std::min(1.0, reached + step);
    }
    keep_record("limits", coarse_->transit_time());
    return true;
  }

  // ---- Where the contact at B cannot be followed.

  /// Solves with the slope that C_B is built from held at one place after the
  /// other, until the slope at the end less that one changes its sign between
  /// two, and closes in on the root. Where it does so nowhere there is no
  /// smooth contact.
  bool bracket_contact(bool tightened) {
    constexpr double kStep = 0.1, kSteepest = 1.4;
    end_held_ = true;
    if (!tightened) {
      coarse_ = loosest_;
      ends_ = loosest_ends_;
      if (!tighten()) return false;
    }
    const double begin = ends_.phi;
    const LimitedCurve first = *coarse_;
    Held last{begin, open_at_B()};
    double least = std::abs(last.open), lowest = begin, highest = begin;
    for (const double direction : {1.0, -1.0}) {
      coarse_ = first;
      last = {begin, open_at_B()};
      for (double phi = begin + direction * kStep; std::abs(phi) < kSteepest;
           phi += direction * kStep) {
        if (!solve_held(phi)) break;
        const Held here{phi, open_at_B()};
        least = std::min(least, std::abs(here.open));
        lowest = std::min(lowest, phi);
        highest = std::max(highest, phi);
        if ((here.open < 0.0) != (last.open < 0.0)) {
          return close_in(last, here);
        }
        last = here;
      }
      if (stopped()) return false;
    }
    if (highest - lowest < 2.0 * kStep) return false;
    return fail(
        Status::NoSmoothContact,
        fmt::format("no smooth contact under these limits: for slopes "
                    "at B from {:.3g} to {:.3g} rad the path that keeps "
                    "the limits ends {:.2g} rad or more off; try "
                    "contact: optimal",
                    lowest, highest, least));
  }
  struct Held {
    double phi, open;
  };
  [[nodiscard]] double open_at_B() {
    return end_slope(*coarse_) - coarse_->problem().ends().phi;
  }
  bool solve_held(double phi) {
    const Mesh mesh = coarse_->problem().mesh();
    LimitedEnds ends = *next_ends(limits_);
    ends.phi = phi;
    return solve_again(limits_, mesh, ends);
  }
  /// By bisection, for slopes may jump where arcs are born.
  bool close_in(Held a, Held b) {
    constexpr double kClose = 1e-3, kJump = 1e-5;
    while (std::abs(a.phi - b.phi) > kJump) {
      const double phi = 0.5 * (a.phi + b.phi);
      if (!solve_held(phi)) return false;
      const Held here{phi, open_at_B()};
      if (std::abs(here.open) < kClose) return true;
      ((here.open < 0.0) == (a.open < 0.0) ? a : b) = here;
    }
    return fail(Status::NoSmoothContact,
                fmt::format("no smooth contact under these limits: at φ = "
                            "{:.6g} rad the slope at the end jumps from {:.2g} "
                            "to {:.2g} rad off; try contact: optimal",
                            a.phi, a.open, b.open));
  }

  bool none_found(double reached) {
    const bool infeasible = out_.status == Status::Infeasible;
    return fail(
        infeasible     ? Status::Infeasible
        : budget_ == 0 ? Status::IterationLimit
                       : Status::NotConverged,
        fmt::format(
            "{}: on the way from what the free extremal keeps to the limits "
            "{:.0f} % were reached{} ({})",
            infeasible ? "no path nearby keeps the limits"
                       : "no path was found that keeps the limits",
            100.0 * reached, tightest(reached),
            budget_ > 0 ? out_.message
                        : fmt::format("{} iterations used up", iterations_)));
  }
  /// Which limit the way ahead costs most.
  [[nodiscard]] std::string tightest(double reached) const {
    if (!coarse_) return {};
    const LimitedTime& problem = coarse_->problem();
    const Inequalities ahead = relaxation_.at(std::min(1.0, reached + 0.01));
    double most = 0.0;
    std::string which;
    for (int i = 0; i < problem.layout().num_limits(); ++i) {
      double cost = 0.0;
      const PathInequality& now = problem.limits()[at(i)];
      const PathInequality& next = ahead[at(i)];
      for (int c = 0; c < problem.layout().num_points(); ++c) {
        const auto row = at(problem.layout().limit(c, i));
        cost += std::abs(coarse_->point().lambda[row]);
      }
      cost *=
          std::abs(next.number - now.number) +
          (std::isfinite(now.lower) ? std::abs(next.lower - now.lower) : 0.0) +
          (std::isfinite(now.upper) ? std::abs(next.upper - now.upper) : 0.0);
      if (cost <= most) continue;
      most = cost;
      which = fmt::format("; the tightest is {}", name(now.kind));
    }
    return which;
  }

  void keep_record(const char* phase, double T) {
    out_.meshes.push_back(std::exchange(record_, {}));
    if (options_.progress) {
      options_.progress(phase, fmt::format("{} elements, T = {:.10g}",
                                           out_.meshes.back().elements, T));
    }
  }

  // ---- Arcs.

  [[nodiscard]] ArcFit fit(const LimitedCurve& nearby, PathSetting setting,
                           int degree) {
    ArcFit found = fit_arcs(nearby, std::move(setting), degree, options_,
                            fitted_ ? &*fitted_ : nullptr);
    record_.passes += found.passes;
    record_.newton_steps += found.newton_steps;
    record_.degree = degree;
    if (found.path) {
      fitted_ = found.path;
      record_.elements = found.path->curve.problem().mesh().num_elements();
    } else {
      fail(Status::NotConverged, std::move(found.message));
    }
    return found;
  }

  /// Arcs that keep all limits, from others that are near.
  [[nodiscard]] std::optional<FittedPath> fit_corrected(LimitedCurve nearby,
                                                        PathSetting setting,
                                                        int degree) {
    constexpr int kMostCorrections = 12;
    for (int i = 0; i < kMostCorrections; ++i) {
      ArcFit found = fit(nearby, setting, degree);
      if (!found.path) return std::nullopt;
      auto other = corrected(found.path->curve, found.path->arcs);
      if (!other) return std::move(found.path);
      setting.arcs = std::move(*other);
      setting.ends = found.path->ends;
      nearby = found.path->curve;
    }
    fail(Status::NotConverged,
         "no arcs were found that keep the limits everywhere");
    return std::nullopt;
  }

  /// From what the interior-point method found.
  [[nodiscard]] std::optional<FittedPath> read_off(int degree) {
    constexpr int kMostMeshes = 2;
    for (int i = 0; i < kMostMeshes; ++i) {
      if (i > 0) {
        if (!solve_again(limits_, finer_at_changes(*coarse_),
                         *next_ends(limits_))) {
          return std::nullopt;
        }
        keep_record("limits", coarse_->transit_time());
      }
      auto path =
          fit_corrected(*coarse_, {limits_, arcs_of(*coarse_), ends_}, degree);
      if (path || stopped()) return path;
    }
    return std::nullopt;
  }

  /// With the arcs known and corrected all along the way from the loosest
  /// limits, where contacts are closed at every step.
  [[nodiscard]] std::optional<FittedPath> follow(int degree) {
    constexpr double kFirstStep = 0.05, kLargestStep = 0.2;
    constexpr double kSmallestStep = 1e-3;
    auto path = fit_corrected(
        *loosest_, {relaxation_.at(0.0), arcs_of(*loosest_), loosest_ends_},
        degree);
    double reached = 0.0;
    double step = kFirstStep;
    while (path && reached < 1.0) {
      const double share = std::min(1.0, reached + step);
      PathSetting setting{relaxation_.at(share), path->arcs, path->ends};
      if (setting.ends.start_slope_fixed) {
        setting.ends.start = start_angle_under(scene_.body, setting.limits);
      }
      std::optional<FittedPath> next;
      if (!setting.ends.start_slope_fixed || setting.ends.start) {
        next = fit_corrected(path->curve, std::move(setting), degree);
      }
      if (stopped()) return std::nullopt;
      if (next) {
        reached = share;
        step = std::min(kLargestStep, 1.5 * step);
        path = std::move(next);
      } else {
        step *= 0.4;
        if (step < kSmallestStep) {
          none_found(reached);
          return std::nullopt;
        }
      }
    }
    return path;
  }

  // ---- Accuracy.

  void refine(std::optional<FittedPath> path, int p) {
    constexpr int kMostMeshes = 8, kManyElements = 2000;
    for (int i = 0; path && i < kMostMeshes; ++i) {
      const ArcFit finer =
          fit(path->curve, {limits_, path->arcs, path->ends}, p + 1);
      if (!finer.path) return;
      const double T = path->curve.transit_time();
      const double error =
          std::abs(finer.path->curve.transit_time() / T - 1.0) +
          path->mismatch.largest() + kRounding;
      record_.estimated_error = error;
      keep_record("arcs", T);
      out_.answer.emplace(LimitedAnswer{*path, error});
      out_.status = Status::Solved;
      out_.message = "solved under limits";
      const double tolerance = wanted_.wanted_tolerance();
      if (wanted_.fixed() ||
          (error <= tolerance && keeps_limits(path->curve)) ||
          path->curve.problem().mesh().num_elements() > kManyElements) {
        return;
      }
      std::vector<Arc> arcs = finer.path->arcs;
      divide(path->curve, finer.path->curve, 0.3 * tolerance, arcs);
      path = fit_corrected(finer.path->curve,
                           {limits_, std::move(arcs), finer.path->ends}, p);
    }
  }

  /// On so many elements as are asked for, or one on each arc.
  [[nodiscard]] std::optional<FittedPath> on_fixed_mesh(const FittedPath& path,
                                                        int p) {
    const int wanted =
        wanted_.elements ? *wanted_.elements : (*wanted_.nodes - 1) / p;
    std::vector<Arc> arcs = path.arcs;
    int left = wanted;
    double begin = 0.0;
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      const auto after = static_cast<int>(arcs.size() - i) - 1;
      const double share = (arcs[i].end - begin) / (1.0 - begin);
      const int count = std::clamp(static_cast<int>(std::lround(share * left)),
                                   1, std::max(1, left - after));
      arcs[i].cuts = equal_cuts(count);
      left -= count;
      begin = arcs[i].end;
    }
    return fit(path.curve, {limits_, std::move(arcs), path.ends}, p).path;
  }

  /// Elements are divided that err too much in T, which falls with their length
  /// h like h^(2p) at least, or exceed a limit between their points, which
  /// falls like h^p.
  static void divide(const LimitedCurve& curve, const LimitedCurve& finer,
                     double tolerance, std::vector<Arc>& arcs) {
    constexpr int kMost = 4;
    constexpr double kSafety = 1.1;
    const double p = curve.problem().mesh().degree;
    const double target = tolerance * finer.transit_time() /
                          curve.problem().mesh().num_elements();
    int e = 0;
    for (Arc& arc : arcs) {
      std::vector<double> cuts{0.0};
      for (std::size_t i = 0; i + 1 < arc.cuts.size(); ++i, ++e) {
        double where = 0.0;
        const double error = std::abs(curve.time_on(e) - finer.time_on(e));
        const double excess = std::max(0.0, curve.excess_on(e, where).value);
        const double pieces =
            kSafety * std::max(std::pow(error / target, 1.0 / (2.0 * p)),
                               std::pow(excess / kExcess, 1.0 / p));
        const int n = std::clamp(
            static_cast<int>(std::ceil(std::min(pieces, double{kMost}))), 1,
            kMost);
        for (int k = 1; k <= n; ++k) {
          cuts.push_back(arc.cuts[i] + (arc.cuts[i + 1] - arc.cuts[i]) * k / n);
        }
      }
      arc.cuts = std::move(cuts);
    }
  }
  [[nodiscard]] static bool keeps_limits(const LimitedCurve& curve) {
    double where = 0.0;
    for (int e = 0; e < curve.problem().mesh().num_elements(); ++e) {
      if (!(curve.excess_on(e, where).value <= kExcess)) return false;
    }
    return true;
  }

  /// Allowed between points, well below what a certificate allows.
  static constexpr double kExcess = 1e-9;
  static constexpr double kRounding = 1e-13;

  const Scene& scene_;
  Discretisation wanted_;
  const ExtremalCurve& free_;
  LimitRelaxation relaxation_;
  Inequalities limits_;
  MeshOptions options_;
  int iterations_, budget_;  ///< of Ipopt, and what is left
  LimitedEnds ends_;
  bool end_held_ = false;                ///< see bracket_contact()
  std::optional<LimitedCurve> coarse_;   ///< under the last limits
  std::optional<LimitedCurve> loosest_;  ///< under the first
  LimitedEnds loosest_ends_;
  std::optional<FittedPath> fitted_;  ///< the last one
  MeshRecord record_;
  LimitedRefinement out_;
};

}  // namespace

LimitedRefinement refine_limited(const Scene& scene,
                                 const Discretisation& wanted,
                                 const ExtremalCurve& free, double phi,
                                 MeshOptions options) {
  return LimitedSolve(scene, wanted, free, phi, options).run();
}

}  // namespace brachisto
