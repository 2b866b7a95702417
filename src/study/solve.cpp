// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/study/solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "brachisto/study/extremal_bridge.hpp"
#include "brachisto/study/global_search.hpp"
#include "brachisto/trajectory/feasibility.hpp"
#include "brachisto/transcription/initial_guess.hpp"

namespace brachisto {

namespace {

// The continuation only has to tell branches apart; degree 5 with this many
// elements per turn of the body keeps its τ right to six digits or so.
constexpr int kCoarseDegree = 5;
constexpr double kCoarseElementsPerTurn = 7.0;
constexpr int kFewestCoarseElements = 8;
// Where an extremal is sampled instead of solved for, there have to be enough
// elements to represent it.
constexpr double kSampledElementsPerTurn = 12.0;
constexpr double kFineElementsPerTurn = 16.0;

double seconds_since(StopCondition::Clock::time_point start) {
  return std::chrono::duration<double>(StopCondition::Clock::now() - start)
      .count();
}

/// Turns of the body along a path of its centre of length s. Each makes the
/// track go up and down once; none matter to a body that is not off-centred.
double turns(const Body& body, double s) {
  return body.off_centred() ? s / (2.0 * std::numbers::pi * body.radius) : 0.0;
}

/// Elements for so many turns, the half turn for the stretch at the start.
int elements_for(double turns, double per_turn) {
  return std::max(kFewestCoarseElements,
                  static_cast<int>(std::ceil(per_turn * (turns + 0.5))));
}

Mesh coarse_mesh(const Scene& scene, const CycloidArc& arc) {
  return uniform_mesh(
      kCoarseDegree,
      elements_for(turns(scene.body, arc.arc_length(arc.psi_end)),
                   kCoarseElementsPerTurn));
}

std::string no_cycloid(const Scene& scene) {
  return fmt::format(
      "B lies inside the uniform cylinder at its start, (L − r)² + H² ≤ r² "
      "with "
      "r = {:g}, L = {:g}, H = {:g}: that body has no path to B, and so the "
      "principal branch, which starts from it, does not exist. Try a smaller "
      "radius or a point B further away",
      scene.body.radius, scene.L, scene.H);
}

/// True if all checks that failed are of the kind that a finer mesh mends.
bool under_resolved(const Certificate& certificate) {
  constexpr std::array kMendable{"hamiltonian", "slope", "start_angle",
                                 "energy_drift", "reintegration_error"};
  return !certificate.verified() &&
         std::all_of(certificate.checks.begin(), certificate.checks.end(),
                     [&](const Check& check) {
                       return check.passed ||
                              std::find(kMendable.begin(), kMendable.end(),
                                        check.name) != kMendable.end();
                     });
}

/// True if the answer is the end of one branch that is followed.
bool follows_the_branch(const SolveOptions& options) {
  return options.method == Method::Ipopt &&
         options.search == Search::Principal && options.guess == Guess::Cycloid;
}

/// One solve: its parts share the scene, the budget and the protocol.
class Run {
 public:
  Run(const Scene& scene, const SolveOptions& options, const SolveHooks& hooks)
      : scene_(scene),
        natural_(in_natural_units(scene)),
        units_(natural_units(scene)),
        options_(options),
        start_time_(StopCondition::Clock::now()) {
    mesh_options_.ipopt.tolerance = options.tolerance;
    mesh_options_.ipopt.verbose = hooks.verbose;
    mesh_options_.ipopt.stop =
        StopCondition(options.limits.seconds, hooks.interrupt);
    mesh_options_.polish = options.polish;
    out_.scene = scene;
    out_.options = options;
  }

  /// \param neighbour  where to begin; nullptr: with the cycloid
  Solution execute(const Neighbour* neighbour) {
    if (neighbour != nullptr) {
      find_beside(*neighbour);
    } else {
      find();
    }
    if (stop().met() && out_.status != Status::IterationLimit) {
      out_.status =
          stop().interrupted() ? Status::Interrupted : Status::TimeLimit;
      out_.message =
          stop().interrupted()
              ? "stopped by a signal before the end"
              : fmt::format("the limit of {:g} s was reached",
                            options_.limits.seconds);
      out_.trajectory.reset();
    }
    out_.effort.seconds = seconds_since(start_time_);
    return std::move(out_);
  }

 private:
  void find();
  void find_beside(const Neighbour& neighbour);
  void find_fastest(const CycloidArc& arc, const Continuation& principal);
  void find_by_shooting();
  void follow_folds(Continuation& principal);
  void try_other_start(const CycloidArc& arc, const Continuation& principal);
  void answer_from(const Continuation& start);
  void report(MeshAnswer& answer);
  void book(const Refinement& refinement);
  [[nodiscard]] ExtremalSolution shoot(double tolerance);

  [[nodiscard]] const StopCondition& stop() const {
    return mesh_options_.ipopt.stop;
  }
  [[nodiscard]] MeshOptions budget() const;

  Scene scene_, natural_;
  Units units_;
  SolveOptions options_;
  StopCondition::Clock::time_point start_time_;
  MeshOptions mesh_options_;
  Solution out_;
};

MeshOptions Run::budget() const {
  MeshOptions options = mesh_options_;
  options.ipopt.max_iterations =
      std::max(0, options_.limits.iterations - out_.effort.iterations);
  return options;
}

void Run::book(const Refinement& refinement) {
  Effort& effort = out_.effort;
  for (const MeshRecord& mesh : refinement.meshes) {
    effort.iterations += mesh.iterations;
    effort.passes += mesh.passes;
    effort.newton_steps += mesh.newton_steps;
    effort.first_iterations = mesh.first_iterations;
    effort.closure_passes = mesh.passes;
    effort.meshes.push_back(mesh);
  }
  out_.log += refinement.log;
  out_.status = refinement.status;
  out_.message = refinement.message;
}

void Run::report(MeshAnswer& answer) {
  out_.status = Status::Solved;
  out_.message = answer.solution.message;
  out_.estimated_error = answer.estimated_error;
  out_.nodes = answer.problem.mesh().num_nodes();
  out_.variables = answer.problem.num_variables();
  out_.constraints = answer.problem.num_constraints();
  out_.trajectory.emplace(answer.curve(), scene_, units_);
  out_.diagnostics = out_.trajectory->diagnose();
  // What lies beyond a fold is not what neighbours continue from the cycloid.
  if (out_.folds.empty() && follows_the_branch(options_)) {
    out_.as_neighbour = {scene_, answer.problem.mesh(), answer.solution.point,
                         answer.solution.closure.phi};
  }
  const auto begin = StopCondition::Clock::now();
  out_.certificate = certify_answer(answer, options_.discretisation);
  if (options_.certify == Certify::Extremal) {
    out_.extremal =
        ask_extremal(scene_, answer, options_.limits.seconds, out_.certificate);
  }
  out_.effort.certificate_seconds += seconds_since(begin);
}

/// Runs the solver from the start that was asked for and says where it led. The
/// principal branch stays the answer.
void Run::try_other_start(const CycloidArc& arc,
                          const Continuation& principal) {
  const ExtremalCurve& known = *principal.curve;
  RollingTime problem(natural_, known.mesh(), principal.phi);
  const PrimalDual guess = options_.guess == Guess::Straight
                               ? straight_guess(problem)
                               : random_guess(problem, arc, options_.seed);
  // Lost in nowhere it must not use up what the answer needs.
  MeshOptions half = budget();
  half.ipopt.max_iterations /= 2;
  const MeshSolution found =
      solve_on_mesh(problem, {guess, principal.phi, -1.0}, half);
  out_.effort.iterations += found.iterations;
  out_.effort.passes += found.closure.passes;
  out_.log += found.log;
  ColdStart cold;
  cold.status = found.status;
  if (found.solved()) {
    const ExtremalCurve curve(problem, found.point);
    cold.tau = Trajectory(curve, scene_, units_).tau();
    // On the same mesh the same extremal has the same T, to the tolerance of
    // the continuation.
    cold.principal =
        std::abs(curve.transit_time() / known.transit_time() - 1.0) < 1e-6;
  }
  out_.cold_start = cold;
}

void Run::find_fastest(const CycloidArc& arc, const Continuation& principal) {
  std::vector<ContactCandidate> known;
  if (principal.curve) known.push_back({*principal.curve, principal.phi});
  const bool has_principal = !known.empty();
  const std::vector<ContactCandidate> candidates = find_contacts(
      natural_, arc, coarse_mesh(natural_, arc), std::move(known), stop());
  std::vector<JudgedBranch> branches = judge_branches(
      scene_, options_.discretisation, candidates, has_principal, budget());
  for (const JudgedBranch& one : branches) out_.branches.push_back(one.branch);
  if (JudgedBranch* best = best_branch(branches)) {
    book(best->refinement);
    report(*best->refinement.answer);
  } else {
    out_.status = Status::NotConverged;
    out_.message = "the search over φ found no smooth contact";
  }
}

ExtremalSolution Run::shoot(double tolerance) {
  ExtremalOptions options;
  options.follow_folds = true;
  options.tolerance = tolerance;
  options.max_seconds = options_.limits.seconds;
  ExtremalSolution extremal = solve_extremal(scene_, options);
  out_.effort.newton_steps += extremal.newton_steps;
  if (extremal.solved()) out_.folds = extremal.continuation.folds;
  return extremal;
}

/// Where the short continuation is stuck, pseudo-arclength continuation of the
/// indirect method goes on: through folds, and past near meetings of branches.
void Run::follow_folds(Continuation& principal) {
  constexpr double kEnoughToStartFrom = 1e-10;
  const ExtremalSolution extremal = shoot(kEnoughToStartFrom);
  if (!extremal.solved()) {
    out_.message += ". By shooting: " + extremal.message;
    return;
  }
  const double length = extremal.centre_path_length / units_.length;
  const RollingTime problem(
      natural_,
      uniform_mesh(kCoarseDegree, elements_for(turns(natural_.body, length),
                                               kSampledElementsPerTurn)),
      extremal.phi);
  principal.curve.emplace(problem, sample_extremal(extremal, units_, problem));
  principal.phi = extremal.phi;
}

/// Method::Extremal: the numbers come from the indirect method; the collocation
/// problem on a fine mesh, which they must satisfy, is their certificate.
void Run::find_by_shooting() {
  const ExtremalSolution extremal = shoot(ExtremalOptions{}.tolerance);
  if (!extremal.solved()) {
    out_.status =
        extremal.status == ExtremalStatus::NoCycloid ? Status::NoAdmissiblePath
        : extremal.status == ExtremalStatus::TimeLimit ? Status::TimeLimit
                                                       : Status::NotConverged;
    out_.message = extremal.message;
    return;
  }
  const double length = extremal.centre_path_length / units_.length;
  const Mesh mesh = uniform_mesh(
      kMaxDegree,
      elements_for(turns(natural_.body, length), kFineElementsPerTurn));
  MeshAnswer answer{
      RollingTime(natural_, mesh, extremal.phi), {}, {}, {}, extremal.phi};
  answer.solution.status = Status::Solved;
  answer.solution.message = extremal.message;
  answer.solution.point = sample_extremal(extremal, units_, answer.problem);
  answer.solution.closure.phi = extremal.phi;
  answer.solution.closure.closed = true;
  const double T = answer.curve().transit_time() * units_.time;
  answer.estimated_error =
      std::abs(T / extremal.transit_time - 1.0) + extremal.error_estimate;
  report(answer);
}

void Run::find() {
  if (options_.method == Method::Extremal) return find_by_shooting();
  const std::optional<CycloidArc> arc = axisymmetric_optimum(natural_);
  if (!arc) {
    out_.status = Status::NoAdmissiblePath;
    out_.message = no_cycloid(scene_);
    return;
  }
  Continuation principal = continue_from_cycloid(
      natural_, *arc, coarse_mesh(natural_, *arc), stop());
  out_.effort.newton_steps += principal.newton_steps;
  out_.effort.continuation = principal.steps;
  out_.status = principal.status;
  out_.message = principal.message;
  if (!principal.curve && !stop().met()) follow_folds(principal);
  if (stop().met()) return;
  if (options_.search == Search::Global &&
      natural_.contact == Contact::Smooth) {
    return find_fastest(*arc, principal);
  }
  if (!principal.curve) {
    out_.message += ". Try search: global, which looks for other extremals";
    return;
  }
  if (options_.guess != Guess::Cycloid) try_other_start(*arc, principal);
  answer_from(principal);
}

void Run::find_beside(const Neighbour& neighbour) {
  const Continuation found =
      continue_from_neighbour(natural_, neighbour, stop());
  out_.effort.newton_steps += found.newton_steps;
  out_.effort.continuation = found.steps;
  out_.status = found.status;
  out_.message = found.message;
  if (found.curve) answer_from(found);
}

/// Refines until T is as accurate as wanted and, where the path bends sharply,
/// until it is resolved between the nodes too.
void Run::answer_from(const Continuation& start) {
  constexpr int kRounds = 3;
  constexpr double kTighter = 1e-2;
  Discretisation wanted = options_.discretisation;
  ExtremalCurve curve = *start.curve;
  double phi = start.phi;
  for (int round = 0; round < kRounds; ++round) {
    Refinement refinement = refine(natural_, wanted, curve, phi, budget());
    book(refinement);
    if (!refinement.answer || stop().met()) return;
    // A better answer than the best one was still wanted.
    if (refinement.status == Status::IterationLimit) return;
    report(*refinement.answer);
    if (wanted.fixed() || !under_resolved(out_.certificate)) return;
    curve = refinement.answer->curve();
    phi = refinement.answer->solution.closure.phi;
    wanted.tolerance = kTighter * wanted.tolerance.value_or(kDefaultTolerance);
  }
}

}  // namespace

std::vector<std::string> Solution::infeasible_because() const {
  if (!diagnostics) return {};
  return brachisto::infeasible_because(scene, *diagnostics);
}

Solution solve(const Scene& scene, const SolveOptions& options,
               const SolveHooks& hooks) {
  const std::vector<SceneError> errors = validate(scene);
  if (!errors.empty()) {
    std::string text = "the scene is not valid:";
    for (const SceneError& error : errors) {
      text += fmt::format("\n  {}: {}", error.key, error.message);
    }
    throw std::invalid_argument(text);
  }
  if (hooks.neighbour != nullptr && comparable(scene, hooks.neighbour->scene) &&
      follows_the_branch(options)) {
    Solution beside = Run(scene, options, hooks).execute(hooks.neighbour);
    if (beside.verified()) return beside;
  }
  return Run(scene, options, hooks).execute(nullptr);
}

}  // namespace brachisto
