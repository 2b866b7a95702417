// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/limited_time.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/index.hpp"
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

}  // namespace

LimitedTime::LimitedTime(const Scene& scene, std::vector<PathInequality> limits,
                         Mesh mesh, const LimitedEnds& ends,
                         std::optional<HeldLimits> held)
    : CollocatedTime(
          scene, mesh,
          VariableLayout::with_limits(
              mesh.num_points(), scene.body.off_centred(),
              static_cast<int>(limits.size()), num_contact_rows(scene, ends),
              num_start_rows(scene, limits, ends)),
          [&](const ocp::Layout& on) {
            return ocp::Collocation<rolling::Turning>(
                {scene, std::move(limits),
                 scene.body.rolls() ? 1.0 / scene.body.radius : 1.0},
                radau_scheme(mesh.degree), on);
          }),
      ends_(ends),
      held_(std::move(held)) {
  fix_ends();
  build_patterns();
}

void LimitedTime::change(std::vector<PathInequality> limits, Mesh mesh,
                         const LimitedEnds& ends) {
  rolling::Turning changed = body();
  changed.change_limits(std::move(limits));
  std::get<0>(collocation_).describe(std::move(changed));
  ends_ = ends;
  change_lengths(std::move(mesh));
  fix_ends();
}

nlp::Range LimitedTime::variable_range(int index) const {
  const nlp::Range given = CollocatedTime::variable_range(index);
  const bool is_slope = index != layout().last() &&
                        index % layout().stride() == layout().state(0, Beta);
  if (given.single() || !is_slope) return given;
  return {-steepest_, steepest_};
}

nlp::Range LimitedTime::constraint_range(int index) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr nlp::Range kAny{-kInfinity, kInfinity};
  const bool at_rest = index >= layout().end_of_points();
  const int i =
      at_rest ? index - layout().start_row(0) : layout().limit_of(index);
  if (i < 0) return {};
  const int c = layout().point_of(index);
  // The place of the last point is given: its limit would say so again.
  if (!free_contacts() && c == layout().num_points() - 1 &&
      collocation().limit_is_of(i, {rolling::kX, rolling::kZ})) {
    return kAny;
  }
  const double margin = at_rest ? 0.0 : this->margin(c, i);
  const PathInequality& limit = limits()[at(i)];
  const nlp::Range range{limit.lower + margin, limit.upper - margin};
  if (!held_) return range;
  const nlp::Held here = at_rest ? held_->at_rest[at(i)] : held_at(c, i);
  if (here == nlp::Held::No) return kAny;
  const double value = nlp::held_value(range, here);
  return {value, value};
}

double LimitedTime::margin(int point, int limit) const {
  if (margins_.empty()) return 0.0;
  const int e = point / mesh().degree;
  const double from_A =
      e > 0 ? 1.0 : scheme().rule.points[at(point % mesh().degree)];
  return from_A * margins_[at(e)][at(limit)];
}

void LimitedTime::fix_ends() {
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
  fix(layout().state(0, W), pushed() ? pushed_w(scene(), start) : 0.0);
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

nlp::ChainStructure LimitedTime::chain_structure() const {
  nlp::ChainStructure chain = ocp::element_chain(
      layout(), mesh(), num_constraints(), collocation().limits_of_control());
  const int last = mesh().num_elements() - 1;
  for (int i = 0; i < num_end_rows(); ++i) {
    const auto row = at(num_variables() + layout().contact_row(i));
    chain.block[row] = is_at_start(i) ? 0 : 2 * (last + 1);
    chain.scale[row] = ocp::root_of_length(mesh(), is_at_start(i) ? 0 : last);
  }
  return chain;
}

std::optional<Transcription::End> LimitedTime::end(
    std::span<const double> x, std::span<const double> lambda) {
  const int last = layout().num_points();
  End out = end_of_states(x);
  out.p = end_costates(lambda);
  const int p = mesh().degree;
  for (int j = 0; j < p; ++j) {
    const double D = scheme().derivative(j, p);
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
    const double D = scheme().derivative(j, p);
    out.p_x -= D * lambda[at(layout().defect(first + j, X))];
    out.p_z -= D * lambda[at(layout().defect(first + j, Z))];
  }
  return out;
}

Costates LimitedTime::start_costates(std::span<const double> lambda) const {
  Costates out;
  for (int j = 0; j < mesh().degree; ++j) {
    const double D = scheme().derivative(j, 0);
    out.p_x += D * lambda[at(layout().defect(j, X))];
    out.p_z += D * lambda[at(layout().defect(j, Z))];
    out.p_w += D * lambda[at(layout().defect(j, W))];
  }
  return out;
}

template <class With>
void LimitedTime::each_end_row(With&& with) const {
  using On = math::Dependence<4>;
  const auto variable = [](int i) { return On::variable(i); };
  for (int i = 0; i < num_end_rows(); ++i) {
    const int node = is_at_start(i) ? 0 : layout().num_points();
    const auto jet = [&](int k) {
      return EndJet::variable(x(layout().state(node, kOfEnds[at(k)])), k);
    };
    with(layout().contact_row(i), node,
         at_end_row(i, jet(0), jet(1), jet(2), jet(3)),
         at_end_row(i, variable(0), variable(1), variable(2), variable(3)));
  }
}

void LimitedTime::do_eval_g(std::span<double> g) const {
  CollocatedTime::do_eval_g(g);
  each_end_row([&](int row, int, const EndJet& value, const auto&) {
    g[at(row)] = value.value;
  });
}

void LimitedTime::put_jac_g(Entries& put) const {
  CollocatedTime::put_jac_g(put);
  each_end_row([&](int row, int node, const EndJet& value, const auto& on) {
    for (std::size_t k = 0; k < kOfEnds.size(); ++k) {
      if (on.any[k]) {
        put(row, layout().state(node, kOfEnds[k]), value.gradient[k]);
      }
    }
  });
}

void LimitedTime::put_hess_lag(double objective_factor,
                               std::span<const double> lambda,
                               Entries& put) const {
  CollocatedTime::put_hess_lag(objective_factor, lambda, put);
  constexpr int kSlope = 3;  // nothing else bends them
  each_end_row([&](int row, int node, const EndJet& value, const auto&) {
    const int beta = layout().state(node, Beta);
    put(beta, beta,
        lambda[at(row)] * value.hessian[EndJet::pair(kSlope, kSlope)]);
  });
}

// Of each point, with v = h u the control's unknown,
//
//     ∂L/∂h = U (b L̃ − λ·f̃) − Σ μ ∂c/∂u u/h,   f̃ = f − u ∂f/∂u, L̃ alike.
void LimitedTime::add_rates_by_length(int element, double rate,
                                      std::span<const double> lambda,
                                      std::span<double> out) const {
  using Turning = ocp::Collocation<rolling::Turning>;
  using Jet = Turning::Jet;
  constexpr int kControl = Turning::kControl;
  const Turning& collocation = this->collocation();
  const ocp::Layout& layout = collocation.layout();
  const CollocationScheme& scheme = collocation.scheme();
  const std::span<const double> x = this->x();
  const double h = mesh().length(element), U = rolling_time();
  const int n = layout.num_variables();
  for (int j = 0; j < scheme.degree; ++j) {
    const int c = element * scheme.degree + j;
    const double u = x[at(layout.control(c))] / h;
    const auto [cost, states] = collocation.second(c);
    const auto index = [&](int a) {
      return at(a == kControl ? layout.control(c) : layout.state(c + 1, a));
    };
    // By the unknown of a local one.
    const auto by_unknown = [&](int a) {
      return a == kControl ? 1.0 / h : 1.0;
    };
    // f̃ and its derivatives, a factor standing before it. Of a rate that is the
    // control, f − u ∂f/∂u is 0 without rounding.
    const auto add = [&](const Jet& f, double factor) {
      out[at(layout.last())] +=
          rate * factor * (f.value - u * f.gradient[kControl]);
      for (const int a : collocation.local().by_duration) {
        const double by_a = a == kControl ? 0.0 : f.gradient[at(a)];
        out[index(a)] += rate * U * factor *
                         (by_a - u * f.hessian[Jet::pair(kControl, a)]) *
                         by_unknown(a);
      }
    };
    add(cost, scheme.rule.weights[at(j)]);
    for (std::size_t s = 0; s < Turning::kStates; ++s) {
      if (!layout.has_state(static_cast<int>(s))) continue;
      const int row = layout.defect(c, static_cast<int>(s));
      const Jet& f = states[s];
      add(f, -lambda[at(row)]);
      out[at(n + row)] -= rate * U * (f.value - u * f.gradient[kControl]);
    }
    for (int i = 0; i < layout.num_limits(); ++i) {
      const int row = layout.limit(c, i);
      const auto value = collocation.limit_at(c, i).unpacked<Jet>();
      const double mu = rate * lambda[at(row)];
      out[at(n + row)] -= rate * (u / h) * value.gradient[kControl];
      for (const int a : collocation.local().limits[at(i)].by) {
        out[index(a)] -= mu * (u / h) * value.hessian[Jet::pair(kControl, a)] *
                         by_unknown(a);
      }
      out[index(kControl)] -= mu * value.gradient[kControl] / (h * h);
    }
  }
}

}  // namespace brachisto
