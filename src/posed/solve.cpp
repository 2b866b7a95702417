// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// From a statement to a checked answer: mesh from mesh, each solved twice, as
// it is and with its elements cut in two.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

#include "brachisto/math/index.hpp"
#include "brachisto/posed/problem.hpp"
#include "brachisto/solvers/program_solvers.hpp"
#include "math/cpu_clock.hpp"
#include "posed/certificate.hpp"
#include "posed/guess.hpp"
#include "posed/held.hpp"
#include "posed/mesh_path.hpp"
#include "posed/prices.hpp"
#include "posed/refine.hpp"
#include "posed/settle.hpp"

namespace brachisto::ocp {

namespace {

/// A mesh with its program and what was found on it.
struct OnMesh {
  Mesh mesh;
  Layout layout;
  std::unique_ptr<nlp::Problem> program;
  SolverResult result;
  double cost = 0.0;
  /// The bounds' multipliers times what is left to them.
  double gap = 0.0;
  /// What holds as an equation is known, and does to the last digit.
  bool exact = false;

  [[nodiscard]] MeshPath path() const { return {mesh, layout, result.point}; }
  [[nodiscard]] bool solved() const { return result.status == Status::Solved; }
};

class Solve {
 public:
  Solve(const Posed& problem, const SolveBy& by)
      : problem_(problem),
        by_(by),
        said_(problem.statement()),
        states_(said_.states.size() + said_.parameters.size()) {}

  [[nodiscard]] Answer run();

 private:
  [[nodiscard]] OnMesh on(const Mesh& mesh) const {
    return {mesh, problem_.layout(mesh), problem_.on(mesh), {}, 0.0, 0.0,
            false};
  }
  /// \param nearby  a path to start from; the guess without one
  [[nodiscard]] OnMesh solved_on(const Mesh& mesh, const MeshPath* nearby,
                                 int most_iterations);
  /// The same, by a detour where the guess is far from a path.
  [[nodiscard]] OnMesh solved_from_guess(const Mesh& mesh);
  [[nodiscard]] std::string why_not(OnMesh& here) const;
  [[nodiscard]] double size_of_cost(const OnMesh& here) const;
  /// Moves both paths' kinks to where they belong; false if it cannot.
  [[nodiscard]] bool settle(OnMesh& coarse, OnMesh& fine,
                            std::vector<RefinedMesh::Junction>& junctions);
  void put_down(OnMesh& fine, const HeldAlong& held,
                const std::vector<RefinedMesh::Junction>& junctions);
  [[nodiscard]] std::string why_not_nearer(
      const MeshPath& path, double relative,
      const std::vector<double>& not_settled) const;
  const Posed& problem_;
  const SolveBy& by_;
  const Statement& said_;
  std::size_t states_;
  Answer answer_;
  int iterations_ = 0;
};

std::string Solve::why_not(OnMesh& here) const {
  const Status status = here.result.status;
  if (was_stopped(status)) return std::string(describe(status));
  const std::vector<double>& x = here.result.point.x;
  if (x.empty()) return here.result.message;
  const MeshPath path = here.path();
  // The largest value, and the equation that is missed most.
  constexpr double kHuge = 1e5;
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
  if (path.duration() > kHuge * said_.duration.guess) {
    return fmt::format(
        "the cost falls without bound, as far as it was followed: the duration "
        "has grown to {:.3g}; bound it",
        path.duration());
  }
  if (largest > kHuge) {
    return "the cost falls without bound, as far as it was followed: " + grown +
           "; bound it";
  }
  if (here.program->set_point(x)) {
    std::vector<double> g(at(here.program->num_constraints()));
    here.program->eval_g(g);
    double missed = 0.0;
    int worst = -1;
    for (int i = 0; i < here.program->num_constraints(); ++i) {
      const nlp::Range range = here.program->constraint_range(i);
      const double by =
          std::max(range.lower - g[at(i)], g[at(i)] - range.upper);
      if (by > missed) missed = by, worst = i;
    }
    if (missed > 1e-6) {
      std::string name = here.program->constraint_name(worst);
      std::string when;
      if (worst < here.layout.end_of_points()) {
        name = name.substr(0, name.rfind('['));
        when = fmt::format(
            " at t = {:.4g}",
            sigma(here.mesh, here.layout.point_of(worst)) * path.duration());
      }
      return fmt::format(
          "no path was found that keeps to all that is asked: the {} is "
          "missed by {:.2g}{}",
          name, missed, when);
    }
  } else {
    return "a formula was not finite where the search went: " +
           here.program->refusal();
  }
  return fmt::format("the solver came to no end: {}", here.result.message);
}

OnMesh Solve::solved_from_guess(const Mesh& mesh) {
  const auto decided = [](const OnMesh& here) {
    return here.solved() || here.result.status == Status::NotEvaluable ||
           was_stopped(here.result.status);
  };
  // High degrees creep where low ones get on, and lead them.
  constexpr int kFew = 60;
  const int few = std::min(kFew, by_.most_iterations);
  OnMesh here = solved_on(mesh, nullptr, few);
  for (const int elements : {40, 10}) {
    if (decided(here)) return here;
    const OnMesh low =
        solved_on(uniform_mesh(1, elements), nullptr, by_.most_iterations);
    if (!low.solved()) continue;
    const MeshPath from = low.path();
    here = solved_on(mesh, &from, by_.most_iterations);
  }
  return decided(here) ? std::move(here)
                       : solved_on(mesh, nullptr, by_.most_iterations);
}

OnMesh Solve::solved_on(const Mesh& mesh, const MeshPath* nearby,
                        int most_iterations) {
  OnMesh here = on(mesh);
  const PrimalDual start =
      nearby != nullptr ? nearby->on(mesh, here.layout) : guess(problem_, mesh);
  if (nearby == nullptr) {
    here.result.message = not_finite(problem_, {mesh, here.layout, start});
    if (!here.result.message.empty()) {
      here.result.status = Status::NotEvaluable;
      return here;
    }
  }
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
  // Short of the last digits: what is left counts in the estimate.
  constexpr double kGood = 1e-7;
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
    if (first_order(*here.program, here.result.point).max() < kGood) {
      here.result.status = Status::Solved;
      break;
    }
  }
  if (!here.solved()) {
    here.result.message = why_not(here);
    return here;
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
    return here;
  }
  here.cost = here.program->eval_f();
  here.gap = left_by_bounds(*here.program, here.result.point);
  return here;
}

bool Solve::settle(OnMesh& coarse, OnMesh& fine,
                   std::vector<RefinedMesh::Junction>& junctions) {
  std::array<std::optional<Settled>, 2> found;
  const std::array both{&coarse, &fine};
  for (std::size_t i = 0; i < both.size(); ++i) {
    OnMesh& here = *both[i];
    found[i] = settled(problem_, *here.program, here.path(), here.result.point,
                       junctions);
    if (!found[i]) return false;
  }
  for (RefinedMesh::Junction& junction : junctions) {
    if (junction.half_width > 0.0) continue;
    const int behind = fine.mesh.locate(junction.sigma).element;
    junction = {found[1]->mesh.boundaries[at(behind)], 0.0, 0.0};
  }
  for (std::size_t i = 0; i < both.size(); ++i) {
    OnMesh& here = *both[i];
    here.mesh = std::move(found[i]->mesh);
    here.program = std::move(found[i]->program);
    here.result.point = std::move(found[i]->point);
    here.cost = found[i]->cost;
    here.gap = 0.0;
    here.exact = true;
  }
  return true;
}

double Solve::size_of_cost(const OnMesh& here) const {
  const MeshPath path = here.path();
  const CollocationScheme& scheme = radau_scheme(here.mesh.degree);
  std::vector<double> out(1 + states_ + said_.limits.size());
  double sum = 0.0;
  for (int c = 0; c < here.layout.num_points(); ++c) {
    problem_.evaluate(path.values(sigma(here.mesh, c)).point(), out);
    sum += here.mesh.length(c / here.mesh.degree) *
           scheme.rule.weights[at(c % here.mesh.degree)] * std::abs(out[0]);
  }
  return std::max(std::abs(here.cost), sum * path.duration());
}

void Solve::put_down(OnMesh& fine, const HeldAlong& held,
                     const std::vector<RefinedMesh::Junction>& junctions) {
  answer_.cost = fine.cost;
  answer_.duration = fine.path().duration();
  answer_.parameters.clear();
  for (std::size_t s = said_.states.size(); s < states_; ++s) {
    answer_.parameters.push_back(
        fine.result.point.x[at(fine.layout.state(0, static_cast<int>(s)))] *
        problem_.scales()[s]);
  }
  answer_.junctions.clear();
  for (int c = 0; c + 1 < fine.layout.num_points(); ++c) {
    if (held[at(c)] == held[at(c + 1)]) continue;
    double place = 0.5 * (sigma(fine.mesh, c) + sigma(fine.mesh, c + 1));
    for (const RefinedMesh::Junction& kink : junctions) {
      const int p = fine.mesh.degree;
      const bool beside =
          kink.sigma >= fine.mesh.boundaries[at(c / p)] &&
          kink.sigma <= fine.mesh.boundaries[at((c + 1) / p + 1)];
      if (kink.half_width == 0.0 && beside) place = kink.sigma;
    }
    if (!answer_.junctions.empty() &&
        answer_.junctions.back() == place * answer_.duration) {
      continue;
    }
    answer_.junctions.push_back(place * answer_.duration);
  }
  answer_.made_of.mesh = fine.mesh;
  answer_.made_of.point = fine.result.point;
  put_prices(problem_, *fine.program, fine.path(), fine.result.point, answer_);
}

std::string Solve::why_not_nearer(
    const MeshPath& path, double relative,
    const std::vector<double>& not_settled) const {
  if (std::string jump = jump_along(problem_, path); !jump.empty()) return jump;
  return fmt::format(
      "the estimated error stays at {:.1e}, {:.1e} is wanted; {}", relative,
      by_.tolerance,
      not_settled.empty()
          ? "a control may jump or be singular"
          : fmt::format("not settled is where bounds begin or cease to hold "
                        "at t = {:.5g}; try another degree or number of "
                        "elements",
                        fmt::join(not_settled, ", ")));
}

Answer Solve::run() {
  const double began = thread_cpu_seconds();
  answer_.made_of.statement = said_;
  answer_.made_of.scales = problem_.scales();
  RefinedMesh next{uniform_mesh(by_.degree, by_.elements).boundaries, {}};
  std::optional<OnMesh> best;
  std::optional<MeshPath> nearby;
  double relative = kNoBound;
  std::vector<double> not_settled;  // times
  // What the cost errs by as junctions are not quite where they are taken to
  // be, which both meshes of a pass have in common: it falls with the square of
  // how far they move.
  const auto by_places = [&](const RefinedMesh& now, const RefinedMesh& after,
                             double cost) {
    if (after.junctions.empty()) return 0.0;
    if (after.has_new()) return kNoBound;
    const double last = answer_.passes[answer_.passes.size() - 2].cost;
    constexpr double kOfJumps = 2.0, kAsKnown = 1e-5;
    if (!after.has_kinks()) return kOfJumps * std::abs(cost - last);
    return std::abs(cost - last) *
           std::min(1.0, std::max(kAsKnown, after.moved()) / now.moved());
  };
  const auto ended = [&](Status status, std::string message) {
    answer_.status = status;
    answer_.message = said_.name + ": " + std::move(message);
  };
  ended(Status::NotConverged, "");
  for (int pass = 0; pass < by_.most_passes; ++pass) {
    iterations_ = 0;
    const Mesh mesh = next.mesh(by_.degree);
    OnMesh coarse = nearby ? solved_on(mesh, &*nearby, by_.most_iterations)
                           : solved_from_guess(mesh);
    OnMesh* failed = coarse.solved() ? nullptr : &coarse;
    std::optional<OnMesh> halves;
    if (failed == nullptr) {
      const MeshPath from = coarse.path();
      halves.emplace(solved_on(halved(mesh), &from, by_.most_iterations));
      if (!halves->solved()) failed = &*halves;
    }
    if (failed != nullptr) {
      if (by_.verbose) {
        std::fprintf(stderr, "%s: %d elements: %s\n", said_.name.c_str(),
                     failed->mesh.num_elements(),
                     failed->result.message.c_str());
      }
      if (!best || was_stopped(failed->result.status)) {
        ended(failed->result.status, failed->result.message);
      }
      break;
    }
    OnMesh& fine = *halves;
    const bool settled =
        next.has_kinks() && settle(coarse, fine, next.junctions);
    const double size = size_of_cost(fine);
    const double change = std::abs(coarse.cost - fine.cost);
    answer_.passes.push_back(
        {fine.mesh.num_elements(), iterations_, fine.cost, change});
    const MeshPath coarse_path = coarse.path(), fine_path = fine.path();
    const auto held =
        held_along(*fine.program, fine.result.point, fine.mesh, fine.layout);
    const std::vector<double> errors =
        element_errors(problem_, {coarse_path, fine_path, held});
    if (by_.verbose) {
      std::fprintf(stderr,
                   "%s: %d elements, %d iterations, %.14g, change %.1e\n",
                   said_.name.c_str(), fine.mesh.num_elements(), iterations_,
                   fine.cost, change);
    }
    const double share = 0.3 * by_.tolerance * size / mesh.num_elements();
    RefinedMesh after =
        refined(next, {coarse_path, fine_path, held}, errors, share);
    Answer priced;
    put_prices(problem_, *fine.program, fine_path, fine.result.point, priced);
    // Next to junctions the finer path need not be the better one.
    constexpr double kRounding = 1e-14;
    const double error = 2.0 * change + fine.gap + kRounding * size +
                         (settled ? 0.0 : by_places(next, after, fine.cost)) +
                         cost_of_excess(problem_, fine_path, priced.prices);
    nearby.emplace(fine_path);
    if (!best || error / size < relative) {
      relative = error / size;
      answer_.estimated_error = error;
      put_down(fine, held, next.junctions);
      not_settled.clear();
      for (const RefinedMesh::Junction& junction : next.junctions) {
        if (settled || junction.half_width > 0.0) continue;
        not_settled.push_back(junction.sigma * answer_.duration);
      }
      best.emplace(std::move(fine));
    }
    if (relative <= by_.tolerance) {
      ended(Status::Solved, "solved");
      break;
    }
    if (after.mesh(by_.degree).boundaries == mesh.boundaries) {
      for (int e = 0; e < mesh.num_elements(); ++e) {
        after.boundaries.push_back(mesh.sigma(e, 0.5));
      }
      std::ranges::sort(after.boundaries);
    }
    if (after.mesh(by_.degree).num_elements() > by_.most_elements) break;
    next = std::move(after);
  }
  if (best) {
    const MeshPath path = best->path();
    if (answer_.status == Status::NotConverged) {
      ended(Status::NotConverged, why_not_nearer(path, relative, not_settled));
    }
    answer_.certificate = certify(problem_, *best->program, best->result.point,
                                  path, relative, by_.tolerance, best->exact);
  }
  answer_.seconds = thread_cpu_seconds() - began;
  return answer_;
}

}  // namespace

Answer solve(const Posed& problem, const SolveBy& by) {
  return Solve(problem, by).run();
}

}  // namespace brachisto::ocp
