// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/study/arc_length_refinement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "brachisto/study/certification.hpp"
#include "brachisto/transcription/prolongation.hpp"
#include "study/turn_meshes.hpp"

namespace brachisto {

namespace {

constexpr int kFewestCoarse = 50;
constexpr double kCoarsePerTurn = 50.0;
constexpr int kMostPieces = 5'000'000;
constexpr double kAim = 0.7;  // of the tolerance
constexpr int kMostTries = 4;
constexpr int kLargestDoubling = 30;

/// n, n/4, n/16, … down to about `coarsest`, in ascending order; n/4 or, of few
/// pieces, n/2 always.
std::vector<int> divisions(int n, int coarsest) {
  constexpr int kStep = 4;
  std::vector<int> pieces{n};
  do {
    const int before = pieces.back();
    pieces.push_back(before >= kStep * coarsest ? (before + kStep - 1) / kStep
                                                : (before + 1) / 2);
  } while (pieces.back() >= 2 * coarsest);
  return {pieces.rbegin(), pieces.rend()};
}

/// One run of refine_arc_length().
class Sequence {
 public:
  Sequence(const Scene& scene, const ExtremalCurve& curve, double phi,
           const MeshOptions& options)
      : scene_(scene), curve_(curve), phi_(phi), options_(options) {}

  /// Solves on meshes of ascending numbers of pieces, those that are not finer
  /// than the present one left out. False if the last one fails.
  bool climb(const std::vector<int>& pieces);
  [[nodiscard]] ArcLengthRefinement& out() { return out_; }

 private:
  [[nodiscard]] MeshSolution solve(ArcLength& problem, const MeshStart& start);
  [[nodiscard]] double estimate(const ArcLengthAnswer& finer) const;

  const Scene& scene_;
  const ExtremalCurve& curve_;
  double phi_;
  MeshOptions options_;
  ArcLengthRefinement out_;
};

MeshSolution Sequence::solve(ArcLength& problem, const MeshStart& start) {
  constexpr double kLargestDeparture = 3e-2;
  const auto is_near = [&](const MeshSolution& found) {
    return found.solved() &&
           std::abs(found.closure.phi - start.phi) <= kLargestDeparture;
  };
  MeshSolution solution = solve_near(problem, start, options_);
  if (options_.ipopt.stop.met() || is_near(solution) || options_.newton_alone ||
      solution.status == Status::OutOfMemory) {
    return solution;
  }
  MeshSolution stayed = stay_on_mesh(problem, start, options_);
  if (is_near(stayed)) {
    stayed.closure.slope = solution.closure.slope;
    take_instead(solution, std::move(stayed));
    return solution;
  }
  if (solution.solved()) {
    solution.status = Status::NotConverged;
    solution.message = "no solution near the coarser one";
  }
  solution.message = fmt::format("on {} pieces: {}", problem.num_intervals(),
                                 solution.message);
  return solution;
}

double Sequence::estimate(const ArcLengthAnswer& finer) const {
  // Of terms of higher order in the change from mesh to mesh: as if the order
  // was only this.
  constexpr double kLeastOrder = 1.58;
  const ArcLengthAnswer& coarser = *out_.answer;
  const double n = finer.problem.num_intervals();
  const double ratio = n / coarser.problem.num_intervals();
  const double q = ratio * ratio;
  const ContactClosure& closure = finer.solution.closure;
  const Costates p = finer.problem.end_costates(finer.solution.point.lambda);
  // dT/dφ
  const double per_radian =
      scene_.contact == Contact::Smooth
          ? -scene_.body.radius *
                (p.p_x * std::cos(closure.phi) + p.p_z * std::sin(closure.phi))
          : 0.0;
  const double T = finer.transit_time;
  const double of_ends =
      per_radian * (closure.phi - coarser.solution.closure.phi);
  const double rest = T - coarser.transit_time - of_ends;
  const double between = (std::abs(of_ends) + std::abs(rest)) /
                         (std::pow(ratio, kLeastOrder) - 1.0) / T;
  const double before = coarser.estimated_error.value_or(0.0) / q;
  const double open = std::abs(closure.mismatch / closure.slope) * per_radian;
  const double ends = rounding_of_ends(scene_, closure.phi, p.p_x, p.p_z);
  // A sum of N terms, each rounded.
  const double rounding =
      2.0 * std::numeric_limits<double>::epsilon() * (8.0 + std::sqrt(n));
  return std::max(between, before) + (open + ends) / T + rounding;
}

bool Sequence::climb(const std::vector<int>& pieces) {
  for (const int n : pieces) {
    if (out_.answer && n <= out_.answer->problem.num_intervals()) continue;
    const bool first = !out_.answer;
    MeshStart start;
    start.phi = first ? phi_ : out_.answer->solution.closure.phi;
    start.closure_slope = first ? -1.0 : out_.answer->solution.closure.slope;
    ArcLengthAnswer answer{ArcLength(scene_, n, start.phi), {}, 0.0, {}, 0};
    start.point = first ? prolong(curve_, answer.problem)
                        : prolong(out_.answer->problem,
                                  out_.answer->solution.point, answer.problem);
    answer.solution = solve(answer.problem, start);
    MeshSolution& solution = answer.solution;
    const bool solved = solution.solved() && !options_.ipopt.stop.met() &&
                        answer.problem.set_point(solution.point.x);
    if (solved) {
      answer.transit_time = answer.problem.eval_f();
      if (!first) {
        answer.estimated_error = estimate(answer);
        answer.coarser_pieces = out_.answer->problem.num_intervals();
      }
    }
    book(answer.problem, solution, answer.estimated_error, options_, out_);
    if (options_.progress) {
      options_.progress(fmt::format("{} pieces", n), solution.message);
    }
    if (!solved) {
      // A mesh that is too coarse tells nothing; the next one starts from the
      // curve again.
      out_.answer.reset();
      if (!too_coarse(solution) || options_.ipopt.stop.met() ||
          n == pieces.back()) {
        return false;
      }
      continue;
    }
    out_.answer.emplace(std::move(answer));
  }
  return true;
}

}  // namespace

ArcLengthRefinement refine_arc_length(const Scene& scene,
                                      const Discretisation& wanted,
                                      const ExtremalCurve& curve, double phi,
                                      MeshOptions options) {
  Sequence sequence(scene, curve, phi, options);
  ArcLengthRefinement& out = sequence.out();
  // All that the continuation's answer is needed for.
  const int coarsest = std::max(
      kFewestCoarse,
      static_cast<int>(
          std::ceil(kCoarsePerTurn * turns(scene.body, curve.arc_length()))));
  if (wanted.fixed()) {
    const int n = wanted.elements ? *wanted.elements : *wanted.nodes - 1;
    sequence.climb(divisions(n, coarsest));
    return std::move(out);
  }
  const double tolerance = wanted.wanted_tolerance();
  int coarse = coarsest;
  while (!sequence.climb({coarse, 2 * coarse}) ||
         !out.answer->estimated_error) {
    if (options.ipopt.stop.met() || coarse > kLargestDoubling * coarsest) {
      return std::move(out);
    }
    coarse *= 2;
  }
  for (int i = 0; i < kMostTries; ++i) {
    const double error = *out.answer->estimated_error;
    if (error <= tolerance) break;
    const double n = out.answer->problem.num_intervals() *
                     std::sqrt(error / (kAim * tolerance));
    if (!(n <= kMostPieces)) {
      out.status = Status::NotConverged;
      out.message = fmt::format(
          "a relative error of {:.1e} would need {:.1e} straight pieces; take "
          "formulation: rolling_time",
          tolerance, n);
      break;
    }
    const auto pieces = static_cast<int>(std::ceil(n));
    if (!sequence.climb(divisions(pieces, coarse)) ||
        !out.answer->estimated_error) {
      break;
    }
  }
  return std::move(out);
}

Certificate certify_answer(ArcLengthAnswer& answer,
                           const ArcLengthMotion& motion,
                           const Discretisation& wanted) {
  const double estimated =
      answer.estimated_error.value_or(std::numeric_limits<double>::quiet_NaN());
  const bool none_wanted = wanted.fixed() && !wanted.tolerance;
  const double tolerance = wanted.wanted_tolerance();
  Certificate certificate =
      certify(answer.problem, answer.solution.point,
              answer.solution.closure.phi, motion, estimated);
  const int n = answer.problem.num_intervals();
  certificate.add(
      "agreement", estimated, none_wanted ? kCoarsestAgreement : tolerance,
      fmt::format("{} pieces against {}", n, answer.coarser_pieces));
  return certificate;
}

}  // namespace brachisto
