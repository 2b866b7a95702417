// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/study/solve.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "brachisto/study/arc_length_refinement.hpp"
#include "brachisto/study/evaluate_path.hpp"
#include "brachisto/study/extremal_bridge.hpp"
#include "brachisto/study/global_search.hpp"
#include "brachisto/transcription/arc_contact.hpp"
#include "math/cpu_clock.hpp"
#include "study/certificate_timer.hpp"
#include "study/descent.hpp"
#include "study/fsolve_solution.hpp"
#include "study/other_start.hpp"
#include "study/shooting_answer.hpp"
#include "study/turn_meshes.hpp"

namespace brachisto {

namespace {

double seconds_since(StopCondition::Clock::time_point start) {
  return std::chrono::duration<double>(StopCondition::Clock::now() - start)
      .count();
}

/// The same scene with |θ_m| < 2π: whole turns only cost digits.
Scene without_whole_turns(Scene scene) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  double& theta_m = scene.body.theta_m;
  if (std::abs(theta_m) >= kTurn) theta_m = std::remainder(theta_m, kTurn);
  return scene;
}

std::string no_cycloid(const Scene& scene) {
  return fmt::format(
      "B lies inside the uniform cylinder at its start, (L − r)² + H² ≤ r² "
      "with r = {:g}, L = {:g}, H = {:g}, so that no branch starts from its "
      "path. Try a smaller radius or a point B further away",
      scene.body.radius, scene.L, scene.H);
}

/// Whether the method poses the nonlinear program.
bool solves_the_program(Method method) {
  return method == Method::Ipopt || method == Method::NewtonKkt;
}

/// True if the answer is the end of one branch that is followed.
bool follows_the_branch(const SolveOptions& options) {
  return solves_the_program(options.method) &&
         options.search == Search::Principal && options.guess == Guess::Cycloid;
}

/// \throws std::invalid_argument if arc_length is combined with what it has not
void check_formulation(const SolveOptions& options) {
  const Discretisation& mesh = options.discretisation;
  if (mesh.formulation != Formulation::ArcLength) return;
  const int pieces = mesh.elements ? *mesh.elements
                     : mesh.nodes  ? *mesh.nodes - 1
                                   : kFewestPieces;
  if (mesh.degree || pieces < kFewestPieces ||
      !solves_the_program(options.method) ||
      options.search != Search::Principal || options.guess != Guess::Cycloid ||
      mesh.wanted_tolerance() < kSmallestArcLengthTolerance) {
    throw std::invalid_argument(fmt::format(
        "the formulation arc_length has no degree, {} pieces or more, the "
        "method ipopt or newton_kkt, the search principal, the guess cycloid, "
        "and a "
        "tolerance of {:g} or more",
        kFewestPieces, kSmallestArcLengthTolerance));
  }
}

/// One solve: its parts share the scene, the budget and the protocol.
class Run {
 public:
  Run(const Scene& scene, const SolveOptions& options, const SolveHooks& hooks)
      : scene_(without_whole_turns(scene)),
        natural_(in_natural_units(scene_)),
        units_(natural_units(scene)),
        options_(options),
        start_time_(StopCondition::Clock::now()),
        start_cpu_(process_cpu_seconds()),
        start_phases_(phase_seconds()) {
    mesh_options_.ipopt.tolerance = options.tolerance;
    mesh_options_.ipopt.linear_solver = options.linear_solver;
    mesh_options_.ipopt.verbose = hooks.verbose;
    mesh_options_.ipopt.stop =
        StopCondition(options.limits.seconds, hooks.interrupt);
    mesh_options_.polish = options.polish;
    mesh_options_.progress = hooks.progress;
    mesh_options_.newton_alone = options.method == Method::NewtonKkt;
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
      out_.message = stop().interrupted()
                         ? "stopped by a signal before the end"
                         : fmt::format("the limit of {:g} s was reached",
                                       options_.limits.seconds);
      out_.discard_answer();
    }
    out_.effort.seconds = seconds_since(start_time_);
    out_.effort.cpu_seconds = process_cpu_seconds() - start_cpu_ -
                              out_.effort.certificate_cpu_seconds;
    out_.effort.phases = phase_seconds();
    out_.effort.phases -= start_phases_;
    return std::move(out_);
  }

 private:
  void find();
  void find_beside(const Neighbour& neighbour);
  void find_fastest(const CycloidArc& arc, const Continuation& principal);
  void add_minima_below(std::vector<ContactCandidate>& known);
  void find_by_shooting();
  void find_by_fsolve();
  void follow_folds(Continuation& principal);
  void try_other_start(const CycloidArc& arc, const Continuation& principal);
  void answer_from(const Continuation& start);
  void report(MeshAnswer& answer,
              std::optional<double> transit_time = std::nullopt);
  void answer_on_pieces(const Continuation& start);
  void report(ArcLengthAnswer& answer, const Continuation& start);
  void tell_of_certificate(int nodes) const;
  void set_verdict(const std::string& message);
  /// Adds up the work on meshes, whether or not the answer comes from there.
  void count(const std::vector<MeshRecord>& meshes);
  /// Keeps how the answer was refined.
  void describe_way(const RefinementProtocol& refinement);
  void book(const RefinementProtocol& refinement);
  [[nodiscard]] ExtremalSolution shoot(double tolerance);

  [[nodiscard]] const StopCondition& stop() const {
    return mesh_options_.ipopt.stop;
  }
  [[nodiscard]] MeshOptions budget() const;

  Scene scene_, natural_;
  Units units_;
  SolveOptions options_;
  StopCondition::Clock::time_point start_time_;
  double start_cpu_;
  PhaseSeconds start_phases_;
  MeshOptions mesh_options_;
  Solution out_;
};

MeshOptions Run::budget() const {
  MeshOptions options = mesh_options_;
  options.ipopt.max_iterations =
      std::max(0, options_.limits.iterations - out_.effort.iterations);
  return options;
}

void Run::count(const std::vector<MeshRecord>& meshes) {
  Effort& effort = out_.effort;
  for (const MeshRecord& mesh : meshes) {
    effort.iterations += mesh.iterations;
    effort.passes += mesh.passes;
    effort.newton_steps += mesh.newton_steps;
  }
}

void Run::describe_way(const RefinementProtocol& refinement) {
  Effort& effort = out_.effort;
  for (const MeshRecord& mesh : refinement.meshes) {
    effort.first_iterations = mesh.first_iterations;
    effort.closure_passes = mesh.passes;
    effort.linear_solver = mesh.linear_solver;
    effort.meshes.push_back(mesh);
  }
  out_.log += refinement.log;
  out_.status = refinement.status;
  out_.message = refinement.message;
}

void Run::book(const RefinementProtocol& refinement) {
  count(refinement.meshes);
  describe_way(refinement);
}

/// \param transit_time  T [s], if it is known better than from the answer
void Run::report(MeshAnswer& answer, std::optional<double> transit_time) {
  out_.estimated_error = answer.estimated_error;
  out_.nodes = answer.problem.mesh().num_nodes();
  out_.variables = answer.problem.num_variables();
  out_.constraints = answer.problem.num_constraints();
  {
    const PhaseTimer timer(Phase::Diagnosis);
    out_.trajectory.emplace(answer.curve(), out_.scene, units_, transit_time);
    out_.diagnostics = out_.trajectory->diagnose();
  }
  // What lies beyond a fold is not what neighbours continue from the cycloid.
  if (out_.folds.empty() && follows_the_branch(options_)) {
    out_.as_neighbour = {scene_, answer.problem.mesh(), answer.solution.point,
                         answer.solution.closure.phi};
  }
  tell_of_certificate(answer.problem.mesh().num_nodes());
  {
    const CertificateTimer timer(out_.effort);
    out_.certificate = certify_answer(answer, options_.discretisation);
    if (options_.certify == Certify::Extremal) {
      out_.extremal = ask_extremal(scene_, answer, stop(), out_.certificate);
    }
  }
  set_verdict(answer.solution.message);
}

void Run::tell_of_certificate(int nodes) const {
  if (!mesh_options_.progress) return;
  mesh_options_.progress("certificate", fmt::format("of {} nodes", nodes));
}

void Run::set_verdict(const std::string& message) {
  // That a finer mesh failed only matters if this one is not good enough.
  if (out_.certificate.verified()) {
    out_.status = Status::Solved;
    out_.message = message;
  } else if (out_.status == Status::Solved) {
    out_.message = fmt::format(
        "solved, but not verified: {}",
        fmt::join(brachisto::not_verified_because(out_.certificate), "; "));
    const Check* second_order = out_.certificate.find("second_order");
    if (follows_the_branch(options_) && second_order != nullptr &&
        !second_order->passed) {
      out_.message += ". search: global looks for minima";
    }
  }
}

void Run::report(ArcLengthAnswer& answer, const Continuation& start) {
  const MeshSolution& solution = answer.solution;
  out_.estimated_error = answer.estimated_error;
  out_.nodes = answer.problem.layout().num_nodes();
  out_.variables = answer.problem.num_variables();
  out_.constraints = answer.problem.num_constraints();
  tell_of_certificate(answer.problem.layout().num_nodes());
  std::optional<CertificateTimer> timer(std::in_place, out_.effort);
  const double end_angle =
      end_slope(answer.problem, solution.point.x, solution.point.lambda);
  auto motion = std::make_shared<const ArcLengthMotion>(
      answer.problem, solution.point.x, answer.transit_time, end_angle,
      out_.scene, units_);
  out_.certificate = certify_answer(answer, *motion, options_.discretisation);
  if (options_.certify == Certify::Extremal) {
    out_.extremal = ask_extremal(
        scene_, *start.curve, start.phi, motion->transit_time(),
        answer.estimated_error.value_or(0.0), stop(), out_.certificate);
  }
  timer.reset();
  // Without a motion there is nothing to diagnose, and the certificate says so.
  if (!motion->on_curve().stall()) {
    const PhaseTimer diagnosis(Phase::Diagnosis);
    out_.diagnostics = motion->diagnose();
    out_.through_nodes = std::move(motion);
  }
  set_verdict(solution.message);
}

void Run::try_other_start(const CycloidArc& arc,
                          const Continuation& principal) {
  // Lost in nowhere it must not use up what the answer needs.
  MeshOptions half = budget();
  half.ipopt.max_iterations /= 2;
  OtherStart other = start_elsewhere(scene_, options_, arc, principal, half);
  out_.effort.iterations += other.iterations;
  out_.effort.passes += other.passes;
  out_.log += other.log;
  out_.cold_start = other.cold;
}

/// A search starts from what is cheap to know: where the principal extremal is
/// a saddle, the minima beside it.
void Run::add_minima_below(std::vector<ContactCandidate>& known) {
  Descent descent = descend(natural_, known.front(), budget());
  out_.effort.iterations += descent.iterations;
  out_.effort.passes += descent.passes;
  out_.log += descent.log;
  for (ContactCandidate& minimum : descent.minima) {
    known.push_back(std::move(minimum));
  }
}

void Run::find_fastest(const CycloidArc& arc, const Continuation& principal) {
  // As a multiple of the path of the uniform cylinder.
  constexpr double kLongest = 3.0;
  std::vector<ContactCandidate> known;
  if (principal.curve) known.push_back({*principal.curve, principal.phi});
  const bool has_principal = !known.empty();
  // Each of the extremals may take what the limit allows.
  const MeshOptions each = budget();
  if (has_principal) add_minima_below(known);
  const ContactSearch search = find_contacts(
      natural_, kLongest * arc.arc_length(arc.psi_end),
      [this](double length) { return sampled_mesh(natural_.body, length); },
      std::move(known), stop(), mesh_options_.progress);
  out_.search_remark = search.remark;
  out_.effort.newton_steps += search.newton_steps;
  JudgedBranches judged = judge_branches(scene_, options_.discretisation,
                                         search.contacts, has_principal, each);
  for (const JudgedBranch& one : judged.branches) {
    out_.branches.push_back(one.branch);
  }
  count(judged.meshes);
  if (JudgedBranch* best = best_branch(judged.branches)) {
    describe_way(best->refinement);
    report(*best->refinement.answer);
  } else {
    out_.status = judged.failure;
    out_.message = fmt::format(
        "of {} smooth contacts that the search found, none could be solved "
        "for as accurately as wanted",
        search.contacts.size());
  }
}

ExtremalSolution Run::shoot(double tolerance) {
  ExtremalOptions options;
  options.follow_folds = true;
  options.tolerance = tolerance;
  options.stop = stop();
  ExtremalSolution extremal = solve_extremal(scene_, options);
  out_.effort.newton_steps += extremal.newton_steps;
  if (extremal.usable()) out_.folds = extremal.continuation.folds;
  return extremal;
}

/// Where the short continuation is stuck, pseudo-arclength continuation of the
/// indirect method goes on: through folds, and past near meetings of branches.
void Run::follow_folds(Continuation& principal) {
  constexpr double kEnoughToStartFrom = 1e-10;
  const ExtremalSolution extremal = shoot(kEnoughToStartFrom);
  if (!extremal.usable()) {
    out_.message += ". By shooting: " + extremal.message;
    return;
  }
  const double length = extremal.centre_path_length / units_.length;
  const RollingTime problem(natural_, sampled_mesh(natural_.body, length),
                            extremal.phi);
  principal.curve.emplace(problem, sample_extremal(extremal, units_, problem));
  principal.phi = extremal.phi;
}

/// Method::Extremal: the numbers come from the indirect method; the collocation
/// problem on a fine mesh, which they must satisfy, is their certificate.
void Run::find_by_shooting() {
  const ExtremalSolution extremal = shoot(ExtremalOptions{}.tolerance);
  if (!extremal.usable()) {
    out_.status = extremal.status == ExtremalStatus::NoCycloid
                      ? Status::NoAdmissiblePath
                      : Status::NotConverged;
    out_.message = extremal.message;
    return;
  }
  MeshAnswer answer = [&] {
    const CertificateTimer timer(out_.effort);
    return answer_from_extremal(natural_, units_, extremal, stop());
  }();
  out_.status = answer.solution.status;
  report(answer, extremal.transit_time);
}

/// Method::Fsolve: an answer to other equations, and its distance from this
/// one.
void Run::find_by_fsolve() {
  out_.discrete = solve_discrete_system(scene_, options_, stop());
  out_.status = out_.discrete->status;
  out_.message = out_.discrete->message;
  out_.effort.iterations = out_.discrete->iterations;
  if (!out_.discrete->solved()) return;
  const CertificateTimer timer(out_.effort);
  const ExtremalSolution extremal = shoot(ExtremalOptions{}.tolerance);
  out_.extremal = opinion_on(*out_.discrete, extremal);
  out_.certificate = certify_discrete(*out_.discrete, *out_.extremal);
  out_.message = fmt::format(
      "the discrete equations hold, but: {}",
      fmt::join(brachisto::not_verified_because(out_.certificate), "; "));
}

void Run::find() {
  if (options_.method == Method::Extremal) return find_by_shooting();
  if (options_.method == Method::Fsolve) return find_by_fsolve();
  const std::optional<CycloidArc> arc = axisymmetric_optimum(natural_);
  if (!arc) {
    out_.status = Status::NoAdmissiblePath;
    out_.message = no_cycloid(scene_);
    return;
  }
  Continuation principal = [&] {
    const PhaseTimer timer(Phase::Start);
    return continue_from_cycloid(natural_, *arc, coarse_mesh(natural_, *arc),
                                 stop(), mesh_options_.progress);
  }();
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

/// The same by straight pieces, in the paper's variables.
void Run::answer_on_pieces(const Continuation& start) {
  ArcLengthRefinement refinement = refine_arc_length(
      natural_, options_.discretisation, *start.curve, start.phi, budget());
  book(refinement);
  if (refinement.answer && !stop().met()) report(*refinement.answer, start);
}

/// Refines until T is as accurate as wanted and, where the path bends sharply,
/// until it is resolved between the nodes too.
void Run::answer_from(const Continuation& start) {
  if (options_.discretisation.formulation == Formulation::ArcLength) {
    return answer_on_pieces(start);
  }
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
  if (scene.path) return evaluate_path(scene, options);
  check_formulation(options);
  if (hooks.neighbour != nullptr && comparable(scene, hooks.neighbour->scene) &&
      follows_the_branch(options)) {
    Solution beside = Run(scene, options, hooks).execute(hooks.neighbour);
    if (beside.verified()) return beside;
  }
  return Run(scene, options, hooks).execute(nullptr);
}

}  // namespace brachisto
