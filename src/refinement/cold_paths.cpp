// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/cold_paths.hpp"

#include <algorithm>

#include "refinement/pass_protocol.hpp"
#include "refinement/random_path.hpp"
#include "refinement/tightening.hpp"

namespace brachisto {

std::vector<LimitedCurve> cold_paths(const Scene& scene,
                                     const ExtremalCurve& free, double phi,
                                     const IpoptOptions& options, int starts,
                                     double most_work, PassProtocol& protocol) {
  constexpr int kMostIterations = 300;  // of a start
  std::vector<LimitedCurve> found;
  const double all = protocol.most_work;
  for (const RoughPath& way : random_ways(scene, starts)) {
    if (protocol.stopped()) break;
    protocol.most_work = std::min(all, protocol.work + most_work);
    IpoptOptions ipopt = protocol.left(options);
    ipopt.max_iterations = std::min(ipopt.max_iterations, kMostIterations);
    Tightening tightening(scene, free, phi, ipopt, protocol);
    const bool kept = tightening.tighten_cold(way);
    protocol.most_work = all;
    if (!kept) continue;
    const auto is_known = [&](const LimitedCurve& known) {
      return alike(known, tightening.last());
    };
    if (std::ranges::none_of(found, is_known)) {
      found.push_back(tightening.last());
    }
  }
  std::ranges::stable_sort(found, {}, &LimitedCurve::transit_time);
  return found;
}

}  // namespace brachisto
