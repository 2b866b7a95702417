// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/shooting_system.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "extremal/boundary.hpp"
#include "math/index.hpp"
#include "model/contact.hpp"

namespace brachisto::shooting {

namespace {

State to_state(const Vector6& v) {
  State y;
  std::copy_n(v.data(), kStates, y.begin());
  return y;
}

Vector6 to_vector(const State& y) {
  return Eigen::Map<const Vector6>(y.data());
}

/// Which states the start fixes, in the order of its rows.
constexpr std::array<Eigen::Index, kStartRows> kFixedAtStart{kX, kZ, kTheta, kW,
                                                             kPW};

void start_rows(const InitialState& start, const ChainVector& point,
                Linearisation& out) {
  Eigen::Matrix<double, kStartRows, 1> wanted;
  wanted << start.x, start.z, start.theta, start.w, start.p_w;
  out.jacobian.start_states.setZero();
  out.jacobian.start_globals.setZero();
  for (int i = 0; i < kStartRows; ++i) {
    const Eigen::Index state = kFixedAtStart[at(i)];
    out.residual.start(i) = point.nodes.front()(state) - wanted(i);
    out.jacobian.start_states(i, state) = 1.0;
  }
  out.jacobian.start_globals.col(kEta) << -start.dx_deta, -start.dz_deta, 0.0,
      0.0, -start.dp_w_deta;
}

}  // namespace

CanonicalFlow ShootingSystem::flow(const ChainVector& point) const {
  const Globals& q = point.globals;
  return {scene_.body, scene_.gravity, {q(kPX), q(kPZ), q(kEta)}};
}

bool ShootingSystem::evaluate(const ChainVector& point,
                              const StepControl& control,
                              Linearisation& out) const {
  const Globals& q = point.globals;
  const CanonicalFlow flow = this->flow(point);
  const double eta_limit = 1.0;
  if (!(q(kU) > 0.0) || !(std::abs(q(kEta)) < eta_limit)) return false;

  const InitialState start = start_conditions(scene_, q(kEta));
  start_rows(start, point, out);

  out.jacobian.arcs.resize(at(num_arcs_));
  out.residual.arcs.resize(at(num_arcs_));
  out.transit_time = 0.0;
  out.steps = 0;
  double near = start.beta;
  double step = 0.0;
  ArcEnd end;
  for (int i = 0; i < num_arcs_; ++i) {
    out.arc = i;
    if (stopped()) return false;
    if (!integrate_arc(flow, to_state(point.nodes[at(i)]), near,
                       q(kU) / num_arcs_, control, step, end)) {
      return false;
    }
    near = end.beta;
    out.transit_time += end.t;
    out.steps += end.steps;
    out.residual.arcs[at(i)] = point.nodes[at(i + 1)] - to_vector(end.y);
    ChainJacobian::Arc& arc = out.jacobian.arcs[at(i)];
    arc.states = end.by_start;
    arc.globals.col(kU) = to_vector(end.rates) / num_arcs_;
    arc.globals.col(kPX) = end.by_parameter.col(0);
    arc.globals.col(kPZ) = end.by_parameter.col(1);
    arc.globals.col(kPhi).setZero();
    arc.globals.col(kEta) = end.by_parameter.col(2);
  }

  const State y = to_state(point.nodes.back());
  CanonicalFlow::Slope slope;
  if (!flow.find_slope(y, near, slope)) return false;
  const double phi = q(kPhi);
  const Point centre = end_of_centre(scene_, phi);
  const EndSlide slide = end_slide(scene_, phi);
  out.end_slope = slope.beta;
  out.residual.end << y[kX] - centre.x, y[kZ] - centre.z, y[kPTheta], y[kPW],
      slope.beta - phi;

  auto& states = out.jacobian.end_states;
  auto& globals = out.jacobian.end_globals;
  states.setZero();
  globals.setZero();
  states(0, kX) = states(1, kZ) = states(2, kPTheta) = states(3, kPW) = 1.0;
  globals(0, kPhi) = -slide.dx_dphi;
  globals(1, kPhi) = -slide.dz_dphi;
  globals(4, kPhi) = -1.0;
  for (const auto component : {kTheta, kW, kPW}) {
    State v{};
    v[component] = 1.0;
    states(4, static_cast<Eigen::Index>(component)) =
        flow.slope_variation(y, slope, v, {});
  }
  globals(4, kPX) = flow.slope_variation(y, slope, {}, {.p_x = 1.0});
  globals(4, kPZ) = flow.slope_variation(y, slope, {}, {.p_z = 1.0});
  globals(4, kEta) = flow.slope_variation(y, slope, {}, {.eta = 1.0});
  return true;
}

std::vector<ExtremalPath::Knot> ShootingSystem::path(
    const ChainVector& point, const StepControl& control) const {
  const Globals& q = point.globals;
  const CanonicalFlow flow = this->flow(point);
  const double span = q(kU) / num_arcs_;
  double near = start_conditions(scene_, q(kEta)).beta;
  double step = 0.0;
  double time = 0.0;
  std::vector<ExtremalPath::Knot> knots;
  for (int i = 0; i < num_arcs_; ++i) {
    // The next arc starts where this one ends, but for the matching error.
    if (i > 0) knots.pop_back();
    const std::size_t first = knots.size();
    State first_state = to_state(point.nodes[at(i)]);
    if (i == 0) first_state[kW] = 0.0;  // exactly, not but for rounding
    ArcEnd end;
    if (stopped() || !integrate_path(flow, first_state, near, span, control,
                                     step, end, knots)) {
      return {};
    }
    for (std::size_t j = first; j < knots.size(); ++j) {
      knots[j].u += i * span;
      knots[j].t += time;
    }
    near = end.beta;
    time += end.t;
  }
  knots.back().u = q(kU);
  return knots;
}

double ShootingSystem::time_missing(const ChainVector& point,
                                    const ChainRows& residual) const {
  const Globals& q = point.globals;
  const auto saved = [&](double x, double z, double theta, double w,
                         const Vector6& node) {
    return -(q(kPX) * x + q(kPZ) * z + node(kPTheta) * theta + node(kPW) * w);
  };
  const auto& start = residual.start;
  double sum =
      saved(start(0), start(1), start(2), start(3), point.nodes.front());
  for (std::size_t i = 0; i < residual.arcs.size(); ++i) {
    const Vector6& gap = residual.arcs[i];
    sum += saved(gap(kX), gap(kZ), gap(kTheta), gap(kW), point.nodes[i + 1]);
  }
  // Ending beyond B has cost what a gap would have saved.
  return sum -
         saved(residual.end(0), residual.end(1), 0.0, 0.0, point.nodes.back());
}

double ChainScale::norm(const ChainVector& change) const {
  double largest =
      change.globals.cwiseQuotient(globals).lpNorm<Eigen::Infinity>();
  for (const Vector6& v : change.nodes) {
    largest =
        std::max(largest, v.cwiseQuotient(node).lpNorm<Eigen::Infinity>());
  }
  return largest;
}

double ChainScale::norm(const ChainRows& residual) const {
  double largest = 0.0;
  for (int i = 0; i < kStartRows; ++i) {
    largest = std::max(
        largest, std::abs(residual.start(i)) / node(kFixedAtStart[at(i)]));
  }
  for (const Vector6& v : residual.arcs) {
    largest =
        std::max(largest, v.cwiseQuotient(node).lpNorm<Eigen::Infinity>());
  }
  const Eigen::Matrix<double, kEndRows, 1> size{node(kX), node(kZ),
                                                node(kPTheta), node(kPW), 1.0};
  return std::max(largest,
                  residual.end.cwiseQuotient(size).lpNorm<Eigen::Infinity>());
}

ChainVector moved(const ChainVector& point, double factor,
                  const ChainVector& change) {
  ChainVector out = point;
  out.globals += factor * change.globals;
  for (std::size_t i = 0; i < out.nodes.size(); ++i) {
    out.nodes[i] += factor * change.nodes[i];
  }
  return out;
}

int choose_arcs(const Scene& natural, const ExtremalGuess& guess, int wanted) {
  constexpr int kFewest = 4;
  constexpr int kMost = 20000;
  constexpr double kPerTurn = 3.0;
  if (wanted > 0) return wanted;
  const double turns =
      natural.body.rolls()
          ? std::abs(guess.state(1.0).theta - natural.body.theta_m) /
                (2.0 * std::numbers::pi)
          : 0.0;
  return static_cast<int>(
      std::clamp(std::ceil(kPerTurn * turns), 1.0 * kFewest, 1.0 * kMost));
}

ChainVector to_chain(const Scene& natural, const Units& units,
                     const ExtremalGuess& guess, int num_arcs) {
  ChainVector point;
  point.globals << guess.rolling_time / units.time, guess.p_x * units.speed(),
      guess.p_z * units.speed(), guess.phi, natural.body.eta_m;
  for (int i = 0; i <= num_arcs; ++i) {
    const ExtremalState s = guess.state(static_cast<double>(i) / num_arcs);
    Vector6 node;
    node << s.x / units.length, s.z / units.length, s.theta,
        s.w / units.speed(), s.p_theta / units.time,
        s.p_w * units.speed() / units.time;
    point.nodes.push_back(node);
  }
  return point;
}

ChainScale scale_of(const Scene& natural, const ChainVector& point) {
  const double p = std::hypot(point.globals(kPX), point.globals(kPZ));
  ChainScale scale;
  scale.globals << point.globals(kU), p, p, 1.0, 1.0;
  scale.node << 1.0, 1.0, 1.0, 1.0, 1.0 / inverse_radius(natural.body),
      std::max(1.0, std::abs(point.nodes.front()(kPW)));
  return scale;
}

}  // namespace brachisto::shooting
