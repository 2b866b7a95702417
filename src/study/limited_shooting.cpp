// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/limited_shooting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "brachisto/math/index.hpp"
#include "brachisto/nlp/problem.hpp"
#include "nlp/stationarity.hpp"

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
  // A tenth of what the slope at A may be off by in a certificate.
  constexpr double kTold = 1e-10;
  const double kink =
      extremal.solved ? std::abs(extremal.path.kink_at_start()) : 0.0;
  if (kink > kTold) {
    return {
        Status::NotConverged,
        fmt::format("a limit on forces holds at A alone, and the arc behind "
                    "it, along which the slope turns by {:.1e} rad, is too "
                    "short for shooting. Try method: ipopt with certify: "
                    "extremal",
                    kink)};
  }
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

namespace {

/// The limit that holds on an arc; −1 if none does.
int held_on(const Arc& arc) {
  for (std::size_t i = 0; i < arc.held.size(); ++i) {
    if (arc.held[i] != nlp::Held::No) return static_cast<int>(i);
  }
  return -1;
}

/// The arcs of a path with the junctions of the extremal.
std::vector<Arc> with_junctions(std::vector<Arc> arcs,
                                const arcs::ArcPath& extremal) {
  double u = 0.0;
  for (std::size_t a = 0; a + 1 < arcs.size(); ++a) {
    u += extremal.arcs()[a].duration;
    arcs[a].end = u / extremal.rolling_time();
  }
  return arcs;
}

/// An extremal at the collocation points of a mesh of its arcs.
class ArcSample {
 public:
  ArcSample(const arcs::ArcPath& path, std::vector<Arc> arcs,
            const LimitedTime& problem)
      : path_(path), arcs_(std::move(arcs)), problem_(problem) {
    for (std::size_t a = 0; a < arcs_.size(); ++a) {
      for (int e = 0; e < arcs_[a].elements(); ++e) {
        elements_.push_back(
            {a, arcs_[a].cuts[at(e)], arcs_[a].cuts[at(e + 1)]});
      }
    }
    point_ = sample_at_mesh(problem_, path_.rolling_time(),
                            [&](Mesh::Place place) { return at_place(place); });
    for (std::size_t a = 0; a < arcs_.size(); ++a) add_jump(a);
    // An extremal keeps moving, so that nothing is refused.
    static_cast<void>(problem_.set_point(point_.x));
    for (std::size_t a = arcs_.size(); a-- > 0;) {
      if (left_to_stationarity(a)) solve_arc(a);
    }
    solve_contacts();
  }

  [[nodiscard]] PrimalDual take() { return std::move(point_); }

 private:
  struct Element {
    std::size_t arc;
    double begin, end;  ///< as shares of the arc
  };

  [[nodiscard]] int elements_before(std::size_t arc) const {
    int count = 0;
    for (std::size_t a = 0; a < arc; ++a) count += arcs_[a].elements();
    return count;
  }

  [[nodiscard]] LimitedPoint at_place(Mesh::Place place) const {
    const auto& [arc, begin, end] = elements_[at(place.element)];
    const arcs::ArcPath::Stretch& here = path_.arcs()[arc];
    const arcs::ArcPoint at_u =
        path_.at(arc, (begin + place.t * (end - begin)) * here.duration);
    const arcs::State& y = at_u.y;
    LimitedPoint out;
    out.state = {y[arcs::kX], y[arcs::kZ],    y[arcs::kTheta],
                 y[arcs::kW], y[arcs::kBeta], at_u.q};
    out.multipliers.assign(problem_.limits().size(), 0.0);
    if (path_.blind(arc)) return out;
    out.p = {y[arcs::kPX], y[arcs::kPZ], y[arcs::kPTheta], y[arcs::kPW]};
    out.p_beta = y[arcs::kPBeta];
    // Multipliers of limits are minus the derivative of T by a bound, ν is
    // positive where a lower one holds.
    if (const int held = held_on(arcs_[arc]); held >= 0) {
      out.multipliers[at(held)] = -at_u.nu;
    }
    return out;
  }

  /// Where costates jump the multipliers of the element's last point have
  /// impulses: −Λ of what they jump along, and as the control is to stay
  /// stationary one of what holds it.
  void add_jump(std::size_t arc) {
    const arcs::ArcPath::Stretch& here = path_.arcs()[arc];
    if (!here.jumps_along) return;
    const Arc& before = arcs_[arc];
    const int held = held_on(before);
    const bool of_control = here.flow.kind() == arcs::ArcFlow::Kind::Control;
    const int along = before.touch ? static_cast<int>(before.touch->limit)
                      : of_control ? held_on(arcs_[arc + 1])
                                   : held;
    const int last = elements_before(arc + 1) * problem_.mesh().degree - 1;
    const auto multiplier = [&](int limit) -> double& {
      return point_.lambda[at(problem_.layout().limit(last, limit))];
    };
    multiplier(along) -= here.jump;
    if (!of_control) return;
    const arcs::ArcPoint y = path_.at(arc, here.duration);
    multiplier(held) += here.jump *
                        here.flow.by_control(here.jumps_along->limit, y) /
                        here.flow.by_control(here.flow.held()->limit, y);
  }

  /// Whether sampled costates would not do: from rest on they are not known,
  /// and on a short arc along a limit of the control what rounding leaves of
  /// them is too much over its length.
  [[nodiscard]] bool left_to_stationarity(std::size_t arc) const {
    constexpr double kShort = 1e-4;
    const arcs::ArcPath::Stretch& here = path_.arcs()[arc];
    return path_.blind(arc) ||
           (arc + 1 < arcs_.size() &&
            here.flow.kind() == arcs::ArcFlow::Kind::Control &&
            here.duration < kShort * path_.rolling_time());
  }

  /// Backwards, element by element, from the costates where the arc ends.
  void solve_arc(std::size_t arc) {
    using enum StateComponent;
    const VariableLayout& layout = problem_.layout();
    const int p = problem_.mesh().degree;
    const int held = held_on(arcs_[arc]);
    const int first = elements_before(arc);
    for (int e = first + arcs_[arc].elements(); e-- > first;) {
      std::vector<int> variables, constraints;
      for (int c = e * p; c < (e + 1) * p; ++c) {
        for (int i = 0; i < layout.num_states(); ++i) {
          variables.push_back(layout.state(c + 1, X) + i);
          constraints.push_back(layout.defect(c, X) + i);
        }
        variables.push_back(layout.control(c));
        constraints.push_back(layout.limit(c, held));
      }
      nlp::make_stationary(problem_, variables, constraints, point_);
    }
  }

  /// What ties the ends of the centre's path to its slopes, and a limit that
  /// holds at rest.
  void solve_contacts() {
    using enum StateComponent;
    const VariableLayout& layout = problem_.layout();
    if (problem_.free_contacts()) {
      const int last = layout.num_points();
      std::vector<int> tied{layout.state(0, X), layout.state(0, Z),
                            layout.state(last, X), layout.state(last, Z),
                            layout.state(0, W)};
      tied.resize(at(layout.num_contact_rows()));
      std::vector<int> rows;
      for (int i = 0; i < layout.num_contact_rows(); ++i) {
        rows.push_back(layout.contact_row(i));
      }
      nlp::make_stationary(problem_, tied, rows, point_);
    }
    const auto& corner = problem_.ends().corner;
    const int held =
        corner ? static_cast<int>(corner->limit) : held_on(arcs_.front());
    if (held < 0 || held >= layout.num_start_rows()) return;
    nlp::make_stationary(problem_, {layout.state(0, Beta)},
                         {layout.start_row(held)}, point_);
  }

  const arcs::ArcPath& path_;
  std::vector<Arc> arcs_;
  LimitedTime problem_;
  std::vector<Element> elements_;
  PrimalDual point_;
};

/// An extremal on a mesh of degree p.
FittedPath sampled_path(const arcs::ArcPath& extremal, const FittedPath& nearby,
                        std::vector<Arc> arcs, int p) {
  const LimitedTime& found = nearby.curve.problem();
  // A slope that the scene gives stays the one that is asked for.
  LimitedEnds ends = nearby.ends;
  const bool sought = end_is_sought(found.scene());
  if (sought) ends.phi = extremal.slope_at_end();
  if (start_is_sought(found.scene(), ends)) {
    ends.start = extremal.slope_at_start();
  }
  const LimitedTime problem(found.scene(), found.limits(), mesh_of(arcs, p),
                            ends, held_limits(arcs, ends.corner));
  LimitedCurve curve(problem, ArcSample(extremal, arcs, problem).take());
  // A bead touches B whatever its slope there.
  if (sought && !found.scene().body.rolls()) ends.phi = end_slope(curve);
  const ContactMismatch mismatch = mismatch_of(curve, ends);
  return {std::move(arcs), ends, std::move(curve), mismatch};
}

/// What is left of the conditions of the finite problem, element by element, as
/// a multiple of what is to be left.
std::vector<double> left_on_elements(const LimitedCurve& curve) {
  // A tenth of what passes, which leaves room for a judge who computes it
  // otherwise; and what is exceeded between the points likewise.
  constexpr double kPasses = 1e-9, kWanted = 0.1 * kPasses, kBetween = 1e-9;
  LimitedTime problem = curve.problem();
  const VariableLayout& layout = problem.layout();
  const int p = problem.mesh().degree;
  const int elements = problem.mesh().num_elements();
  std::vector<double> left(at(elements), 0.0);
  const auto note = [&](int element, double ratio) {
    // Written so that a NaN stays.
    if (element < elements && !(ratio <= left[at(element)])) {
      left[at(element)] = ratio;
    }
  };
  static_cast<void>(problem.set_point(curve.point().x));
  const std::vector<long double> gradient =
      nlp::lagrangian_gradient(problem, curve.point().lambda);
  const double rounding = problem.rounding(curve.point().x);
  for (int i = 0; i < layout.rolling_time(); ++i) {
    if (problem.variable_range(i).single()) continue;
    const double weight = problem.weight(i);
    // What rounding leaves on so short an element a shorter one has more of.
    if (rounding > kPasses * weight) continue;
    const double ratio = std::abs(static_cast<double>(gradient[at(i)])) /
                         std::max(kWanted * weight, rounding);
    const int node = layout.node_of(i);
    if (!layout.is_state(i)) {
      note(node / p, ratio);
      continue;
    }
    if (node > 0) note((node - 1) / p, ratio);
    if (node % p == 0) note(node / p, ratio);
  }
  std::vector<double> g(at(problem.num_constraints()));
  problem.eval_g(g);
  for (int i = 0; i < layout.contact_row(0); ++i) {
    const nlp::Range range = problem.constraint_range(i);
    note(layout.point_of(i) / p,
         std::max(range.lower - g[at(i)], g[at(i)] - range.upper) / kWanted);
  }
  for (int e = 0; e < elements; ++e) {
    note(e, curve.excess_on(e).value / kBetween);
  }
  return left;
}

/// Halves the elements on which something is left; false if there are none.
bool divide_where_left(const std::vector<double>& left,
                       std::vector<Arc>& arcs) {
  bool divided = false;
  std::size_t e = 0;
  for (Arc& arc : arcs) {
    std::vector<double> cuts{0.0};
    for (std::size_t i = 1; i < arc.cuts.size(); ++i, ++e) {
      if (!(left[e] <= 1.0)) {
        cuts.push_back(0.5 * (arc.cuts[i - 1] + arc.cuts[i]));
        divided = true;
      }
      cuts.push_back(arc.cuts[i]);
    }
    arc.cuts = std::move(cuts);
  }
  return divided;
}

}  // namespace

LimitedAnswer answer_from_extremal(const FittedPath& nearby,
                                   const LimitedExtremal& extremal,
                                   const StopCondition& stop) {
  constexpr int kMostHalvings = 8;
  // Of what is to be left that passes. Where halving lessens it no more it is
  // rounding, and over the weight of a shorter element more of it.
  constexpr double kPasses = 10.0, kFalls = 0.5;
  std::vector<Arc> arcs = with_junctions(nearby.arcs, extremal.path);
  FittedPath path = sampled_path(extremal.path, nearby, arcs, kMaxDegree);
  std::vector<double> left = left_on_elements(path.curve);
  for (int i = 0; i < kMostHalvings && !stop.met(); ++i) {
    if (!divide_where_left(left, arcs)) break;
    FittedPath finer = sampled_path(extremal.path, nearby, arcs, kMaxDegree);
    std::vector<double> then = left_on_elements(finer.curve);
    const double worst = std::ranges::max(left);
    if (worst <= kPasses && !(std::ranges::max(then) < kFalls * worst)) break;
    path = std::move(finer);
    left = std::move(then);
  }
  const double error =
      std::abs(path.curve.transit_time() / extremal.transit_time - 1.0) +
      extremal.error_estimate + path.curve.misled_from_rest().cost;
  return {std::move(path), error, true};
}

}  // namespace brachisto
