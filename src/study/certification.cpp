// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/study/certification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "brachisto/study/extremal_bridge.hpp"
#include "brachisto/transcription/element_errors.hpp"

namespace brachisto {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace

bool under_resolved(const Certificate& certificate) {
  constexpr std::array kMendable{"hamiltonian",       "slope",
                                 "start_angle",       "energy_drift",
                                 "reintegrated_time", "reintegration_error"};
  return !certificate.verified() &&
         std::all_of(certificate.checks.begin(), certificate.checks.end(),
                     [&](const Check& check) {
                       return check.passed ||
                              std::find(kMendable.begin(), kMendable.end(),
                                        check.name) != kMendable.end();
                     });
}

Certificate certify_answer(MeshAnswer& answer, const Discretisation& wanted) {
  const double estimated = answer.estimated_error.value_or(kUnknown);
  const bool none_wanted = wanted.fixed() && !wanted.tolerance;
  const double tolerance = wanted.tolerance.value_or(kDefaultTolerance);
  // A mesh that missed the tolerance is judged by what it reached. Errors of
  // either sign may cancel in T; along the path they do not.
  const ExtremalCurve curve = answer.curve();
  double shares = 0.0;
  for (const double share : element_errors(curve)) shares += std::abs(share);
  const double error =
      std::max(none_wanted ? estimated : std::max(tolerance, estimated),
               shares / curve.transit_time());
  Certificate certificate = certify(answer.problem, answer.solution.point,
                                    answer.solution.closure.phi, error);
  const Mesh& mesh = answer.problem.mesh();
  certificate.add(
      "agreement", estimated, none_wanted ? kCoarsestAgreement : tolerance,
      answer.coarser_elements > 0
          ? fmt::format("{} elements against {}, degree {}",
                        mesh.num_elements(), answer.coarser_elements,
                        mesh.degree)
          : fmt::format("degree {} against {} on {} elements", mesh.degree,
                        mesh.degree + 1, mesh.num_elements()));
  return certificate;
}

ExtremalOpinion ask_extremal(const Scene& scene, const MeshAnswer& answer,
                             const StopCondition& stop,
                             Certificate& certificate) {
  const ExtremalCurve curve = answer.curve();
  return ask_extremal(scene, curve, answer.solution.closure.phi,
                      curve.transit_time() * natural_units(scene).time,
                      answer.estimated_error.value_or(0.0), stop, certificate);
}

ExtremalOpinion ask_extremal(const Scene& scene, const ExtremalCurve& nearby,
                             double phi, double T, double error,
                             const StopCondition& stop,
                             Certificate& certificate) {
  ExtremalOptions options;
  options.stop = stop;
  const ExtremalSolution other = solve_extremal(
      scene, as_guess(nearby, natural_units(scene), phi), options);
  ExtremalOpinion opinion;
  opinion.solved = other.usable();
  opinion.message = other.message;
  double difference = kUnknown;
  if (opinion.solved) {
    opinion.tau = other.tau;
    opinion.error_estimate = other.error_estimate;
    difference = std::abs(T / other.transit_time - 1.0);
    opinion.difference = difference;
  }
  certificate.add("extremal", difference, error + opinion.error_estimate,
                  other.message);
  return opinion;
}

}  // namespace brachisto
