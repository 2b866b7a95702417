// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "program_files/solved_program.hpp"

#include <utility>

#include "brachisto/math/index.hpp"
#include "study/answer_kinds.hpp"
#include "study/pose.hpp"
#include "study/start.hpp"
#include "transcription/initial_guess.hpp"
#include "transcription/prolongation.hpp"

namespace brachisto::program_files {

namespace {

PrimalDual guess_for(const RollingTime& problem, const PosedProblem& posed) {
  if (!posed.cycloid || posed.program.guess == Guess::Straight) {
    return straight_guess(problem);
  }
  return posed.program.guess == Guess::Random
             ? random_guess(problem, *posed.cycloid, posed.program.seed)
             : cycloid_guess(problem, *posed.cycloid);
}

/// Where every element of the answer lies on one side of a field's surface,
/// each has the law of its side: the same answer, of a program that is smooth.
void hold_sides(RollingTime& problem, const ExtremalCurve& answer) {
  std::vector<FieldSide> sides;
  for (int e = 0; e < problem.mesh().num_elements(); ++e) {
    const std::optional<FieldSide> side = answer.scene_in(e).world.side;
    if (!side) return;
    sides.push_back(*side);
  }
  problem.hold_sides(std::move(sides));
}

/// With what is fixed where it is fixed.
PrimalDual within_fixed(const Transcription& problem, PrimalDual point) {
  for (int i = 0; i < problem.num_variables(); ++i) {
    const nlp::Range range = problem.variable_range(i);
    if (range.single()) point.x[at(i)] = range.lower;
  }
  return point;
}

template <class Problem>
SolvedProgram made_of(Problem problem, PrimalDual answer, PrimalDual guess,
                      const PosedProblem& posed,
                      std::optional<double> end_slope) {
  PrimalDual start = within_fixed(problem, std::move(guess));
  return {std::make_unique<Problem>(std::move(problem)), std::move(answer),
          std::move(start), posed.units, end_slope};
}

}  // namespace

double SolvedProgram::objective() const {
  if (!problem->set_point(answer.x)) {
    throw std::runtime_error("the answer is no point of its program: " +
                             problem->refusal());
  }
  return problem->eval_f();
}

std::string no_program_because(const Scene& scene,
                               const SolveOptions& options) {
  if (scene.path) {
    return "the path that the scene states is evaluated, not optimised";
  }
  if (options.of<Collocation>() == nullptr) {
    return "this method solves no nonlinear program; solver.method ipopt does";
  }
  return {};
}

void require_program(const io::ProblemFile& problem,
                     const std::string& source) {
  const std::string reason = no_program_because(problem.scene, problem.options);
  if (reason.empty()) return;
  throw io::InputError({{source, 0, 0, "", "it has no program: " + reason}});
}

std::optional<SolvedProgram> solved_program(const Solution& solution) {
  const PosedProblem posed = pose(solution.scene, solution.options, {});
  if (const auto* found = answer_as<CollocationAnswer>(solution.answer)) {
    const ExtremalCurve& curve = found->trajectory.curve();
    RollingTime problem(curve.scene(), curve.mesh(), found->phi);
    hold_sides(problem, curve);
    PrimalDual guess = guess_for(problem, posed);
    return made_of(std::move(problem), found->point, std::move(guess), posed,
                   found->phi);
  }
  if (const auto* found = answer_as<PiecewiseAnswer>(solution.answer)) {
    ArcLength problem(posed.natural, found->program.elements, found->phi);
    // From the nodes of the plain cycloid Newton's steps lead nowhere.
    PrimalDual guess =
        prolong(start_from_cycloid(posed).curve.value(), problem);
    return made_of(std::move(problem), found->point, std::move(guess), posed,
                   found->phi);
  }
  if (const auto* found = answer_as<LimitedPathAnswer>(solution.answer)) {
    const LimitedCurve& curve = found->motion.curve();
    const LimitedTime& solved = curve.problem();
    LimitedTime problem(solved.scene(), solved.limits(), solved.mesh(),
                        solved.ends());
    PrimalDual guess = cycloid_guess(problem, *posed.cycloid);
    std::optional<double> end_slope;
    if (!problem.free_contacts()) end_slope = problem.ends().phi;
    return made_of(std::move(problem), curve.point(), std::move(guess), posed,
                   end_slope);
  }
  return std::nullopt;
}

}  // namespace brachisto::program_files
