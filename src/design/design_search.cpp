// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "design/design_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "brachisto/solvers/ipopt.hpp"
#include "design/closed_times.hpp"
#include "design/design_problem.hpp"
#include "design/design_space.hpp"
#include "math/portable_random.hpp"
#include "solvers/few_variables.hpp"

namespace brachisto {

namespace {

/// Minima that agree to this, relative to τ, and in coordinates, are one.
constexpr double kSameTau = 1e-8;
constexpr double kSamePlace = 1e-5;

/// A search needs few digits before its end.
SolveOptions on_the_way(SolveOptions options) {
  constexpr double kEnough = 1e-7;
  if (options.of<Collocation>() == nullptr) return options;
  Discretisation& mesh = options.use<Collocation>().discretisation;
  if (!mesh.fixed()) {
    mesh.tolerance = std::max(kEnough, mesh.wanted_tolerance());
  }
  return options;
}

/// Solves the track of a minimum anew, from the cycloid, and says what comes of
/// it.
std::optional<Solution> judge(const Scene& scene, const SolveOptions& options,
                              DesignMinimum& minimum) {
  Scene built = scene;
  built.body = minimum.body;
  Solution anew = solve(built, options);
  if (!anew.verified()) {
    minimum.remarks.push_back(anew.status == Status::Solved
                                  ? "its track could not be verified"
                                  : anew.message);
    return std::nullopt;
  }
  minimum.feasible = anew.feasible();
  minimum.remarks = anew.infeasible_because();
  const double tau = anew.motion()->tau();
  minimum.verified = std::abs(tau / minimum.tau - 1.0) <= kSameTau;
  if (!minimum.verified) {
    minimum.remarks.push_back(fmt::format(
        "the search has left the principal branch, on which τ is {:.9g}", tau));
  }
  return anew;
}

class Searcher {
 public:
  Searcher(const Scene& scene, const SolveOptions& options,
           const DesignPlan& plan, const std::atomic<int>* interrupt)
      : scene_(scene),
        options_(options),
        plan_(plan),
        space_(design_space(plan, scene.body)),
        times_(scene, on_the_way(options), interrupt) {
    ipopt_.tolerance = kTolerance;
    ipopt_.max_iterations = kMostIterations;
    ipopt_.linear_solver = LinearSolver::Mumps;
    if (interrupt != nullptr) {
      ipopt_.stop = StopCondition(options.limits.seconds, interrupt);
    }
  }

  [[nodiscard]] DesignSearch search(int number) {
    const Eigen::VectorXd start = reachable_start(number);
    run({start.begin(), start.end()}, false);
    if (plan_.require_feasible && !out_.minima.empty() &&
        !out_.minima.back().feasible) {
      run({start.begin(), start.end()}, true);
    }
    out_.solves = times_.solves();
    out_.cpu_seconds = times_.cpu_seconds();
    return std::move(out_);
  }

 private:
  // Newton's method brings the last digits.
  static constexpr double kTolerance = 1e-6;
  static constexpr int kMostIterations = 100;
  // Errors of gradients over it, and its square, are below 1e-5.
  static constexpr double kStepOfHessian = 1e-3;

  [[nodiscard]] Eigen::VectorXd start_of(int number) const {
    if (number == 1) return space_->first();
    const RandomStream stream(plan_.seed, "design");
    SplitMix64 random(static_cast<std::uint64_t>(
        stream.draw(static_cast<std::uint64_t>(number))));
    return space_->random(random);
  }

  /// A start, drawn towards the axis if the branch of the cycloid, which begins
  /// there, does not reach it.
  [[nodiscard]] Eigen::VectorXd reachable_start(int number) {
    constexpr int kMostSteps = 6;
    Eigen::VectorXd y = start_of(number);
    for (int i = 0; i < kMostSteps; ++i) {
      if (times_.move_to(space_->traits(y))) break;
      y = space_->nearer_to_the_axis(y);
    }
    return y;
  }

  void run(std::vector<double> start, bool require_feasible) {
    DesignProblem problem(*space_, times_, require_feasible);
    try {
      times_.let_go();
      times_.use(on_the_way(options_));
      const SolverResult found =
          solve_with_ipopt(problem, {std::move(start), {}}, ipopt_);
      keep_path(problem);
      if (found.status != Status::Solved) {
        out_.message = found.message;
      } else {
        times_.use(options_);
        const FewVariablesPoint refined =
            refine_few_variables(problem, found.point, kStepOfHessian);
        take(problem, refined.converged ? refined.point : found.point, refined);
      }
    } catch (const NoWayOn& error) {
      keep_path(problem);
      out_.message = error.what();
    }
  }

  void keep_path(const DesignProblem& problem) {
    std::ranges::copy(problem.path(), std::back_inserter(out_.path));
  }

  void take(DesignProblem& problem, const PrimalDual& point,
            const FewVariablesPoint& refined) {
    if (!problem.set_point(point.x)) {
      out_.message = problem.refusal();
      return;
    }
    const Eigen::VectorXd y = Eigen::Map<const Eigen::VectorXd>(
        point.x.data(), static_cast<Eigen::Index>(point.x.size()));
    DesignMinimum minimum;
    minimum.body = space_->body(y);
    minimum.values = space_->values(y);
    minimum.tau = times_.tau();
    minimum.gradient = space_->slopes(y, times_.gradient());
    if (refined.converged) {
      minimum.bounds_active = problem.bounds_that_hold(refined.point);
      minimum.curvatures = refined.curvatures;
    }
    out_.answer = judge(scene_, options_, minimum);
    out_.minima.push_back(std::move(minimum));
  }

  Scene scene_;
  SolveOptions options_;
  DesignPlan plan_;
  std::unique_ptr<DesignSpace> space_;
  ClosedTimes times_;
  IpoptOptions ipopt_;
  DesignSearch out_;
};

/// Whether only the end that a design has without a bound of its own holds
/// η_m back.
bool runs_away(const DesignPlan& plan, const DesignMinimum& minimum) {
  return !plan.bounds[static_cast<std::size_t>(BodyKey::EtaM)] &&
         std::ranges::any_of(minimum.bounds_active, [](const auto& held) {
           return held.name == name(BodyKey::EtaM) &&
                  held.bound == kLargestOffset;
         });
}

bool same(const DesignMinimum& a, const DesignMinimum& b) {
  return std::abs(a.tau / b.tau - 1.0) <= kSameTau &&
         (traits_of(a.body) - traits_of(b.body)).norm() <= kSamePlace;
}

}  // namespace

DesignSearch search_design(const Scene& scene, const SolveOptions& options,
                           const DesignPlan& plan, int start,
                           const std::atomic<int>* interrupt) {
  return Searcher(scene, options, plan, interrupt).search(start);
}

DesignAnswer gather_designs(const DesignPlan& plan,
                            std::vector<DesignSearch> searches) {
  DesignAnswer out;
  for (DesignSearch& search : searches) {
    for (DesignMinimum& minimum : search.minima) {
      const auto known = std::ranges::find_if(
          out.minima,
          [&](const DesignMinimum& other) { return same(minimum, other); });
      if (known == out.minima.end()) {
        minimum.found_from = 1;
        out.minima.push_back(std::move(minimum));
      } else {
        ++known->found_from;
      }
    }
    out.paths.push_back(std::move(search.path));
    out.solves += search.solves;
    out.cpu_seconds += search.cpu_seconds;
  }
  std::ranges::stable_sort(out.minima, {}, &DesignMinimum::tau);
  for (DesignMinimum& minimum : out.minima) {
    if (!runs_away(plan, minimum)) continue;
    minimum.remarks.push_back(fmt::format(
        "it leans on η_m = {}, where a design ends that states no bound: "
        "towards η_m = 1, k = 0 bodies grow ever quicker, and there is no "
        "quickest one; state design.bounds.eta_m",
        kLargestOffset));
  }
  const auto best =
      std::ranges::find_if(out.minima, [&](const DesignMinimum& minimum) {
        return minimum.verified && !runs_away(plan, minimum) &&
               (minimum.feasible || !plan.require_feasible);
      });
  if (best != out.minima.end()) out.best = *best;
  return out;
}

}  // namespace brachisto
