// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/study/adaptive_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "brachisto/solvers/newton_kkt.hpp"
#include "brachisto/transcription/contact_equation.hpp"
#include "brachisto/transcription/discretisation.hpp"
#include "brachisto/transcription/extremal_curve.hpp"
#include "brachisto/transcription/mesh.hpp"
#include "brachisto/transcription/prolongation.hpp"

namespace brachisto {

namespace {

/// What rounding leaves of T, relative: a few ulps of the sum of the integral,
/// and half an ulp for each element, whose defect hands the state on with as
/// much, and on equal elements to the same side.
double rounding_error(const Mesh& mesh) {
  constexpr double kOfSum = 2e-15;
  constexpr double kHalfAnUlp = 0.5 * std::numeric_limits<double>::epsilon();
  return kOfSum + kHalfAnUlp * mesh.num_elements();
}

double sum_of_absolutes(const std::vector<double>& values) {
  return std::accumulate(
      values.begin(), values.end(), 0.0,
      [](double sum, double value) { return sum + std::abs(value); });
}

/// dT/dφ = r √A / w at the end: the end point moves along the path.
double time_per_radian(const ExtremalCurve& curve) {
  const ExtremalPoint end = curve.at(1.0);
  const Body& body = curve.scene().body;
  return body.radius * std::sqrt(inertia_factor(body, end.theta, end.beta)) /
         end.w;
}

/// What a better or an independent solution says of the error of `answer`,
/// given a bound on that solution's own, relative.
double estimate(const MeshAnswer& answer, const ExtremalCurve& curve,
                const ExtremalCurve& other, double other_phi,
                double error_of_other, double weight) {
  const double T = curve.transit_time();
  const bool smooth = curve.scene().contact == Contact::Smooth;
  const ContactClosure& closure = answer.solution.closure;
  const double per_radian = smooth ? time_per_radian(curve) : 0.0;
  // Two parts of the error, that of the end point and that between fixed ends,
  // may have opposite signs; the estimate must not profit from it.
  const double difference = other.transit_time() - T;
  const double of_ends = per_radian * (other_phi - closure.phi);
  const double apart = std::abs(of_ends) + std::abs(difference - of_ends);
  const double open_contact =
      smooth ? std::abs(closure.mismatch / closure.slope) * per_radian : 0.0;
  const double of_ends_rounded =
      rounding_of_ends(curve.scene(), closure.phi, curve.p_x(), curve.p_z());
  return (std::max(weight * std::abs(difference), apart) + open_contact +
          of_ends_rounded) /
             T +
         error_of_other + rounding_error(curve.mesh());
}

/// By the same elements with degree p + 1.
void estimate_by_degree(MeshAnswer& answer, const MeshOptions& options) {
  const ExtremalCurve coarse = answer.curve();
  Mesh mesh = coarse.mesh();
  mesh.degree += 1;
  const double phi = answer.solution.closure.phi;
  RollingTime finer(coarse.scene(), mesh, phi);
  const bool smooth = coarse.scene().contact == Contact::Smooth;
  std::optional<ContactEquation> contact;
  if (smooth) contact.emplace(finer);
  NewtonOptions newton;
  // A looser one may hold at the start already, and nothing would be learnt.
  newton.tolerance =
      reachable(std::min(options.ipopt.tolerance, kRoundingResidual),
                answer.problem, answer.solution.point.x);
  newton.max_iterations = 10;
  newton.linear_solver = options.ipopt.linear_solver;
  newton.stop = options.ipopt.stop;
  const NewtonResult result = solve_with_newton(
      finer, smooth ? &*contact : nullptr, prolong(coarse, finer), phi, newton);
  answer.solution.polish.newton_steps += result.iterations;
  if (result.residual > reachable(kRoundingResidual, finer, result.point.x))
    return;
  answer.finer.emplace(finer, result.point);
  answer.finer_phi = result.phi;
  constexpr double kSameSide = 2.0;
  const double of_finer = sum_of_absolutes(element_errors(*answer.finer));
  answer.estimated_error =
      estimate(answer, coarse, *answer.finer, result.phi,
               of_finer / coarse.transit_time(), kSameSide);
}

/// How far a solution lies from the curve it started from: in T, relative, or
/// in φ, whichever is more.
double departure(const RollingTime& problem, const MeshSolution& solution,
                 const ExtremalCurve& curve, double phi) {
  const double T = ExtremalCurve(problem, solution.point).transit_time();
  return std::max(std::abs(T / curve.transit_time() - 1.0),
                  std::abs(solution.closure.phi - phi));
}

}  // namespace

MeshAnswer answer_on_mesh(const Scene& scene, const Mesh& mesh,
                          const ExtremalCurve& curve, double phi,
                          const MeshOptions& options,
                          const MeshAnswer* coarser) {
  // Far less than branches lie apart, far more than meshes differ that follow
  // a tolerance.
  constexpr double kLargestDeparture = 3e-3;
  MeshAnswer answer{RollingTime(scene, mesh, phi), {}, {}, {}, phi};
  MeshSolution& solution = answer.solution;
  const MeshStart start{prolong(curve, answer.problem), phi, -1.0};
  solution = solve_near(answer.problem, start, options);
  const bool out_of_budget =
      solution.status == Status::IterationLimit &&
      solution.iterations >= options.ipopt.max_iterations;
  if (out_of_budget || solution.status == Status::OutOfMemory ||
      options.ipopt.stop.met()) {
    return answer;
  }
  const double away = solution.solved()
                          ? departure(answer.problem, solution, curve, phi)
                          : std::numeric_limits<double>::infinity();
  if (away > kLargestDeparture && !options.newton_alone) {
    MeshSolution stayed = stay_on_mesh(answer.problem, start, options);
    if (stayed.solved() &&
        departure(answer.problem, stayed, curve, phi) < 0.5 * away) {
      take_instead(solution, std::move(stayed));
    } else {
      answer.problem.set_end_angle(solution.closure.phi);
      if (solution.status == Status::IterationLimit) {
        solution.status = Status::NotConverged;
        solution.message = fmt::format(
            "on degree {}, {} elements no solution near the coarser one: {}",
            mesh.degree, mesh.num_elements(), solution.message);
      }
    }
  }
  if (!solution.solved()) return answer;
  if (coarser == nullptr) {
    if (options.progress) {
      options.progress("check", fmt::format("degree {} on the same elements",
                                            mesh.degree + 1));
    }
    estimate_by_degree(answer, options);
  } else {
    answer.coarser_elements = coarser->problem.mesh().num_elements();
    answer.estimated_error = estimate(answer, answer.curve(), coarser->curve(),
                                      coarser->solution.closure.phi,
                                      coarser->estimated_error.value(), 1.0);
  }
  return answer;
}

int starting_degree(double tolerance) {
  // One degree more for every two digits: elements stay about a tenth of a
  // turn of the body long.
  const double digits = -std::log10(tolerance);
  return std::clamp(static_cast<int>(std::lround(0.5 * digits + 0.5)), 2, 7);
}

Mesh next_mesh(const MeshAnswer& answer, double tolerance,
               bool degree_is_fixed) {
  const Mesh& mesh = answer.problem.mesh();
  Mesh next = mesh;
  next.degree += 1;
  if (!answer.estimated_error) {
    // Nothing is known but that the mesh is too coarse.
    return uniform_mesh(mesh.degree, 2 * mesh.num_elements());
  }
  const double T = answer.finer->transit_time();
  if (!degree_is_fixed && next.degree <= kMaxDegree) {
    // The finer solution's own error, judged as the coarse one's was.
    const double of_finer = sum_of_absolutes(element_errors(*answer.finer));
    if (3.0 * of_finer / T <= tolerance) return next;
  }
  // Errors between fixed ends by element, scaled to the estimate, which knows
  // the contact too.
  std::vector<double> errors = element_errors(answer.curve());
  const double sum = sum_of_absolutes(errors);
  const double scale = sum > 0.0 ? *answer.estimated_error * T / sum : 1.0;
  for (double& error : errors) error *= scale;
  constexpr double kSafety = 0.3;
  Mesh refined = equidistribute(mesh, errors, kSafety * tolerance * T);
  if (refined.num_elements() <= mesh.num_elements()) {
    // The order is not reached yet, or the error is rounding.
    refined = uniform_mesh(mesh.degree, mesh.num_elements() * 3 / 2 + 1);
  }
  return refined;
}

}  // namespace brachisto
