// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/limited_shooting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "brachisto/math/index.hpp"

namespace brachisto {

arcs::Guess as_guess(const FittedPath& path) {
  const LimitedTime& problem = path.curve.problem();
  const auto held_limit = [&](std::size_t limit, nlp::Held where) {
    const PathInequality& found = problem.limits()[limit];
    return arcs::HeldLimit{
        found, where == nlp::Held::AtUpper ? found.upper : found.lower};
  };
  arcs::Guess guess;
  std::vector<int> first_element{0};
  double begin = 0.0;
  for (const Arc& arc : path.arcs) {
    arcs::Arc& out = guess.arcs.emplace_back();
    out.duration = (arc.end - begin) * path.curve.rolling_time();
    for (std::size_t i = 0; i < arc.held.size(); ++i) {
      if (arc.held[i] != nlp::Held::No) out.held = held_limit(i, arc.held[i]);
    }
    if (arc.touch) {
      out.touched = held_limit(arc.touch->limit, arc.touch->at);
    }
    if (const auto& corner = path.ends.corner; corner && begin == 0.0) {
      out.corner = held_limit(corner->limit, corner->at);
    }
    begin = arc.end;
    first_element.push_back(first_element.back() + arc.elements());
  }
  guess.state = [&path, first_element](std::size_t arc, double share) {
    const std::vector<double>& cuts = path.arcs[arc].cuts;
    int e = 0;
    while (e + 1 < path.arcs[arc].elements() && share >= cuts[at(e + 1)]) ++e;
    const double length = cuts[at(e + 1)] - cuts[at(e)];
    const LimitedPoint here =
        path.curve.at(first_element[arc] + e, (share - cuts[at(e)]) / length);
    return arcs::State{here.state.x, here.state.z,    here.state.theta,
                       here.state.w, here.state.beta, here.p.p_x,
                       here.p.p_z,   here.p.p_theta,  here.p.p_w,
                       here.p_beta};
  };
  return guess;
}

LimitedExtremal shoot_over_arcs(const FittedPath& path,
                                const StopCondition& stop) {
  const bool twice =
      std::any_of(path.arcs.begin(), path.arcs.end(), [](const Arc& arc) {
        return std::count(arc.held.begin(), arc.held.end(), nlp::Held::No) + 1 <
               static_cast<std::ptrdiff_t>(arc.held.size());
      });
  if (!twice && !path.arcs.empty()) {
    return solve_limited_extremal(path.curve.problem().scene(), as_guess(path),
                                  stop);
  }
  LimitedExtremal none;
  none.message = path.arcs.empty()
                     ? "it needs arcs, which were not found"
                     : "arcs on which two limits hold are not known to it";
  return none;
}

Outcome outcome_of(const LimitedExtremal& extremal) {
  if (extremal.solved) {
    return {Status::Solved,
            "solved under limits by shooting over the arcs that the program "
            "found"};
  }
  return {Status::NotConverged,
          fmt::format("the indirect method has no answer for the arcs that the "
                      "program found: {}. Try method: ipopt",
                      extremal.message)};
}

}  // namespace brachisto
