// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/limited_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/index.hpp"
#include "math/minima.hpp"
#include "model/field.hpp"
#include "nlp/active_set.hpp"
#include "transcription/held_control.hpp"

namespace brachisto {

namespace {

using enum StateComponent;

}  // namespace

LimitedCurve::LimitedCurve(std::shared_ptr<LimitedTime> problem,
                           PrimalDual point)
    : problem_(std::move(problem)),
      point_(std::make_shared<const PrimalDual>(std::move(point))) {
  for (int e = 0; e < problem_->mesh().num_elements(); ++e) {
    transit_time_ += time_on(e);
  }
  if (problem_->held()) return;
  const nlp::ActiveSet set = nlp::active_set(*problem_, *point_);
  const VariableLayout& layout = problem_->layout();
  for (int c = 0; c < layout.num_points(); ++c) {
    for (int i = 0; i < layout.num_limits(); ++i) {
      held_.push_back(set.constraints[brachisto::at(layout.limit(c, i))]);
    }
  }
  for (int i = 0; i < layout.num_start_rows(); ++i) {
    at_rest_.push_back(set.constraints[brachisto::at(layout.start_row(i))]);
  }
  // At the end multipliers vanish with p_β, whether a limit is active or not.
  const int limits = layout.num_limits();
  for (int i = 0; i < limits; ++i) {
    const auto last = static_cast<int>(held_.size()) - limits + i;
    held_[brachisto::at(last)] = held_[brachisto::at(last - limits)];
  }
}

bool LimitedCurve::active(int point, int limit) const {
  if (problem_->held()) {
    return problem_->constraint_range(problem_->layout().limit(point, limit))
        .single();
  }
  return held(point, limit) != nlp::Held::No;
}

nlp::Held LimitedCurve::held(int point, int limit) const {
  return held_[brachisto::at(point * problem_->layout().num_limits() + limit)];
}

bool LimitedCurve::holds_control(int point) const {
  for (int i = 0; i < problem_->layout().num_limits(); ++i) {
    if (problem_->limits()[brachisto::at(i)].bounds_control() &&
        active(point, i)) {
      return true;
    }
  }
  return false;
}

double LimitedCurve::time_on(int element) const {
  const VariableLayout& layout = problem_->layout();
  const CollocationScheme& scheme = problem_->scheme();
  const Scene& scene = problem_->scene();
  double sum = 0.0;
  for (int j = 0; j < scheme.degree; ++j) {
    const int node = element * scheme.degree + j + 1;
    const double beta = point_->x[brachisto::at(layout.state(node, Beta))];
    const double theta =
        layout.has_theta() ? point_->x[brachisto::at(layout.state(node, Theta))]
                           : 0.0;
    sum += scheme.rule.weights[brachisto::at(j)] *
           root_of_inertia(scene, theta, beta);
  }
  return problem_->mesh().length(element) * rolling_time() * sum;
}

double LimitedCurve::largest_multiplier(int first, int end) const {
  const std::optional<HeldLimits>& held = problem_->held();
  double largest = 0.0;
  for (int e = first; e < end; ++e) {
    for (const double t : problem_->scheme().rule.points) {
      // Where something is touched all multipliers have impulses.
      if (t == 1.0 && held && !held->at_end[brachisto::at(e)].empty()) continue;
      const std::vector<double> multipliers = at(e, t).multipliers;
      for (std::size_t i = 0; i < multipliers.size(); ++i) {
        // What holds at the element's end alone is no function of the path.
        if (held && held->in_element[brachisto::at(e)][i] == nlp::Held::No) {
          continue;
        }
        largest = std::max(largest, std::abs(multipliers[i]));
      }
    }
  }
  return largest;
}

std::vector<double> LimitedCurve::places(int element, int count) const {
  std::vector<double> out = problem_->scheme().rule.points;
  const auto place = [&](int i) { return static_cast<double>(i) / count; };
  for (int i = 0; i <= count; ++i) out.push_back(place(i));
  std::vector<Point> centres;
  for (const PathInequality& limit : problem_->limits()) {
    if (limit.kind != PathInequality::Kind::Disc) continue;
    for (int i = 0; centres.size() <= brachisto::at(count); ++i) {
      const TurningPoint<double> here = state_at(element, place(i));
      centres.push_back({here.x, here.z});
    }
    for (int i = 1; i <= count; ++i) {
      const double share = next_to(centres[brachisto::at(i - 1)],
                                   centres[brachisto::at(i)], limit.place);
      if (share > 0.0 && share < 1.0) {
        out.push_back(place(i) - (1.0 - share) / count);
      }
    }
  }
  std::ranges::sort(out);
  // The element's end is one of both kinds.
  const auto doubled = std::ranges::unique(out);
  out.erase(doubled.begin(), doubled.end());
  return out;
}

ExcessAt LimitedCurve::excess_on(int element) const {
  constexpr int kPlaces = 20;
  constexpr double kLooked = 1e-9;  // well below what matters
  // What holds from rest on does so there, to what polynomials of states and
  // control differ by next to the points; if it is a limit of curvature q
  // vanishes, and others of curvature hold too.
  std::vector<PathInequality> at_rest;
  if (element == 0 && problem_->held()) {
    const std::vector<nlp::Held>& held = problem_->held()->in_element.front();
    const int control = held_of_control(held, problem_->limits());
    const auto turns = [&](std::size_t i) {
      return problem_->limits()[i].bounds_control() &&
             !problem_->limits()[i].bounds_force();
    };
    const bool turning = control >= 0 && turns(brachisto::at(control));
    at_rest = problem_->limits();
    for (std::size_t i = 0; i < held.size(); ++i) {
      if (held[i] == nlp::Held::No && !(turning && turns(i))) continue;
      at_rest[i].lower = -std::numeric_limits<double>::infinity();
      at_rest[i].upper = std::numeric_limits<double>::infinity();
    }
  }
  ExcessAt worst;
  const auto look = [&](double t) {
    const Excess here =
        worst_excess(t > 0.0 || at_rest.empty() ? problem_->limits() : at_rest,
                     problem_->scene(), state_at(element, t));
    // Written so that a NaN stays.
    if (!(here.value <= worst.value) && !std::isnan(worst.value)) {
      worst = {here, element, t};
    }
    return -here.value;
  };
  std::vector<math::Sample> slack;
  for (const double t : places(element, kPlaces)) {
    if (element == 0 && t == 0.0 && at_rest.empty()) continue;
    slack.push_back({t, look(t)});
  }
  // Between the places too.
  static_cast<void>(math::minima_below(-kLooked, slack, look));
  return worst;
}

ExcessAt LimitedCurve::largest_excess() const {
  ExcessAt worst;
  for (int e = 0; e < problem_->mesh().num_elements(); ++e) {
    check_stop(e);
    const ExcessAt here = excess_on(e);
    if (std::isnan(worst.value)) break;
    if (!(here.value <= worst.value)) worst = here;
  }
  return worst;
}

double LimitedCurve::start_slope() const {
  const TurningPoint<double> start = at(0, 0.0).state;
  if (!problem_->pushed() || holds_control(0)) return start.beta;
  return minimising_slope(problem_->scene(), moving(start),
                          problem_->start_costates(point_->lambda), start.beta);
}

TurningPoint<double> LimitedCurve::state_at(int element, double t) const {
  const VariableLayout& layout = problem_->layout();
  const CollocationScheme& scheme = problem_->scheme();
  const int p = scheme.degree;
  const int first = element * p;
  std::array<double, kLargestDegree + 1> basis;
  const std::span<double> of_nodes(basis.data(), brachisto::at(p + 1));
  scheme.nodes.evaluate(t, of_nodes);
  TurningPoint<double> out{0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  for (int n = 0; n <= p; ++n) {
    const double share = of_nodes[brachisto::at(n)];
    const auto add = [&](StateComponent component, double& sum) {
      sum +=
          share * point_->x[brachisto::at(layout.state(first + n, component))];
    };
    add(X, out.x);
    add(Z, out.z);
    add(W, out.w);
    add(Beta, out.beta);
    if (layout.has_theta()) add(Theta, out.theta);
  }
  const std::span<double> of_points(basis.data(), brachisto::at(p));
  scheme.points.evaluate(t, of_points);
  const double length = problem_->mesh().length(element);
  for (int j = 0; j < p; ++j) {
    out.q += of_points[brachisto::at(j)] *
             point_->x[brachisto::at(layout.control(first + j))] / length;
  }
  return out;
}

LimitedPoint LimitedCurve::at(int element, double t) const {
  const VariableLayout& layout = problem_->layout();
  const CollocationScheme& scheme = problem_->scheme();
  const int p = scheme.degree;
  const int first = element * p;
  std::array<double, kLargestDegree> basis;
  const std::span<double> of_points(basis.data(), brachisto::at(p));
  scheme.points.evaluate(t, of_points);
  const auto costate = [&](StateComponent component) {
    double sum = 0.0;
    for (int j = 0; j < p; ++j) {
      sum -=
          of_points[brachisto::at(j)] *
          point_->lambda[brachisto::at(layout.defect(first + j, component))] /
          scheme.rule.weights[brachisto::at(j)];
    }
    return sum;
  };
  LimitedPoint out;
  out.state = state_at(element, t);
  out.p = {costate(X), costate(Z), 0.0, costate(W)};
  if (layout.has_theta()) out.p.p_theta = costate(Theta);
  out.p_beta = costate(Beta);
  const double hU = problem_->mesh().length(element) * rolling_time();
  out.multipliers.assign(brachisto::at(layout.num_limits()), 0.0);
  for (int j = 0; j < p; ++j) {
    for (int i = 0; i < layout.num_limits(); ++i) {
      out.multipliers[brachisto::at(i)] +=
          of_points[brachisto::at(j)] *
          point_->lambda[brachisto::at(layout.limit(first + j, i))] /
          (hU * scheme.rule.weights[brachisto::at(j)]);
    }
  }
  return out;
}

LimitedPoint LimitedCurve::at(double sigma) const {
  const auto [element, t] = problem_->mesh().locate(sigma);
  return at(element, t);
}

PrimalDual sample_at_mesh(
    const LimitedTime& problem, double rolling_time,
    const std::function<LimitedPoint(Mesh::Place)>& path) {
  const VariableLayout& layout = problem.layout();
  const CollocationScheme& scheme = problem.scheme();
  PrimalDual out;
  out.x.assign(at(problem.num_variables()), 0.0);
  out.lambda.assign(at(problem.num_constraints()), 0.0);
  const auto put = [&](int node, const TurningPoint<double>& state) {
    out.x[at(layout.state(node, X))] = state.x;
    out.x[at(layout.state(node, Z))] = state.z;
    if (layout.has_theta()) out.x[at(layout.state(node, Theta))] = state.theta;
    out.x[at(layout.state(node, W))] = state.w;
    out.x[at(layout.state(node, Beta))] = state.beta;
  };
  put(0, path({0, 0.0}).state);
  for (int c = 0; c < layout.num_points(); ++c) {
    const int e = c / scheme.degree;
    const auto j = at(c % scheme.degree);
    const double h = problem.mesh().length(e);
    const double b = scheme.rule.weights[j];
    const LimitedPoint point = path({e, scheme.rule.points[j]});
    put(c + 1, point.state);
    out.x[at(layout.control(c))] = h * point.state.q;
    out.lambda[at(layout.defect(c, X))] = -b * point.p.p_x;
    out.lambda[at(layout.defect(c, Z))] = -b * point.p.p_z;
    if (layout.has_theta()) {
      out.lambda[at(layout.defect(c, Theta))] = -b * point.p.p_theta;
    }
    out.lambda[at(layout.defect(c, W))] = -b * point.p.p_w;
    out.lambda[at(layout.defect(c, Beta))] = -b * point.p_beta;
    for (int i = 0; i < layout.num_limits(); ++i) {
      const double mu = h * rolling_time * b * point.multipliers[at(i)];
      const int row = layout.limit(c, i);
      const nlp::Range range = problem.constraint_range(row);
      out.lambda[at(row)] =
          std::isfinite(mu < 0.0 ? range.lower : range.upper) ? mu : 0.0;
    }
  }
  out.x[at(layout.last())] = rolling_time;
  return out;
}

PrimalDual sample_at_mesh(
    const LimitedTime& problem, double rolling_time,
    const std::function<LimitedPoint(double sigma)>& path) {
  return sample_at_mesh(problem, rolling_time, [&](Mesh::Place place) {
    return path(problem.mesh().sigma(place.element, place.t));
  });
}

PrimalDual prolong(const LimitedCurve& curve, const LimitedTime& problem) {
  PrimalDual out =
      sample_at_mesh(problem, curve.rolling_time(),
                     [&](double sigma) { return curve.at(sigma); });
  const VariableLayout& layout = problem.layout();
  const VariableLayout& old = curve.problem().layout();
  const auto keep = [&](int row, int old_row) {
    out.lambda[at(row)] = curve.point().lambda[at(old_row)];
  };
  if (problem.free_contacts() && curve.problem().free_contacts()) {
    for (int i = 0; i < layout.num_contact_rows(); ++i) {
      keep(layout.contact_row(i), old.contact_row(i));
    }
  }
  if (layout.num_start_rows() == old.num_start_rows()) {
    for (int i = 0; i < layout.num_start_rows(); ++i) {
      keep(layout.start_row(i), old.start_row(i));
    }
  }
  return out;
}

bool alike(const LimitedCurve& a, const LimitedCurve& b) {
  constexpr int kPlaces = 64;
  constexpr double kApart = 3e-3;  // in natural units, L or H being 1
  for (int i = 1; i <= kPlaces; ++i) {
    const double sigma = static_cast<double>(i) / kPlaces;
    const TurningPoint<double> p = a.at(sigma).state, q = b.at(sigma).state;
    if (distance({p.x, p.z}, {q.x, q.z}) > kApart) return false;
  }
  return true;
}

}  // namespace brachisto
