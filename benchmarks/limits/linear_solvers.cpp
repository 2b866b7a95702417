// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The program of a limited track on ever finer meshes, its limits inequalities,
// by Ipopt with the chain and with MUMPS from the same start.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <vector>

#include "brachisto/math/clock.hpp"
#include "brachisto/solvers/program_solvers.hpp"
#include "refinement/limited_refinement.hpp"
#include "refinement/open_conditions.hpp"
#include "study/pose.hpp"
#include "study/start.hpp"
#include "support/table.hpp"

using namespace brachisto;
using namespace brachisto::benchmarks;

namespace {

/// One run; iterations, and processor time of one factorisation [s].
struct Run {
  SolverResult result;
  double factorisation = 0.0, all = 0.0;
};

Run run(LimitedTime problem, const PrimalDual& start, LinearSolver solver) {
  IpoptOptions options;
  options.tolerance = 1e-8;
  options.complementarity = 1e-9;
  options.linear_solver = solver;
  const PhaseSeconds before = phase_seconds();
  Run out{solve_with_ipopt(problem, start, options)};
  PhaseSeconds spent = phase_seconds();
  spent -= before;
  out.factorisation =
      spent.of(Phase::Factorisation) / std::max(1, out.result.iterations);
  for (const double seconds : spent.seconds) out.all += seconds;
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  double friction = 0.5;
  int degree = 7;
  std::vector<int> nodes{1000, 10'000, 100'000};
  CLI::App app{"A limited track by Ipopt with the chain and with MUMPS"};
  app.add_option("--friction", friction, "Bound")->capture_default_str();
  app.add_option("--degree", degree, "Of the elements")->capture_default_str();
  app.add_option("--nodes", nodes, "Of the meshes")->capture_default_str();
  CLI11_PARSE(app, argc, argv);

  Scene scene;
  scene.body = Body::cylinder(1.0 / 3.0, 2.0 / 3.0, 0.0, 0.5);
  scene.L = 3.0;
  scene.H = 1.0;
  // The start keeps a bound that is somewhat looser, as in tightening.
  constexpr double kLooser = 1.1;
  scene.limits.friction = kLooser * friction;
  const PosedProblem posed = pose(scene, {}, {});
  const Start start = start_from_cycloid(posed);
  const LimitedRefinement refined =
      refine_limited(*posed.limited, posed.program.discretisation, *start.curve,
                     start.phi, posed.mesh_options);
  if (!refined.answer) {
    fmt::print(stderr, "{}\n", refined.message);
    return 1;
  }
  const FittedPath& path = refined.answer->path;
  Scene tight = *posed.limited;
  tight.limits.friction = friction;
  const std::vector<PathInequality> limits =
      inequalities(tight.body, tight.limits);
  const LimitedEnds ends = *with_start(path.ends, tight, limits, false);
  fmt::print("Friction {}, degree {}. {}.\n\n", friction, degree, machine());
  fmt::print("{:>8} {:>10} {:>10} {:>14} {:>14} {:>6} {:>8} {:>8}\n", "nodes",
             "iterations", "MUMPS", "factor. chain", "factor. MUMPS", "ratio",
             "chain s", "MUMPS s");
  for (const int wanted : nodes) {
    std::vector<Arc> arcs = path.arcs;
    const int elements = wanted / degree;
    double begin = 0.0;
    for (Arc& arc : arcs) {
      const double share = arc.end - begin;
      arc.cuts = equal_cuts(std::max(2, static_cast<int>(share * elements)));
      begin = arc.end;
    }
    const LimitedTime problem(tight, limits, mesh_of(arcs, degree), ends);
    const PrimalDual from = prolong(path.curve, problem);
    const Run chain = run(problem, from, LinearSolver::Chain);
    const Run mumps = run(problem, from, LinearSolver::Mumps);
    for (const Run* one : {&chain, &mumps}) {
      if (one->result.status == Status::Solved) continue;
      fmt::print("{} nodes: {}\n", wanted, one->result.message);
    }
    fmt::print(
        "{:>8} {:>10} {:>10} {:>14.4g} {:>14.4g} {:>6.1f} {:>8.3g} "
        "{:>8.3g}\n",
        problem.mesh().num_nodes(), chain.result.iterations,
        mumps.result.iterations, chain.factorisation, mumps.factorisation,
        mumps.factorisation / chain.factorisation, chain.all, mumps.all);
  }
  return 0;
}
