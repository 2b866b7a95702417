// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Sequences of meshes of straight pieces.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <utility>

#include "refinement/mesh_sequence.hpp"
#include "refinement/refinement.hpp"
#include "refinement/turn_meshes.hpp"
#include "transcription/prolongation.hpp"

namespace brachisto {

namespace {

/// Pieces of a mesh over those of the mesh before.
constexpr int kStride = 4;
/// The same where the mesh before is fine: what is left of its error after the
/// first step of Newton's method is the square, and that is rounding then.
constexpr int kLongStride = kStride * kStride;

/// n, n/4, n/16, … down to about `coarsest`, in ascending order; n/4 or, of few
/// pieces, n/2 always.
///
/// \param longest  the stride to a mesh of `longest` times `coarsest` or more
std::deque<int> divisions(int n, int coarsest, int longest) {
  std::deque<int> pieces{n};
  do {
    const int before = pieces.back();
    const int stride =
        before / longest >= longest * coarsest ? longest : kStride;
    pieces.push_back(before >= stride * coarsest
                         ? (before + stride - 1) / stride
                         : (before + 1) / 2);
  } while (pieces.back() >= 2 * coarsest);
  return {pieces.rbegin(), pieces.rend()};
}

/// Near the start, or nothing that is solved.
MeshSolution solve_from(ArcLength& problem, MeshStart start,
                        const MeshOptions& options) {
  if (options.newton_alone) {
    return solve_near(problem, std::move(start), options);
  }
  constexpr double kLargestDeparture = 3e-2;
  const auto is_near = [phi = start.phi](const MeshSolution& found) {
    return found.solved() &&
           std::abs(found.tangency.phi - phi) <= kLargestDeparture;
  };
  MeshSolution solution = solve_near(problem, start, options);
  if (options.ipopt.stop.met() || is_near(solution) ||
      solution.status == Status::OutOfMemory) {
    return solution;
  }
  MeshSolution stayed = stay_on_mesh(problem, std::move(start), options);
  if (is_near(stayed)) {
    stayed.tangency.slope = solution.tangency.slope;
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

/// The error of `finer`; see refine_arc_length().
double estimate(const ArcLengthAnswer& finer, const ArcLengthAnswer& coarser) {
  // Of terms of higher order in the change from mesh to mesh: as if the order
  // was only this.
  constexpr double kLeastOrder = 1.58;
  const double n = finer.problem.num_intervals();
  const double ratio = n / coarser.problem.num_intervals();
  const double q = ratio * ratio;
  const Tangency& tangency = finer.solution.tangency;
  const EndErrors ends =
      errors_of_end(finer.problem.scene(), tangency,
                    finer.problem.end_costates(finer.solution.point.lambda));
  const double T = finer.transit_time;
  const double of_ends =
      ends.per_radian * (tangency.phi - coarser.solution.tangency.phi);
  const double rest = T - coarser.transit_time - of_ends;
  const double between = (std::abs(of_ends) + std::abs(rest)) /
                         (std::pow(ratio, kLeastOrder) - 1.0) / T;
  const double before = coarser.estimated_error.value_or(0.0) / q;
  // A sum of N terms, each rounded.
  const double rounding =
      2.0 * std::numeric_limits<double>::epsilon() * (8.0 + std::sqrt(n));
  return std::max(between, before) + (ends.open + ends.rounding) / T + rounding;
}

/// Climbs from coarse meshes to fine ones, each from the solution before.
class Pieces {
 public:
  Pieces(const Scene& scene, const Discretisation& wanted,
         const ExtremalCurve& curve, double phi)
      : scene_(scene),
        curve_(curve),
        phi_(phi),
        fixed_(wanted.fixed()),
        tolerance_(wanted.wanted_tolerance()),
        // All that the continuation's answer is needed for.
        coarsest_(std::max(
            kFewestCoarse,
            static_cast<int>(std::ceil(
                kCoarsePerTurn * turns(scene.body, curve.arc_length()))))),
        coarse_(coarsest_),
        next_(fixed_ ? divisions(wanted.elements ? *wanted.elements
                                                 : *wanted.nodes - 1,
                                 coarsest_, kLongStride)
                     : std::deque{coarse_, 2 * coarse_}) {}

  [[nodiscard]] std::string name() const {
    return fmt::format("{} pieces", next_.front());
  }
  [[nodiscard]] ArcLengthAnswer solve(const MeshOptions& options,
                                      ArcLengthRefinement& out) const {
    ArcLengthAnswer* const before = out.answer ? &*out.answer : nullptr;
    MeshStart start;
    start.phi = before ? before->solution.tangency.phi : phi_;
    if (before) start.tangency_slope = before->solution.tangency.slope;
    ArcLengthAnswer answer{
        ArcLength(scene_, next_.front(), start.phi), {}, 0.0, {}, 0};
    start.point = before ? prolong(before->problem, before->solution.point,
                                   answer.problem)
                         : prolong(curve_, answer.problem);
    answer.solution = solve_from(answer.problem, std::move(start), options);
    if (answer.solution.solved() && !options.ipopt.stop.met() &&
        answer.problem.set_point(answer.solution.point.x)) {
      answer.transit_time = answer.problem.eval_f();
      if (before) {
        answer.estimated_error = estimate(answer, *before);
        answer.coarser_pieces = before->problem.num_intervals();
      }
    }
    return answer;
  }
  bool goes_on(ArcLengthAnswer answer, const StopCondition& stop,
               ArcLengthRefinement& out) {
    next_.pop_front();
    if (answer.transit_time > 0.0) {
      out.answer.emplace(std::move(answer));
    } else {
      // A mesh that is too coarse tells nothing; the next one starts from the
      // curve again.
      out.answer.reset();
      if (!too_coarse(answer.solution) || stop.met()) next_.clear();
    }
    if (!next_.empty()) return true;
    if (fixed_) return false;
    return out.answer && out.answer->estimated_error ? refines(out)
                                                     : begins_anew(stop, out);
  }

 private:
  static constexpr int kFewestCoarse = 50;
  static constexpr double kCoarsePerTurn = 50.0;

  /// With twice as many pieces, if there was no estimate yet.
  bool begins_anew(const StopCondition& stop, const ArcLengthRefinement& out) {
    constexpr int kLargestDoubling = 30;
    if (tries_ > 0 || stop.met() || coarse_ > kLargestDoubling * coarsest_) {
      return false;
    }
    coarse_ *= 2;
    climb_to({coarse_, 2 * coarse_}, out);
    return true;
  }
  /// Until the error is as small as wanted.
  bool refines(ArcLengthRefinement& out) {
    constexpr int kMostPieces = 5'000'000;
    constexpr double kAim = 0.7;  // of the tolerance
    constexpr int kMostTries = 4;
    const double error = *out.answer->estimated_error;
    if (error <= tolerance_ || ++tries_ > kMostTries) return false;
    const double n = out.answer->problem.num_intervals() *
                     std::sqrt(error / (kAim * tolerance_));
    if (!(n <= kMostPieces)) {
      out.status = Status::NotConverged;
      out.message = fmt::format(
          "a relative error of {:.1e} would need {:.1e} straight pieces; take "
          "formulation: rolling_time",
          tolerance_, n);
      return false;
    }
    // The estimate that n follows from is that of short strides.
    climb_to(divisions(static_cast<int>(std::ceil(n)), coarse_, kStride), out);
    return true;
  }
  /// Over those meshes that are finer than the present one.
  void climb_to(std::deque<int> pieces, const ArcLengthRefinement& out) {
    next_ = std::move(pieces);
    while (out.answer && next_.front() <= out.answer->problem.num_intervals()) {
      next_.pop_front();
    }
  }

  const Scene& scene_;
  const ExtremalCurve& curve_;
  double phi_;
  bool fixed_;
  double tolerance_;
  int coarsest_, coarse_;
  int tries_ = 0;
  std::deque<int> next_;  ///< numbers of pieces, ascending
};

}  // namespace

ArcLengthRefinement refine_arc_length(const Scene& scene,
                                      const Discretisation& wanted,
                                      const ExtremalCurve& curve, double phi,
                                      MeshOptions options) {
  return run<Pieces, ArcLengthRefinement>({scene, wanted, curve, phi},
                                          std::move(options));
}

}  // namespace brachisto
