// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/path_system.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "brachisto/math/index.hpp"
#include "brachisto/nlp/problem.hpp"
#include "refinement/open_conditions.hpp"
#include "transcription/held_control.hpp"

namespace brachisto {

namespace {

LimitedTime problem_with(const Scene& scene, const PathSetting& setting,
                         int degree) {
  return {scene, setting.limits, mesh_of(setting.arcs, degree), setting.ends,
          held_limits(setting.arcs, setting.ends.corner)};
}

void change(LimitedTime& problem, const PathSetting& setting) {
  problem.change(setting.limits, mesh_of(setting.arcs, problem.mesh().degree),
                 setting.ends);
}

/// Of x at B, which leads there: the last one of the constraints.
double end_defect_of_x(const LimitedCurve& curve) {
  const LimitedTime& problem = curve.problem();
  const VariableLayout& layout = problem.layout();
  const int p = problem.mesh().degree;
  const int first = layout.num_points() - p;
  const int element = problem.mesh().num_elements() - 1;
  double defect = 0.0;
  for (int n = 0; n <= p; ++n) {
    defect += problem.scheme().derivative(p - 1, n) *
              curve.point().x[at(layout.state(first + n, StateComponent::X))];
  }
  const TurningPoint<double> end = curve.state_at(element, 1.0);
  return defect - problem.mesh().length(element) * curve.rolling_time() *
                      (end.w * std::cos(end.beta));
}

}  // namespace

void move_along(PrimalDual& point, std::span<const double> direction,
                double by) {
  std::size_t i = 0;
  for (double& x : point.x) x += by * direction[i++];
  for (double& lambda : point.lambda) lambda += by * direction[i++];
}

PathSystem::PathSystem(const Scene& scene, PathSetting setting, int degree)
    : scene_(scene),
      setting_(std::move(setting)),
      problem_(std::make_shared<LimitedTime>(
          problem_with(scene, setting_, degree))) {
  // Rounding may hide that the chain is singular.
  const bool all_held = !problem_->free_contacts() &&
                        std::ranges::none_of(setting_.arcs, [](const Arc& arc) {
                          return is_free(arc.held);
                        });
  release(all_held ? with_end() : touched_rows(setting_.arcs, *problem_));
}

std::vector<int> PathSystem::with_end() const {
  const VariableLayout& layout = problem_->layout();
  std::vector<int> rows = touched_rows(setting_.arcs, *problem_);
  rows.push_back(layout.defect(layout.num_points() - 1, StateComponent::X));
  return rows;
}

void PathSystem::release(std::vector<int> rows) {
  released_ = std::move(rows);
  nlp::ActiveSet active = nlp::equations_only(*problem_);
  for (const int row : released_) {
    active.constraints[at(row)] = nlp::Held::No;
  }
  system_ = std::make_unique<KktSystem>(*problem_, nullptr, std::move(active));
  chain_ = BorderedChain::make(*system_);
}

LimitedCurve PathSystem::take_curve() && {
  chain_.reset();
  system_.reset();
  moved_.reset();
  return {*problem_, std::move(point_)};
}

double PathSystem::residual() const {
  const std::span<const double> all = system_->residual();
  const int n = problem_->num_variables();
  double worst = 0.0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const int row = static_cast<int>(i) - n;
    if (!(std::abs(all[i]) <= worst) &&
        std::ranges::find(released_, row) == released_.end()) {
      worst = std::abs(all[i]);
    }
    if (std::isnan(worst)) break;
  }
  return worst;
}

double PathSystem::rounding() const {
  std::vector<double> sums(at(problem_->num_constraints()), 0.0);
  const std::span<const double> values = system_->jac_g();
  problem_->jac_g_pattern().for_each([&](std::size_t k, int row, int column) {
    if (!problem_->constraint_range(row).single()) return;
    sums[at(row)] += std::abs(values[k] * point_.x[at(column)]);
  });
  return std::numeric_limits<double>::epsilon() * std::ranges::max(sums);
}

double PathSystem::cost_of_residuals() {
  const Elsewhere here = evaluated(setting_);
  return std::abs(here.lagrangian - problem_->eval_f());
}

Eigen::VectorXd PathSystem::open_at(LimitedCurve there,
                                    const PathSetting& setting) const {
  Eigen::VectorXd open = open_conditions(there, setting.arcs, setting.ends);
  if (released_.empty()) return open;
  Eigen::Index next = open.size();
  open.conservativeResize(next + static_cast<Eigen::Index>(released_.size()));
  const LimitedTime& problem = there.problem();
  int element = 0;
  for (const Arc& arc : setting.arcs) {
    element += arc.elements();
    if (!arc.touch) continue;
    const PathInequality& limit = problem.limits()[arc.touch->limit];
    open[next++] =
        value_of(limit, problem.scene(), there.state_at(element - 1, 1.0)) -
        bound_of(limit, arc.touch->at);
  }
  if (next < open.size()) open[next] = end_defect_of_x(there);
  return open;
}

bool PathSystem::move_to(PathSetting setting, PrimalDual point) {
  setting_ = std::move(setting);
  point_ = std::move(point);
  change(*problem_, setting_);
  return evaluate();
}

/// At setting and point.
bool PathSystem::evaluate() {
  if (!system_->evaluate(point_.x, point_.lambda, 0.0)) return false;
  open_ = open_at({problem_, point_}, setting_);
  return true;
}

bool PathSystem::linearise() {
  system_->evaluate_jacobian();
  // Arcs may have become a thousandth as long.
  if (chain_) chain_->rescale();
  if (chain_ && chain_->factorise()) return true;
  // A condition on where the path ends, where nothing else gives way.
  std::vector<int> rows = with_end();
  if (rows.size() == released_.size()) return false;
  release(std::move(rows));
  if (!chain_ || !evaluate()) return false;
  system_->evaluate_jacobian();
  return chain_->factorise();
}

std::shared_ptr<LimitedTime> PathSystem::problem_of(
    const PathSetting& changed) {
  if (&changed == &setting_) return problem_;
  if (changed.scene) {
    return std::make_shared<LimitedTime>(
        problem_with(*changed.scene, changed, problem_->mesh().degree));
  }
  if (!moved_) moved_ = std::make_shared<LimitedTime>(*problem_);
  change(*moved_, changed);
  return moved_;
}

PrimalDual PathSystem::turned(PrimalDual point,
                              const PathSetting& changed) const {
  const VariableLayout& layout = problem_->layout();
  if (!changed.scene || !layout.has_theta()) return point;
  const double turn = changed.scene->body.theta_m - scene_.body.theta_m;
  for (int node = 0; node < layout.num_nodes(); ++node) {
    point.x[at(layout.state(node, StateComponent::Theta))] += turn;
  }
  return point;
}

PathRates PathSystem::along(std::span<const double> rhs,
                            const PathSetting& less, const PathSetting& more,
                            double width, RatesOf asked, double enough) {
  PathRates rates{std::vector<double>(rhs.size()), open_};
  const bool solved =
      (asked == RatesOf::Point ? chain_->solve_alike(rhs, rates.point, enough)
                               : chain_->solve(rhs, rates.point, enough)) &&
      std::ranges::all_of(rates.point,
                          [](double value) { return std::isfinite(value); });
  if (!solved) {
    rates.time = std::nan("");
    rates.open.setConstant(std::nan(""));
    return rates;
  }
  rates.open.setZero();
  const auto follow = [&](const PathSetting& changed, double by) {
    PrimalDual point{point_.x, point_.lambda};
    move_along(point, rates.point, by);
    point = turned(std::move(point), changed);
    const std::shared_ptr<LimitedTime> problem = problem_of(changed);
    // Next to a singular chain the way there is long: no path moves backwards.
    bool moves = point.x[at(problem->layout().last())] > 0.0;
    for (int node = 0; node < problem->layout().num_nodes(); ++node) {
      moves =
          moves &&
          point.x[at(problem->layout().state(node, StateComponent::W))] >= 0.0;
    }
    if (!moves) {
      rates.time = std::nan("");
      rates.open.setConstant(std::nan(""));
      return;
    }
    const LimitedCurve there(problem, std::move(point));
    const double sign = by < 0.0 ? -1.0 : 1.0;
    if (asked == RatesOf::Time) rates.time += sign * there.transit_time();
    rates.open += sign * open_at(there, changed);
  };
  follow(less, -0.5 * width);
  follow(more, 0.5 * width);
  rates.open /= width;
  rates.time /= width;
  if (asked == RatesOf::Time) rates.point = std::vector<double>();
  return rates;
}

PathRates PathSystem::newton(double enough) {
  constexpr double kStep = 1e-6;
  std::vector<double> rhs(system_->residual().begin(),
                          system_->residual().end());
  for (const int row : released_)
    rhs[at(problem_->num_variables() + row)] = 0.0;
  double largest = kStep;
  for (double& value : rhs) {
    value = -value;
    largest = std::max(largest, std::abs(value));
  }
  return along(rhs, setting_, setting_, 2.0 * kStep / largest, RatesOf::Point,
               enough);
}

std::vector<PathRates> PathSystem::to_unknowns(RatesOf asked) {
  constexpr double kStep = 1e-6, kShare = 1e-3;
  std::vector<PathRates> rates;
  std::vector<double> rhs;
  const auto add = [&](double step, auto&& move) {
    PathSetting less = setting_, more = setting_;
    move(less, -step);
    move(more, step);
    rates.push_back(along(rhs, less, more, 2.0 * step, asked));
  };
  double begin = 0.0;
  int element = 0;
  for (std::size_t i = 0; i + 1 < setting_.arcs.size(); ++i) {
    // All elements of the arc before a junction grow, those behind it shrink.
    const double end = setting_.arcs[i].end;
    const double before = end - begin;
    const double after = setting_.arcs[i + 1].end - end;
    rhs.assign(at(system_->size()), 0.0);
    const auto stretch = [&](int first, int count, double by) {
      for (int e = first; e < first + count; ++e) {
        problem_->add_rates_by_length(e, -by * problem_->mesh().length(e),
                                      point_.lambda, rhs);
      }
    };
    stretch(element, setting_.arcs[i].elements(), 1.0 / before);
    element += setting_.arcs[i].elements();
    stretch(element, setting_.arcs[i + 1].elements(), -1.0 / after);
    for (int k = 0; k < system_->size(); ++k) {
      if (system_->given(k)) rhs[at(k)] = 0.0;
    }
    add(std::min(kStep, kShare * std::min(before, after)),
        [i](PathSetting& moved, double by) { moved.arcs[i].end += by; });
    begin = end;
  }
  // The centre turns about the contact, if it is that that is given.
  const auto turn = [&](int node, double slope) {
    rhs.assign(at(system_->size()), 0.0);
    if (scene_.contact == Contact::Centre) return;
    const VariableLayout& layout = problem_->layout();
    const double r = scene_.body.radius;
    rhs[at(layout.state(node, StateComponent::X))] = r * std::cos(slope);
    rhs[at(layout.state(node, StateComponent::Z))] = r * std::sin(slope);
  };
  if (end_is_sought(scene_)) {
    turn(problem_->layout().num_points(), setting_.ends.phi);
    add(kStep, [](PathSetting& moved, double by) { moved.ends.phi += by; });
  }
  if (start_is_sought(scene_, setting_.ends)) {
    const double slope = *setting_.ends.start;
    turn(0, slope);
    const VariableLayout& layout = problem_->layout();
    if (problem_->pushed()) {
      rhs[at(layout.state(0, StateComponent::W))] =
          pushed_w(problem_->scene(), math::Jet2<double, 1>::variable(slope, 0))
              .gradient[0];
    }
    if (setting_.ends.start_slope_fixed) {
      rhs[at(layout.state(0, StateComponent::Beta))] = 1.0;
    }
    add(kStep, [](PathSetting& moved, double by) { *moved.ends.start += by; });
  }
  for (const int row : released_) {
    rhs.assign(at(system_->size()), 0.0);
    rhs[at(problem_->num_variables() + row)] = 1.0;
    add(kStep, [](PathSetting&, double) {});
  }
  return rates;
}

/// Leaves the system there, unless the scene is another.
PathSystem::Elsewhere PathSystem::evaluated(const PathSetting& changed) {
  const auto of = [&](LimitedTime& problem, KktSystem& system) {
    const PrimalDual point = turned(point_, changed);
    if (!system.evaluate(point.x, point.lambda, 0.0)) {
      return Elsewhere{std::vector<double>(at(system.size()), std::nan("")),
                       std::nan("")};
    }
    std::vector<double> g(point.lambda.size());
    problem.eval_g(g);
    long double sum = problem.eval_f();
    for (std::size_t i = 0; i < g.size(); ++i) {
      const nlp::Range range = problem.constraint_range(static_cast<int>(i));
      if (!range.single()) continue;
      sum += static_cast<long double>(point.lambda[i]) * (g[i] - range.lower);
    }
    return Elsewhere{{system.residual().begin(), system.residual().end()},
                     static_cast<double>(sum)};
  };
  if (changed.scene) {
    LimitedTime problem =
        problem_with(*changed.scene, changed, problem_->mesh().degree);
    KktSystem other(problem, nullptr, system_->active());
    return of(problem, other);
  }
  change(*problem_, changed);
  return of(*problem_, *system_);
}

PathRates PathSystem::to(const PathSetting& less, const PathSetting& more,
                         double width, double& lagrangian) {
  Elsewhere low = evaluated(less);
  {
    const Elsewhere high = evaluated(more);
    lagrangian = (high.lagrangian - low.lagrangian) / width;
    for (std::size_t i = 0; i < low.residual.size(); ++i) {
      low.residual[i] = (low.residual[i] - high.residual[i]) / width;
    }
  }
  change(*problem_, setting_);
  // Where it was before it is not refused.
  static_cast<void>(system_->evaluate(point_.x, point_.lambda, 0.0));
  return along(low.residual, less, more, width, RatesOf::Time);
}

double PathSystem::of_fixed(const PathSetting& changed) {
  if (!problem_->set_point(point_.x)) return std::nan("");
  const std::vector<long double> pull =
      nlp::lagrangian_gradient(*problem_, point_.lambda);
  const std::shared_ptr<LimitedTime> problem = problem_of(changed);
  const PrimalDual point = turned(point_, changed);
  long double sum = 0.0L;
  for (int i = 0; i < problem->num_variables(); ++i) {
    const nlp::Range range = problem->variable_range(i);
    if (range.single()) sum += pull[at(i)] * (range.lower - point.x[at(i)]);
  }
  return static_cast<double>(sum);
}

}  // namespace brachisto
