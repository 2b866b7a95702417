// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/limited_time.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "brachisto/math/stop_condition.hpp"
#include "math/index.hpp"
#include "model/field.hpp"
#include "model/start_angle.hpp"
#include "transcription/program_formulas.hpp"

namespace brachisto {

namespace {

using enum StateComponent;

int num_contact_rows(const Scene& scene, const LimitedEnds& ends) {
  if (!ends.free_contacts) return 0;
  return scene.world.start_speed > 0.0 ? 5 : 4;
}

/// Of forces where they are known without the control: at rest.
int num_start_rows(const Scene& scene,
                   const std::vector<PathInequality>& limits,
                   const LimitedEnds& ends) {
  if (ends.start_slope_fixed || scene.world.start_speed > 0.0) return 0;
  return static_cast<int>(
      std::ranges::count_if(limits, &PathInequality::bounds_force));
}

/// x, z, θ, w, β, h q, as a formula sees which of them it depends on.
const std::array<math::Dependence<6>, 6> kVariables = [] {
  std::array<math::Dependence<6>, 6> out;
  for (int i = 0; i < 6; ++i) out[at(i)] = math::Dependence<6>::variable(i);
  return out;
}();

/// Of the rows of free contacts: x and z at A and at B, and the push.
bool is_at_A(int contact_row) {
  return contact_row < 2 || contact_row == 4;
}

bool is_of_place(const math::Dependence<6>& on) {
  return (on.any >> 2U).none();
}

}  // namespace

LimitedTime::LimitedTime(const Scene& scene, std::vector<PathInequality> limits,
                         Mesh mesh, const LimitedEnds& ends,
                         std::optional<HeldLimits> held)
    : Transcription(
          scene, mesh,
          VariableLayout::with_limits(
              mesh.num_points(), scene.body.off_centred(),
              static_cast<int>(limits.size()), num_contact_rows(scene, ends),
              num_start_rows(scene, limits, ends)),
          {}, "collocation point"),
      scheme_(&radau_scheme(mesh.degree)),
      body_(scene, std::move(limits),
            scene.body.rolls() ? 1.0 / scene.body.radius : 1.0),
      ends_(ends),
      held_(std::move(held)),
      rates_on_(body_.rates(kVariables)),
      row_lower_(at(num_constraints())),
      row_upper_(at(num_constraints())),
      points_(at(layout().num_points())),
      limit_values_(points_.size() * body_.num_limits()) {
  for (std::size_t i = 0; i < body_.num_limits(); ++i) {
    limits_on_.push_back(body_.limit(i, kVariables));
  }
  const auto bends_places = [](const Dependence& on) {
    return on.curved[0] || on.curved[1];
  };
  curved_places_ =
      scene.world.sphere || std::ranges::any_of(limits_on_, bends_places);
  fix_start();
  weigh();
  bound_limits();
  build_patterns();
}

void LimitedTime::weigh() {
  weights_.assign(at(num_variables() + num_constraints()), 1.0);
  for (int c = 0; c < layout().num_points(); ++c) {
    const double b = scheme_->rule.weights[at(c % scheme_->degree)];
    const double share = b * mesh().length(c / scheme_->degree);
    for (int i = 0; i < layout().num_states(); ++i) {
      weights_[at(layout().state(c + 1, X) + i)] = share;
      if (c == 0) weights_[at(i)] = share;
      weights_[at(num_variables() + layout().defect(c, X) + i)] = b;
    }
    weights_[at(layout().control(c))] = b;
    for (int i = 0; i < layout().num_limits(); ++i) {
      weights_[at(num_variables() + layout().limit(c, i))] = share;
    }
  }
}

void LimitedTime::change(std::vector<PathInequality> limits, Mesh mesh,
                         const LimitedEnds& ends) {
  body_.change_limits(std::move(limits));
  ends_ = ends;
  change_lengths(std::move(mesh));
  fix_start();
  weigh();
  bound_limits();
}

void LimitedTime::bound_slopes(double steepest) {
  for (int node = 0; node < layout().num_nodes(); ++node) {
    const int beta = layout().state(node, Beta);
    if (!variable_range(beta).single()) bound(beta, -steepest, steepest);
  }
}

void LimitedTime::bound_limits() {
  const auto bound = [&](int row, const PathInequality& limit,
                         nlp::Held where) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    double lower = limit.lower;
    double upper = limit.upper;
    if (held_) {
      const double value = where == nlp::Held::AtLower ? lower : upper;
      lower = where == nlp::Held::No ? -kInfinity : value;
      upper = where == nlp::Held::No ? kInfinity : value;
    }
    row_lower_[at(row)] = lower;
    row_upper_[at(row)] = upper;
  };
  for (int i = 0; i < layout().num_limits(); ++i) {
    for (int c = 0; c < layout().num_points(); ++c) {
      bound(layout().limit(c, i), limits()[at(i)],
            held_ ? held_at(c, i) : nlp::Held::No);
    }
    // The place of the last point is given: its limit would say so again.
    if (!free_contacts() && is_of_place(limits_on_[at(i)])) {
      constexpr double kInfinity = std::numeric_limits<double>::infinity();
      const auto row = at(layout().limit(layout().num_points() - 1, i));
      row_lower_[row] = -kInfinity;
      row_upper_[row] = kInfinity;
    }
    if (i < layout().num_start_rows()) {
      bound(layout().start_row(i), limits()[at(i)],
            held_ ? held_->at_rest[at(i)] : nlp::Held::No);
    }
  }
}

math::Jet2<double, 1> LimitedTime::at_rest(int limit, double beta) const {
  using Start = math::Jet2<double, 1>;
  return value_of(limits()[at(limit)], scene(),
                  resting(Start::variable(beta, 0)));
}

math::Jet2<double, 1> LimitedTime::push_at(double beta) const {
  return pushed_w(scene(), math::Jet2<double, 1>::variable(beta, 0));
}

void LimitedTime::fix_start() {
  const Body& body = scene().body;
  if (layout().has_theta()) fix(layout().state(0, Theta), body.theta_m);
  if (free_contacts()) {
    if (!pushed()) fix(layout().state(0, W), 0.0);
    return;
  }
  const double start = ends_.start.value_or(start_angle(scene()));
  const brachisto::Point centre =
      scene().contact == Contact::Centre
          ? brachisto::Point{}
          : centre_above({0.0, 0.0}, body.radius, start);
  fix(layout().state(0, X), centre.x);
  fix(layout().state(0, Z), centre.z);
  fix(layout().state(0, W), pushed() ? push_at(start).value : 0.0);
  if (ends_.start_slope_fixed) {
    fix(layout().state(0, Beta), start);
  } else {
    release(layout().state(0, Beta));
  }
  set_end_angle(ends_.phi);
  if (scene().contact == Contact::EndSlope) {
    fix(layout().state(layout().num_points(), Beta), ends_.phi);
  }
}

nlp::Held LimitedTime::held_at(int point, int limit) const {
  const int element = point / mesh().degree;
  const auto& held = held_->in_element;
  const nlp::Held here = held[at(element)][at(limit)];
  const bool last = point % mesh().degree == mesh().degree - 1;
  if (last && at(element) < held_->at_end.size() &&
      !held_->at_end[at(element)].empty()) {
    const nlp::Held touched = held_->at_end[at(element)][at(limit)];
    if (touched != nlp::Held::No) return touched;
  }
  if (here != nlp::Held::No || !last || limits()[at(limit)].bounds_control() ||
      element + 1 == mesh().num_elements()) {
    return here;
  }
  return held[at(element + 1)][at(limit)];
}

int LimitedTime::local(int point, int number) const {
  return number == kControl ? layout().control(point)
                            : layout().state(point + 1, kStates.at(at(number)));
}

const LimitedTime::Jet& LimitedTime::limit_at(int point, int number) const {
  return limit_values_[at(point) * body_.num_limits() + at(number)];
}

nlp::ChainStructure LimitedTime::chain_structure() const {
  nlp::ChainStructure chain = Transcription::chain_structure();
  const int p = mesh().degree;
  for (int c = 0; c < layout().num_points(); ++c) {
    const int element = c / p;
    const bool last = c % p == p - 1;
    const int block = last ? 2 * (element + 1) : 2 * element + 1;
    if (last) chain.block[at(layout().control(c))] = block;
    for (int i = 0; i < layout().num_limits(); ++i) {
      chain.block[at(num_variables() + layout().limit(c, i))] = block;
    }
  }
  for (int i = 0; i < layout().num_contact_rows(); ++i) {
    chain.block[at(num_variables() + layout().contact_row(i))] =
        is_at_A(i) ? 0 : 2 * mesh().num_elements();
  }
  for (int i = 0; i < layout().num_start_rows(); ++i) {
    chain.block[at(num_variables() + layout().start_row(i))] = 0;
  }
  // The Hessian by states and controls is of the order of h, as an integral
  // over the element, the Jacobian of order one: both are with √h between them.
  chain.scale.assign(chain.block.size(), 1.0);
  const auto root_of = [&](int element) {
    return std::exp2(std::round(0.5 * std::log2(mesh().length(element))));
  };
  for (int c = 0; c < layout().num_points(); ++c) {
    const double root = root_of(c / p);
    for (int i = 0; i < layout().num_states(); ++i) {
      chain.scale[at(layout().state(c + 1, X) + i)] = 1.0 / root;
      if (c == 0) chain.scale[at(i)] = 1.0 / root;
      chain.scale[at(num_variables() + layout().defect(c, X) + i)] = root;
    }
    chain.scale[at(layout().control(c))] = 1.0 / root;
    for (int i = 0; i < layout().num_limits(); ++i) {
      // By the unknown h q of the control a limit has a derivative like 1/h.
      chain.scale[at(num_variables() + layout().limit(c, i))] =
          limits()[at(i)].bounds_control() ? root * root * root : root;
    }
  }
  for (int i = 0; i < layout().num_contact_rows(); ++i) {
    chain.scale[at(num_variables() + layout().contact_row(i))] =
        root_of(is_at_A(i) ? 0 : mesh().num_elements() - 1);
  }
  for (int i = 0; i < layout().num_start_rows(); ++i) {
    chain.scale[at(num_variables() + layout().start_row(i))] = root_of(0);
  }
  return chain;
}

std::optional<Transcription::End> LimitedTime::end(
    std::span<const double> x, std::span<const double> lambda) {
  const int last = layout().num_points();
  End out;
  out.state.w = x[at(layout().state(last, W))];
  out.by_x.push_back({layout().state(last, W), 0.0, 1.0, 0.0, 0.0});
  if (layout().has_theta()) {
    out.state.theta = x[at(layout().state(last, Theta))];
    out.by_x.push_back({layout().state(last, Theta), 1.0, 0.0, 0.0, 0.0});
  }
  out.p = end_costates(lambda);
  const int p = mesh().degree;
  for (int j = 0; j < p; ++j) {
    const double D = scheme_->derivative(j, p);
    out.by_lambda.push_back(
        {layout().defect(last - p + j, X), 0.0, 0.0, -D, 0.0});
    out.by_lambda.push_back(
        {layout().defect(last - p + j, Z), 0.0, 0.0, 0.0, -D});
  }
  out.last_slope = x[at(layout().state(last, Beta))];
  return out;
}

Costates LimitedTime::end_costates(std::span<const double> lambda) const {
  const int p = mesh().degree;
  const int first = layout().num_points() - p;
  Costates out;
  for (int j = 0; j < p; ++j) {
    const double D = scheme_->derivative(j, p);
    out.p_x -= D * lambda[at(layout().defect(first + j, X))];
    out.p_z -= D * lambda[at(layout().defect(first + j, Z))];
  }
  return out;
}

Costates LimitedTime::start_costates(std::span<const double> lambda) const {
  Costates out;
  for (int j = 0; j < mesh().degree; ++j) {
    const double D = scheme_->derivative(j, 0);
    out.p_x += D * lambda[at(layout().defect(j, X))];
    out.p_z += D * lambda[at(layout().defect(j, Z))];
    out.p_w += D * lambda[at(layout().defect(j, W))];
  }
  return out;
}

bool LimitedTime::evaluate() {
  if (!(x(layout().rolling_time()) > 0.0)) {
    return refuse(-1, "the rolling time U is not positive");
  }
  for (int c = 0; c < layout().num_points(); ++c) {
    check_stop(c);
    std::array<Jet, kLocals> yu;
    for (int i = 0; i < kLocals; ++i) {
      yu[at(i)] = has_local(i) ? Jet::variable(x(local(c, i)), i) : Jet(0.0);
    }
    yu[kControl] = yu[kControl] * Jet(1.0 / mesh().length(c / mesh().degree));
    if (!(yu[rolling::kW].value > 0.0)) {
      return refuse(c, "the speed w is not positive");
    }
    if (!std::isfinite(std::cos(yu[rolling::kBeta].value))) {
      return refuse(c, "the slope angle is not finite");
    }
    points_[at(c)] = body_.rates(yu);
    if (!(points_[at(c)].cost.value > 0.0)) {
      return refuse(c, "the inertia factor A is not positive");
    }
    // What is neither held nor an inequality is not asked for. Forces once for
    // all limits that bound them.
    const auto [x_c, z_c, theta, w, beta, q] = yu;
    const TurningPoint<Jet> place{x_c, z_c, theta, w, beta, q};
    ContactForce<Jet> force;
    bool known = false;
    for (int i = 0; i < layout().num_limits(); ++i) {
      const bool asked = !held_ || held_at(c, i) != nlp::Held::No;
      if (asked && limits()[at(i)].bounds_force() && !known) {
        force = contact_force(scene(), place);
        known = true;
      }
      limit_values_[at(c) * body_.num_limits() + at(i)] =
          asked ? value_of(limits()[at(i)], force, place) : Jet(0.0);
    }
  }
  return true;
}

double LimitedTime::do_eval_f() const {
  double sum = 0.0;
  for (int e = 0; e < mesh().num_elements(); ++e) {
    double element = 0.0;
    for (int j = 0; j < mesh().degree; ++j) {
      element += scheme_->rule.weights[at(j)] *
                 points_[at(e * mesh().degree + j)].cost.value;
    }
    sum += mesh().length(e) * element;
  }
  return x(layout().rolling_time()) * sum;
}

void LimitedTime::do_eval_g(std::span<double> g) const {
  const int p = mesh().degree;
  for (int e = 0; e < mesh().num_elements(); ++e) {
    const double hU = mesh().length(e) * x(layout().rolling_time());
    for (int j = 0; j < p; ++j) {
      const int c = e * p + j;
      for (int s = 0; s < kControl; ++s) {
        if (!has_local(s)) continue;
        const StateComponent component = kStates[at(s)];
        double sum = 0.0;
        for (int n = 0; n <= p; ++n) {
          sum += scheme_->derivative(j, n) *
                 x(layout().state(e * p + n, component));
        }
        g[at(layout().defect(c, component))] =
            sum - hU * points_[at(c)].states[at(s)].value;
      }
      for (int i = 0; i < layout().num_limits(); ++i) {
        g[at(layout().limit(c, i))] = limit_at(c, i).value;
      }
    }
  }
  for (int i = 0; i < layout().num_start_rows(); ++i) {
    g[at(layout().start_row(i))] = at_rest(i, x(layout().state(0, Beta))).value;
  }
  if (!free_contacts()) return;
  const auto put_contact = [&](int row, int node, brachisto::Point contact) {
    const OffContact<double> off =
        off_contact(x(layout().state(node, X)), x(layout().state(node, Z)),
                    scene().body.radius, contact.x, contact.z,
                    x(layout().state(node, Beta)));
    g[at(layout().contact_row(row))] = off.x;
    g[at(layout().contact_row(row + 1))] = off.z;
  };
  put_contact(0, 0, {0.0, 0.0});
  put_contact(2, layout().num_points(), {scene().L, scene().H});
  if (pushed()) {
    g[at(layout().contact_row(4))] =
        x(layout().state(0, W)) - push_at(x(layout().state(0, Beta))).value;
  }
}

}  // namespace brachisto
