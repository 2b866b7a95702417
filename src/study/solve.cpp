// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/study/solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "brachisto/study/extremal_bridge.hpp"
#include "brachisto/study/global_search.hpp"
#include "brachisto/transcription/element_errors.hpp"
#include "brachisto/transcription/equidistribution.hpp"
#include "brachisto/transcription/initial_guess.hpp"
#include "brachisto/transcription/prolongation.hpp"

namespace brachisto {

namespace {

constexpr int kMaxMeshes = 12;
constexpr int kFixedMeshDegree = 5;

// The continuation only has to tell branches apart; degree 5 with eight
// elements per turn of the body keeps its τ right to six digits or so.
constexpr int kCoarseDegree = 5;
constexpr double kCoarseElementsPerTurn = 7.0;
constexpr int kFewestCoarseElements = 8;

// With a fixed mesh and no wanted tolerance, what the coarsest mesh must reach
// for its numbers to mean anything.
constexpr double kCoarsestAgreement = 1e-2;

double seconds_since(StopCondition::Clock::time_point start) {
  return std::chrono::duration<double>(StopCondition::Clock::now() - start)
      .count();
}

/// The mesh of the continuation: so many elements for each turn of the body,
/// which makes the track go up and down once.
Mesh coarse_mesh(const Scene& scene, const CycloidArc& arc) {
  double turns = 0.0;
  if (scene.body.off_centred()) {
    turns = arc.arc_length(arc.psi_end) /
            (2.0 * std::numbers::pi * scene.body.radius);
  }
  const double wanted = kCoarseElementsPerTurn * (turns + 0.5);
  return uniform_mesh(
      kCoarseDegree,
      std::max(kFewestCoarseElements, static_cast<int>(std::ceil(wanted))));
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

  Solution execute() {
    find();
    out_.effort.seconds = seconds_since(start_time_);
    return std::move(out_);
  }

 private:
  void find();
  void find_fastest(const CycloidArc& arc, const Continuation& principal);
  void solve_by_shooting();
  void follow_folds(Continuation& principal);
  void try_other_start(const CycloidArc& arc, const Continuation& principal);
  [[nodiscard]] std::optional<MeshAnswer> refine(const ExtremalCurve& curve,
                                                 double phi);
  [[nodiscard]] Branch judge(MeshAnswer& answer);
  void report(MeshAnswer& answer);
  void ask_extremal(const MeshAnswer& answer);

  [[nodiscard]] double wanted_tolerance() const {
    return options_.discretisation.tolerance.value_or(kDefaultTolerance);
  }
  [[nodiscard]] const StopCondition& stop() const {
    return mesh_options_.ipopt.stop;
  }
  [[nodiscard]] MeshOptions budget() const;
  void book(const MeshAnswer& answer);
  [[nodiscard]] Certificate certificate(MeshAnswer& answer) const;

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

void Run::book(const MeshAnswer& answer) {
  const MeshSolution& solution = answer.solution;
  Effort& effort = out_.effort;
  effort.iterations += solution.iterations;
  effort.passes += solution.closure.passes;
  effort.newton_steps += solution.polish.newton_steps;
  effort.first_iterations = solution.first_iterations;
  effort.closure_passes = solution.closure.passes;
  effort.meshes.push_back({answer.problem.mesh().degree,
                           answer.problem.mesh().num_elements(),
                           answer.estimated_error, solution.closure.passes,
                           solution.iterations, solution.polish.newton_steps});
  out_.log += solution.log;
  out_.status = solution.status;
  out_.message = solution.message;
}

/// Solves on the fixed mesh, or on meshes that follow the tolerance, each from
/// the solution of the one before.
std::optional<MeshAnswer> Run::refine(const ExtremalCurve& curve, double phi) {
  const Discretisation& wanted = options_.discretisation;
  if (wanted.fixed()) {
    const int degree = wanted.degree.value_or(kFixedMeshDegree);
    const int elements =
        wanted.elements ? *wanted.elements : (*wanted.nodes - 1) / degree;
    MeshAnswer answer = answer_on_mesh(natural_, uniform_mesh(degree, elements),
                                       curve, phi, budget());
    book(answer);
    if (!answer.solution.solved()) return std::nullopt;
    return answer;
  }

  const double tolerance = wanted_tolerance();
  // From the coarse curve's own error, carried over to the wanted degree.
  const int degree = wanted.degree.value_or(starting_degree(tolerance));
  Mesh mesh = equidistribute(curve.mesh(), element_errors(curve),
                             0.1 * tolerance * curve.transit_time());
  mesh.degree = degree;
  if (degree != curve.mesh().degree) {
    // Elements of another degree are as good if they have as many unknowns.
    const double ratio = static_cast<double>(curve.mesh().degree) / degree;
    mesh = stretch(
        mesh,
        std::max(4, static_cast<int>(std::ceil(ratio * mesh.num_elements()))));
  }
  std::optional<MeshAnswer> best;
  ExtremalCurve from = curve;
  double from_phi = phi;
  for (int i = 0; i < kMaxMeshes; ++i) {
    MeshAnswer answer =
        answer_on_mesh(natural_, mesh, from, from_phi, budget());
    book(answer);
    if (!answer.solution.solved()) return std::nullopt;
    if (stop().met()) break;
    const bool improved = !best ||
                          (answer.estimated_error &&
                           answer.estimated_error < best->estimated_error) ||
                          !best->estimated_error;
    if (improved) best.emplace(std::move(answer));
    if (best->estimated_error && *best->estimated_error <= tolerance) break;
    // Rounding has the last word: finer meshes only get worse.
    if (!improved) break;
    mesh = next_mesh(*best, tolerance, wanted.degree.has_value());
    if (best->finer) {
      from = *best->finer;
      from_phi = best->finer_phi;
    } else {
      from = best->curve();
      from_phi = best->solution.closure.phi;
    }
  }
  return best;
}

Certificate Run::certificate(MeshAnswer& answer) const {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Discretisation& wanted = options_.discretisation;
  double threshold = wanted_tolerance();
  if (wanted.fixed() && !wanted.tolerance) threshold = kCoarsestAgreement;
  const double estimated = answer.estimated_error.value_or(nan);
  // A mesh that missed the tolerance is judged by what it reached.
  const double error = wanted.fixed() && !wanted.tolerance
                           ? estimated
                           : std::max(wanted_tolerance(), estimated);
  Certificate result = certify(answer.problem, answer.solution.point,
                               answer.solution.closure.phi, error);
  const Mesh& mesh = answer.problem.mesh();
  result.add("agreement", estimated, threshold,
             fmt::format("degree {} against {} on {} elements", mesh.degree,
                         mesh.degree + 1, mesh.num_elements()));
  return result;
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
  const auto begin = StopCondition::Clock::now();
  out_.certificate = certificate(answer);
  if (options_.certify == Certify::Extremal) ask_extremal(answer);
  out_.effort.certificate_seconds += seconds_since(begin);
}

void Run::ask_extremal(const MeshAnswer& answer) {
  const ExtremalCurve curve = answer.curve();
  ExtremalOptions options;
  options.max_seconds = options_.limits.seconds;
  const ExtremalSolution other = solve_extremal(
      scene_, as_guess(curve, units_, answer.solution.closure.phi), options);
  ExtremalOpinion opinion;
  opinion.solved = other.solved();
  opinion.message = other.message;
  double difference = std::numeric_limits<double>::quiet_NaN();
  if (other.solved()) {
    opinion.tau = other.tau;
    opinion.error_estimate = other.error_estimate;
    difference = std::abs(out_.trajectory->tau() - other.tau) / other.tau;
    opinion.difference = difference;
  }
  // Two right answers differ by no more than both their errors.
  out_.certificate.add(
      "extremal", difference,
      answer.estimated_error.value_or(0.0) + opinion.error_estimate,
      other.message);
  out_.extremal = opinion;
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
  const MeshSolution found =
      solve_on_mesh(problem, {guess, principal.phi, -1.0}, budget());
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

Branch Run::judge(MeshAnswer& answer) {
  const Trajectory trajectory(answer.curve(), scene_, units_);
  const Certificate checks = certificate(answer);
  Solution judged;
  judged.scene = scene_;
  judged.diagnostics = trajectory.diagnose();
  Branch branch;
  branch.tau = trajectory.tau();
  branch.estimated_error =
      answer.estimated_error.value_or(std::numeric_limits<double>::quiet_NaN());
  branch.end_angle = trajectory.end_angle();
  branch.centre_path_length = trajectory.centre_path_length();
  branch.verified = checks.verified();
  const Check* second_order = checks.find("second_order");
  branch.minimum = second_order != nullptr && second_order->passed;
  branch.remarks = judged.infeasible_because();
  branch.feasible = branch.remarks.empty();
  for (const Check& check : checks.checks) {
    if (!check.passed) branch.remarks.push_back("failed check " + check.name);
  }
  return branch;
}

void Run::find_fastest(const CycloidArc& arc, const Continuation& principal) {
  std::vector<ContactCandidate> known;
  if (principal.curve) known.push_back({*principal.curve, principal.phi});
  const std::vector<ContactCandidate> candidates = find_contacts(
      natural_, arc, coarse_mesh(natural_, arc), std::move(known), stop());
  struct Judged {
    Branch branch;
    MeshAnswer answer;
  };
  std::vector<Judged> judged;
  for (std::size_t i = 0; i < candidates.size() && !stop().met(); ++i) {
    std::optional<MeshAnswer> answer =
        refine(candidates[i].curve, candidates[i].phi);
    if (!answer) continue;
    Branch branch = judge(*answer);
    branch.principal = i == 0 && principal.curve.has_value();
    // Candidates that refinement led to one and the same extremal count once.
    const bool again =
        std::any_of(judged.begin(), judged.end(), [&](const Judged& other) {
          return std::abs(other.branch.tau / branch.tau - 1.0) < 1e-7 &&
                 std::abs(other.branch.end_angle - branch.end_angle) < 1e-6;
        });
    if (!again) judged.push_back({std::move(branch), std::move(*answer)});
  }
  std::stable_sort(judged.begin(), judged.end(),
                   [](const Judged& a, const Judged& b) {
                     return a.branch.tau < b.branch.tau;
                   });
  for (const Judged& one : judged) out_.branches.push_back(one.branch);
  if (stop().met()) {
    out_.status =
        stop().interrupted() ? Status::Interrupted : Status::TimeLimit;
    return;
  }
  const auto fastest =
      std::find_if(judged.begin(), judged.end(), [](const Judged& one) {
        return one.branch.verified && one.branch.feasible;
      });
  if (fastest != judged.end()) {
    report(fastest->answer);
  } else if (!judged.empty()) {
    report(judged.front().answer);
  } else {
    out_.status = Status::NotConverged;
    out_.message = "the search over φ found no smooth contact";
  }
}

/// Method::Extremal: the numbers come from the indirect method; the collocation
/// problem on a fine mesh, which they must satisfy, is their certificate.
void Run::solve_by_shooting() {
  ExtremalOptions options;
  options.max_seconds = options_.limits.seconds;
  options.follow_folds = true;
  const ExtremalSolution extremal = solve_extremal(scene_, options);
  out_.folds = extremal.continuation.folds;
  out_.effort.newton_steps = extremal.newton_steps;
  if (!extremal.solved()) {
    out_.status =
        extremal.status == ExtremalStatus::NoCycloid ? Status::NoAdmissiblePath
        : extremal.status == ExtremalStatus::TimeLimit ? Status::TimeLimit
                                                       : Status::NotConverged;
    out_.message = extremal.message;
    return;
  }
  constexpr int kElementsPerTurn = 16;
  const double turns =
      natural_.body.off_centred()
          ? std::abs(extremal.rotation) / (2.0 * std::numbers::pi)
          : 0.0;
  const Mesh mesh = uniform_mesh(
      kMaxDegree,
      static_cast<int>(std::ceil(kElementsPerTurn * (turns + 1.0))));
  MeshAnswer answer{
      RollingTime(natural_, mesh, extremal.phi), {}, {}, {}, extremal.phi};
  answer.solution.status = Status::Solved;
  answer.solution.message = extremal.message;
  answer.solution.point = sample_extremal(extremal, units_, answer.problem);
  answer.solution.closure.phi = extremal.phi;
  answer.solution.closure.closed = true;
  const double T = answer.curve().transit_time() * units_.time;
  answer.estimated_error =
      std::abs(T - extremal.transit_time) / extremal.transit_time +
      extremal.error_estimate;
  report(answer);
}

/// Where the short continuation is stuck, pseudo-arclength continuation of the
/// indirect method goes on: through folds, and past near meetings of branches.
void Run::follow_folds(Continuation& principal) {
  ExtremalOptions options;
  options.follow_folds = true;
  options.tolerance = 1e-10;
  options.max_seconds = options_.limits.seconds;
  const ExtremalSolution extremal = solve_extremal(scene_, options);
  out_.effort.newton_steps += extremal.newton_steps;
  if (!extremal.solved()) {
    out_.message += ". By shooting: " + extremal.message;
    return;
  }
  out_.folds = extremal.continuation.folds;
  const double turns = std::abs(extremal.rotation) / (2.0 * std::numbers::pi);
  constexpr double kElementsPerTurn = 12.0;
  const Mesh mesh = uniform_mesh(
      kCoarseDegree,
      static_cast<int>(std::ceil(kElementsPerTurn * (turns + 0.5))));
  const RollingTime problem(natural_, mesh, extremal.phi);
  principal.curve.emplace(problem, sample_extremal(extremal, units_, problem));
  principal.phi = extremal.phi;
}

void Run::find() {
  if (options_.method == Method::Extremal) return solve_by_shooting();
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
  const bool global =
      options_.search == Search::Global && natural_.contact == Contact::Smooth;
  if (!principal.curve && !stop().met()) follow_folds(principal);
  if (stop().met()) return;
  if (global) return find_fastest(*arc, principal);
  if (!principal.curve) {
    out_.message += ". Try search: global, which looks for other extremals";
    return;
  }
  if (options_.guess != Guess::Cycloid) try_other_start(*arc, principal);
  std::optional<MeshAnswer> answer = refine(*principal.curve, principal.phi);
  if (answer && !stop().met()) report(*answer);
  if (stop().met()) {
    out_.status =
        stop().interrupted() ? Status::Interrupted : Status::TimeLimit;
  }
}

}  // namespace

std::vector<std::string> Solution::infeasible_because() const {
  std::vector<std::string> reasons;
  if (!diagnostics || !scene.body.rolls()) return reasons;
  if (scene.contact == Contact::Smooth) {
    const Point start = start_of_centre(scene);
    if (std::hypot(scene.L - start.x, scene.H - start.z) < scene.body.radius) {
      reasons.emplace_back("B lies inside the body at its start");
    }
  }
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
  if (diagnostics->self_crossing) {
    reasons.push_back(fmt::format(
        "the track crosses itself at x_b = {:.4g}, z_b = {:.4g}",
        diagnostics->self_crossing->x, diagnostics->self_crossing->z));
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
