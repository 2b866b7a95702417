// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/tightening.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "brachisto/math/index.hpp"
#include "model/contact.hpp"
#include "model/loaded_fall.hpp"
#include "model/passage.hpp"
#include "nlp/elastic.hpp"
#include "refinement/arc_elements.hpp"
#include "refinement/open_conditions.hpp"
#include "refinement/random_path.hpp"
#include "refinement/turn_meshes.hpp"

namespace brachisto {

namespace {

bool winds(const LimitedCurve& curve) {
  constexpr double kTooSteep = 0.999 * std::numbers::pi;
  const VariableLayout& layout = curve.problem().layout();
  for (int node = 0; node < layout.num_nodes(); ++node) {
    const int beta = layout.state(node, StateComponent::Beta);
    if (std::abs(curve.point().x[at(beta)]) > kTooSteep) return true;
  }
  return false;
}

Mesh coarse_mesh(const Scene& scene, const ExtremalCurve& free,
                 Tightening::Care care) {
  constexpr int kDegree = 4;
  const int elements =
      static_cast<int>(24 + 12 * turns(scene.body, free.arc_length()));
  return uniform_mesh(
      kDegree, care == Tightening::Care::Rough ? elements / 2 : elements);
}

}  // namespace

Tightening::Tightening(const Scene& scene, const ExtremalCurve& free,
                       double phi, const IpoptOptions& ipopt,
                       PassProtocol& protocol, Care care)
    : scene_(scene),
      free_(free),
      relaxation_(scene, free),
      limits_(inequalities(scene.body, scene.limits)),
      care_(care),
      mesh_(coarse_mesh(scene, free, care)),
      ipopt_(ipopt),
      budget_(ipopt.max_iterations),
      protocol_(protocol) {
  first_ends_.free_contacts = scene.contact == Contact::Optimal;
  first_ends_.phi = scene.end_slope.value_or(phi);
  if (scene.world.start_speed > 0.0) first_ends_.start = free.at(0.0).beta;
}

SolverResult Tightening::run(nlp::Problem& problem, const PrimalDual& start,
                             double complementarity, Pass pass) {
  // Solutions are starts.
  constexpr double kTolerance = 1e-8;
  IpoptOptions ipopt =
      of_pass(care_ == Care::Rough ? Pass::Short : pass, ipopt_, problem);
  ipopt.max_iterations = std::min(budget_, ipopt.max_iterations);
  ipopt.tolerance = std::max(ipopt.tolerance, wider() * kTolerance);
  ipopt.complementarity = wider() * complementarity;
  SolverResult result = solve_with_ipopt(problem, start, ipopt);
  budget_ = std::max(0, budget_ - result.iterations);
  protocol_.add(result, problem);
  if (result.status == Status::IterationLimit && budget_ > 0) {
    // Of one of many passes, not of the user.
    result.status = Status::NotConverged;
  }
  return result;
}

/// Takes what was found under limits, if anything was.
bool Tightening::take(const LimitedTime& problem, SolverResult result) {
  protocol_.record.degree = problem.mesh().degree;
  protocol_.record.elements = problem.mesh().num_elements();
  if (result.status != Status::Solved) {
    return protocol_.fail(result.status, std::move(result.message));
  }
  LimitedCurve curve(problem, std::move(result.point));
  if (winds(curve)) {
    return protocol_.fail(Status::NotConverged,
                          "the path that was found has a loop");
  }
  last_.emplace(std::move(curve));
  return true;
}

PrimalDual Tightening::start_of(const LimitedTime& problem) const {
  if (last_) return prolong(*last_, problem);
  if (rough_ && rough_->slopes) return start_on(problem, *rough_);
  if (rough_) {
    return sample_at_mesh(
        problem, rough_->rolling_time, [&](double sigma) -> LimitedPoint {
          return {.state = rough_->at(sigma),
                  .p = free_.at(sigma).p,
                  .multipliers = std::vector<double>(problem.limits().size())};
        });
  }
  return sample_at_mesh(
      problem, free_.rolling_time(), [&](double sigma) -> LimitedPoint {
        return {.state = turning_point(free_, sigma),
                .p = free_.at(sigma).p,
                .multipliers = std::vector<double>(problem.limits().size())};
      });
}

bool Tightening::solve_rigid(const Inequalities& limits, const Mesh& mesh,
                             const LimitedEnds& ends, Pass pass) {
  constexpr double kComplementarity = 1e-11;
  LimitedTime problem(scene_, limits, mesh, ends);
  problem.bound_slopes(std::numbers::pi);
  return take(problem, run(problem, start_of(problem), kComplementarity, pass));
}

std::vector<double> Tightening::give_of_rows(
    const LimitedTime& problem, const std::vector<double>& most) const {
  std::vector<double> give(at(problem.num_constraints()), 0.0);
  const VariableLayout& layout = problem.layout();
  for (int i = 0; i < layout.num_limits(); ++i) {
    // Without it the slopes of Contact::Optimal have no meaning.
    if (scene_.contact == Contact::Optimal &&
        problem.limits()[at(i)].kind == PathInequality::Kind::Hump) {
      continue;
    }
    const auto gives = [&](int row) {
      if (problem.constraint_range(row).bounded()) give[at(row)] = most[at(i)];
    };
    for (int c = 0; c < layout.num_points(); ++c) gives(layout.limit(c, i));
    if (i < layout.num_start_rows()) gives(layout.start_row(i));
  }
  return give;
}

std::vector<double> Tightening::give_of(LimitedTime& problem,
                                        const std::vector<double>& x) const {
  constexpr double kLeast = 0.1;
  const VariableLayout& layout = problem.layout();
  std::vector<double> most(problem.limits().size(), kLeast);
  std::vector<double> g(at(problem.num_constraints()));
  if (!problem.set_point(x)) return std::vector<double>(g.size(), 0.0);
  problem.eval_g(g);
  for (int i = 0; i < layout.num_limits(); ++i) {
    for (int c = 0; c < layout.num_points(); ++c) {
      const int row = layout.limit(c, i);
      const nlp::Range range = problem.constraint_range(row);
      most[at(i)] = std::max(
          {most[at(i)], range.lower - g[at(row)], g[at(row)] - range.upper});
    }
  }
  return give_of_rows(problem, most);
}

bool Tightening::solve_elastic(const LimitedEnds& ends, double price) {
  constexpr double kComplementarity = 1e-9;
  LimitedTime problem(scene_, limits_, mesh_, ends);
  problem.bound_slopes(std::numbers::pi);
  PrimalDual start = start_of(problem);
  if (give_.size() != at(problem.num_constraints())) {
    give_ = give_of(problem, start.x);
  }
  nlp::Elastic elastic(problem, give_, price);
  SolverResult result =
      run(elastic, elastic.with_elasticity(std::move(start), given_way_),
          kComplementarity, Pass::Long);
  const double given_way = result.point.x.empty() ? 0.0 : result.point.x.back();
  if (result.status == Status::Solved) {
    result.point = elastic.without_elasticity(std::move(result.point));
  }
  if (!take(problem, std::move(result))) return false;
  given_way_ = given_way;
  return true;
}

LimitedEnds Tightening::known_ends() const {
  if (last_) return last_->problem().ends();
  LimitedEnds ends = first_ends_;
  if (rough_ && rough_->slopes) {
    ends.phi = scene_.end_slope.value_or(rough_->slopes->at_B);
    ends.start = rough_->slopes->at_A;
  }
  return ends;
}

std::optional<LimitedEnds> Tightening::next_ends(const Inequalities& limits) {
  LimitedEnds ends = known_ends();
  ends.corner.reset();
  if (ends.free_contacts) return ends;
  if (end_is_sought(scene_) && last_ && !end_held_) {
    ends.phi = end_slope(*last_);
  }
  if (last_) ends.start = last_->start_slope();
  return with_start(ends, scene_, limits, last_ && last_->holds_control(0));
}

bool Tightening::is_shut() {
  if (!shut_) {
    const bool open = way_is_open(scene_, limits_);
    shut_ = !open || !comes_down(scene_, limits_);
    if (*shut_) {
      protocol_.fail(Status::NoAdmissiblePath,
                     std::string(open ? kTooFast : kNoWay));
    }
  }
  return *shut_;
}

bool Tightening::none_at_rest() {
  return protocol_.fail(Status::NoAdmissiblePath,
                        "no admissible path: at rest no direction keeps the "
                        "limits of friction and normal force");
}

bool Tightening::keep_limits(const LimitedEnds& ends) {
  constexpr double kNone = 1e-6, kHighestPrice = 1e4, kSame = 0.95;
  given_way_ = 1.0;
  give_.clear();
  give_way_for_good_ = false;
  std::optional<double> before;  // at a tenth of the price
  for (double price = 1.0; price <= kHighestPrice; price *= 10.0) {
    const bool solved = solve_elastic(ends, price);
    if (solved && given_way_ <= wider() * kNone) return true;
    if (!has_more()) return false;
    if (!solved && price > 1.0) return false;
    if (solved && before && given_way_ > kSame * *before) {
      give_way_for_good_ = true;
      return false;
    }
    if (solved) before = given_way_;
  }
  return false;
}

bool Tightening::tighten() {
  const auto first = next_ends(limits_);
  if (!first) return none_at_rest();
  if (!keep_limits(*first)) {
    // Other slopes may let the path keep what these do not.
    const bool sought = end_is_sought(scene_);
    if (!(sought || start_is_sought(scene_, *first)) || !last_) {
      return none_found();
    }
    const bool for_good = give_way_for_good_;
    LimitedEnds free = *first;
    free.free_contacts = sought;
    // Between given ends of the centre a push has the slope at A left.
    free.start_slope_fixed = free.start_slope_fixed && sought;
    if (!has_more() || !keep_limits(free)) {
      // Without a bound of humps free slopes may lead nowhere; what the first
      // ones have shown stands, unless the others were not looked at to the
      // end.
      give_way_for_good_ = has_more() && (give_way_for_good_ || for_good);
      return none_found();
    }
    LimitedEnds found = *first;
    found.phi = last_->at(1.0).state.beta;
    found.start = last_->start_slope();
    const auto ends =
        with_start(found, scene_, limits_, last_->holds_control(0));
    const bool overhangs = std::abs(found.phi) > 0.5 * std::numbers::pi;
    if (!ends || ((overhangs || !keep_limits(*ends)) &&
                  !keep_limits_elsewhere(*first))) {
      give_way_for_good_ = false;  // with these slopes; there are others
      return none_found();
    }
  }
  if (care_ == Care::Full) {
    const auto ends = next_ends(limits_);
    if (!ends) return none_at_rest();
    if (!solve_rigid(limits_, mesh_, *ends) && protocol_.stopped()) {
      return false;
    }
  }
  tight_ = last_;
  // What failed on the way did so for its price alone.
  protocol_.status = Status::NotConverged;
  protocol_.message.clear();
  protocol_.keep_record("limits", last_->transit_time());
  return true;
}

bool Tightening::tighten_from(const LimitedCurve& nearby) {
  last_ = nearby;
  return tighten();
}

bool Tightening::tighten_from(RoughPath path) {
  last_.reset();
  rough_ = std::move(path);
  end_held_ = false;
  return tighten();
}

bool Tightening::tighten_cold(RoughPath path) {
  constexpr int kDegree = 3, kElements = 30, kMostPasses = 15;
  constexpr double kGive = 1.0, kPrice = 1e3, kNone = 1e-6;
  constexpr double kClosed = 1e-4, kTurn = 0.3;
  last_.reset();
  rough_ = std::move(path);
  mesh_ = uniform_mesh(kDegree, kElements);
  end_held_ = false;
  given_way_ = 1.0;
  give_.clear();
  for (int i = 0; i < kMostPasses && has_more(); ++i) {
    auto ends = next_ends(limits_);
    if (!ends) return none_at_rest();
    if (last_) {
      const double phi = last_->problem().ends().phi;
      ends->phi = phi + std::clamp(ends->phi - phi, -kTurn, kTurn);
    }
    if (give_.empty()) {
      give_ = give_of_rows(LimitedTime(scene_, limits_, mesh_, *ends),
                           std::vector<double>(limits_.size(), kGive));
    }
    if (!solve_elastic(*ends, kPrice)) return false;
    if (end_is_sought(scene_) && std::abs(held().open) > kClosed) continue;
    if (given_way_ > kNone) return none_found();
    tight_ = last_;
    protocol_.keep_record("limits", last_->transit_time());
    return true;
  }
  return protocol_.fail(Status::NotConverged, "the contact at B stays open");
}

bool Tightening::tighten_elsewhere() {
  if (!other_ways_) {
    other_ways_ = other_ways(scene_, free_, limits_);
    std::ranges::reverse(*other_ways_);
  }
  // What is left serves limits that ask for less.
  while (!other_ways_->empty() && 2 * budget_ > ipopt_.max_iterations &&
         !protocol_.stopped()) {
    RoughPath way = std::move(other_ways_->back());
    other_ways_->pop_back();
    if (tighten_from(std::move(way))) return true;
  }
  return false;
}

bool Tightening::solve_anew(const Inequalities& limits) {
  last_.reset();
  rough_.reset();
  const auto ends = next_ends(limits);
  if (!ends) return none_at_rest();
  return solve_rigid(limits, mesh_, *ends);
}

bool Tightening::solve_loosest() {
  return solve_anew(relaxation_.at(0.0));
}

bool Tightening::tighten_after(const std::vector<PathInequality>& looser) {
  return solve_anew(looser) && tighten();
}

bool Tightening::solve_finer() {
  const auto ends = next_ends(limits_);
  if (!ends) return none_at_rest();
  if (!solve_rigid(limits_, finer_at_changes(*last_), *ends, Pass::Short)) {
    return false;
  }
  protocol_.keep_record("limits", last_->transit_time());
  return true;
}

bool Tightening::none_found() {
  if (!blocking_ && !tight_) blocking_ = tightest();
  std::string text = give_way_for_good_
                         ? "where the solver ended no small change keeps "
                           "the limits"
                         : "no path was found that keeps the limits";
  if (budget_ == 0) {
    text += fmt::format(" ({} iterations used up: solver.limits.iterations)",
                        ipopt_.max_iterations);
  } else if (!give_way_for_good_ && !protocol_.message.empty()) {
    text += fmt::format(" ({})", protocol_.message);
  }
  return protocol_.fail(give_way_for_good_ ? Status::Infeasible
                        : budget_ == 0     ? Status::IterationLimit
                                           : Status::NotConverged,
                        std::move(text));
}

std::optional<BlockingLimit> Tightening::tightest() const {
  if (!last_ || give_.size() != last_->point().lambda.size()) return {};
  const LimitedTime& problem = last_->problem();
  double most = 0.0;
  std::optional<std::size_t> which;
  for (int i = 0; i < problem.layout().num_limits(); ++i) {
    double cost = 0.0;
    for (int c = 0; c < problem.layout().num_points(); ++c) {
      const auto row = at(problem.layout().limit(c, i));
      cost += give_[row] * std::abs(last_->point().lambda[row]);
    }
    if (cost <= most) continue;
    most = cost;
    which = at(i);
  }
  if (!which) return {};
  return BlockingLimit{*last_, *which};
}

}  // namespace brachisto
