// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/arc_accuracy.hpp"

#include <cmath>
#include <utility>

#include "refinement/arc_elements.hpp"

namespace brachisto {

std::optional<FittedPath> on_fixed_mesh(
    const FittedPath& path, int p, const std::vector<PathInequality>& limits,
    const Discretisation& wanted, ArcSearch& search) {
  const int elements =
      wanted.elements ? *wanted.elements : (*wanted.nodes - 1) / p;
  return search
      .fit(path.curve, {limits, with_elements(path.arcs, elements), path.ends},
           p)
      .path;
}

std::optional<LimitedAnswer> refine_arcs(
    std::optional<FittedPath> path, int p,
    const std::vector<PathInequality>& limits, const Discretisation& wanted,
    ArcSearch& search, PassProtocol& protocol) {
  constexpr double kRounding = 1e-13;
  constexpr int kMostMeshes = 8, kManyElements = 2000;
  std::optional<LimitedAnswer> answer;
  for (int i = 0; path && i < kMostMeshes; ++i) {
    if (!wanted.fixed() && i + 1 < kMostMeshes &&
        path->curve.problem().mesh().num_elements() <= kManyElements &&
        !keeps_limits(path->curve)) {
      std::vector<Arc> arcs = path->arcs;
      divide(path->curve, path->curve, wanted.wanted_tolerance(), arcs);
      path = search.fit_corrected(path->curve,
                                  {limits, std::move(arcs), path->ends}, p);
      continue;
    }
    const ArcFit finer =
        search.fit(path->curve, {limits, path->arcs, path->ends}, p + 1);
    if (!finer.path) return answer;
    const double T = path->curve.transit_time();
    // The difference is T's error less that of the finer one, of either sign.
    const double error =
        2.0 * std::abs(finer.path->curve.transit_time() / T - 1.0) +
        path->mismatch.largest() + kRounding;
    protocol.record.estimated_error = error;
    protocol.keep_record("arcs", T);
    answer.emplace(LimitedAnswer{*path, error});
    protocol.status = Status::Solved;
    protocol.message = "solved under limits";
    const double tolerance = wanted.wanted_tolerance();
    if (wanted.fixed() || (error <= tolerance && keeps_limits(path->curve)) ||
        path->curve.problem().mesh().num_elements() > kManyElements) {
      return answer;
    }
    std::vector<Arc> arcs = finer.path->arcs;
    divide(path->curve, finer.path->curve, 0.3 * tolerance, arcs);
    path = search.fit_corrected(finer.path->curve,
                                {limits, std::move(arcs), finer.path->ends}, p);
  }
  return answer;
}

}  // namespace brachisto
