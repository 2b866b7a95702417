// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/arc_system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "brachisto/math/index.hpp"
#include "extremal/node_equations.hpp"

namespace brachisto::arcs {

namespace {

using Eigen::Index;
using Kind = ArcFlow::Kind;

/// Whether a limit that holds keeps the control from growing.
bool holds_from_above(const ArcFlow& flow, const State& y) {
  ArcPoint at;
  double near = 0.0;
  if (!flow.find(flow.node_of(y), near, at)) return false;
  const HeldLimit& held = *flow.held();
  return (flow.by_control(held.limit, at) > 0.0) == held.at_upper();
}

bool turns(const ArcFlow& flow) {
  return flow.kind() == Kind::Control;
}

std::string touches_alone(const HeldLimit& touched) {
  return fmt::format("it touches {} where no limit holds the control",
                     name(touched.limit.kind));
}

}  // namespace

double ArcSystem::Linearisation::largest() const {
  double out = 0.0;
  for (const ocp::ChainLink& link : links) {
    out = std::max(out, link.residual.lpNorm<Eigen::Infinity>());
  }
  return out;
}

double ArcSystem::Linearisation::norm() const {
  double sum = 0.0;
  for (const ocp::ChainLink& link : links) sum += link.residual.squaredNorm();
  return std::sqrt(sum);
}

int ArcSystem::Linearisation::worst_node() const {
  const auto worst =
      std::max_element(links.begin(), links.end(),
                       [](const ocp::ChainLink& a, const ocp::ChainLink& b) {
                         return a.residual.lpNorm<Eigen::Infinity>() <
                                b.residual.lpNorm<Eigen::Infinity>();
                       });
  return static_cast<int>(worst - links.begin());
}

void ArcSystem::Linearisation::take_values(const Linearisation& other) {
  for (std::size_t i = 0; i < links.size(); ++i) {
    links[i].residual = other.links[i].residual;
  }
  transit_time = other.transit_time;
  slope_at_A.value = other.slope_at_A.value;
  slope_at_B.value = other.slope_at_B.value;
  steps = other.steps;
}

ArcSystem::ArcSystem(const Scene& natural, const Guess& guess, int pieces)
    : scene_(natural),
      arcs_(guess.arcs),
      leave_(natural, guess.arcs.front().held, guess.state(0, 0.0)[kBeta],
             guess.arcs.front().corner),
      slope_near_A_(guess.state(0, 0.0)[kBeta]),
      refusal_(leave_.refusal()) {
  constexpr double kFewest = 4.0, kMost = 20'000.0, kPerTurn = 3.0;
  double U = 0.0;
  for (const Arc& arc : arcs_) {
    flows_.emplace_back(scene_, arc.held);
    U += arc.duration;
  }
  if (blind(0)) flows_.front().judge_states_alone();
  const double turned = std::abs(guess.state(arcs_.size() - 1, 1.0)[kTheta] -
                                 guess.state(0, 0.0)[kTheta]) /
                        (2.0 * std::numbers::pi);
  const double wanted =
      pieces > 0 ? pieces : std::clamp(kPerTurn * turned, kFewest, kMost);
  int nodes = 0;
  for (int a = 0; a < num_arcs(); ++a) {
    first_node_.push_back(nodes);
    pieces_.push_back(std::max(
        1, static_cast<int>(std::ceil(arcs_[at(a)].duration / U * wanted))));
    nodes += pieces_.back();
    jump_.push_back(-1);
    opposite_.push_back(false);
    if (a == 0) continue;
    if (refusal_.empty()) refusal_ = unknown_junction(a);
    const Kind before = flows_[at(a - 1)].kind(), here = flows_[at(a)].kind();
    const bool off_boundary = before == Kind::Place && here == Kind::Control;
    // Behind a blind arc all costates are unknown anyhow.
    if ((arcs_[at(a - 1)].touched || off_boundary) && !blind(a - 1)) {
      jump_.back() = num_jumps_++;
    }
    if (before == Kind::Control && here == Kind::Control) {
      const State junction = guess.state(at(a), 0.0);
      opposite_.back() = holds_from_above(flows_[at(a - 1)], junction) !=
                         holds_from_above(flows_[at(a)], junction);
    }
  }
  first_node_.push_back(nodes);
  const int last = num_arcs() - 1;
  const bool touches_B = arcs_.back().touched && !blind(last);
  jump_.push_back(touches_B ? num_jumps_++ : -1);
  if (touches_B && refusal_.empty() && !turns(flows_.back())) {
    refusal_ = touches_alone(*arcs_.back().touched);
  }
  take_guess(guess);
}

ArcSystem ArcSystem::in(const Scene& natural) const {
  ArcSystem out = *this;
  out.scene_ = natural;
  out.leave_ = Departure(natural, arcs_.front().held, slope_near_A_,
                         arcs_.front().corner);
  out.flows_.clear();
  for (const Arc& arc : arcs_) out.flows_.emplace_back(natural, arc.held);
  if (out.blind(0)) out.flows_.front().judge_states_alone();
  return out;
}

std::string ArcSystem::unknown_junction(int arc) const {
  const Kind before = flows_[at(arc - 1)].kind(), here = flows_[at(arc)].kind();
  const auto& touched = arcs_[at(arc - 1)].touched;
  if (touched && (before != Kind::Control || here != Kind::Control)) {
    return touches_alone(*touched);
  }
  if (before == Kind::Place && here == Kind::Place) {
    return "it goes from one boundary to another";
  }
  return {};
}

void ArcSystem::take_guess(const Guess& guess) {
  start_.globals.setZero(of_jump(num_jumps_));
  for (int a = 0; a < num_arcs(); ++a) {
    const int pieces = pieces_[at(a)];
    for (int i = 0; i < pieces; ++i) {
      State y = guess.state(at(a), static_cast<double>(i) / pieces);
      if (blind(a)) {
        if (i == 0) y = leave_.left_rest();
        std::fill(y.begin() + kStates, y.end(), 0.0);
      }
      start_.nodes.push_back(flows_[at(a)].node_of(y));
    }
    start_.globals(a) = arcs_[at(a)].duration;
  }
  start_.nodes.push_back(
      flows_.back().node_of(guess.state(arcs_.size() - 1, 1.0)));
}

int ArcSystem::arc_of_node(int node) const {
  const auto behind =
      std::upper_bound(first_node_.begin(), first_node_.end(), node);
  return static_cast<int>(behind - first_node_.begin()) - 1;
}

double ArcSystem::span_of(const Point& point, int arc) const {
  const double at_rest = blind(arc) ? Departure::kLeftRest : 0.0;
  return (point.globals(arc) - at_rest) / pieces_[at(arc)];
}

const HeldLimit& ArcSystem::jumps_along(int arc) const {
  const Arc& before = arcs_[at(arc - 1)];
  if (before.touched) return *before.touched;
  return *(flows_[at(arc)].kind() == Kind::Place ? arcs_[at(arc)] : before)
              .held;
}

void ArcSystem::junction_rows(NodeEquations& rows, int arc, const Node& y,
                              const LinearPoint& at_node) const {
  const ArcFlow& here = flows_[at(arc)];
  if (arc == 0 ? !blind(0) : blind(arc - 1)) rows.add(at_node.hamiltonian);
  if (arc == 0) return;
  const ArcFlow& before = flows_[at(arc - 1)];
  if (const auto& touched = arcs_[at(arc - 1)].touched) {
    const AlongArc c = before.along(touched->limit, y);
    rows.add(c.value - touched->bound);
    rows.add(c.rate);
    return;
  }
  if (here.kind() == Kind::Place) {
    const HeldLimit& held = *here.held();
    const auto& [limit, bound] = held;
    rows.add(value_of(limit, ContactForce<Jet>{},
                      TurningPoint<Jet>{
                          at_node.y[kX], at_node.y[kZ], {}, {}, {}, {}}) -
             bound);
    if (!turns(before) || blind(arc - 1)) rows.add(at_node.multiplier);
  }
  if (!turns(before) || !turns(here)) return;
  if (opposite_[at(arc)]) {
    rows.add(at_node.y[kPBeta]);
  } else {
    const HeldLimit& held = *here.held();
    rows.add(before.along(held.limit, y).value - held.bound);
  }
}

bool ArcSystem::matching_rows(NodeEquations& rows, int arc, const PieceEnd& end,
                              const Node& next, double next_near,
                              double jump) const {
  const ArcFlow& before = flows_[at(arc)];
  const ArcFlow& behind = flows_[at(std::min(arc + 1, num_arcs() - 1))];
  const double share = 1.0 / pieces_[at(arc)];
  LinearPoint a, b;
  double control = end.control;
  if (!before.find(end.y, control, a)) return false;
  if (!behind.find(next, next_near, b)) return false;
  const auto fit = [&](const Jet& of_next, const Jet& of_end) {
    rows.add(of_next, of_end, end, arc, share);
  };
  for (const Component i : {kX, kZ, kTheta, kW}) fit(b.y[i], a.y[i]);
  if (turns(before) || turns(behind)) fit(b.y[kBeta], a.y[kBeta]);
  if (blind(arc)) return true;
  const int jumps = jump_[at(arc + 1)];
  if (jumps < 0) {
    // Where a boundary begins its μ is either 0 or the jump.
    const bool lands = behind.kind() == Kind::Place;
    fit(lands ? b.p_x : b.y[kPX], a.y[kPX]);
    fit(lands ? b.p_z : b.y[kPZ], a.y[kPZ]);
    fit(b.y[kPTheta], a.y[kPTheta]);
    fit(b.y[kPW], a.y[kPW]);
    if (turns(before) || turns(behind)) fit(b.y[kPBeta], a.y[kPBeta]);
    return true;
  }
  std::array<Jet, kStates> along{};
  const PathInequality& limit = jumps_along(arc + 1).limit;
  if (arcs_[at(arc)].touched) {
    along = before.along(limit, next).by_state;
  } else {
    const auto normal = normal_at(limit, b.y);
    along[kX] = normal.x;
    along[kZ] = normal.z;
  }
  for (std::size_t i = 0; i < kStates; ++i) {
    const std::size_t p = kStates + i;
    const Jet& from = p == kPX ? a.p_x : p == kPZ ? a.p_z : a.y[p];
    fit(b.y[p] - along[i] * jump, from);
    rows.by_global(of_jump(jumps)) = -along[i].value;
  }
  return true;
}

bool ArcSystem::evaluate(const Point& point, const ocp::StepControl& control,
                         Linearisation& out, bool derivatives) const {
  const Index globals = point.globals.size();
  out.links.clear();
  out.links.reserve(point.nodes.size());
  out.transit_time = 0.0;
  out.time_gradient.nodes.assign(point.nodes.size(), {});
  out.time_gradient.globals.setZero(globals);
  out.steps = 0;
  double slope = slope_near_A_;
  for (int a = 0; a < num_arcs(); ++a) {
    const ArcFlow& flow = flows_[at(a)];
    const double span = span_of(point, a);
    const double share = 1.0 / pieces_[at(a)];
    out.arc = a;
    double step = 0.0;
    for (int k = 0; k < pieces_[at(a)]; ++k) {
      const std::size_t i = at(first_node_[at(a)] + k);
      out.piece = first_node_[at(a)] + k;
      const Node& y = point.nodes[i];
      const Node& next = point.nodes[i + 1];
      const double near = turns(flow) ? 0.0 : slope;
      NodeEquations rows(y.size(), next.size(), globals);
      if (k == 0) {
        LinearPoint first;
        double steer = near;
        if (!flow.find(y, steer, first)) return false;
        if (a == 0) {
          for (const Jet& row : leave_.conditions(first.y)) rows.add(row);
          out.slope_at_A = leave_.contact_slope(first.y);
        }
        if (!blind(a)) junction_rows(rows, a, y, first);
        ArcPoint here;
        if (blind(a) && flow.find(y, steer, here)) {
          out.transit_time += Departure::kLeftRest * here.root;
        }
      }
      PieceEnd end;
      if (!flow.integrate(y, near, span, control, step, end, derivatives)) {
        return false;
      }
      slope = turns(flow) ? end.y(static_cast<Index>(kBeta)) : end.control;
      out.steps += end.steps;
      out.transit_time += end.t;
      out.time_gradient.nodes[i] = end.time_by_start.transpose();
      out.time_gradient.globals(a) += end.time_rate * share;
      if (blind(a)) rows.pin_costates(y);
      const int jump = jump_[at(a + 1)];
      if (k + 1 == pieces_[at(a)] && (a + 1 < num_arcs() || jump >= 0)) {
        const bool turning = turns(flows_[at(std::min(a + 1, num_arcs() - 1))]);
        if (!matching_rows(rows, a, end, next, turning ? 0.0 : slope,
                           jump < 0 ? 0.0 : point.globals(of_jump(jump)))) {
          return false;
        }
      } else if (blind(a)) {
        rows.match_states(next, end, a, share);
      } else {
        rows.match(next, end, a, share);
      }
      out.links.push_back(rows.take());
    }
  }
  const Node& last = point.nodes.back();
  const bool turning = turns(flows_.back());
  LinearPoint at_B;
  double steer = turning ? 0.0 : slope;
  if (!flows_.back().find(last, steer, at_B)) return false;
  NodeEquations rows(last.size(), 0, globals);
  for (const Jet& row : end_conditions(scene_, at_B.y, turning)) rows.add(row);
  if (jump_.back() >= 0) {
    const HeldLimit& touched = *arcs_.back().touched;
    rows.add(flows_.back().along(touched.limit, last).value - touched.bound);
  }
  out.links.push_back(rows.take());
  out.slope_at_B = at_B.y[kBeta];
  return true;
}

std::string ArcSystem::place_of(int arc) const {
  if (arc == num_arcs()) return "B";
  const std::optional<HeldLimit>& held = arcs_[at(arc)].held;
  return fmt::format(
      "arc {} of {}, {}", arc + 1, num_arcs(),
      held ? fmt::format("along {}", name(held->limit.kind)) : "which is free");
}

ArcPath ArcSystem::path(const Point& point,
                        const ocp::StepControl& control) const {
  std::vector<ArcPath::Stretch> arcs;
  double slope = slope_near_A_;
  double time = 0.0;
  for (int a = 0; a < num_arcs(); ++a) {
    ArcPath::Stretch& arc = arcs.emplace_back(
        ArcPath::Stretch{flows_[at(a)], point.globals(a), {}});
    const bool turning = turns(arc.flow);
    const double begin = blind(a) ? Departure::kLeftRest : 0.0;
    const double span = span_of(point, a);
    for (int k = 0; k < pieces_[at(a)]; ++k) {
      Node start = point.nodes[at(first_node_[at(a)] + k)];
      // At rest exactly, not but for rounding.
      const bool rests = scene_.world.start_speed == 0.0 && !blind(0);
      if (a == 0 && k == 0 && rests) start(static_cast<Index>(kW)) = 0.0;
      // In place of the end of the piece before, from which it is not far.
      if (k > 0) arc.knots.pop_back();
      const double from = begin + k * span;
      const double before = time;
      if (!arc.flow.follow(start, turning ? 0.0 : slope, span, control,
                           [&](Knot knot) {
                             knot.u += from;
                             knot.t += before;
                             arc.knots.push_back(std::move(knot));
                           })) {
        return {};
      }
      const Knot& last = arc.knots.back();
      slope = turning ? last.y(static_cast<Index>(kBeta)) : last.control;
      time = last.t;
    }
    if (a + 1 == num_arcs() && jump_.back() >= 0) {
      arc.jumps_along = jumps_along(a + 1);
      arc.jump = point.globals(of_jump(jump_.back()));
    }
    if (a == 0) continue;
    const Kind kind = arc.flow.kind();
    ArcPath::Stretch& before = arcs[at(a - 1)];
    ArcPoint first, last;
    double near = arc.knots.front().control;
    double near_end = before.knots.back().control;
    if (blind(a - 1) || !arc.flow.find(arc.knots.front().y, near, first) ||
        !before.flow.find(before.knots.back().y, near_end, last)) {
      continue;
    }
    if (jump_[at(a)] >= 0) {
      before.jumps_along = jumps_along(a);
      before.jump = point.globals(of_jump(jump_[at(a)])) - last.jump;
    } else if (kind == Kind::Place && turns(before.flow)) {
      before.jumps_along = jumps_along(a);
      before.jump = first.jump;
    }
  }
  return {std::move(arcs), leave_};
}

ocp::ChainVector moved(const ocp::ChainVector& point, double factor,
                       const ocp::ChainVector& change) {
  ocp::ChainVector out = point;
  out.globals += factor * change.globals;
  for (std::size_t i = 0; i < out.nodes.size(); ++i) {
    out.nodes[i] += factor * change.nodes[i];
  }
  return out;
}

}  // namespace brachisto::arcs
