// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/answer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "model/centre_curve.hpp"
#include "study/certification.hpp"
#include "study/limits_on_path.hpp"
#include "trajectory/certify.hpp"

namespace brachisto {

namespace {

void tell_of_certificate(const PosedProblem& posed, int nodes) {
  if (!posed.progress()) return;
  posed.progress()("certificate", fmt::format("of {} nodes", nodes));
}

/// With the cross-check of T [s], if that is asked for.
Certified cross_checked(const PosedProblem& posed, Certificate certificate,
                        const ExtremalCurve& nearby, double phi, double T,
                        std::optional<double> error) {
  Certified out{std::move(certificate), {}};
  if (posed.program.certify == Certify::Extremal) {
    out.cross_check = cross_check(posed, nearby, phi, T, error.value_or(0.0),
                                  posed.stop(), out.certificate);
  }
  return out;
}

ProgramSize size_of(const Transcription& problem, std::optional<int> degree) {
  return {problem.layout().num_nodes(), problem.num_variables(),
          problem.num_constraints(), degree, problem.mesh().num_elements()};
}

}  // namespace

Answered answer_of(const PosedProblem& posed, const MeshAnswer& found,
                   std::optional<double> transit_time) {
  const PhaseTimer timer(Phase::Diagnosis);
  Trajectory trajectory(found.curve(), posed.asked, posed.units, transit_time);
  PathDiagnostics diagnostics = trajectory.diagnose();
  return {std::make_shared<const Answer>(CollocationAnswer{
              std::move(trajectory),
              size_of(found.problem, found.problem.mesh().degree),
              found.solution.point, found.solution.tangency.phi}),
          found.estimated_error, std::move(diagnostics)};
}

Answered answer_of(const PosedProblem& posed, ArcLengthAnswer& found) {
  const PhaseTimer timer(Phase::Diagnosis);
  const PrimalDual& point = found.solution.point;
  const double end_angle = found.problem.end_slope(point.x, point.lambda);
  ArcLengthMotion motion(found.problem, point.x, found.transit_time, end_angle,
                         posed.asked, posed.units);
  std::optional<PathDiagnostics> diagnostics;
  if (!motion.on_curve().stall()) diagnostics = motion.diagnose();
  return {std::make_shared<const Answer>(PiecewiseAnswer{
              std::move(motion), size_of(found.problem, std::nullopt), point,
              found.solution.tangency.phi}),
          found.estimated_error, std::move(diagnostics)};
}

Answered answer_of(const PosedProblem& posed, const LimitedAnswer& found,
                   std::optional<double> transit_time) {
  const PhaseTimer timer(Phase::Diagnosis);
  const LimitedTime& problem = found.path.curve.problem();
  LimitedMotion motion(found.path.curve, posed.asked, posed.units,
                       transit_time);
  PathDiagnostics diagnostics = motion.diagnose();
  std::vector<LimitOnPath> limits = limits_on_path(posed, found.path, motion);
  return {std::make_shared<const Answer>(LimitedPathAnswer{
              std::move(motion), size_of(problem, problem.mesh().degree),
              found.path.arcs, found.path.ends}),
          found.estimated_error, std::move(diagnostics), std::move(limits)};
}

Answered answer_on_given_path(const PosedProblem& posed) {
  const PhaseTimer timer(Phase::Diagnosis);
  PrescribedMotion motion(posed.scene, centre_curve(posed.asked));
  std::optional<PathDiagnostics> diagnostics;
  if (!motion.stall()) diagnostics = motion.diagnose();
  const double error = motion.error_estimate();
  return {std::make_shared<const Answer>(std::move(motion)), error,
          std::move(diagnostics)};
}

Certified certify(const PosedProblem& posed, MeshAnswer& found,
                  const ExtremalCurve& curve) {
  tell_of_certificate(posed, found.problem.mesh().num_nodes());
  return cross_checked(
      posed, certify_answer(found, curve, posed.program.discretisation), curve,
      found.solution.tangency.phi, curve.transit_time() * posed.units.time,
      found.estimated_error);
}

Certified certify(const PosedProblem& posed, ArcLengthAnswer& found,
                  const ArcLengthMotion& motion, const ExtremalCurve& nearby,
                  double phi) {
  tell_of_certificate(posed, found.problem.mesh().num_nodes());
  return cross_checked(
      posed, certify_answer(found, motion, posed.program.discretisation),
      nearby, phi, motion.transit_time(), found.estimated_error);
}

Certified certify(const PosedProblem& posed, const LimitedAnswer& found) {
  tell_of_certificate(posed, found.path.curve.problem().mesh().num_nodes());
  const Discretisation& wanted = posed.program.discretisation;
  Certified out{certify_answer(found, wanted), {}};
  if (posed.program.certify == Certify::Extremal) {
    const double error = std::max(wanted.wanted_tolerance(),
                                  found.estimated_error.value_or(0.0));
    out.cross_check =
        cross_check(found.path, error, posed.stop(), out.certificate);
  }
  return out;
}

Certified certify_given_path(const PosedProblem& posed,
                             const PrescribedMotion& motion) {
  return {certify_path(motion, posed.program.discretisation.tolerance.value_or(
                                   kDefaultTolerance)),
          std::nullopt};
}

Outcome verdict(const Solution& certified, const std::string& found) {
  if (certified.certificate.verified()) return {Status::Solved, found};
  Outcome outcome{certified.status, certified.message};
  if (outcome.status == Status::Solved) {
    outcome.message =
        fmt::format("solved, but not verified: {}",
                    fmt::join(certified.not_verified_because(), "; "));
  }
  const std::string advice = certified.advice();
  if (!advice.empty()) outcome.message += ". To try: " + advice;
  return outcome;
}

}  // namespace brachisto
