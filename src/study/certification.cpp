// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/certification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "refinement/without_arcs.hpp"
#include "study/limited_shooting.hpp"
#include "study/shooting.hpp"
#include "trajectory/certify.hpp"
#include "trajectory/checks.hpp"
#include "transcription/extremal_curve.hpp"

namespace brachisto {

namespace {

/// Whether a mesh is fixed and its error is not to be judged by a tolerance.
bool none_wanted(const Discretisation& wanted) {
  return wanted.fixed() && !wanted.tolerance;
}

void add_agreement(double estimated, const Discretisation& wanted,
                   std::string where, Certificate& certificate) {
  certificate.add(
      "agreement", estimated,
      none_wanted(wanted) ? kCoarsestAgreement : wanted.wanted_tolerance(),
      std::move(where));
}

}  // namespace

bool under_resolved(const Certificate& certificate) {
  constexpr std::array kMendable{"kkt_residual",      "contact_error",
                                 "hamiltonian",       "slope",
                                 "start_angle",       "energy_drift",
                                 "reintegrated_time", "reintegration_error",
                                 "extremal_slopes",   "extremal_junctions"};
  // Between points a multiplier that falls to zero errs like the rate of β.
  constexpr double kLittle = 100.0;
  const auto mendable = [&](const Check& check) {
    return std::ranges::find(kMendable, check.name) != kMendable.end() ||
           (check.name == "multiplier_signs" &&
            check.value <= kLittle * check.threshold);
  };
  return !certificate.verified() &&
         std::ranges::all_of(certificate.checks, [&](const Check& check) {
           return check.passed || mendable(check);
         });
}

Certificate certify_answer(MeshAnswer& answer, const ExtremalCurve& curve,
                           const Discretisation& wanted) {
  const double estimated = answer.estimated_error.value_or(kUnmeasured);
  // A mesh that missed the tolerance is judged by what it reached.
  const double error = std::max(
      none_wanted(wanted) ? estimated
                          : std::max(wanted.wanted_tolerance(), estimated),
      sum_of_errors(element_errors(curve)) / curve.transit_time());
  Certificate certificate = certify(answer.problem, answer.solution.point,
                                    curve, answer.solution.tangency.phi, error);
  const Mesh& mesh = answer.problem.mesh();
  add_agreement(
      estimated, wanted,
      answer.coarser_elements > 0
          ? fmt::format("{} elements against {}, degree {}",
                        mesh.num_elements(), answer.coarser_elements,
                        mesh.degree)
          : fmt::format("degree {} against {} on {} elements", mesh.degree,
                        mesh.degree + 1, mesh.num_elements()),
      certificate);
  return certificate;
}

Certificate certify_answer(ArcLengthAnswer& answer,
                           const ArcLengthMotion& motion,
                           const Discretisation& wanted) {
  const double estimated = answer.estimated_error.value_or(kUnmeasured);
  Certificate certificate =
      certify(answer.problem, answer.solution.point,
              answer.solution.tangency.phi, motion, estimated);
  add_agreement(
      estimated, wanted,
      fmt::format("{} pieces against {}", answer.problem.num_intervals(),
                  answer.coarser_pieces),
      certificate);
  return certificate;
}

Certificate certify_answer(const LimitedAnswer& answer,
                           const Discretisation& wanted) {
  const double estimated = answer.estimated_error.value_or(kUnmeasured);
  const Mesh& mesh = answer.path.curve.problem().mesh();
  Certificate certificate =
      certify(answer.path.curve, answer.path.mismatch.largest(), estimated);
  if (!arcs_are_known(answer.path.curve)) {
    certificate.add("agreement", estimated,
                    wanted.tolerance.value_or(kToleranceWithoutArcs),
                    fmt::format("{} elements against half as many, degree {}, "
                                "without arcs",
                                mesh.num_elements(), mesh.degree));
    return certificate;
  }
  add_agreement(
      estimated, wanted,
      answer.sampled ? fmt::format("the sum over {} elements and shooting",
                                   mesh.num_elements())
      : answer.judged_by > 0
          ? fmt::format("{} elements of degree {} against {} of another mesh",
                        mesh.num_elements(), mesh.degree, answer.judged_by)
          : fmt::format("degree {} against {} on {} elements", mesh.degree,
                        mesh.degree + 1, mesh.num_elements()),
      certificate);
  return certificate;
}

CrossCheck compare_with(const ExtremalSolution& extremal, double ratio) {
  CrossCheck check;
  check.solved = extremal.usable();
  check.message = extremal.message;
  if (check.solved) {
    check.tau = extremal.tau;
    check.error_estimate = extremal.error_estimate;
    check.difference = std::abs(ratio - 1.0);
  }
  return check;
}

CrossCheck cross_check(const PosedScene& scene, const ExtremalCurve& nearby,
                       double phi, double T, double error,
                       const StopCondition& stop, Certificate& certificate) {
  ExtremalOptions options;
  options.stop = stop;
  const ExtremalSolution other =
      solve_extremal(scene.scene, as_guess(nearby, scene.units, phi), options);
  CrossCheck check = compare_with(other, T / other.transit_time);
  certificate.add("extremal", check.solved ? check.difference : kUnmeasured,
                  error + check.error_estimate, check.message);
  return check;
}

CrossCheck cross_check(const FittedPath& found, double error,
                       const StopCondition& stop, Certificate& certificate) {
  constexpr double kSlopes = 100.0, kJunctions = 1000.0;
  const Scene& scene = found.curve.problem().scene();
  if (!arcs_are_known(found.curve)) {
    CrossCheck none{.message = "a path without arcs is not known to it"};
    certificate.add("extremal", kUnmeasured, error, none.message);
    return none;
  }
  const LimitedExtremal other = shoot_over_arcs(found, stop);
  CrossCheck check{.solved = other.solved, .message = other.message};
  if (!check.solved) {
    certificate.add("extremal", kUnmeasured, error, check.message);
    return check;
  }
  check.tau = other.transit_time * std::sqrt(2.0 * scene.gravity / scene.H);
  check.error_estimate = other.error_estimate;
  check.difference =
      std::abs(found.curve.transit_time() / other.transit_time - 1.0);
  certificate.add("extremal", check.difference, error + check.error_estimate);

  // Of several differences the one that comes closest to what is allowed.
  const auto compare = [&](const char* name, double factor,
                           const std::vector<std::pair<double, Loose>>& both) {
    double largest = 0.0, worst = 0.0, allowed = factor * error;
    for (const auto& [here, there] : both) {
      const double difference = std::abs(here - there.value);
      const double most = std::max(factor, there.looseness) * error;
      // Written so that a NaN stays.
      if (!(difference <= largest)) largest = difference;
      if (std::isnan(worst) || difference / most <= worst / allowed) continue;
      worst = difference;
      allowed = most;
    }
    certificate.add(name, worst, allowed);
    return largest;
  };
  check.of_slopes =
      compare("extremal_slopes", kSlopes,
              {{found.curve.at(0.0).state.beta, other.start_angle},
               {found.curve.at(1.0).state.beta, other.end_angle}});
  std::vector<std::pair<double, Loose>> junctions;
  const double U = other.junctions.back().value;
  for (std::size_t i = 0; i + 1 < found.arcs.size(); ++i) {
    const auto& [u, looseness] = other.junctions[i];
    junctions.push_back({found.arcs[i].end, {u / U, looseness / U}});
  }
  check.of_junctions = compare("extremal_junctions", kJunctions, junctions);
  return check;
}

Certificate certify_discrete(const DiscreteAnswer& answer,
                             const CrossCheck& check) {
  Certificate certificate;
  certificate.add("discrete_residual", answer.residual,
                  DiscreteSystem{}.tolerance);
  certificate.add(
      "discretisation", check.solved ? check.difference : kUnmeasured,
      kDefaultTolerance,
      check.solved
          ? fmt::format("τ = {:.6f} of {} nodes, {:.6f} of the extremal",
                        answer.tau, answer.nodes, check.tau)
          : check.message);
  return certificate;
}

}  // namespace brachisto
