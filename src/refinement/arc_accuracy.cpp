// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/arc_accuracy.hpp"

#include <cmath>
#include <utility>

#include "refinement/arc_elements.hpp"
#include "refinement/mesh_choice.hpp"

namespace brachisto {

namespace {

constexpr double kRounding = 1e-13;
constexpr const char* kSolvedOverArcs = "solved under limits";
constexpr int kManyElements = 2000;

LimitedAnswer told(FittedPath path, double error, PassProtocol& protocol) {
  protocol.record.estimated_error = error;
  protocol.keep_record("arcs", path.curve.transit_time());
  protocol.status = Status::Solved;
  protocol.message = kSolvedOverArcs;
  return {std::move(path), error};
}

/// By how much the time along one path is off that along another, relative.
double change(const FittedPath& path, const FittedPath& other) {
  return std::abs(other.curve.transit_time() / path.curve.transit_time() - 1.0);
}

/// How closely limits are kept.
struct Closeness {
  double allowed = kAllowedExcess;  ///< to be exceeded by
  bool stays = false;               ///< no arcs were found without
};

/// The path with less of it: on shorter elements, if polynomials exceed limits
/// between the points, or with more arcs, if the path does, unless that is so
/// little that these would be too short for their equations. Nothing if it was
/// not found on shorter elements.
std::optional<FittedPath> within_limits(FittedPath path, int p,
                                        double tolerance, ArcSearch& search,
                                        Closeness& closeness) {
  constexpr int kMostMeshes = 7;
  constexpr double kTooLittle = 5e-9;  // half of what a certificate allows
  constexpr double kFalls = 0.25;      // of polynomials by far more
  std::optional<double> before;
  for (int i = 0; i < kMostMeshes && !closeness.stays; ++i) {
    const double now = largest_excess(path.curve);
    if (now <= closeness.allowed ||
        path.curve.problem().mesh().num_elements() > kManyElements) {
      break;
    }
    const bool of_path = before && now > kFalls * *before;
    if (of_path && now <= kTooLittle) {
      closeness.allowed = kTooLittle;
      break;
    }
    const std::vector<PathInequality> limits = path.curve.problem().limits();
    std::vector<Arc> arcs = path.arcs;
    if (!of_path) divide(path.curve, path.curve, tolerance, arcs);
    auto next =
        search.fit_corrected(path.curve, {limits, std::move(arcs), path.ends},
                             p, of_path ? kTooLittle : kExceeded);
    if (!next && !of_path) return std::nullopt;
    closeness.stays = of_path;
    if (next) path = *std::move(next);
    before = now;
  }
  return path;
}

}  // namespace

std::optional<LimitedAnswer> on_fixed_mesh(const FittedPath& path, int p,
                                           const Discretisation& wanted,
                                           ArcSearch& search,
                                           PassProtocol& protocol) {
  const int elements =
      wanted.elements ? *wanted.elements : (*wanted.nodes - 1) / p;
  const std::vector<PathInequality>& limits = path.curve.problem().limits();
  constexpr int kTimesCoarser = 16;
  const Mesh& coarse = path.curve.problem().mesh();
  std::optional<LimitedAnswer> judge;
  if (elements >= kTimesCoarser * coarse.num_elements()) {
    Discretisation accurate;
    accurate.tolerance = largest_error_of_a_judge(wanted.wanted_tolerance());
    judge = refine_arcs(path, coarse.degree, accurate, search, protocol);
    if (judge &&
        (*judge->estimated_error > *accurate.tolerance ||
         !(largest_excess(judge->path.curve) <= kAllowedExcess) ||
         judge->path.curve.problem().mesh().num_elements() >= elements)) {
      judge.reset();
    }
  }
  const FittedPath& from = judge ? judge->path : path;
  std::optional<FittedPath> found =
      search
          .fit(from.curve,
               {limits, with_elements(from.arcs, elements), from.ends}, p)
          .path;
  if (!found || !judge) {
    return refine_arcs(std::move(found), p, wanted, search, protocol);
  }
  const double error = *judge->estimated_error + change(*found, judge->path) +
                       found->mismatch.largest() + kRounding;
  LimitedAnswer answer = told(*std::move(found), error, protocol);
  answer.judged_by = judge->path.curve.problem().mesh().num_elements();
  return answer;
}

std::optional<LimitedAnswer> refine_arcs(std::optional<FittedPath> path, int p,
                                         const Discretisation& wanted,
                                         ArcSearch& search,
                                         PassProtocol& protocol) {
  constexpr int kMostMeshes = 8;
  if (!path) return std::nullopt;
  const std::vector<PathInequality> limits = path->curve.problem().limits();
  const double tolerance = wanted.wanted_tolerance();
  std::optional<LimitedAnswer> answer;
  bool accurate = false;  // in time
  Closeness closeness;
  for (int i = 0; path && i < kMostMeshes; ++i) {
    if (!wanted.fixed() && i + 1 < kMostMeshes) {
      path = within_limits(*std::move(path), p, tolerance, search, closeness);
      if (!path) break;
    }
    const ArcFit finer =
        search.fit(path->curve, {limits, path->arcs, path->ends}, p + 1);
    if (!finer.path) break;
    // The difference is T's error less that of the finer one, of either sign.
    const double error =
        2.0 * change(*path, *finer.path) + path->mismatch.largest() + kRounding;
    const bool good =
        error <= tolerance && largest_excess(path->curve) <= closeness.allowed;
    if (accurate && !good) break;
    accurate = good;
    answer.emplace(told(*path, error, protocol));
    if (wanted.fixed() ||
        (good && slopes_agree(path->curve, finer.path->curve, tolerance)) ||
        path->curve.problem().mesh().num_elements() > kManyElements) {
      return answer;
    }
    std::vector<Arc> arcs = finer.path->arcs;
    if (!divide(path->curve, finer.path->curve, 0.3 * tolerance, arcs)) break;
    path = search.fit_corrected(finer.path->curve,
                                {limits, std::move(arcs), finer.path->ends}, p);
  }
  if (accurate) {  // only its slopes could be better
    protocol.status = Status::Solved;
    protocol.message = kSolvedOverArcs;
  }
  return answer;
}

}  // namespace brachisto
