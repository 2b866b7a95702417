// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/limited_system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/index.hpp"
#include "model/contact.hpp"
#include "model/energy.hpp"
#include "model/inertia.hpp"
#include "model/start_angle.hpp"
#include "model/start_under_limits.hpp"

namespace brachisto::limited {

namespace {

using Kind = LimitedFlow::Kind;

constexpr int kWidth = static_cast<int>(kSize);

/// The rest is left after so much u by its series, where a limit on forces is
/// 0/0: with β − β₀ and w − g a u of its second and third order the states err
/// by 1e-15, and what β errs by dies out.
constexpr double kLeftRest = 1e-5;

Values<Jet> variables(const State& y) {
  Values<Jet> out;
  for (std::size_t i = 0; i < kSize; ++i) {
    out[i] = Jet::variable(y[i], static_cast<int>(i));
  }
  return out;
}

/// Whether a limit that holds keeps the control from growing.
bool holds_from_above(const LimitedFlow& flow, const State& y) {
  const HeldLimit& held = *flow.held();
  const bool grows = flow.by_control(held.limit, y) > 0.0;
  return grows == (held.bound == held.limit.upper);
}

/// The slope at rest next to `near` at which a limit on forces holds.
double slope_at_rest(const Scene& scene, const HeldLimit& held, double near) {
  using On = math::Jet1<double, 1>;
  constexpr int kMostSteps = 30;
  double beta = near;
  for (int i = 0; i < kMostSteps; ++i) {
    const On value =
        value_of(held.limit, scene.body, scene.gravity,
                 TurningPoint<On>{On(0.0), On(0.0), On(scene.body.theta_m),
                                  On(0.0), On::variable(beta, 0), On(0.0)});
    const double change = (held.bound - value.value) / value.gradient[0];
    beta += change;
    if (!(std::abs(change) > 1e-15)) break;
  }
  return beta;
}

}  // namespace

/// The equations, one after the other.
class LimitedSystem::Rows {
 public:
  Rows(int unknowns, int most) {
    residual_.setZero(most);
    jacobian_.setZero(most, unknowns);
  }

  /// An equation of the unknowns of one node.
  void add(const Jet& value, int node) {
    for (int j = 0; j < kWidth; ++j) {
      by(kWidth * node + j) += value.gradient[at(j)];
    }
    finish(value.value);
  }
  /// A derivative of the equation that is finished next.
  [[nodiscard]] double& by(int unknown) { return jacobian_(size_, unknown); }
  void finish(double value) { residual_(size_++) = value; }

  void move_to(Linearisation& out) {
    out.residual = residual_.head(size_);
    out.jacobian = jacobian_.topRows(size_);
  }

 private:
  Eigen::VectorXd residual_;
  Eigen::MatrixXd jacobian_;
  Eigen::Index size_ = 0;
};

LimitedSystem::LimitedSystem(const Scene& natural, const Guess& guess)
    : scene_(natural), arcs_(guess.arcs) {
  constexpr double kFewest = 4.0, kPerTurn = 3.0;
  double U = 0.0;
  for (const Arc& arc : arcs_) {
    flows_.emplace_back(scene_, arc.held);
    U += arc.duration;
  }
  const State first = guess.state(0, 0.0);
  const State last = guess.state(arcs_.size() - 1, 1.0);
  const double turns =
      std::abs(last[kTheta] - first[kTheta]) / (2.0 * std::numbers::pi);
  choose_start(first);

  int nodes = 0;
  for (std::size_t a = 0; a < arcs_.size(); ++a) {
    const double share = arcs_[a].duration / U;
    first_node_.push_back(nodes);
    pieces_.push_back(static_cast<int>(
        std::ceil(share * std::max(kFewest, kPerTurn * turns))));
    nodes += pieces_.back();
    jump_.push_back(-1);
    opposite_.push_back(false);
    if (a == 0) continue;
    const Kind before = flows_[a - 1].kind(), here = flows_[a].kind();
    const bool touched = arcs_[a - 1].touched.has_value();
    const bool of_boundary = (before == Kind::Control && here == Kind::Place) ||
                             (before == Kind::Place && here == Kind::Control);
    if ((touched || of_boundary) && !blind(static_cast<int>(a) - 1)) {
      jump_.back() = num_jumps_++;
    }
    const State junction = guess.state(a, 0.0);
    if (before == Kind::Control && here == Kind::Control) {
      opposite_.back() = holds_from_above(flows_[a - 1], junction) !=
                         holds_from_above(flows_[a], junction);
    }
    if (touched && (before != Kind::Control || here != Kind::Control)) {
      refusal_ = fmt::format("it touches {} where no limit holds the control",
                             name(arcs_[a - 1].touched->limit.kind));
    }
    if (before == Kind::Place && here == Kind::Place) {
      refusal_ = "it goes from one boundary to another";
    }
  }
  first_node_.push_back(nodes);

  start_.setZero(kWidth * (nodes + 1) + static_cast<int>(arcs_.size()) +
                 num_jumps_);
  const auto put = [&](int i, State y, Kind kind) {
    if (kind != Kind::Control) y[kPBeta] = 0.0;
    start_.segment(kWidth * i, kWidth) =
        Eigen::Map<const Eigen::Matrix<double, kWidth, 1>>(y.data());
  };
  for (std::size_t a = 0; a < arcs_.size(); ++a) {
    for (int i = 0; i < pieces_[a]; ++i) {
      State y = guess.state(a, static_cast<double>(i) / pieces_[a]);
      if (blind(static_cast<int>(a))) {
        if (i == 0) y = at_rest(*start_slope_);
        std::fill(y.begin() + kPX, y.end(), 0.0);
      }
      put(first_node_[a] + i, y, flows_[a].kind());
    }
    start_(kWidth * (nodes + 1) + static_cast<Eigen::Index>(a)) =
        arcs_[a].duration;
  }
  put(nodes, last, flows_.back().kind());
}

void LimitedSystem::choose_start(const State& first) {
  const bool optimal =
      scene_.contact == Contact::Optimal && scene_.body.rolls();
  const std::optional<HeldLimit>& held = arcs_.front().held;
  if (!held) {
    start_kind_ = Start::Free;
    start_slope_ = start_angle(scene_.body);
    if (optimal) refusal_ = "it leaves an optimal contact freely";
    return;
  }
  if (flows_.front().kind() == Kind::Place) {
    refusal_ = "it starts along a boundary";
    return;
  }
  if (held->limit.bounds_force()) {
    start_kind_ = Start::Forced;
    start_slope_ = slope_at_rest(scene_, *held, first[kBeta]);
    return;
  }
  start_kind_ = Start::Turning;
  const std::vector<PathInequality> limits =
      inequalities(scene_.body, scene_.limits);
  const bool takes_time =
      std::any_of(limits.begin(), limits.end(), [](const PathInequality& one) {
        return one.kind == PathInequality::Kind::Valley;
      });
  if (!optimal && !takes_time) {
    start_slope_ = start_angle_under(scene_.body, limits);
    if (!start_slope_) refusal_ = "no direction at rest keeps the limits";
  }
}

State LimitedSystem::node(const Eigen::VectorXd& point, int i) const {
  State y;
  std::copy_n(point.data() + kWidth * i, kSize, y.begin());
  return y;
}

State LimitedSystem::first(const Eigen::VectorXd& point) const {
  return node(point, 0);
}

State LimitedSystem::last(const Eigen::VectorXd& point) const {
  return node(point, first_node_.back());
}

double LimitedSystem::span_of(const Eigen::VectorXd& point, int arc) const {
  const double duration = point(kWidth * (first_node_.back() + 1) + arc);
  return (duration - (blind(arc) ? kLeftRest : 0.0)) / pieces_[at(arc)];
}

std::vector<double> LimitedSystem::junctions(
    const Eigen::VectorXd& point) const {
  std::vector<double> out;
  double u = 0.0;
  for (std::size_t a = 0; a < arcs_.size(); ++a) {
    u +=
        point(kWidth * (first_node_.back() + 1) + static_cast<Eigen::Index>(a));
    out.push_back(u);
  }
  return out;
}

State LimitedSystem::at_rest(double beta) const {
  const Body& body = scene_.body;
  const double u = kLeftRest;
  const double w = scene_.gravity * energy_slope(body, body.theta_m, beta) * u;
  const Point centre = scene_.contact == Contact::Centre
                           ? Point{0.0, 0.0}
                           : centre_above({0.0, 0.0}, body.radius, beta);
  const double s = 0.5 * w * u;
  State y{};
  y[kX] = centre.x + s * std::cos(beta);
  y[kZ] = centre.z + s * std::sin(beta);
  y[kTheta] = body.theta_m + s * flows_.front().inverse_radius();
  y[kW] = w;
  y[kBeta] = beta;
  return y;
}

void LimitedSystem::start_rows(Rows& rows, const State& y) const {
  const Values<Jet> v = variables(y);
  if (start_kind_ == Start::Forced) {
    const State rest = at_rest(*start_slope_);
    for (std::size_t i = 0; i < kStates; ++i) rows.add(v[i] - Jet(rest[i]), 0);
    return;
  }
  const Body& body = scene_.body;
  const double r = scene_.contact == Contact::Centre ? 0.0 : body.radius;
  rows.add(v[kX] - sin(v[kBeta]) * r, 0);
  rows.add(v[kZ] + cos(v[kBeta]) * r, 0);
  rows.add(v[kTheta] - body.theta_m, 0);
  rows.add(v[kW], 0);
  if (start_slope_) rows.add(v[kBeta] - *start_slope_, 0);
  if (start_kind_ == Start::Free || !start_slope_) {
    const bool optimal = scene_.contact == Contact::Optimal;
    const Jet along = v[kPX] * cos(v[kBeta]) + v[kPZ] * sin(v[kBeta]);
    rows.add(v[kPBeta] + along * (optimal ? r : 0.0), 0);
  }
}

void LimitedSystem::junction_rows(Rows& rows, int arc, const State& y) const {
  const int i = first_node_[at(arc)];
  const Values<Jet> v = variables(y);
  const LimitedFlow& here = flows_[at(arc)];
  if (arc == 0 ? !blind(0) : blind(arc - 1)) rows.add(here.hamiltonian(v), i);
  if (arc == 0) return;
  const LimitedFlow& before = flows_[at(arc - 1)];
  if (const auto& touched = arcs_[at(arc - 1)].touched) {
    rows.add(before.value(touched->limit, v) - touched->bound, i);
    rows.add(before.rate_of(touched->limit, v), i);
    return;
  }
  const bool from_control = before.kind() == Kind::Control;
  if (here.kind() == Kind::Place) {
    rows.add(here.value(here.held()->limit, v) - here.held()->bound, i);
    rows.add(here.rate_of(here.held()->limit, v), i);
  }
  if (here.kind() != Kind::Control && from_control) {
    rows.add(v[kPBeta], i);
    rows.add(here.slope_condition(v), i);
  }
  if (here.kind() == Kind::Control && from_control) {
    rows.add(opposite_[at(arc)]
                 ? v[kPBeta]
                 : before.value(here.held()->limit, v) - here.held()->bound,
             i);
  }
}

void LimitedSystem::end_rows(Rows& rows, const State& y) const {
  const int i = first_node_.back();
  const Values<Jet> v = variables(y);
  const bool of_centre = scene_.contact == Contact::Centre;
  const double r = of_centre ? 0.0 : scene_.body.radius;
  rows.add(v[kX] - sin(v[kBeta]) * r - scene_.L, i);
  rows.add(v[kZ] + cos(v[kBeta]) * r - scene_.H, i);
  rows.add(v[kPTheta], i);
  rows.add(v[kPW], i);
  if (scene_.contact == Contact::EndSlope && scene_.body.rolls()) {
    rows.add(v[kBeta] - *scene_.end_slope, i);
    return;
  }
  const bool optimal = scene_.contact == Contact::Optimal;
  const Jet along = v[kPX] * cos(v[kBeta]) + v[kPZ] * sin(v[kBeta]);
  rows.add(v[kPBeta] + along * (optimal ? r : 0.0), i);
}

bool LimitedSystem::evaluate(const Eigen::VectorXd& point,
                             const shooting::StepControl& control,
                             Linearisation& out) const {
  const auto unknowns = static_cast<int>(point.size());
  const int nodes = first_node_.back() + 1;
  const auto arcs = static_cast<int>(arcs_.size());
  Rows rows(unknowns, unknowns + 2 * kWidth + 4 * arcs);
  out.transit_time = 0.0;
  out.time_gradient.setZero(unknowns);
  out.steps = 0;
  start_rows(rows, node(point, 0));
  for (int a = 0; a < arcs; ++a) {
    const LimitedFlow& flow = flows_[at(a)];
    const int of_duration = kWidth * nodes + a;
    const double span = span_of(point, a);
    if (!(span > 0.0)) return false;
    if (!blind(a)) {
      junction_rows(rows, a, node(point, first_node_[at(a)]));
    }
    if (blind(a)) {
      out.transit_time += kLeftRest * flow.rates(node(point, 0)).t;
    }
    double step = 0.0;
    for (int k = 0; k < pieces_[at(a)]; ++k) {
      const int i = first_node_[at(a)] + k;
      const State begin = node(point, i);
      PieceEnd end;
      if (!integrate_piece(
              flow, begin, span,
              blind(a) ? Judged::StatesAlone : Judged::StatesAndCostates,
              control, step, end)) {
        return false;
      }
      out.steps += end.steps;
      out.transit_time += end.t;
      out.time_gradient.segment(kWidth * i, kWidth) += end.time_by_start;
      out.time_gradient(of_duration) += end.time_rate / pieces_[at(a)];

      Values<Jet> next = variables(node(point, i + 1));
      const bool last = k + 1 == pieces_[at(a)];
      const int jump = last && a + 1 < arcs ? jump_[at(a + 1)] : -1;
      const int of_jump = kWidth * nodes + arcs + jump;
      std::array<Jet, kStates> along{};
      if (jump >= 0) {
        const auto& touched = arcs_[at(a)].touched;
        along = touched ? flow.gradient(touched->limit, next)
                : flow.kind() == Kind::Place
                    ? flow.gradient(flow.held()->limit, next)
                    : flows_[at(a + 1)].gradient(
                          flows_[at(a + 1)].held()->limit, next);
      }
      for (std::size_t c = 0; c < (blind(a) ? kStates : kSize); ++c) {
        const auto row = static_cast<Eigen::Index>(c);
        Jet gap = next[c] - Jet(end.y[c]);
        if (jump >= 0 && c >= kPX) {
          rows.by(of_jump) -= along[c - kPX].value;
          gap = gap - along[c - kPX] * point(of_jump);
        }
        for (int j = 0; j < kWidth; ++j) {
          rows.by(kWidth * i + j) -= end.by_start(row, j);
        }
        rows.by(of_duration) -= end.rates[c] / pieces_[at(a)];
        rows.add(gap, i + 1);
      }
      for (std::size_t c = kPX; blind(a) && c < kSize; ++c) {
        rows.add(Jet::variable(begin[c], static_cast<int>(c)), i);
      }
    }
  }
  end_rows(rows, node(point, first_node_.back()));
  rows.move_to(out);
  return true;
}

std::string LimitedSystem::objection(
    const Eigen::VectorXd& point, const std::vector<PathInequality>& limits,
    const shooting::StepControl& control) const {
  constexpr double kExceeded = 1e-8;
  constexpr double kWrongSign = 1e-6;
  std::string out;
  double start_of_arc = 0.0;
  if (getenv("WDBG")) {
    int nn = first_node_.back() + 1;
    for (size_t a = 0; a < arcs_.size(); ++a) {
      auto i = node(point, first_node_[a]);
      fprintf(stderr,
              "arc %zu %s dur %.9g (guess %.9g) pieces %d pbeta %.3e Hb %.3e "
              "jump %.3e touched %s beta %.8f\n",
              a, arcs_[a].held ? name(arcs_[a].held->limit.kind) : "free",
              point(kWidth * nn + (int)a), arcs_[a].duration, pieces_[a],
              i[kPBeta], flows_[a].slope_condition(i),
              jump_[a] >= 0 ? point(kWidth * nn + (int)arcs_.size() + jump_[a])
                            : 0.0,
              arcs_[a].touched ? name(arcs_[a].touched->limit.kind) : "-",
              i[kBeta]);
    }
  }
  for (int a = 0; a < static_cast<int>(arcs_.size()) && out.empty(); ++a) {
    const LimitedFlow& flow = flows_[at(a)];
    const std::optional<HeldLimit>& held = flow.held();
    double largest = 1.0, wrong = 0.0;
    for (int k = 0; k < pieces_[at(a)]; ++k) {
      const double span = span_of(point, a);
      const auto look = [&](double u, const State& y) {
        u += start_of_arc + k * span;
        for (const PathInequality& limit : limits) {
          if (held && held->limit.kind == limit.kind &&
              limit.bounds_control()) {
            continue;
          }
          const double value = flow.value(limit, y);
          const double excess =
              std::max(limit.lower - value, value - limit.upper);
          if (excess <= kExceeded || !out.empty()) continue;
          out = fmt::format("{} is exceeded by {:.1e} at u = {:.6g}",
                            name(limit.kind), excess, u);
        }
        if (flow.kind() == Kind::Free && !(flow.legendre(y) > 0.0)) {
          out = fmt::format("its free arc is no minimum at u = {:.6g}", u);
        }
        if (!held || blind(a)) return;
        const double nu = flow.rates(y).nu;
        largest = std::max(largest, std::abs(nu));
        wrong = std::max(wrong, held->bound == held->limit.upper ? nu : -nu);
      };
      if (!follow_piece(
              flow, node(point, first_node_[at(a)] + k), span,
              blind(a) ? Judged::StatesAlone : Judged::StatesAndCostates,
              control, look)) {
        return "it cannot be integrated again";
      }
    }
    if (out.empty() && wrong > kWrongSign * largest) {
      out = fmt::format("the multiplier of {} has the wrong sign, by {:.1e}",
                        name(held->limit.kind), wrong / largest);
    }
    start_of_arc += point(kWidth * (first_node_.back() + 1) + a);
  }
  return out;
}

}  // namespace brachisto::limited
