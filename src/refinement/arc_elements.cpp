// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/arc_elements.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace brachisto {

namespace {

/// The slope of a path may err so much [rad]: T is flat about the fastest path,
/// so that a slope that errs by ε costs some ε² of it, but it is the path that
/// is built, and followed to another scene.
double allowed_turn(double tolerance) {
  return 1e-3 * std::sqrt(tolerance);
}

/// By how much one path is off another along an element.
struct Difference {
  double slope = 0.0;  ///< [rad], at the same σ
  /// Of slope and w at the same places of the element, less what follows from
  /// its ends: what is made here, and not carried along from other elements or
  /// due to junctions that moved; in natural units.
  double made_here = 0.0;
};

Difference difference(int element, const LimitedCurve& one,
                      const LimitedCurve& other) {
  struct Off {
    double slope, w;
  };
  Difference result;
  const auto off = [&](double share) {
    const auto [e, t] = other.problem().mesh().locate(
        one.problem().mesh().sigma(element, share));
    const TurningPoint<double> a = one.state_at(element, share);
    const TurningPoint<double> b = other.state_at(element, share);
    result.slope =
        std::max(result.slope, std::abs(a.beta - other.state_at(e, t).beta));
    return Off{a.beta - b.beta, a.w - b.w};
  };
  const Off first = off(0.0), last = off(1.0);
  for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    const Off here = off(share);
    for (const auto quantity : {&Off::slope, &Off::w}) {
      result.made_here =
          std::max(result.made_here,
                   std::abs(here.*quantity -
                            std::lerp(first.*quantity, last.*quantity, share)));
    }
  }
  return result;
}

/// Divides elements that are so many times too long. Whether any was.
template <class TooLong>
bool divide_where(std::vector<Arc>& arcs, const TooLong& too_long) {
  constexpr double kMost = 4.0, kSafety = 1.1;
  int e = 0;
  bool any = false;
  for (Arc& arc : arcs) {
    std::vector<double> cuts{0.0};
    for (std::size_t i = 0; i + 1 < arc.cuts.size(); ++i, ++e) {
      const double by = too_long(e);
      const int n =
          by <= 1.0
              ? 1
              : static_cast<int>(std::ceil(std::min(kSafety * by, kMost)));
      any = any || n > 1;
      for (int k = 1; k <= n; ++k) {
        cuts.push_back(arc.cuts[i] + (arc.cuts[i + 1] - arc.cuts[i]) * k / n);
      }
    }
    arc.cuts = std::move(cuts);
  }
  return any;
}

/// How many times an element is too long to keep limits between its points.
double for_limits(const LimitedCurve& curve, int element, double allowed) {
  const double excess = std::max(0.0, curve.excess_on(element).value) / allowed;
  return std::pow(excess, 1.0 / curve.problem().mesh().degree);
}

}  // namespace

bool divide_for_limits(const LimitedCurve& curve, double allowed,
                       std::vector<Arc>& arcs) {
  return divide_where(arcs,
                      [&](int e) { return for_limits(curve, e, allowed); });
}

bool divide(const LimitedCurve& curve, const LimitedCurve& finer,
            double tolerance, double allowed, std::vector<Arc>& arcs) {
  const double p = curve.problem().mesh().degree;
  const int elements = curve.problem().mesh().num_elements();
  const double all = tolerance * finer.transit_time();
  const double target = all / elements;
  // Times of elements change with the path to first order, their sum does not.
  const bool errs_in_time =
      2.0 * std::abs(curve.transit_time() - finer.transit_time()) > all;
  std::vector<double> made;
  double most_made = 0.0, most_turned = 0.0;
  for (int e = 0; e < elements; ++e) {
    const Difference here = difference(e, curve, finer);
    made.push_back(here.made_here);
    most_made = std::max(most_made, here.made_here);
    most_turned = std::max(most_turned, here.slope);
  }
  // What is off may have been carried along from elsewhere, and have grown; so
  // all of it is put down to where it is made.
  const double turns =
      most_made > 0.0 ? most_turned / allowed_turn(tolerance) / most_made : 0.0;
  return divide_where(arcs, [&](int e) {
    const double error =
        errs_in_time ? std::abs(curve.time_on(e) - finer.time_on(e)) : 0.0;
    return std::max({std::pow(error / target, 1.0 / (2.0 * p)),
                     std::pow(turns * made[at(e)], 1.0 / p),
                     for_limits(curve, e, allowed)});
  });
}

bool slopes_agree(const LimitedCurve& curve, const LimitedCurve& finer,
                  double tolerance) {
  const double allowed = allowed_turn(tolerance);
  for (int e = 0; e < curve.problem().mesh().num_elements(); ++e) {
    if (!(difference(e, curve, finer).slope <= allowed)) return false;
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

std::optional<std::vector<Arc>> graded_where_signs_err(
    const LimitedCurve& curve, std::vector<Arc> arcs) {
  constexpr double kOfWorst = 0.1;
  constexpr int kHalvings = 10;
  // In front of each arc and at B, how wrong a sign is nearest to there.
  std::vector<double> wrong(arcs.size() + 1, 0.0);
  int e = 0;
  for (std::size_t a = 0; a < arcs.size(); ++a) {
    const std::vector<double>& cuts = arcs[a].cuts;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i, ++e) {
      for (const double t : curve.problem().scheme().rule.points) {
        const std::vector<double> multipliers = curve.at(e, t).multipliers;
        double& most =
            wrong[std::lerp(cuts[i], cuts[i + 1], t) < 0.5 ? a : a + 1];
        for (std::size_t j = 0; j < multipliers.size(); ++j) {
          const nlp::Held held = arcs[a].held[j];
          if (held == nlp::Held::No) continue;
          most = std::max(most, held == nlp::Held::AtLower ? multipliers[j]
                                                           : -multipliers[j]);
        }
      }
    }
  }
  const double worst = std::ranges::max(wrong);
  if (!(worst > 0.0)) return std::nullopt;
  for (std::size_t a = 0; a < arcs.size(); ++a) {
    std::vector<double>& cuts = arcs[a].cuts;
    const double first = cuts[1], last = 1.0 - cuts[cuts.size() - 2];
    for (int k = 1; k <= kHalvings; ++k) {
      const double share = std::ldexp(1.0, -k);
      if (wrong[a] >= kOfWorst * worst) cuts.push_back(share * first);
      if (wrong[a + 1] >= kOfWorst * worst) cuts.push_back(1.0 - share * last);
    }
    std::ranges::sort(cuts);
    const auto doubles = std::ranges::unique(cuts);
    cuts.erase(doubles.begin(), doubles.end());
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
