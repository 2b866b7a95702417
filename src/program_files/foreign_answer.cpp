// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "program_files/foreign_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "brachisto/io/problem_file.hpp"
#include "brachisto/math/index.hpp"
#include "program_files/nl_numbering.hpp"
#include "trajectory/arc_length_motion.hpp"
#include "trajectory/certify.hpp"
#include "trajectory/checks.hpp"
#include "transcription/arc_length.hpp"
#include "transcription/limited_curve.hpp"
#include "transcription/rolling_time.hpp"

namespace brachisto::program_files {

namespace {

/// The order of the program, and λ for AMPL's −λ. Without multipliers none of
/// them is a number.
PrimalDual in_program_order(const Transcription& problem, const SolFile& theirs,
                            const std::string& source) {
  const auto refuse = [&](const std::string& why) {
    throw io::InputError({{source, 0, 0, "", why}});
  };
  if (theirs.num_variables != problem.num_variables() ||
      theirs.num_constraints != problem.num_constraints()) {
    refuse(fmt::format(
        "an answer to another program: {} variables and {} constraints, and "
        "the program has {} and {}; write the program anew, or fix its mesh by "
        "discretisation.elements",
        theirs.num_variables, theirs.num_constraints, problem.num_variables(),
        problem.num_constraints()));
  }
  if (theirs.variables.size() != at(problem.num_variables())) {
    refuse("it has no values of the variables: the solver found no answer");
  }
  const auto formulas = in_formulas(problem);
  const NlNumbering order(problem, *formulas);
  PrimalDual out{
      std::vector<double>(at(problem.num_variables())),
      std::vector<double>(at(problem.num_constraints()), kUnmeasured)};
  for (std::size_t i = 0; i < out.x.size(); ++i) {
    out.x[at(order.variables[i])] = theirs.variables[i];
  }
  for (std::size_t i = 0; i < theirs.multipliers.size(); ++i) {
    out.lambda[at(order.constraints[i])] = -theirs.multipliers[i];
  }
  // Solvers leave what is fixed where it is, to rounding or to a tolerance.
  constexpr double kSame = 1e-6;
  for (int i = 0; i < problem.num_variables(); ++i) {
    const nlp::Range range = problem.variable_range(i);
    if (!range.single() || std::abs(out.x[at(i)] - range.lower) <= kSame) {
      continue;
    }
    refuse(fmt::format(
        "an answer to another program: {} is {:.9g}, and the program fixes it "
        "at {:.9g}",
        problem.variable_name(i), out.x[at(i)], range.lower));
  }
  return out;
}

/// \param T      of the point, in natural units
/// \param error  relative, of T
Certificate certify_program(Transcription& problem, const PrimalDual& point,
                            double T, double error, const Solution& solution,
                            const SolvedProgram& program) {
  const double phi = program.end_slope.value_or(0.0);
  if (auto* const smooth = dynamic_cast<RollingTime*>(&problem)) {
    return certify(*smooth, point, phi, error);
  }
  if (auto* const pieces = dynamic_cast<ArcLength*>(&problem)) {
    const ArcLengthMotion motion(*pieces, point.x, T,
                                 pieces->end_slope(point.x, point.lambda),
                                 solution.scene, program.units);
    return certify(*pieces, point, phi, motion, error);
  }
  const LimitedCurve curve(dynamic_cast<const LimitedTime&>(problem), point);
  const double mismatch =
      program.end_slope && problem.scene().contact == Contact::Smooth
          ? curve.at(1.0).state.beta - phi
          : 0.0;
  return certify(curve, mismatch, error);
}

}  // namespace

CheckedAnswer check_answer(const Solution& solution,
                           const SolvedProgram& program, const SolFile& theirs,
                           const std::string& source) {
  // Of rounding, where our own error is less.
  constexpr double kRounding = 1e-13;
  Transcription& problem = *program.problem;
  CheckedAnswer out;
  out.solver = theirs.message;
  out.code = theirs.code;
  const PrimalDual point = in_program_order(problem, theirs, source);
  const double ours = program.objective();
  if (!problem.set_point(point.x)) {
    throw io::InputError(
        {{source, 0, 0, "", "no point of the program: " + problem.refusal()}});
  }
  const double T = problem.eval_f();
  out.transit_time = T * program.units.time;
  out.difference = T / ours - 1.0;
  for (int i = 0; i < problem.num_variables(); ++i) {
    const double off = std::abs(point.x[at(i)] - program.answer.x[at(i)]);
    if (off <= out.farthest) continue;
    out.farthest = off;
    out.farthest_variable = problem.variable_name(i);
  }
  out.our_error = solution.estimated_error.value_or(kUnmeasured);
  const double allowed = std::max(out.our_error, kRounding);
  out.certificate =
      certify_program(problem, point, T, allowed, solution, program);
  out.certificate.add("agreement", std::abs(out.difference), allowed,
                      fmt::format("T against that of the program's answer "
                                  "here, which errs by {:.1e}",
                                  out.our_error));
  return out;
}

nlohmann::ordered_json CheckedAnswer::to_json() const {
  nlohmann::ordered_json checks = nlohmann::ordered_json::array();
  for (const Check& check : certificate.checks) {
    checks.push_back({{"name", check.name},
                      {"value", check.value},
                      {"threshold", check.threshold},
                      {"passed", check.passed},
                      {"where", check.where}});
  }
  nlohmann::ordered_json out = {
      {"verified", certificate.verified()},
      {"not_verified_because", not_verified_because(certificate)},
      {"solver_message", solver},
      {"solver_code", nullptr},
      {"transit_time", transit_time},
      {"difference", difference},
      {"estimated_error", our_error},
      {"farthest", farthest},
      {"farthest_variable", farthest_variable},
      {"checks", std::move(checks)}};
  if (code) out["solver_code"] = *code;
  return out;
}

std::string CheckedAnswer::in_words() const {
  const auto passed = std::ranges::count_if(certificate.checks, &Check::passed);
  std::string out = fmt::format(
      "solver        {}\n"
      "T             {:.15g} s, by {:+.1e} of it from the answer here, which "
      "errs by {:.1e}\n"
      "farthest      {} in natural units: {:.1e}\n"
      "{}: {} of {} checks\n",
      solver.empty() ? "says nothing" : solver, transit_time, difference,
      our_error, farthest_variable.empty() ? "nothing" : farthest_variable,
      farthest, certificate.verified() ? "verified" : "NOT VERIFIED", passed,
      certificate.checks.size());
  for (const std::string& reason : not_verified_because(certificate)) {
    out += fmt::format("failed check  {}\n", reason);
  }
  return out;
}

}  // namespace brachisto::program_files
