// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/arcs_from_mesh.hpp"

#include <limits>
#include <utility>

#include "refinement/arcs.hpp"

namespace brachisto {

std::optional<FittedPath> arcs_from(const LimitedCurve& mesh, int degree,
                                    ArcSearch& search, PassProtocol& protocol) {
  const std::vector<Arc> arcs = arcs_of(mesh);
  if (kinks_at_rest(mesh, arcs)) {
    protocol.fail(Status::NoFastestTrack,
                  "there is no fastest track under these limits: the more "
                  "sharply it turns upwards right behind A, where a normal "
                  "force bounds no turn, the faster it is. To try: "
                  "limits.curvature.valley");
    return std::nullopt;
  }
  const ArcsFromA from_A =
      with_corner(mesh.problem(), arcs, mesh.corner_at_rest(kExceeded));
  LimitedEnds ends = mesh.problem().ends();
  ends.corner = from_A.corner;
  for (const bool graded : {false, true}) {
    auto path =
        search.fit_corrected(mesh, {mesh.problem().limits(), from_A.arcs, ends},
                             degree, kExceeded, graded);
    if (path || protocol.stopped()) return path;
  }
  return std::nullopt;
}

std::optional<LimitedAnswer> refined(FittedPath path,
                                     const Discretisation& wanted,
                                     ArcSearch& search,
                                     PassProtocol& protocol) {
  const int p = wanted.degree.value_or(wanted.fixed() ? wanted.degree_of_fixed()
                                                      : kArcDegree);
  if (wanted.fixed()) return on_fixed_mesh(path, p, wanted, search, protocol);
  if (p == kArcDegree) {
    return refine_arcs(std::move(path), p, wanted, search, protocol);
  }
  return refine_arcs(
      search
          .fit(path.curve,
               {path.curve.problem().limits(), path.arcs, path.ends}, p)
          .path,
      p, wanted, search, protocol);
}

FromMesh without_its_arcs(const LimitedCurve& coarse,
                          const Discretisation& wanted,
                          const IpoptOptions& options, ArcSearch& search,
                          PassProtocol& protocol) {
  FromMesh out;
  solve_without_arcs(coarse, wanted.tolerance.value_or(kToleranceWithoutArcs),
                     options, protocol, [&](SolvedWithoutArcs solved) {
                       if (solved.finest() && !protocol.stopped()) {
                         out.path = arcs_from(*solved.finest(), kArcDegree,
                                              search, protocol);
                       }
                       out.mesh = std::move(solved.path);
                       return out.path || out.mesh ||
                              protocol.status == Status::NoFastestTrack;
                     });
  return out;
}

LimitedAnswer answer_without_arcs(const PathWithoutArcs& found,
                                  PassProtocol& protocol) {
  protocol.status = Status::Solved;
  protocol.message = kSolvedWithoutArcs;
  return {found.path, found.estimated_error};
}

LimitedRefinement refine_from_mesh(const LimitedCurve& mesh,
                                   const Discretisation& wanted,
                                   const MeshOptions& options,
                                   ItsArcs its_arcs) {
  PassProtocol protocol(options);
  ArcSearch search(protocol, options);
  std::optional<LimitedAnswer> answer;
  FromMesh without;
  std::optional<FittedPath> path;
  if (its_arcs == ItsArcs::Tried) {
    path = arcs_from(mesh, kArcDegree, search, protocol);
  }
  if (path) answer = refined(*std::move(path), wanted, search, protocol);
  if (!answer && !wanted.fixed() && !protocol.stopped() &&
      protocol.status != Status::NoFastestTrack) {
    protocol.most_work = most_search_work(options);
    without = without_its_arcs(mesh, wanted, options.ipopt, search, protocol);
    protocol.most_work = std::numeric_limits<double>::infinity();
    if (without.path) {
      answer = refined(*std::move(without.path), wanted, search, protocol);
    }
  }
  if (!answer && without.mesh) {
    answer = answer_without_arcs(*without.mesh, protocol);
  }
  return {std::move(protocol).finished(), std::move(answer)};
}

}  // namespace brachisto
