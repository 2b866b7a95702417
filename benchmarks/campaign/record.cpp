// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "campaign/record.hpp"

#include <fmt/format.h>

#include "brachisto/study/solve.hpp"
#include "math/wall_clock.hpp"
#include "model/cycloid.hpp"
#include "study/answer_kinds.hpp"
#include "support/csv.hpp"

namespace brachisto::benchmarks {

namespace {

constexpr double kWitnessSeconds = 300.0;

Verdict judge(const Record& record, bool witness_usable) {
  if (record.status != Status::Solved) return Verdict::NotSolved;
  if (!record.verified) return Verdict::Unverified;
  if (!witness_usable) return Verdict::NoWitness;
  const bool same =
      record.difference.tau <= kSameTau && record.difference.path <= kSamePath;
  return same ? Verdict::Agrees : Verdict::Disagrees;
}

}  // namespace

std::string_view word(Verdict verdict) {
  switch (verdict) {
    case Verdict::Agrees:
      return "agrees";
    case Verdict::Disagrees:
      return "disagrees";
    case Verdict::NoWitness:
      return "no_witness";
    case Verdict::Unverified:
      return "unverified";
    case Verdict::NotSolved:
      return "not_solved";
    case Verdict::NoCycloid:
      return "no_cycloid";
    case Verdict::Lost:
      return "lost";
  }
  return "unknown";
}

Record examine(const Scene& scene) {
  Record record;
  if (!axisymmetric_optimum(scene)) {
    record.verdict = Verdict::NoCycloid;
    return record;
  }
  const Solution found = solve(scene);
  record.status = found.status;
  record.verified = found.verified();
  record.feasible = found.verified() && found.feasible();
  record.reason = FixedText<400>(why_not_verified(found));
  if (found.estimated_error) record.estimated_error = *found.estimated_error;
  if (trajectory_of(found)) {
    record.tau = found.motion()->tau();
    record.degree = trajectory_of(found)->curve().mesh().degree;
    record.elements = trajectory_of(found)->curve().mesh().num_elements();
  }
  record.meshes = static_cast<int>(found.effort.meshes.size());
  record.iterations = found.effort.iterations;
  record.newton_steps = found.effort.newton_steps;
  record.folds = static_cast<int>(found.folds.size());
  record.seconds = found.effort.seconds;

  const auto begin = WallClock::now();
  const ExtremalSolution witness = ask_witness(scene, kWitnessSeconds);
  record.witness_seconds = seconds_since(begin);
  record.witness_status = witness.status;
  record.witness_folds = static_cast<int>(witness.continuation.folds.size());
  if (!witness.solved()) {
    record.witness_reason = FixedText<400>(witness.message);
  }
  if (witness.usable()) {
    record.witness_tau = witness.tau;
    record.witness_error = witness.error_estimate;
    if (trajectory_of(found)) {
      record.difference = compare(*trajectory_of(found), witness);
    }
  }
  record.verdict = judge(record, witness.usable());
  return record;
}

std::string csv_head() {
  return "index,L,r,eta_m,theta_m,k,verdict,status,verified,feasible,tau,"
         "estimated_error,degree,elements,meshes,iterations,newton_steps,folds,"
         "seconds,witness,witness_tau,witness_error,witness_folds,"
         "witness_seconds,difference_tau,difference_path,"
         "difference_nodes,difference_angle,"
         "reason,witness_reason\n";
}

std::string csv_line(int index, const Scene& scene, const Record& record) {
  const Body& body = scene.body;
  const Difference& apart = record.difference;
  return fmt::format(
      "{},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{},{},{:d},{:d},{:.15g},"
      "{:.3g},{},{},{},{},{},{},{:.4f},{},{:.15g},{:.3g},{},{:.4f},{:.3g},"
      "{:.3g},{:.3g},{:.3g},{},{}\n",
      index, scene.L, body.radius, body.eta_m, body.theta_m, body.k,
      word(record.verdict), name(record.status), record.verified,
      record.feasible, record.tau, record.estimated_error, record.degree,
      record.elements, record.meshes, record.iterations, record.newton_steps,
      record.folds, record.seconds, word(record.witness_status),
      record.witness_tau, record.witness_error, record.witness_folds,
      record.witness_seconds, apart.tau, apart.path, apart.nodes, apart.angle,
      csv_field(record.reason.str()), csv_field(record.witness_reason.str()));
}

}  // namespace brachisto::benchmarks
