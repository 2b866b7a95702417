// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/tightening.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "math/index.hpp"
#include "refinement/open_conditions.hpp"
#include "refinement/turn_meshes.hpp"

namespace brachisto {

namespace {

bool winds(const LimitedCurve& curve) {
  constexpr double kTooSteep = 1.02 * std::numbers::pi;
  const VariableLayout& layout = curve.problem().layout();
  for (int node = 0; node < layout.num_nodes(); ++node) {
    const int beta = layout.state(node, StateComponent::Beta);
    if (std::abs(curve.point().x[at(beta)]) > kTooSteep) return true;
  }
  return false;
}

/// Elements halved where what holds changes within them or next to them.
Mesh finer_at_changes(const LimitedCurve& curve) {
  const LimitedTime& problem = curve.problem();
  const Mesh& mesh = problem.mesh();
  const auto changes = [&](int point) {
    if (point < 1 || point >= problem.layout().num_points()) return false;
    for (int i = 0; i < problem.layout().num_limits(); ++i) {
      if (curve.active(point, i) != curve.active(point - 1, i)) return true;
    }
    return false;
  };
  Mesh next{mesh.degree, {0.0}};
  for (int e = 0; e < mesh.num_elements(); ++e) {
    bool any = false;
    for (int c = e * mesh.degree; c <= (e + 1) * mesh.degree; ++c) {
      any = any || changes(c);
    }
    if (any) next.boundaries.push_back(mesh.sigma(e, 0.5));
    next.boundaries.push_back(mesh.boundaries[at(e + 1)]);
  }
  return next;
}

}  // namespace

Tightening::Tightening(const Scene& scene, const ExtremalCurve& free,
                       double phi, const IpoptOptions& ipopt,
                       PassProtocol& protocol)
    : scene_(scene),
      free_(free),
      relaxation_(scene, free),
      limits_(inequalities(scene.body, scene.limits)),
      ipopt_(ipopt),
      budget_(ipopt.max_iterations),
      protocol_(protocol) {
  first_ends_.free_contacts = scene.contact == Contact::Optimal;
  first_ends_.phi = scene.end_slope.value_or(phi);
}

bool Tightening::solve(
    const Inequalities& limits, const Mesh& mesh, const LimitedEnds& ends,
    const std::function<PrimalDual(const LimitedTime&)>& start,
    int most_iterations) {
  // Solutions are starts.
  constexpr double kTolerance = 1e-8;
  constexpr double kComplementarity = 1e-11;
  LimitedTime problem(scene_, limits, mesh, ends);
  IpoptOptions ipopt = ipopt_;
  ipopt.tolerance = std::max(ipopt.tolerance, kTolerance);
  ipopt.complementarity = kComplementarity;
  ipopt.max_iterations = std::min(budget_, most_iterations);
  SolverResult result = solve_with_ipopt(problem, start(problem), ipopt);
  budget_ = std::max(0, budget_ - result.iterations);
  MeshRecord& record = protocol_.record;
  record.iterations += result.iterations;
  ++record.passes;
  record.degree = mesh.degree;
  record.elements = mesh.num_elements();
  record.linear_solver = result.linear_solver;
  protocol_.log += result.log;
  if (result.status == Status::IterationLimit && budget_ > 0) {
    // Of one of many passes, not of the user.
    result.status = Status::NotConverged;
  }
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

bool Tightening::solve_first(const Inequalities& limits, const Mesh& mesh,
                             const LimitedEnds& ends) {
  constexpr int kMostIterations = 300;
  return solve(
      limits, mesh, ends,
      [&](const LimitedTime& problem) {
        return sample_at_mesh(
            problem, free_.rolling_time(), [&](double sigma) -> LimitedPoint {
              return {.state = turning_point(free_, sigma),
                      .p = free_.at(sigma).p,
                      .multipliers = std::vector<double>(limits.size())};
            });
      },
      kMostIterations);
}

bool Tightening::solve_again(const Inequalities& limits, const Mesh& mesh,
                             const LimitedEnds& ends) {
  constexpr int kMostIterations = 120;
  const LimitedCurve before = *last_;
  return solve(
      limits, mesh, ends,
      [&](const LimitedTime& problem) { return prolong(before, problem); },
      kMostIterations);
}

std::optional<LimitedEnds> Tightening::next_ends(const Inequalities& limits) {
  LimitedEnds ends = last_ ? last_->problem().ends() : first_ends_;
  if (ends.free_contacts) return ends;
  if (end_is_sought(scene_) && last_ && !end_held_) {
    ends.phi = end_slope(*last_);
  }
  if (last_) ends.start = last_->at(0.0).state.beta;
  return with_start(ends, scene_, limits, last_ && last_->holds_control(0));
}

bool Tightening::none_at_rest() {
  return protocol_.fail(Status::NoAdmissiblePath,
                        "no admissible path: at rest no direction keeps the "
                        "limits of friction and normal force");
}

bool Tightening::tighten() {
  constexpr int kDegree = 4;
  constexpr double kFirstStep = 0.125, kLargestStep = 0.25;
  constexpr double kSmallestStep = 5e-3;
  const Mesh mesh = uniform_mesh(
      kDegree,
      static_cast<int>(24 + 12 * turns(scene_.body, free_.arc_length())));
  double reached = 0.0;
  double step = kFirstStep;
  for (double share = 0.0;;) {
    const Inequalities limits = relaxation_.at(share);
    const auto ends = next_ends(limits);
    if (!ends) return none_at_rest();
    const bool first = !last_;
    const bool solved = first ? solve_first(limits, mesh, *ends)
                              : solve_again(limits, mesh, *ends);
    if (ipopt_.stop.met()) return false;
    if (solved) {
      reached = share;
      if (first) loosest_ = last_;
      if (share >= 1.0) break;
      if (!first) step = std::min(kLargestStep, 1.5 * step);
    } else {
      step *= 0.4;
      if (first || step < kSmallestStep) return none_found(reached);
    }
    share = std::min(1.0, reached + step);
  }
  tightened_ = true;
  // What failed on the way did so for its step alone.
  protocol_.status = Status::NotConverged;
  protocol_.message.clear();
  protocol_.keep_record("limits", last_->transit_time());
  return true;
}

bool Tightening::solve_finer() {
  const auto ends = next_ends(limits_);
  if (!ends) return none_at_rest();
  if (!solve_again(limits_, finer_at_changes(*last_), *ends)) return false;
  protocol_.keep_record("limits", last_->transit_time());
  return true;
}

bool Tightening::bracket_contact() {
  constexpr double kStep = 0.1, kSteepest = 1.4;
  end_held_ = true;
  if (!tightened_) {
    last_ = loosest_;
    if (!tighten()) return false;
  }
  const LimitedCurve first = *last_;
  const Held begin = held();
  double least = std::abs(begin.open);
  double lowest = begin.phi, highest = begin.phi;
  for (const double direction : {1.0, -1.0}) {
    last_ = first;
    Held before = begin;
    for (double phi = begin.phi + direction * kStep; std::abs(phi) < kSteepest;
         phi += direction * kStep) {
      if (!solve_held(phi)) break;
      const Held here = held();
      least = std::min(least, std::abs(here.open));
      lowest = std::min(lowest, phi);
      highest = std::max(highest, phi);
      if ((here.open < 0.0) != (before.open < 0.0)) {
        return close_in(before, here);
      }
      before = here;
    }
    if (ipopt_.stop.met()) return false;
  }
  if (highest - lowest < 2.0 * kStep) return false;
  return protocol_.fail(
      Status::NoSmoothContact,
      fmt::format("no smooth contact under these limits: for slopes "
                  "at B from {:.3g} to {:.3g} rad the path that keeps "
                  "the limits ends {:.2g} rad or more off; try "
                  "contact: optimal",
                  lowest, highest, least));
}

bool Tightening::solve_held(double phi) {
  const Mesh mesh = last_->problem().mesh();
  auto ends = next_ends(limits_);
  if (!ends) return none_at_rest();
  ends->phi = phi;
  return solve_again(limits_, mesh, *ends);
}

Tightening::Held Tightening::held() {
  const double phi = last_->problem().ends().phi;
  return {phi, end_slope(*last_) - phi};
}

bool Tightening::close_in(Held a, Held b) {
  constexpr double kClose = 1e-3, kJump = 1e-5;
  while (std::abs(a.phi - b.phi) > kJump) {
    const double phi = 0.5 * (a.phi + b.phi);
    if (!solve_held(phi)) return false;
    const Held here = held();
    if (std::abs(here.open) < kClose) return true;
    ((here.open < 0.0) == (a.open < 0.0) ? a : b) = here;
  }
  return protocol_.fail(
      Status::NoSmoothContact,
      fmt::format("no smooth contact under these limits: at φ = "
                  "{:.6g} rad the slope at the end jumps from {:.2g} "
                  "to {:.2g} rad off; try contact: optimal",
                  a.phi, a.open, b.open));
}

bool Tightening::none_found(double reached) {
  const bool infeasible = protocol_.status == Status::Infeasible;
  return protocol_.fail(
      infeasible     ? Status::Infeasible
      : budget_ == 0 ? Status::IterationLimit
                     : Status::NotConverged,
      fmt::format(
          "{}: on the way from what the free extremal keeps to the limits "
          "{:.0f} % were reached{} ({})",
          infeasible ? "no path nearby keeps the limits"
                     : "no path was found that keeps the limits",
          100.0 * reached, tightest(reached),
          budget_ > 0
              ? protocol_.message
              : fmt::format("{} iterations used up", ipopt_.max_iterations)));
}

std::string Tightening::tightest(double reached) const {
  if (!last_) return {};
  const LimitedTime& problem = last_->problem();
  const Inequalities ahead = relaxation_.at(std::min(1.0, reached + 0.01));
  double most = 0.0;
  std::string which;
  for (int i = 0; i < problem.layout().num_limits(); ++i) {
    double cost = 0.0;
    const PathInequality& now = problem.limits()[at(i)];
    const PathInequality& next = ahead[at(i)];
    for (int c = 0; c < problem.layout().num_points(); ++c) {
      const auto row = at(problem.layout().limit(c, i));
      cost += std::abs(last_->point().lambda[row]);
    }
    cost *=
        std::abs(next.number - now.number) +
        (std::isfinite(now.lower) ? std::abs(next.lower - now.lower) : 0.0) +
        (std::isfinite(now.upper) ? std::abs(next.upper - now.upper) : 0.0);
    if (cost <= most) continue;
    most = cost;
    which = fmt::format("; the tightest is {}", name(now.kind));
  }
  return which;
}

}  // namespace brachisto
