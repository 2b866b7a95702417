// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/arc_structure.hpp"

#include <algorithm>
#include <utility>

namespace brachisto::report {

namespace {

/// A place where arcs meet.
struct Junction {
  double sigma, u, t, x;
};

std::vector<Junction> junctions(const Solution& solution) {
  const TrajectoryPoint end = solution.motion()->at(1.0);
  std::vector<Junction> out{{0.0, 0.0, 0.0, 0.0},
                            {1.0, end.u, end.t, solution.scene.L}};
  for (const LimitOnPath& limit : solution.limits) {
    for (const ActiveArc& arc : limit.active) {
      out.push_back({arc.sigma.from, arc.u.from, arc.t.from, arc.x.from});
      out.push_back({arc.sigma.to, arc.u.to, arc.t.to, arc.x.to});
    }
  }
  std::ranges::stable_sort(out, {}, &Junction::sigma);
  const auto same = std::ranges::unique(out, {}, &Junction::sigma);
  out.erase(same.begin(), same.end());
  return out;
}

PathArc between(const Junction& a, const Junction& b,
                std::vector<std::string> holds) {
  return {{{a.sigma, b.sigma}, {a.u, b.u}, {a.t, b.t}, {a.x, b.x}},
          std::move(holds)};
}

}  // namespace

std::vector<std::string> holding_at(double sigma,
                                    const std::vector<LimitOnPath>& limits) {
  std::vector<std::string> names;
  for (const LimitOnPath& limit : limits) {
    const bool active =
        std::ranges::any_of(limit.active, [&](const ActiveArc& arc) {
          return arc.sigma.from <= sigma && sigma <= arc.sigma.to;
        });
    if (active) names.push_back(limit.name);
  }
  return names;
}

std::vector<PathArc> arc_structure(const Solution& solution) {
  std::vector<PathArc> out;
  if (solution.motion() == nullptr) return out;
  const std::vector<Junction> places = junctions(solution);
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (const LimitOnPath& limit : solution.limits) {
      const bool touched =
          std::ranges::any_of(limit.active, [&](const ActiveArc& arc) {
            return arc.sigma.from == places[i].sigma &&
                   arc.sigma.to == places[i].sigma;
          });
      if (touched) out.push_back(between(places[i], places[i], {limit.name}));
    }
    if (i + 1 == places.size()) break;
    const double middle = 0.5 * (places[i].sigma + places[i + 1].sigma);
    out.push_back(
        between(places[i], places[i + 1], holding_at(middle, solution.limits)));
  }
  return out;
}

}  // namespace brachisto::report
