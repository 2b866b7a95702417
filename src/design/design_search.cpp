// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "design/design_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "brachisto/solvers/program_solvers.hpp"
#include "design/closed_times.hpp"
#include "design/design_problem.hpp"
#include "design/design_space.hpp"
#include "math/portable_random.hpp"
#include "nlp/active_set.hpp"
#include "solvers/few_variables.hpp"
#include "trajectory/grip.hpp"

namespace brachisto {

namespace {

/// Solves of one track agree to this, relative to τ.
constexpr double kSameTau = 1e-8;

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

Eigen::VectorXd as_coordinates(const std::vector<double>& x) {
  return Eigen::Map<const Eigen::VectorXd>(x.data(),
                                           static_cast<Eigen::Index>(x.size()));
}

/// The multipliers of what leans on its bound at a point of an interior-point
/// method, without those of all the rest. \pre the problem has been moved there
PrimalDual with_held_alone(nlp::Problem& problem, PrimalDual point) {
  const nlp::ActiveSet active = nlp::active_set(problem, point);
  for (std::size_t i = 0; i < point.lambda.size(); ++i) {
    const double towards =
        active.constraints[i] == nlp::Held::AtLower   ? -point.lambda[i]
        : active.constraints[i] == nlp::Held::AtUpper ? point.lambda[i]
                                                      : 0.0;
    if (!(towards > 0.0)) point.lambda[i] = 0.0;
  }
  point.z_lower.assign(point.x.size(), 0.0);
  point.z_upper.assign(point.x.size(), 0.0);
  nlp::set_bound_multipliers(problem, active, point);
  for (std::vector<double>* const z : {&point.z_lower, &point.z_upper}) {
    for (double& value : *z) value = std::max(0.0, value);
  }
  return point;
}

/// What a body is found to be when its track is solved anew, from the cycloid.
enum class Judged { Verified, OnAnotherBranch, Unverified };

class Searcher {
 public:
  Searcher(const Scene& scene, const SolveOptions& options,
           const DesignPlan& plan, const std::atomic<int>* interrupt)
      : scene_(scene),
        options_(options),
        plan_(plan),
        space_(design_space(plan, scene.body)),
        interrupt_(interrupt),
        times_(scene, on_the_way(options), plan.max_grip, interrupt) {
    ipopt_.tolerance = kTolerance;
    ipopt_.linear_solver = LinearSolver::Mumps;
    ipopt_.stop = StopCondition(options.limits.seconds, interrupt);
  }

  /// From one start, and from others as long as it comes to nothing.
  [[nodiscard]] DesignSearch search(int number) {
    const RandomStream stream(plan_.seed, "design");
    SplitMix64 random(static_cast<std::uint64_t>(
        stream.draw(static_cast<std::uint64_t>(number))));
    out_.number = number;
    try {
      seek_from_starts(number, random);
      out_.reached.reset();
    } catch (const Stopped&) {
      if (interrupt_ != nullptr && interrupt_->load() != 0) throw;
      out_.stopped = true;
      out_.message = "the limit of time ended it on its way";
    }
    out_.solves = times_.solves();
    out_.cpu_seconds = times_.cpu_seconds();
    return std::move(out_);
  }

 private:
  // Newton's method brings the last digits.
  static constexpr double kTolerance = 1e-6;
  static constexpr int kMostIterations = 100;
  // Where τ jumps more of them only go to and fro.
  static constexpr int kMostOverJumps = 50;
  // Errors of gradients over it, and its square, are below 1e-5.
  static constexpr double kStepOfHessian = 1e-3;
  static constexpr int kMostStarts = 3;

  void seek_from_starts(int number, SplitMix64& random) {
    while (out_.starts < kMostStarts) {
      const bool of_scene = number == 1 && out_.starts == 0;
      ++out_.starts;
      if (seek(
              reachable(of_scene ? space_->first() : space_->random(random)))) {
        return;
      }
      out_.lost.push_back(out_.message);
    }
  }

  [[nodiscard]] bool move_to(const Eigen::VectorXd& y) {
    return times_.move_to(space_->traits(y), space_->moved_traits(y));
  }

  /// A start, drawn towards the axis if the branch of the cycloid, which begins
  /// there, does not reach it.
  [[nodiscard]] Eigen::VectorXd reachable(Eigen::VectorXd y) {
    constexpr int kMostSteps = 6;
    times_.begin(Follow::Neighbours);
    times_.use(on_the_way(options_));
    for (int i = 0; i < kMostSteps; ++i) {
      if (move_to(y)) {
        times_.hold_on();
        break;
      }
      y = space_->nearer_to_the_axis(y);
    }
    return y;
  }

  /// Whether a body came of it that a design may choose.
  bool seek(const Eigen::VectorXd& start) {
    Eigen::VectorXd from = start;
    std::optional<Judged> end = descend(from);
    if (end == Judged::OnAnotherBranch) {
      from = *back_;
      end = descend(from);
    }
    if (end == Judged::OnAnotherBranch) {
      from = *back_;
      end = run_along_principal(from);
    }
    if (end != Judged::Verified) return false;
    if (!plan_.require_feasible || out_.minima.back().feasible) return true;
    return run(from, Keep::All, Follow::Neighbours) == Judged::Verified &&
           out_.minima.back().feasible;
  }

  /// To the quickest body near a start; if a branch ends on the way, along its
  /// edge. Where that comes to nothing it is begun again elsewhere, but what it
  /// has passed is there so far.
  std::optional<Judged> descend(const Eigen::VectorXd& from) {
    back_.reset();
    const std::optional<Judged> end = run(from, Keep::None, Follow::Neighbours);
    if (end) return end;
    if (!back_) {
      take_passed();
      return std::nullopt;
    }
    const Eigen::VectorXd edge = *back_;
    const std::optional<Judged> along =
        run(edge, Keep::Branch, Follow::Neighbours);
    if (!along) take_passed();
    return along;
  }

  /// A run over principal tracks alone, whose τ jumps: if it comes to no
  /// minimum, to the quickest body that it has passed.
  std::optional<Judged> run_along_principal(const Eigen::VectorXd& from) {
    const std::optional<Judged> end =
        run(from, Keep::Branch, Follow::Principal);
    return end ? end : take_passed();
  }

  /// The quickest body of the last run, told as no minimum.
  std::optional<Judged> take_passed() {
    if (!passed_ || !move_to(*passed_)) {
      return std::nullopt;
    }
    return take(*passed_, {});
  }

  /// One run of the optimiser. \return nothing if it comes to no minimum
  std::optional<Judged> run(const Eigen::VectorXd& start, Keep keep,
                            Follow follow) {
    DesignProblem problem(*space_, times_, keep);
    std::optional<Judged> end;
    try {
      times_.begin(follow);
      times_.use(on_the_way(options_));
      ipopt_.max_iterations =
          follow == Follow::Principal ? kMostOverJumps : kMostIterations;
      const SolverResult found =
          solve_with_ipopt(problem, {{start.begin(), start.end()}, {}}, ipopt_);
      out_.message = found.message;
      if (!found.point.x.empty()) end = finish(problem, found, keep);
    } catch (const NoWayOn& error) {
      out_.message = error.what();
      back_ = problem.last_on_branch();
    } catch (const Stopped&) {
      note_way(problem);
      throw;
    }
    note_way(problem);
    return end;
  }

  void note_way(const DesignProblem& problem) {
    out_.paths.push_back(problem.path());
    passed_ = problem.quickest();
    if (!passed_ || (out_.reached && out_.reached->tau <= problem.least_tau()))
      return;
    DesignMinimum reached;
    reached.body = space_->body(*passed_);
    reached.values = space_->values(*passed_);
    reached.tau = problem.least_tau();
    reached.remarks.emplace_back(
        "it is no minimum: the limit of time ended the search on its way");
    out_.reached = std::move(reached);
  }

  /// What Newton's method confirms is a minimum, however the optimiser ended.
  std::optional<Judged> finish(DesignProblem& problem,
                               const SolverResult& found, Keep keep) {
    problem.use(options_);
    if (!problem.set_point(found.point.x)) {
      // It was come to step by step, and as a whole it is not found again.
      out_.message = problem.refusal();
      back_ = problem.last_on_branch();
      return std::nullopt;
    }
    const FewVariablesPoint refined =
        refine_few_variables(problem, found.point, kStepOfHessian);
    if (!refined.converged && found.status != Status::Solved) {
      return std::nullopt;
    }
    const PrimalDual& point = refined.converged ? refined.point : found.point;
    if (!problem.set_point(point.x)) {
      out_.message = problem.refusal();
      return std::nullopt;
    }
    if (keep == Keep::None && !(times_.branch_margin() > 0.0)) {
      // The least τ of tracks that are no minima between their ends.
      out_.message = "it has run over the edge of its branch";
      back_ = problem.last_on_branch();
      return std::nullopt;
    }
    DesignMinimum minimum;
    minimum.stationary = true;
    minimum.bounds_active = problem.bounds_that_hold(
        refined.converged ? refined.point
                          : with_held_alone(problem, found.point));
    if (refined.converged) minimum.curvatures = refined.curvatures;
    return take(as_coordinates(point.x), std::move(minimum));
  }

  /// \param y  the body that the times have been moved to
  Judged take(const Eigen::VectorXd& y, DesignMinimum minimum) {
    minimum.body = space_->body(y);
    minimum.values = space_->values(y);
    minimum.tau = times_.tau();
    minimum.gradient = space_->slopes(y, times_.gradient());
    const Judged judged = judge(minimum);
    if (judged != Judged::Verified) back_ = y;
    out_.minima.push_back(std::move(minimum));
    return judged;
  }

  /// Why a track needs more grip than there is; empty if it does not.
  [[nodiscard]] std::string lack_of_grip(const Motion& motion) const {
    if (!plan_.max_grip) return {};
    const auto& [mu, after] = *plan_.max_grip;
    if (grip_margin(motion, *plan_.max_grip) >= 0.0) return {};
    return fmt::format(
        "from {:g} % of the time on the least friction coefficient that would "
        "do is {}, and design.max_grip.mu is {:g}",
        100.0 * after,
        grip_in_words(friction_coefficient(motion.friction_angle_after(after))),
        mu);
  }

  /// Solves the track of a minimum anew and says what comes of it.
  Judged judge(DesignMinimum& minimum) {
    Scene built = scene_;
    built.body = minimum.body;
    Solution anew = solve(built, options_until(options_, times_.end()),
                          {.interrupt = interrupt_});
    if (was_stopped(anew.status)) throw Stopped();
    if (!anew.verified()) {
      out_.message = anew.status == Status::Solved
                         ? "its track could not be verified"
                         : fmt::format("solved anew, its track is lost ({})",
                                       name(anew.status));
      minimum.remarks.push_back(out_.message);
      return Judged::Unverified;
    }
    minimum.remarks = anew.infeasible_because();
    if (const std::string lack = lack_of_grip(*anew.motion()); !lack.empty()) {
      minimum.remarks.push_back(lack);
    }
    minimum.feasible = minimum.remarks.empty();
    const double tau = anew.motion()->tau();
    minimum.verified = std::abs(tau / minimum.tau - 1.0) <= kSameTau;
    if (!minimum.verified) {
      out_.message = fmt::format(
          "the search has left the principal branch, on which τ is {:.9g}",
          tau);
      minimum.remarks.push_back(out_.message);
    } else if (!minimum.stationary) {
      minimum.remarks.emplace_back(
          "it is no minimum but the quickest body that a search has passed, "
          "which came to none: near it τ may jump, where branches fold");
    } else if (at_edge_of_branch(minimum)) {
      minimum.remarks.emplace_back(
          "it lies at the edge of its branch: from there on a track is no "
          "minimum between its ends, and beyond, where the branch turns, τ "
          "jumps");
    }
    out_.answer = std::move(anew);
    return minimum.verified ? Judged::Verified : Judged::OnAnotherBranch;
  }

  Scene scene_;
  SolveOptions options_;
  DesignPlan plan_;
  std::unique_ptr<DesignSpace> space_;
  const std::atomic<int>* interrupt_;
  ClosedTimes times_;
  IpoptOptions ipopt_;
  DesignSearch out_;
  /// Where to go on from: the last body on its branch of a run whose branch
  /// ended, or what a run came to that left the principal branch.
  std::optional<Eigen::VectorXd> back_;
  std::optional<Eigen::VectorXd> passed_;  ///< the quickest of the last run
};

}  // namespace

bool at_edge_of_branch(const DesignMinimum& minimum) {
  return std::ranges::any_of(
      minimum.bounds_active,
      [](const BoundOfDesign& held) { return held.name == kBranchMargin; });
}

DesignSearch search_design(const Scene& scene, const SolveOptions& options,
                           const DesignPlan& plan, int start,
                           const std::atomic<int>* interrupt) {
  return Searcher(scene, options, plan, interrupt).search(start);
}

}  // namespace brachisto
