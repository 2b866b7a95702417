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
#include "solvers/few_variables.hpp"

namespace brachisto {

namespace {

/// Minima that agree to this, relative to τ, and in coordinates, are one.
constexpr double kSameTau = 1e-8;
constexpr double kSamePlace = 1e-5;

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
        space_(design_space(plan, scene.body)),
        times_(scene, options, interrupt) {
    ipopt_.tolerance = kTolerance;
    ipopt_.max_iterations = kMostIterations;
    ipopt_.linear_solver = LinearSolver::Mumps;
    if (interrupt != nullptr) {
      ipopt_.stop = StopCondition(options.limits.seconds, interrupt);
    }
  }

  [[nodiscard]] DesignSearch search(bool require_feasible) {
    const Eigen::VectorXd start = space_->coordinates(scene_.body);
    run({start.begin(), start.end()}, false);
    if (require_feasible && !out_.minima.empty() &&
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

  void run(std::vector<double> start, bool require_feasible) {
    times_.let_go();
    DesignProblem problem(*space_, times_, require_feasible);
    const SolverResult found =
        solve_with_ipopt(problem, {std::move(start), {}}, ipopt_);
    std::ranges::copy(problem.path(), std::back_inserter(out_.path));
    if (found.status != Status::Solved) {
      out_.message = found.message;
      return;
    }
    const FewVariablesPoint refined =
        refine_few_variables(problem, found.point, kStepOfHessian);
    take(problem, refined.converged ? refined.point : found.point, refined);
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
    minimum.body = times_.solution().scene.body;
    minimum.values = space_->values(y);
    minimum.tau = times_.tau();
    minimum.gradient = space_->slopes(y, times_.gradient(Traits::Ones()));
    if (refined.converged) {
      minimum.bounds_active = problem.bounds_that_hold(refined.point);
      minimum.curvatures = refined.curvatures;
    }
    out_.answer = judge(scene_, options_, minimum);
    out_.minima.push_back(std::move(minimum));
  }

  Scene scene_;
  SolveOptions options_;
  std::unique_ptr<DesignSpace> space_;
  ClosedTimes times_;
  IpoptOptions ipopt_;
  DesignSearch out_;
};

bool same(const DesignMinimum& a, const DesignMinimum& b) {
  return std::abs(a.tau / b.tau - 1.0) <= kSameTau &&
         (traits_of(a.body) - traits_of(b.body)).norm() <= kSamePlace;
}

}  // namespace

std::vector<Body> design_starts(const Scene& scene, const DesignPlan& plan) {
  constexpr double kOffTheAxis = 1e-2;
  const std::unique_ptr<DesignSpace> space = design_space(plan, scene.body);
  const RandomStream stream(plan.seed, "design");
  std::vector<Body> starts;
  for (int i = 0; i < plan.starts; ++i) {
    Body body = scene.body;
    if (i > 0) {
      SplitMix64 random(static_cast<std::uint64_t>(
          stream.draw(static_cast<std::uint64_t>(i))));
      body = body_of(space->traits(space->random(random)), scene.body);
    } else if (body.eta_m == 0.0 && plan.is_free(BodyKey::EtaM)) {
      // A body on its axis has a track of another kind, without θ.
      body.eta_m = kOffTheAxis;
    }
    starts.push_back(body);
  }
  return starts;
}

DesignSearch search_design(const Scene& scene, const SolveOptions& options,
                           const DesignPlan& plan,
                           const std::atomic<int>* interrupt) {
  return Searcher(scene, options, plan, interrupt)
      .search(plan.require_feasible);
}

DesignAnswer gather_designs(const DesignPlan& plan,
                            std::vector<DesignSearch> searches) {
  DesignAnswer out;
  out.plan = plan;
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
  const auto best =
      std::ranges::find_if(out.minima, [&](const DesignMinimum& minimum) {
        return minimum.verified && (minimum.feasible || !plan.require_feasible);
      });
  if (best != out.minima.end()) out.best = *best;
  return out;
}

}  // namespace brachisto
