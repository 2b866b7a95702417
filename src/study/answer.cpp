// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/answer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "model/centre_curve.hpp"
#include "refinement/limited_rates.hpp"
#include "refinement/without_arcs.hpp"
#include "study/certification.hpp"
#include "trajectory/certify.hpp"
#include "trajectory/stated_limits.hpp"

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

/// Whether a stated limit is one of those that are held.
bool is_among(const std::vector<nlp::Held>& held,
              const std::vector<PathInequality>& limits,
              const StatedLimit& stated) {
  int index = 0;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    index = i > 0 && limits[i].kind == limits[i - 1].kind ? index + 1 : 0;
    if (held[i] != nlp::Held::No &&
        stated.is(limits[i].kind, index, held[i] == nlp::Held::AtLower)) {
      return true;
    }
  }
  return false;
}

/// x of the track, which starts at 0 but for rounding.
double place_of(const TrajectoryPoint& at, double L) {
  constexpr double kRounding = 1e-14;
  const double x = at.motion.contact.x;
  return std::abs(x) < kRounding * L ? 0.0 : x;
}

ActiveArc touch_at(double sigma, const LimitedMotion& motion) {
  const TrajectoryPoint here = motion.at(sigma);
  const double x = place_of(here, motion.scene().L);
  return {{sigma, sigma}, {here.u, here.u}, {here.t, here.t}, {x, x}};
}

/// Whether a limit that holds along no arc holds at A, and T feels it there.
bool decides_the_start(const StatedLimit& stated, const LimitedMotion& motion,
                       const LimitOnPath& limit) {
  constexpr double kRounding = 1e-9;
  const double size = std::max(1.0, std::abs(stated.bound.value_or(0.0)));
  const double slack = stated.slack(motion.at(0.0));
  return size * std::abs(limit.price.value_or(0.0)) > kRounding &&
         std::abs(slack) <= kRounding * size;
}

/// Arcs of one limit that follow each other are one, as where a body needs all
/// friction first forwards and then backwards.
std::vector<ActiveArc> active_arcs(const std::vector<Arc>& arcs,
                                   const std::vector<PathInequality>& limits,
                                   const StatedLimit& stated,
                                   const LimitedMotion& motion) {
  const double L = motion.scene().L;
  std::vector<ActiveArc> active;
  double begin = 0.0;
  for (const Arc& arc : arcs) {
    if (is_among(arc.held, limits, stated)) {
      const TrajectoryPoint from = motion.at(begin);
      const TrajectoryPoint to = motion.at(arc.end);
      if (!active.empty() && active.back().sigma.to == begin) {
        active.back().sigma.to = arc.end;
        active.back().u.to = to.u;
        active.back().t.to = to.t;
        active.back().x.to = place_of(to, L);
      } else {
        active.push_back({{begin, arc.end},
                          {from.u, to.u},
                          {from.t, to.t},
                          {place_of(from, L), place_of(to, L)}});
      }
    }
    if (arc.touch) {
      std::vector<nlp::Held> touched(limits.size(), nlp::Held::No);
      touched[arc.touch->limit] = arc.touch->at;
      if (is_among(touched, limits, stated)) {
        active.push_back(touch_at(arc.end, motion));
      }
    }
    begin = arc.end;
  }
  return active;
}

/// Of limits that hold nowhere.
void add_least_slacks(const std::vector<StatedLimit>& asked,
                      const Motion& motion, std::vector<LimitOnPath>& limits) {
  std::vector<std::function<double(const TrajectoryPoint&)>> slacks;
  std::vector<LimitOnPath*> of;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    if (!limits[i].active.empty()) continue;
    slacks.push_back(asked[i].slack);
    of.push_back(&limits[i]);
  }
  if (slacks.empty()) return;
  const std::vector<double> least = motion.least_of(slacks);
  for (std::size_t i = 0; i < of.size(); ++i) of[i]->least_slack = least[i];
}

/// What each limit means for the path: one for each bound of the scene, in the
/// order of stated_limits().
/// \param motion  of the path
std::vector<LimitOnPath> limits_on_path(const PosedProblem& posed,
                                        const FittedPath& path,
                                        const LimitedMotion& motion) {
  // Half of what a bound is moved by, in natural units; of small ones a part.
  constexpr double kStep = 1e-5, kLeastStep = 1e-9, kPart = 0.1;
  const Scene& natural = *posed.limited;
  // τ = T √(2 g/H), times in natural units being those of 2 g = 1.
  const double tau = 1.0 / std::sqrt(natural.H);
  const std::vector<StatedLimit> asked = stated_limits(posed.asked);
  const std::vector<StatedLimit> scaled = stated_limits(natural);
  const bool known = arcs_are_known(path.curve);
  const std::vector<Arc> arcs = known ? path.arcs : arcs_of(path.curve);
  std::vector<LimitOnPath> out;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    LimitOnPath limit{asked[i].name, asked[i].bound, {}, 0.0, 0.0, {}, {}};
    limit.active =
        active_arcs(arcs, path.curve.problem().limits(), asked[i], motion);
    for (const ActiveArc& arc : limit.active) {
      limit.share_of_time += (arc.t.to - arc.t.from) / motion.transit_time();
    }
    out.push_back(std::move(limit));
  }
  if (asked.empty()) return out;
  add_least_slacks(asked, motion, out);
  if (!known) return out;
  LimitedRates rates(path);
  for (std::size_t i = 0; i < asked.size() && rates.regular(); ++i) {
    // One that holds nowhere may still decide the direction at A.
    PathLimits less = natural.limits, more = natural.limits;
    const double bound = scaled[i].bound.value_or(0.0);
    const double step =
        bound > 0.0 ? std::clamp(kPart * bound, kLeastStep, kStep) : kStep;
    scaled[i].move(less, -step);
    scaled[i].move(more, step);
    const TimeRate price =
        rates.price(inequalities(natural.body, less),
                    inequalities(natural.body, more), 2.0 * step);
    const double scale = tau * asked[i].natural;
    if (std::isfinite(price.total) && std::isfinite(price.at_fixed_contacts)) {
      out[i].price = price.total * scale;
      out[i].price_at_fixed_contacts = price.at_fixed_contacts * scale;
    }
    if (out[i].active.empty() && decides_the_start(asked[i], motion, out[i])) {
      out[i].active.push_back(touch_at(0.0, motion));
      out[i].least_slack = 0.0;
    }
  }
  return out;
}

}  // namespace

std::vector<LimitOnPath> limits_held_nowhere(const Motion& motion) {
  const std::vector<StatedLimit> asked = stated_limits(motion.scene());
  std::vector<LimitOnPath> out;
  for (const StatedLimit& limit : asked) {
    out.push_back({limit.name, limit.bound, {}, 0.0, 0.0, 0.0, 0.0});
  }
  add_least_slacks(asked, motion, out);
  return out;
}

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
