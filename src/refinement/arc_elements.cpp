// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/arc_elements.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace brachisto {

namespace {

/// Allowed between points, well below what a certificate allows.
constexpr double kExcess = 1e-9;

}  // namespace

void divide(const LimitedCurve& curve, const LimitedCurve& finer,
            double tolerance, std::vector<Arc>& arcs) {
  constexpr int kMost = 4;
  constexpr double kSafety = 1.1;
  const double p = curve.problem().mesh().degree;
  const double target =
      tolerance * finer.transit_time() / curve.problem().mesh().num_elements();
  int e = 0;
  for (Arc& arc : arcs) {
    std::vector<double> cuts{0.0};
    for (std::size_t i = 0; i + 1 < arc.cuts.size(); ++i, ++e) {
      double where = 0.0;
      const double error = std::abs(curve.time_on(e) - finer.time_on(e));
      const double excess = std::max(0.0, curve.excess_on(e, where).value);
      const double pieces =
          kSafety * std::max(std::pow(error / target, 1.0 / (2.0 * p)),
                             std::pow(excess / kExcess, 1.0 / p));
      const int n = std::clamp(
          static_cast<int>(std::ceil(std::min(pieces, double{kMost}))), 1,
          kMost);
      for (int k = 1; k <= n; ++k) {
        cuts.push_back(arc.cuts[i] + (arc.cuts[i + 1] - arc.cuts[i]) * k / n);
      }
    }
    arc.cuts = std::move(cuts);
  }
}

bool keeps_limits(const LimitedCurve& curve) {
  double where = 0.0;
  for (int e = 0; e < curve.problem().mesh().num_elements(); ++e) {
    if (!(curve.excess_on(e, where).value <= kExcess)) return false;
  }
  return true;
}

std::vector<Arc> halved(std::vector<Arc> arcs) {
  for (Arc& arc : arcs) {
    std::vector<double> cuts{0.0};
    for (std::size_t i = 1; i < arc.cuts.size(); ++i) {
      cuts.push_back(0.5 * (arc.cuts[i - 1] + arc.cuts[i]));
      cuts.push_back(arc.cuts[i]);
    }
    arc.cuts = std::move(cuts);
  }
  return arcs;
}

std::vector<Arc> with_elements(std::vector<Arc> arcs, int wanted) {
  int left = wanted;
  double begin = 0.0;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const auto after = static_cast<int>(arcs.size() - i) - 1;
    const double share = (arcs[i].end - begin) / (1.0 - begin);
    const int count = std::clamp(static_cast<int>(std::lround(share * left)), 1,
                                 std::max(1, left - after));
    arcs[i].cuts = equal_cuts(count);
    left -= count;
    begin = arcs[i].end;
  }
  return arcs;
}

Mesh finer_at_changes(const LimitedCurve& curve) {
  const LimitedTime& problem = curve.problem();
  const Mesh& mesh = problem.mesh();
  const auto changes = [&](int point) {
    if (point < 1 || point >= problem.layout().num_points()) return false;
    for (int i = 0; i < problem.layout().num_limits(); ++i) {
      if (curve.active(point, i) != curve.active(point - 1, i)) return true;
    }
    return false;
  };
  Mesh next{mesh.degree, {0.0}};
  for (int e = 0; e < mesh.num_elements(); ++e) {
    bool any = false;
    for (int c = e * mesh.degree; c <= (e + 1) * mesh.degree; ++c) {
      any = any || changes(c);
    }
    if (any) next.boundaries.push_back(mesh.sigma(e, 0.5));
    next.boundaries.push_back(mesh.boundaries[at(e + 1)]);
  }
  return next;
}

}  // namespace brachisto
