// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/limited_system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "math/index.hpp"

namespace brachisto::limited {

namespace {

using Kind = LimitedFlow::Kind;

/// Whether a limit that holds keeps the control from growing.
bool holds_from_above(const LimitedFlow& flow, const State& y) {
  const HeldLimit& held = *flow.held();
  const bool grows = flow.by_control(held.limit, y) > 0.0;
  return grows == held.at_upper();
}

std::string touches_alone(const HeldLimit& touched) {
  return fmt::format("it touches {} where no limit holds the control",
                     name(touched.limit.kind));
}

}  // namespace

/// The equations, one after the other.
class LimitedSystem::Rows {
 public:
  Rows(int unknowns, int most) {
    residual_.setZero(most);
    jacobian_.setZero(most, unknowns);
  }

  /// What is added from here on belongs to an arc.
  void begin(int arc) { arc_ = arc; }
  /// An equation of the unknowns of one node.
  void add(const Jet& value, int node) {
    for (int j = 0; j < kWidth; ++j) {
      by(kWidth * node + j) += value.gradient[at(j)];
    }
    arc_of_row_.push_back(arc_);
    residual_(size_++) = value.value;
  }
  void add(const std::vector<Jet>& values, int node) {
    for (const Jet& value : values) add(value, node);
  }
  /// A derivative of the equation that is added next.
  [[nodiscard]] double& by(int unknown) { return jacobian_(size_, unknown); }

  void move_to(Linearisation& out) {
    out.residual = residual_.head(size_);
    out.jacobian = jacobian_.topRows(size_);
    out.arc_of_row = std::move(arc_of_row_);
  }

 private:
  Eigen::VectorXd residual_;
  Eigen::MatrixXd jacobian_;
  std::vector<int> arc_of_row_;
  int arc_ = 0;
  Eigen::Index size_ = 0;
};

LimitedSystem::LimitedSystem(const Scene& natural, const Guess& guess)
    : scene_(natural),
      arcs_(guess.arcs),
      leave_(natural, guess.arcs.front().held, guess.state(0, 0.0)[kBeta]),
      refusal_(leave_.refusal()) {
  // Their number squared is the size of the matrix.
  constexpr double kFewest = 4.0, kMost = 150.0, kPerTurn = 3.0;
  double U = 0.0;
  for (const Arc& arc : arcs_) {
    flows_.emplace_back(scene_, arc.held);
    U += arc.duration;
  }
  const double turns = std::abs(guess.state(arcs_.size() - 1, 1.0)[kTheta] -
                                guess.state(0, 0.0)[kTheta]) /
                       (2.0 * std::numbers::pi);
  const double pieces = std::clamp(kPerTurn * turns, kFewest, kMost);
  int nodes = 0;
  for (int a = 0; a < num_arcs(); ++a) {
    first_node_.push_back(nodes);
    pieces_.push_back(std::max(
        1, static_cast<int>(std::ceil(arcs_[at(a)].duration / U * pieces))));
    nodes += pieces_.back();
    jump_.push_back(-1);
    opposite_.push_back(false);
    if (a == 0) continue;
    if (refusal_.empty()) refusal_ = unknown_junction(a);
    const Kind before = flows_[at(a - 1)].kind(), here = flows_[at(a)].kind();
    const bool of_boundary = (before == Kind::Control && here == Kind::Place) ||
                             (before == Kind::Place && here == Kind::Control);
    // Behind a blind arc all costates are unknown anyhow.
    if ((arcs_[at(a - 1)].touched || of_boundary) && !blind(a - 1)) {
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
  if (touches_B && refusal_.empty() && flows_.back().kind() != Kind::Control) {
    refusal_ = touches_alone(*arcs_.back().touched);
  }
  take_guess(guess);
}

std::string LimitedSystem::unknown_junction(int arc) const {
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

void LimitedSystem::take_guess(const Guess& guess) {
  start_.setZero(of_jump(num_jumps_));
  const auto put = [&](int i, State y, int arc) {
    if (flows_[at(arc)].kind() != Kind::Control) y[kPBeta] = 0.0;
    std::copy(y.begin(), y.end(), start_.data() + of_node(i));
  };
  for (int a = 0; a < num_arcs(); ++a) {
    const int pieces = pieces_[at(a)];
    for (int i = 0; i < pieces; ++i) {
      State y = guess.state(at(a), static_cast<double>(i) / pieces);
      if (blind(a)) {
        if (i == 0) y = leave_.left_rest();
        std::fill(y.begin() + kStates, y.end(), 0.0);
      }
      put(first_node_[at(a)] + i, y, a);
    }
    start_(of_duration(a)) = arcs_[at(a)].duration;
  }
  put(first_node_.back(), guess.state(arcs_.size() - 1, 1.0), num_arcs() - 1);
}

State LimitedSystem::node(const Eigen::VectorXd& point, int i) const {
  State y;
  std::copy_n(point.data() + of_node(i), kSize, y.begin());
  return y;
}

double LimitedSystem::span_of(const Eigen::VectorXd& point, int arc) const {
  const double at_rest = blind(arc) ? LimitedStart::kLeftRest : 0.0;
  return (point(of_duration(arc)) - at_rest) / pieces_[at(arc)];
}

const HeldLimit& LimitedSystem::jumps_along(int arc) const {
  const Arc& before = arcs_[at(arc - 1)];
  if (before.touched) return *before.touched;
  return *(flows_[at(arc)].kind() == Kind::Place ? arcs_[at(arc)] : before)
              .held;
}

void LimitedSystem::junction_rows(Rows& rows, int arc, const State& y) const {
  const int i = first_node_[at(arc)];
  const Values<Jet> v = variables(y);
  const LimitedFlow& here = flows_[at(arc)];
  if (arc == 0 ? !blind(0) : blind(arc - 1)) rows.add(here.hamiltonian(v), i);
  if (arc == 0) return;
  const LimitedFlow& before = flows_[at(arc - 1)];
  const auto reaches = [&](const LimitedFlow& flow, const HeldLimit& held) {
    rows.add(flow.value(held.limit, v) - held.bound, i);
    rows.add(flow.rate_of(held.limit, v), i);
  };
  if (const auto& touched = arcs_[at(arc - 1)].touched) {
    return reaches(before, *touched);
  }
  if (here.kind() == Kind::Place) reaches(here, *here.held());
  if (before.kind() != Kind::Control) return;
  if (here.kind() != Kind::Control) {
    rows.add({v[kPBeta], here.slope_condition(v)}, i);
  } else if (opposite_[at(arc)]) {
    rows.add(v[kPBeta], i);
  } else {
    rows.add(before.value(here.held()->limit, v) - here.held()->bound, i);
  }
}

/// The next node less where a piece ends, and less a jump of costates.
void LimitedSystem::matching_rows(Rows& rows, int arc, int piece,
                                  const PieceEnd& end,
                                  const Eigen::VectorXd& point) const {
  const LimitedFlow& flow = flows_[at(arc)];
  const int i = first_node_[at(arc)] + piece;
  const Values<Jet> next = variables(node(point, i + 1));
  const bool last = piece + 1 == pieces_[at(arc)];
  const int jump = last ? jump_[at(arc + 1)] : -1;
  std::array<Jet, kStates> along{};
  if (jump >= 0) along = flow.gradient(jumps_along(arc + 1).limit, next);
  for (std::size_t c = 0; c < (blind(arc) ? kStates : kSize); ++c) {
    Jet gap = next[c] - end.y[c];
    if (jump >= 0 && c >= kStates) {
      rows.by(of_jump(jump)) -= along[c - kStates].value;
      gap = gap - along[c - kStates] * point(of_jump(jump));
    }
    for (int j = 0; j < kWidth; ++j) {
      rows.by(of_node(i) + j) -= end.by_start(static_cast<Eigen::Index>(c), j);
    }
    rows.by(of_duration(arc)) -= end.rates[c] / pieces_[at(arc)];
    rows.add(gap, i + 1);
  }
  if (!blind(arc)) return;
  const Values<Jet> begin = variables(node(point, i));
  for (std::size_t c = kStates; c < kSize; ++c) rows.add(begin[c], i);
}

bool LimitedSystem::evaluate(const Eigen::VectorXd& point,
                             const shooting::StepControl& control,
                             Linearisation& out) const {
  const auto unknowns = static_cast<int>(point.size());
  Rows rows(unknowns, unknowns + 2 * kWidth + 4 * num_arcs());
  out.transit_time = 0.0;
  out.time_gradient.setZero(unknowns);
  out.steps = 0;
  rows.add(leave_.conditions(node(point, 0)), 0);
  if (blind(0)) {
    out.transit_time =
        LimitedStart::kLeftRest * flows_.front().rates(node(point, 0)).t;
  }
  for (int a = 0; a < num_arcs(); ++a) {
    const double span = span_of(point, a);
    rows.begin(a);
    out.arc = a;
    if (!blind(a)) junction_rows(rows, a, node(point, first_node_[at(a)]));
    double step = 0.0;
    for (int k = 0; k < pieces_[at(a)]; ++k) {
      const int i = first_node_[at(a)] + k;
      PieceEnd end;
      if (!integrate_piece(flows_[at(a)], node(point, i), span, judged(a),
                           control, step, end)) {
        return false;
      }
      out.steps += end.steps;
      out.transit_time += end.t;
      out.time_gradient.segment(of_node(i), kWidth) += end.time_by_start;
      out.time_gradient(of_duration(a)) += end.time_rate / pieces_[at(a)];
      matching_rows(rows, a, k, end, point);
    }
  }
  rows.begin(num_arcs());
  const State end = node(point, num_nodes() - 1);
  rows.add(end_conditions(scene_, end), num_nodes() - 1);
  if (jump_.back() >= 0) {
    const HeldLimit& touched = *arcs_.back().touched;
    rows.add(flows_.back().value(touched.limit, variables(end)) - touched.bound,
             num_nodes() - 1);
  }
  rows.move_to(out);
  return true;
}

std::string LimitedSystem::place_of(int arc) const {
  if (arc == num_arcs()) return "B";
  const std::optional<HeldLimit>& held = arcs_[at(arc)].held;
  return fmt::format(
      "arc {} of {}, {}", arc + 1, num_arcs(),
      held ? fmt::format("along {}", name(held->limit.kind)) : "which is free");
}

ArcPath LimitedSystem::path(const Eigen::VectorXd& point,
                            const shooting::StepControl& control) const {
  std::vector<ArcPath::Stretch> arcs;
  for (int a = 0; a < num_arcs(); ++a) {
    ArcPath::Stretch& arc = arcs.emplace_back(
        ArcPath::Stretch{flows_[at(a)], point(of_duration(a)), {}});
    const double begin = blind(a) ? LimitedStart::kLeftRest : 0.0;
    const double span = span_of(point, a);
    for (int k = 0; k < pieces_[at(a)]; ++k) {
      const State start = node(point, first_node_[at(a)] + k);
      // In place of the end of the piece before, from which it is not far.
      if (k > 0) arc.knots.pop_back();
      arc.knots.push_back({begin + k * span, start});
      if (!follow_piece(arc.flow, start, span, judged(a), control,
                        [&](double u, const State& y) {
                          arc.knots.push_back({begin + k * span + u, y});
                        })) {
        return {};
      }
    }
    if (jump_[at(a + 1)] >= 0) {
      arc.jumps_along = jumps_along(a + 1);
      arc.jump = point(of_jump(jump_[at(a + 1)]));
    }
  }
  return {std::move(arcs), blind(0) ? std::optional(leave_) : std::nullopt};
}

}  // namespace brachisto::limited
