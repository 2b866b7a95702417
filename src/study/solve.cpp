// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/study/solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "brachisto/transcription/initial_guess.hpp"
#include "brachisto/transcription/prolongation.hpp"

namespace brachisto {

namespace {

constexpr int kDefaultDegree = 5;
constexpr int kMaxMeshes = 8;

// A cold start is trusted to have found the principal branch if Newton's method
// went straight to it; anything longer is repeated by continuation in η_m.
constexpr int kTrustedIterations = 10;

// With a fixed mesh and no wanted tolerance, what the coarsest mesh must reach
// for its numbers to mean anything.
constexpr double kCoarsestAgreement = 1e-2;

// What rounding leaves of T, relative: a few ulps from the sum of the integral.
constexpr double kRoundingError = 1e-15;

double seconds_since(StopCondition::Clock::time_point start) {
  return std::chrono::duration<double>(StopCondition::Clock::now() - start)
      .count();
}

/// Turns of the body on its way, as far as the cycloid tells; each turn makes
/// the track go up and down once. Zero if turning has no influence.
double estimated_turns(const Scene& scene, const CycloidArc& arc) {
  if (!scene.body.off_centred()) return 0.0;
  return arc.arc_length(arc.psi_end) /
         (2.0 * std::numbers::pi * scene.body.radius);
}

/// Elements of degree p for a relative error ε of T. With degree 5 and 12
/// elements a turn the cases of the paper reach about 1e-10; the error falls
/// like N^(−2p).
int initial_elements(double turns, int degree, double tolerance) {
  const double per_turn = 12.0 * (5.0 / degree);
  const double refinement = std::pow(1e-10 / tolerance, 0.5 / degree);
  const double count = std::max(8.0, per_turn * (turns + 0.5)) * refinement;
  return std::max(4, static_cast<int>(std::ceil(count)));
}

/// One solve: its parts share the scene, the budget and the protocol.
class Run {
 public:
  Run(const Scene& scene, const SolveOptions& options, const SolveHooks& hooks)
      : natural_(in_natural_units(scene)),
        units_(natural_units(scene)),
        start_time_(StopCondition::Clock::now()),
        options_(options) {
    solution_.scene = scene;
    solution_.options = options;
    mesh_options_.ipopt.tolerance = options.tolerance;
    mesh_options_.ipopt.verbose = hooks.verbose;
    mesh_options_.ipopt.stop =
        StopCondition(options.limits.seconds, hooks.interrupt);
  }

  Solution execute() {
    find();
    solution_.effort.seconds = seconds_since(start_time_);
    return std::move(solution_);
  }

 private:
  void find();
  bool start_cold(const CycloidArc& arc, const Mesh& mesh);
  bool continue_in_eta(const CycloidArc& arc, const Mesh& mesh);
  bool solve_from(const MeshStart& start);
  void refine(int degree, double tolerance);
  void check();
  void report();

  /// Books a solve; false if it failed.
  bool book(const MeshSolution& solution);
  [[nodiscard]] MeshOptions budget() const;
  [[nodiscard]] ExtremalCurve curve() const {
    return ExtremalCurve(*problem_, found_.point);
  }

  Scene natural_;
  Units units_;
  StopCondition::Clock::time_point start_time_;
  SolveOptions options_;
  MeshOptions mesh_options_;
  Solution solution_;
  std::optional<RollingTime> problem_;
  MeshSolution found_;  ///< on problem_'s mesh
};

MeshOptions Run::budget() const {
  MeshOptions options = mesh_options_;
  options.ipopt.max_iterations =
      std::max(0, options_.limits.iterations - solution_.effort.iterations);
  return options;
}

bool Run::book(const MeshSolution& solution) {
  solution_.effort.iterations += solution.iterations;
  solution_.effort.passes += solution.closure.passes;
  solution_.log += solution.log;
  solution_.status = solution.status;
  solution_.message = solution.message;
  return solution.solved();
}

bool Run::start_cold(const CycloidArc& arc, const Mesh& mesh) {
  const double phi = arc.slope_angle(arc.psi_end);
  problem_.emplace(natural_, mesh, phi);
  const PrimalDual guess = options_.guess == Guess::Straight
                               ? straight_guess(*problem_)
                               : cycloid_guess(*problem_, arc);
  found_ = solve_on_mesh(*problem_, {guess, phi}, budget());
  const bool straight_to_it = found_.first_iterations <= kTrustedIterations &&
                              found_.refused_points == 0;
  return book(found_) && (straight_to_it || !natural_.body.off_centred());
}

bool Run::solve_from(const MeshStart& start) {
  found_ = solve_on_mesh(*problem_, start, budget());
  return book(found_);
}

bool Run::continue_in_eta(const CycloidArc& arc, const Mesh& mesh) {
  // Coarse, since it only has to tell branches apart.
  const int elements =
      initial_elements(estimated_turns(natural_, arc), kDefaultDegree, 1e-6);
  Continuation path = continue_from_cycloid(
      natural_, arc, uniform_mesh(kDefaultDegree, elements), budget());
  solution_.effort.iterations += path.iterations;
  solution_.effort.passes += path.passes;
  solution_.effort.continuation = path.steps;
  solution_.log += path.log;
  solution_.status = path.status;
  solution_.message = path.message;
  if (!path.curve) return false;
  problem_.emplace(natural_, mesh, path.phi);
  return solve_from(
      {prolong(*path.curve, *problem_), path.phi, path.closure_slope});
}

/// Solves the same scene with degree p + 1 and compares.
void Run::check() {
  const auto begin = StopCondition::Clock::now();
  const ExtremalCurve coarse = curve();
  Mesh mesh = coarse.mesh();
  mesh.degree += 1;
  RollingTime finer(natural_, mesh, found_.closure.phi);
  const MeshSolution solution = solve_on_mesh(
      finer, {prolong(coarse, finer), found_.closure.phi, found_.closure.slope},
      budget());
  solution_.effort.iterations += solution.iterations;
  solution_.effort.passes += solution.closure.passes;
  solution_.log += solution.log;
  if (solution.solved()) {
    const ExtremalCurve fine(finer, solution.point);
    const double T = coarse.transit_time();
    const double open_contact = std::abs(found_.closure.mismatch) *
                                natural_.body.radius * coarse.transit_time() /
                                std::max(coarse.arc_length(), 1e-300);
    solution_.estimated_error =
        (std::abs(fine.transit_time() - T) + open_contact) / T + kRoundingError;
  } else {
    solution_.estimated_error.reset();
    if (solution.status == Status::Interrupted ||
        solution.status == Status::TimeLimit ||
        solution.status == Status::IterationLimit) {
      solution_.status = solution.status;
      solution_.message =
          "while checking with degree p + 1: " + solution.message;
    }
  }
  solution_.effort.check_seconds += seconds_since(begin);
}

/// Refines the mesh until the check agrees to the tolerance.
void Run::refine(int degree, double tolerance) {
  for (int meshes = 1; meshes < kMaxMeshes; ++meshes) {
    if (solution_.status != Status::Solved) return;
    double factor = 2.0;
    if (solution_.estimated_error) {
      if (*solution_.estimated_error <= tolerance) return;
      factor = std::clamp(
          1.1 * std::pow(*solution_.estimated_error / tolerance, 0.5 / degree),
          1.25, 2.5);
    }
    const ExtremalCurve coarse = curve();
    const int elements =
        static_cast<int>(std::ceil(factor * coarse.mesh().num_elements()));
    problem_.emplace(natural_, uniform_mesh(degree, elements),
                     found_.closure.phi);
    if (!solve_from({prolong(coarse, *problem_), found_.closure.phi,
                     found_.closure.slope})) {
      return;
    }
    check();
  }
}

void Run::find() {
  const std::optional<CycloidArc> arc = axisymmetric_optimum(natural_);
  if (!arc) {
    solution_.status = Status::NoAdmissiblePath;
    solution_.message = fmt::format(
        "the centre would have to end above its start: with r = {:g} ≥ H = "
        "{:g} "
        "a smooth contact at B needs L > r + √(r² − H²) = {:g}, but L = {:g}. "
        "Try a smaller radius or a point B further away",
        solution_.scene.body.radius, solution_.scene.H,
        units_.length * (natural_.body.radius +
                         std::sqrt((natural_.body.radius - natural_.H) *
                                   (natural_.body.radius + natural_.H))),
        solution_.scene.L);
    return;
  }

  const Discretisation& wanted = options_.discretisation;
  const int degree = wanted.degree.value_or(kDefaultDegree);
  const double tolerance = wanted.tolerance.value_or(kDefaultTolerance);
  int elements =
      initial_elements(estimated_turns(natural_, *arc), degree, tolerance);
  if (wanted.elements) elements = *wanted.elements;
  if (wanted.nodes) elements = (*wanted.nodes - 1) / degree;
  const Mesh mesh = uniform_mesh(degree, elements);

  if (!start_cold(*arc, mesh)) {
    const bool stopped = mesh_options_.ipopt.stop.met() ||
                         solution_.status == Status::IterationLimit;
    if (stopped || !natural_.body.off_centred()) return;
    if (!continue_in_eta(*arc, mesh)) return;
  }
  check();
  if (!wanted.fixed()) refine(degree, tolerance);
  if (solution_.status == Status::Solved) report();
}

void Run::report() {
  solution_.nodes = problem_->mesh().num_nodes();
  solution_.variables = problem_->num_variables();
  solution_.constraints = problem_->num_constraints();
  solution_.effort.first_iterations = found_.first_iterations;
  solution_.effort.closure_passes = found_.closure.passes;
  solution_.trajectory.emplace(curve(), solution_.scene, units_);
  solution_.diagnostics = solution_.trajectory->diagnose();

  const auto begin = StopCondition::Clock::now();
  solution_.certificate = certify(*problem_, found_.point, found_.closure.phi);
  const Discretisation& wanted = options_.discretisation;
  double threshold = wanted.tolerance.value_or(kDefaultTolerance);
  if (wanted.fixed() && !wanted.tolerance) threshold = kCoarsestAgreement;
  solution_.certificate.add(
      "agreement",
      solution_.estimated_error.value_or(
          std::numeric_limits<double>::quiet_NaN()),
      threshold,
      fmt::format("degree {} against {} on {} elements",
                  problem_->mesh().degree, problem_->mesh().degree + 1,
                  problem_->mesh().num_elements()));
  solution_.effort.check_seconds += seconds_since(begin);
}

}  // namespace

std::vector<std::string> Solution::infeasible_because() const {
  std::vector<std::string> reasons;
  if (!diagnostics || !scene.body.rolls()) return reasons;
  const Extreme& force = diagnostics->min_normal_force;
  if (!(force.value > 0.0)) {
    reasons.push_back(
        fmt::format("the body would lift off: R_n = {:.4g} m g at x_b = {:.4g}",
                    force.value, force.x));
  }
  const Extreme& margin = diagnostics->min_fold_margin;
  if (!(margin.value > 0.0)) {
    reasons.push_back(
        fmt::format("the track folds: 1 − r κ_c = {:.4g} at x_b = {:.4g}",
                    margin.value, margin.x));
  }
  return reasons;
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
  return Run(scene, options, hooks).execute();
}

}  // namespace brachisto
