// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/arc_flow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace brachisto::arcs {

namespace {

template <class Flow>
constexpr bool kSteered = Flow::kStates == 4;

template <class Flow>
typename Flow::State array_of(const Node& y) {
  typename Flow::State out;
  std::copy_n(y.data(), out.size(), out.begin());
  return out;
}

template <class Array>
Node vector_of(const Array& y) {
  return Eigen::Map<const Node>(y.data(), static_cast<Eigen::Index>(y.size()));
}

template <class Flow>
Knot knot_of(const ocp::Passed<Flow>& at) {
  return {at.u, vector_of(at.y), at.cost, at.control};
}
template <class Flow>
ocp::Passed<Flow> passed_at(const Knot& knot) {
  return {knot.u, array_of<Flow>(knot.y), knot.t, knot.control};
}

/// A number with a row of derivatives.
template <class Row>
Jet jet_of(double value, const Row& by) {
  Jet out(value);
  std::copy(by.begin(), by.end(), out.gradient.begin());
  return out;
}

double dot(const auto& a, const auto& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// The states and their costates in a node, where β is none of them.
constexpr std::array<Component, 8> kWithoutSlope{kX,  kZ,  kTheta,  kW,
                                                 kPX, kPZ, kPTheta, kPW};

/// use(flow, at, ∂(control, μ)/∂y, rates) of the point found at y; false if
/// there is none.
template <class Flows, class Use>
bool with_point(const Flows& flows, const Node& y, double& control, Use use) {
  return std::visit(
      [&]<class Flow>(const Flow& flow) {
        typename Flow::template At<typename Flow::SecondOrder> at;
        if (!flow.find(array_of<Flow>(y), control, at)) return false;
        use(flow, at, flow.eliminated(at), Flow::rates(at));
        return true;
      },
      flows);
}

}  // namespace

double rotation_per_length(const Scene& natural) {
  if (natural.limits.any() && !natural.body.off_centred()) return 0.0;
  return natural.body.rolls() ? 1.0 / natural.body.radius : 1.0;
}

ArcFlow::ArcFlow(const Scene& natural, std::optional<HeldLimit> held)
    : held_(std::move(held)),
      kind_(!held_                          ? Kind::Free
            : held_->limit.bounds_control() ? Kind::Control
                                            : Kind::Place),
      flow_([&]() -> AnyFlow {
        const double turn = rotation_per_length(natural);
        if (kind_ == Kind::Control) {
          return TurningFlow(rolling::Turning(natural, {held_->limit}, turn),
                             ocp::HeldLimit{0, held_->bound});
        }
        if (kind_ == Kind::Place) {
          return SteeredFlow(rolling::Steered(natural, {held_->limit}, turn),
                             ocp::HeldLimit{0, 0.0});
        }
        if (natural.world.changes_rates()) {
          return SteeredFlow(rolling::Steered(natural, {}, turn));
        }
        return FallingFlow(rolling::SteeredFalling(natural, {}, turn));
      }()) {}

void ArcFlow::judge_states_alone() {
  std::visit([](auto& flow) { flow.judges_costates = false; }, flow_);
}

Node ArcFlow::node_of(const State& y) const {
  if (kind_ == Kind::Control) return vector_of(y);
  Node out(8);
  for (std::size_t i = 0; i < kWithoutSlope.size(); ++i) {
    out(static_cast<Eigen::Index>(i)) = y[kWithoutSlope[i]];
  }
  return out;
}

bool ArcFlow::find(const Node& y, double& control, LinearPoint& out) const {
  return with_point(flow_, y, control,
                    [&]<class Flow>(const Flow&, const auto& at, const auto& by,
                                    const auto& rates) {
                      typename Flow::State h;  // ∂𝓗/∂(y, p)
                      for (std::size_t i = 0; i < Flow::kStates; ++i) {
                        h[i] = -rates[Flow::kStates + i];
                        h[Flow::kStates + i] = rates[i];
                      }
                      out.hamiltonian = jet_of(at.hamiltonian.value, h);
                      out.multiplier = jet_of(at.multiplier, by.multiplier);
                      const auto variable = [&](std::size_t i) {
                        const auto place = static_cast<int>(i);
                        return Jet::variable(y(place), place);
                      };
                      if constexpr (kSteered<Flow>) {
                        for (std::size_t i = 0; i < kWithoutSlope.size(); ++i) {
                          out.y[kWithoutSlope[i]] = variable(i);
                        }
                        out.y[kBeta] = jet_of(control, by.control);
                        out.y[kPBeta] = Jet(0.0);
                      } else {
                        for (std::size_t i = 0; i < kSize; ++i)
                          out.y[i] = variable(i);
                      }
                      out.p_x = out.y[kPX];
                      out.p_z = out.y[kPZ];
                      if (kind_ == Kind::Place) {
                        const auto normal = normal_at(held_->limit, out.y);
                        out.y[kPX] += out.multiplier * normal.x;
                        out.y[kPZ] += out.multiplier * normal.z;
                      }
                    });
}

bool ArcFlow::find(const Node& y, double& control, ArcPoint& out) const {
  return with_point(flow_, y, control,
                    [&]<class Flow>(const Flow&, const auto& at, const auto& by,
                                    const auto& rates) {
                      out = {};
                      out.root = at.rates.cost.value;
                      if constexpr (kSteered<Flow>) {
                        for (std::size_t i = 0; i < kWithoutSlope.size(); ++i) {
                          out.y[kWithoutSlope[i]] =
                              y(static_cast<Eigen::Index>(i));
                        }
                        out.y[kBeta] = control;
                        out.q = dot(by.control, rates);
                        if (kind_ == Kind::Free) {
                          out.legendre = Flow::legendre(at);
                          return;
                        }
                        out.jump = at.multiplier;
                        out.nu = dot(by.multiplier, rates);
                        const auto normal = rolling::normal_of(
                            held_->limit, out.y[kX], out.y[kZ]);
                        out.y[kPX] += at.multiplier * normal.x;
                        out.y[kPZ] += at.multiplier * normal.z;
                      } else {
                        std::copy_n(y.data(), kSize, out.y.begin());
                        out.q = control;
                        out.nu = -at.multiplier;
                      }
                    });
}

// With q(y) from d(y, q) = b along the arc, the limit is c(y, q(y)), and for
// any function of both, with e = ∂q/∂y = −d_y/d_q,
//
//     c̃_y = c_y + c_q e,   c̃_yy = c̄ − (c_q/d_q) d̄,
//     c̄ = c_yy + c_yq eᵀ + e c_qy + c_qq e eᵀ.
AlongArc ArcFlow::along(const PathInequality& limit, const Node& y) const {
  const TurningFlow& flow = std::get<TurningFlow>(flow_);
  using Second = TurningFlow::SecondOrder;
  constexpr std::size_t kQ = TurningFlow::kControl;
  double control = 0.0;
  TurningFlow::At<Second> at;
  AlongArc out;
  if (!flow.find(array_of<TurningFlow>(y), control, at)) {
    out.value = out.rate = Jet(std::numeric_limits<double>::quiet_NaN());
    return out;
  }
  std::array<double, kStates + 1> yu;
  std::copy_n(y.data(), kStates, yu.begin());
  yu[kQ] = control;
  const Second c = flow.problem().value(limit, ocp::as_variables<Second>(yu));
  const Second& d = at.limit;
  const TurningFlow::State e = flow.eliminated(at).control;
  const auto bent = [&](const Second& of, std::size_t i, std::size_t j) {
    return of.second(i, j) + of.second(i, kQ) * e[j] + of.second(j, kQ) * e[i] +
           of.second(kQ, kQ) * e[i] * e[j];
  };
  const double share = c.gradient[kQ] / d.gradient[kQ];
  for (std::size_t i = 0; i < kStates; ++i) {
    out.by_state[i] = Jet(c.gradient[i] + c.gradient[kQ] * e[i]);
    for (std::size_t j = 0; j < kStates; ++j) {
      out.by_state[i].gradient[j] = bent(c, i, j) - share * bent(d, i, j);
    }
  }
  out.value = Jet(c.value);
  out.rate = Jet(0.0);
  const TurningFlow::Linearisation by = flow.linearisation(at);
  for (std::size_t i = 0; i < kStates; ++i) {
    out.value.gradient[i] = out.by_state[i].value;
    out.rate += out.by_state[i] * jet_of(at.rates.states[i].value, by[i]);
  }
  return out;
}

namespace {

template <class Scalar>
TurningPoint<Scalar> turning_point(const ArcPoint& at, const Scalar& q) {
  return {Scalar(at.y[kX]), Scalar(at.y[kZ]),    Scalar(at.y[kTheta]),
          Scalar(at.y[kW]), Scalar(at.y[kBeta]), q};
}

}  // namespace

double ArcFlow::value(const PathInequality& limit, const ArcPoint& at) const {
  return std::visit(
      [&](const auto& flow) {
        const Scene& scene = flow.problem().scene();
        return value_of(limit, scene, turning_point(at, at.q));
      },
      flow_);
}

double ArcFlow::by_control(const PathInequality& limit,
                           const ArcPoint& at) const {
  using On = math::Jet1<double, 1>;
  return std::visit(
      [&](const auto& flow) {
        const Scene& scene = flow.problem().scene();
        return value_of(limit, scene, turning_point(at, On::variable(at.q, 0)))
            .gradient[0];
      },
      flow_);
}

bool ArcFlow::integrate(const Node& start, double near, double span,
                        const ocp::StepControl& control, double& step,
                        PieceEnd& end, bool derivatives) const {
  return std::visit(
      [&]<class Flow>(const Flow& flow) {
        ocp::ArcEnd<Flow> found;
        found.by_start.setZero();
        found.cost_by_start.setZero();
        const auto y = array_of<Flow>(start);
        if (!(derivatives ? ocp::integrate_arc(flow, y, near, span, control,
                                               step, found)
                          : ocp::end_of_arc(flow, y, near, span, control, step,
                                            found))) {
          return false;
        }
        end = {.y = vector_of(found.y),
               .rates = vector_of(found.rates),
               .t = found.cost,
               .control = found.control,
               .time_rate = found.cost_rate,
               .by_start = found.by_start,
               .time_by_start = found.cost_by_start,
               .steps = found.steps};
        return true;
      },
      flow_);
}

bool ArcFlow::follow(const Node& start, double near, double span,
                     const ocp::StepControl& control,
                     const std::function<void(const Knot&)>& tell) const {
  return std::visit(
      [&]<class Flow>(const Flow& flow) {
        return ocp::follow_arc(
            flow, array_of<Flow>(start), near, span, control,
            [&](const ocp::Passed<Flow>& at) { tell(knot_of(at)); });
      },
      flow_);
}

Knot ArcFlow::step_from(const Knot& from, const Knot& towards,
                        double span) const {
  return std::visit(
      [&]<class Flow>(const Flow& flow) {
        const ocp::Passed<Flow> start = passed_at<Flow>(from);
        if (!flow.has_surface()) {
          return knot_of(ocp::step_from(flow, start, span));
        }
        // Paths have knots on the surface, and only one of two that follow on
        // each other is there.
        const double first = flow.height(start.y);
        const double last = flow.height(array_of<Flow>(towards.y));
        const double height = std::abs(first) > std::abs(last) ? first : last;
        return knot_of(ocp::step_from(flow.on_side(height > 0.0), start, span));
      },
      flow_);
}

}  // namespace brachisto::arcs
