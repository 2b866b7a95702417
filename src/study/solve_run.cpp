// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/solve_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "brachisto/study/extremal_bridge.hpp"
#include "math/cpu_clock.hpp"
#include "study/certificate_timer.hpp"
#include "study/within_limits.hpp"

namespace brachisto {

namespace {

double seconds_since(StopCondition::Clock::time_point start) {
  return std::chrono::duration<double>(StopCondition::Clock::now() - start)
      .count();
}

}  // namespace

bool solves_the_program(Method method) {
  return method == Method::Ipopt || method == Method::NewtonKkt;
}

bool follows_the_branch(const SolveOptions& options) {
  return solves_the_program(options.method) &&
         options.search == Search::Principal && options.guess == Guess::Cycloid;
}

SolveRun::SolveRun(const Scene& scene, const SolveOptions& options,
                   const SolveHooks& hooks)
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

Solution SolveRun::execute(const Neighbour* neighbour) {
  within_limits(out_, stop(), [&] {
    if (neighbour != nullptr) {
      find_beside(*neighbour);
    } else {
      find();
    }
  });
  out_.effort.seconds = seconds_since(start_time_);
  out_.effort.cpu_seconds =
      process_cpu_seconds() - start_cpu_ - out_.effort.certificate_cpu_seconds;
  out_.effort.phases = phase_seconds();
  out_.effort.phases -= start_phases_;
  return std::move(out_);
}

MeshOptions SolveRun::budget() const {
  MeshOptions options = mesh_options_;
  options.ipopt.max_iterations =
      std::max(0, options_.limits.iterations - out_.effort.iterations);
  return options;
}

void SolveRun::count(const std::vector<MeshRecord>& meshes) {
  Effort& effort = out_.effort;
  for (const MeshRecord& mesh : meshes) {
    effort.iterations += mesh.iterations;
    effort.passes += mesh.passes;
    effort.newton_steps += mesh.newton_steps;
  }
}

void SolveRun::describe_way(const RefinementProtocol& refinement) {
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

void SolveRun::book(const RefinementProtocol& refinement) {
  count(refinement.meshes);
  describe_way(refinement);
}

/// \param transit_time  T [s], if it is known better than from the answer
void SolveRun::report(MeshAnswer& answer, std::optional<double> transit_time) {
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

void SolveRun::tell_of_certificate(int nodes) const {
  if (!mesh_options_.progress) return;
  mesh_options_.progress("certificate", fmt::format("of {} nodes", nodes));
}

void SolveRun::set_verdict(const std::string& message) {
  // That a finer mesh failed only matters if this one is not good enough.
  if (out_.certificate.verified()) {
    out_.status = Status::Solved;
    out_.message = message;
    return;
  }
  if (out_.status == Status::Solved) {
    out_.message = fmt::format(
        "solved, but not verified: {}",
        fmt::join(brachisto::not_verified_because(out_.certificate), "; "));
  }
  const std::string advice = out_.advice();
  if (!advice.empty()) out_.message += ". To try: " + advice;
}

void SolveRun::report(ArcLengthAnswer& answer, const Continuation& start) {
  const MeshSolution& solution = answer.solution;
  out_.estimated_error = answer.estimated_error;
  out_.nodes = answer.problem.layout().num_nodes();
  out_.variables = answer.problem.num_variables();
  out_.constraints = answer.problem.num_constraints();
  tell_of_certificate(answer.problem.layout().num_nodes());
  std::optional<CertificateTimer> timer(std::in_place, out_.effort);
  const double end_angle =
      answer.problem.end_slope(solution.point.x, solution.point.lambda);
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

}  // namespace brachisto
