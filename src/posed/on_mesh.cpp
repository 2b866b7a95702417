// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "posed/on_mesh.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "brachisto/math/index.hpp"
#include "posed/bounds.hpp"
#include "posed/certificate.hpp"
#include "posed/guess.hpp"
#include "posed/mistakes.hpp"

namespace brachisto::ocp {

std::string MeshSolver::why_not(OnMesh& here) const {
  const Status status = here.result.status;
  if (was_stopped(status)) return std::string(describe(status));
  if (here.result.point.x.empty()) return here.result.message;
  const MeshPath path = here.path();
  // Many times what was guessed, and the largest value.
  constexpr double kLong = 30.0, kHuge = 1e5;
  const bool is_long = path.duration() > kLong * said_.duration.guess;
  const bool is_open = std::isinf(said_.duration.upper);
  const std::string longer =
      fmt::format("the duration has grown to {:.3g}; {}guess it nearer",
                  path.duration(), is_open ? "bound it, or " : "");
  double largest = 0.0;
  std::string grown;
  for (int c = 0; c < here.layout.num_points(); ++c) {
    const std::vector<double> yu = path.values(sigma(here.mesh, c)).point();
    for (std::size_t i = 0; i < yu.size(); ++i) {
      if (!(std::abs(yu[i]) > largest)) continue;
      largest = std::abs(yu[i]);
      grown = fmt::format("{} has grown to {:.3g} at t = {:.4g}",
                          variable(said_, i).name, yu[i] * problem_.scales()[i],
                          sigma(here.mesh, c) * path.duration());
    }
  }
  const std::string hint = size_hint(said_, problem_.scales());
  const std::string falls =
      "the cost falls without bound, as far as it was followed: ";
  std::string text = not_evaluable(here);
  if (text.empty()) text = missed(here);
  if (is_long && is_open && text.empty()) return falls + longer;
  if (largest > kHuge && hint.empty()) return falls + grown + "; bound it";
  if (text.empty()) {
    text = "the solver came to no end: " + here.result.message;
  }
  if (is_long) text += "; " + longer;
  if (largest > kHuge) text += "; " + grown;
  return text + hint;
}

/// Which formula is not finite at the last point, or where the path begins, or
/// is not smooth.
std::string MeshSolver::not_evaluable(const OnMesh& here) const {
  if (here.result.refused_points > 0 ||
      here.result.status == Status::NotEvaluable) {
    if (std::string found = not_finite(problem_, here.path(), true);
        !found.empty()) {
      return "where the search went " + found;
    }
  }
  std::string because = here.program->refusal();
  if (!here.program->set_point(here.result.point.x)) {
    because = here.program->refusal();
  } else if (here.result.status != Status::NotEvaluable) {
    return {};
  }
  if (std::string found = not_smooth(problem_, here.path()); !found.empty()) {
    return found;
  }
  return because.empty()
             ? ""
             : "nothing can be evaluated where the search went: " + because;
}

/// The equation that is missed most, and what stands in its way.
std::string MeshSolver::missed(OnMesh& here) const {
  const std::vector<double>& x = here.result.point.x;
  if (!here.program->set_point(x)) return {};
  const MeshPath path = here.path();
  std::vector<double> g(at(here.program->num_constraints()));
  here.program->eval_g(g);
  double most = 0.0;
  int worst = -1;
  for (int i = 0; i < here.program->num_constraints(); ++i) {
    const nlp::Range range = here.program->constraint_range(i);
    const double by = std::max(range.lower - g[at(i)], g[at(i)] - range.upper);
    if (by > most) most = by, worst = i;
  }
  constexpr double kMuch = 1e-6, kThere = 1e-4;
  if (!(most > kMuch)) return {};
  std::string name = here.program->constraint_name(worst), when;
  if (worst < here.layout.end_of_points()) {
    name = name.substr(0, name.rfind('['));
    const std::string defect = "defect of ";
    if (name.starts_with(defect)) {
      name = "the equation of " + name.substr(defect.size());
    }
    when = fmt::format(
        " at t = {:.4g}",
        sigma(here.mesh, here.layout.point_of(worst)) * path.duration());
  }
  std::set<std::string> held;
  for (int c = 0; c < here.layout.num_points(); ++c) {
    const std::vector<double> yu = path.values(sigma(here.mesh, c)).point();
    for (std::size_t i = 0; i < yu.size(); ++i) {
      const Variable& one = variable(said_, i);
      const double scale = problem_.scales()[i], value = yu[i] * scale;
      if (value < one.lower + kThere * scale) {
        held.insert(fmt::format("{} ≥ {:.6g}", one.name, one.lower));
      }
      if (value > one.upper - kThere * scale) {
        held.insert(fmt::format("{} ≤ {:.6g}", one.name, one.upper));
      }
    }
  }
  return fmt::format(
      "no path was found that keeps to all that is asked: {} is missed by "
      "{:.2g}{}{}",
      name, most, when,
      held.empty() ? ""
                   : fmt::format(", where the path is stopped by {}",
                                 fmt::join(held, ", ")));
}

OnMesh MeshSolver::solved_from_guess(const Mesh& mesh) {
  const auto decided = [](const OnMesh& here) {
    return here.solved() || here.result.status == Status::NotEvaluable ||
           was_stopped(here.result.status);
  };
  // High degrees creep where low ones get on, and lead them.
  constexpr int kFew = 60;
  const int few = std::min(kFew, by_.most_iterations);
  OnMesh here = solved_from(nullptr, mesh, few);
  for (const int elements : {40, 10}) {
    if (decided(here)) return here;
    const OnMesh low =
        solved_from(nullptr, uniform_mesh(1, elements), by_.most_iterations);
    if (!low.solved()) continue;
    const MeshPath from = low.path();
    here = solved_from(&from, mesh, by_.most_iterations);
  }
  return decided(here) ? std::move(here)
                       : solved_from(nullptr, mesh, by_.most_iterations);
}

OnMesh MeshSolver::solved_from(const MeshPath* nearby, const Mesh& mesh,
                               int most_iterations) {
  OnMesh here = not_solved(mesh);
  const PrimalDual start =
      nearby != nullptr ? nearby->on(mesh, here.layout) : guess(problem_, mesh);
  if (nearby == nullptr) {
    const std::string found =
        not_finite(problem_, {mesh, here.layout, start}, false);
    if (!found.empty()) {
      here.result.status = Status::NotEvaluable;
      here.result.message =
          "at the guess " + found + ": give a guess where it is";
      return here;
    }
  }
  fill_in(here, start, most_iterations);
  return here;
}

void MeshSolver::fill_in(OnMesh& here, const PrimalDual& start,
                         int most_iterations) {
  IpoptOptions options;
  options.tolerance = 1e-9;
  // All bounds together leave a tenth of what the cost may err by.
  options.complementarity =
      std::clamp(0.1 * by_.tolerance /
                     (2.0 * static_cast<double>(here.program->num_variables())),
                 1e-14, 1e-12);
  options.max_iterations = most_iterations;
  options.linear_solver = by_.linear_solver;
  options.stop = by_.stop;
  struct Attempt {
    double looser;
    LinearSolver solver;
  };
  // On short elements MUMPS may do what the chain cannot.
  for (const auto [looser, solver] :
       {Attempt{1.0, by_.linear_solver}, Attempt{1.0, LinearSolver::Mumps},
        Attempt{1e3, by_.linear_solver}, Attempt{1e5, by_.linear_solver}}) {
    IpoptOptions some = options;
    some.complementarity = std::min(1e-8, looser * *options.complementarity);
    some.linear_solver = solver;
    here.result = solve_with_ipopt(*here.program, start, some);
    iterations_ += here.result.iterations;
    if (here.result.status != Status::NotConverged ||
        here.result.point.x.empty() ||
        !here.program->set_point(here.result.point.x)) {
      break;
    }
    // Short of the last digits: what is left counts in the estimate.
    if (first_order(*here.program, here.result.point).max() < kAsCertified) {
      here.result.status = Status::Solved;
      break;
    }
  }
  if (!here.solved()) {
    here.result.message = why_not(here);
    return;
  }
  NewtonOptions newton;
  newton.tolerance = 1e-10;
  newton.to_rounding = true;
  newton.max_iterations = 8;
  newton.stop = by_.stop;
  NewtonResult polished =
      solve_with_newton(*here.program, here.result.point, newton);
  if (polished.status == Status::Solved && polished.active_set_holds) {
    here.result.point = std::move(polished.point);
    here.exact = true;
  }
  if (!here.program->set_point(here.result.point.x)) {
    here.result.status = Status::NotEvaluable;
    here.result.message = why_not(here);
    return;
  }
  here.cost = here.program->eval_f();
  here.gap = left_by_bounds(*here.program, here.result.point);
  return;
}

double MeshSolver::size_of_cost(const OnMesh& here) const {
  const MeshPath path = here.path();
  const CollocationScheme& scheme = radau_scheme(here.mesh.degree);
  double sum = 0.0;
  for (int c = 0; c < here.layout.num_points(); ++c) {
    const double rate =
        formulas(problem_, path.values(sigma(here.mesh, c)).point()).front();
    sum += here.mesh.length(c / here.mesh.degree) *
           scheme.rule.weights[at(c % here.mesh.degree)] * std::abs(rate);
  }
  constexpr double kLeast = 1e-300;  // of a problem that costs nothing
  return std::max({std::abs(here.cost), sum * path.duration(), kLeast});
}

}  // namespace brachisto::ocp
