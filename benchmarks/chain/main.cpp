// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The chain solver and what it stands in for, on one mesh. One task to a
// process, so that the peak memory is that of the task.

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "brachisto/solvers/program_solvers.hpp"
#include "math/cpu_clock.hpp"
#include "model/cycloid.hpp"
#include "solvers/chain_ldlt.hpp"
#include "solvers/inequality_problems.hpp"
#include "solvers/newton_solver.hpp"
#include "support/peak_memory.hpp"
#include "support/refined_solution.hpp"
#include "support/scenes.hpp"
#include "transcription/contact_equation.hpp"
#include "transcription/extremal_curve.hpp"
#include "transcription/initial_guess.hpp"
#include "transcription/prolongation.hpp"

namespace {

using namespace brachisto;

/// Memory of this process that is in use [bytes].
double resident_bytes() {
  std::ifstream statm("/proc/self/statm");
  double all = 0.0;
  double resident = 0.0;
  statm >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

/// An extremal on a coarse mesh, and its φ.
struct Coarse {
  ExtremalCurve curve;
  double phi;
};

Coarse solve_coarse(const Scene& scene) {
  constexpr double kPhi = -0.1;
  RollingTime problem(scene, uniform_mesh(5, 20), kPhi);
  const auto arc =
      cycloid_between(start_of_centre(scene), end_of_centre(scene, kPhi));
  const PrimalDual point =
      solve_with_ipopt(problem, cycloid_guess(problem, *arc), {}).point;
  ContactEquation contact(problem);
  const NewtonResult result =
      NewtonSolver(problem, &contact).solve(point, kPhi, {});
  return {ExtremalCurve(problem, result.point), result.phi};
}

/// Bytes that one core moves between memory and itself in a second: the best
/// of a few copies of an array that no cache holds, read and written counted.
double bytes_per_second() {
  constexpr std::size_t kNumbers = 32'000'000;
  constexpr int kCopies = 5;
  const std::vector<double> from(kNumbers, 1.0);
  std::vector<double> to(kNumbers);
  double best = 0.0;
  double last = process_cpu_seconds();
  for (int i = 0; i < kCopies; ++i) {
    std::copy(from.begin(), from.end(), to.begin());
    const double now = process_cpu_seconds();
    best = std::max(best, 2.0 * sizeof(double) * kNumbers / (now - last));
    last = now;
  }
  return to.back() == 1.0 ? best : 0.0;
}

/// The KKT matrix at the prolonged solution: analysis, factorisation, solution.
void factor(RollingTime& problem, const PrimalDual& point, bool with_floor) {
  std::vector<double> hess(problem.hess_lag_pattern().num_entries());
  std::vector<double> jac(problem.jac_g_pattern().num_entries());
  if (!problem.set_point(point.x)) return;
  problem.eval_hess_lag(1.0, point.lambda, hess);
  problem.eval_jac_g(jac);
  const std::array<std::span<const double>, 2> values = {hess, jac};
  double start = process_cpu_seconds();
  const auto lap = [&] {
    const double now = process_cpu_seconds();
    return now - std::exchange(start, now);
  };
  problem.eval_hess_lag(1.0, point.lambda, hess);
  problem.eval_jac_g(jac);
  const double evaluation = lap();
  const double before = resident_bytes();
  const auto chain = make_chain_ldlt(problem, nlp::equations_only(problem));
  const double analysis = lap();
  bool factorised = chain->factorise(values);
  const double first = lap();
  factorised = chain->factorise(values) && factorised;
  const double again = lap();
  std::vector<double> x(point.x.size() + point.lambda.size(), 1.0);
  const std::vector<double> b = x;
  chain->solve(x);
  const double solution = lap();
  x = testing::refined_solution(*chain, b, 1);
  const double refined = lap();
  const double state = resident_bytes() - before;
  fmt::print(
      "factorised {}, analysis {:.3f} s, first {:.3f} s, again {:.3f} s, "
      "solution {:.3f} s, refined {:.3f} s, factor {:.3f} GB, dense links {}\n",
      factorised, analysis, first, again, solution, refined, 1e-9 * state,
      chain->num_dense_links());
  if (!with_floor) return;
  const double entries =
      static_cast<double>(sizeof(double) * (hess.size() + jac.size()));
  const double speed = bytes_per_second();
  fmt::print(
      "derivatives {:.3f} s, entries {:.3f} GB; memory {:.1f} GB/s, so that no "
      "less than {:.3f} s for the derivatives, {:.3f} s for a factorisation, "
      "{:.3f} s for a solution can do\n",
      evaluation, 1e-9 * entries, 1e-9 * speed, entries / speed,
      (entries + state) / speed, 2.0 * state / speed);
}

/// Factorisations by one thread and by several in turn: the best time of each
/// [s of the clock], and whether they give the same digits.
void threads(RollingTime& problem, const PrimalDual& point, int num_threads) {
  std::vector<double> hess(problem.hess_lag_pattern().num_entries());
  std::vector<double> jac(problem.jac_g_pattern().num_entries());
  if (!problem.set_point(point.x)) return;
  problem.eval_hess_lag(1.0, point.lambda, hess);
  problem.eval_jac_g(jac);
  const std::array<std::span<const double>, 2> values = {hess, jac};
  const auto make = [&](int count) {
    const ChainScope scope(count);
    return make_chain_ldlt(problem, nlp::equations_only(problem));
  };
  const std::array chains = {make(1), make(num_threads)};
  std::array<double, 2> best = {1e300, 1e300};
  std::array<std::vector<double>, 2> x;
  constexpr int kTurns = 8;
  for (int turn = 0; turn < kTurns; ++turn) {
    for (const std::size_t i : {0U, 1U}) {
      const auto start = std::chrono::steady_clock::now();
      if (!chains[i]->factorise(values)) return;
      const std::chrono::duration<double> passed =
          std::chrono::steady_clock::now() - start;
      best[i] = std::min(best[i], passed.count());
      x[i].assign(point.x.size() + point.lambda.size(), 1.0);
      chains[i]->solve(x[i]);
    }
  }
  fmt::print("one thread {:.3f} s, {} threads {:.3f} s: {:.2f} times; {}\n",
             best[0], num_threads, best[1], best[0] / best[1],
             x[0] == x[1] ? "the same digits" : "OTHER DIGITS");
}

/// A program with inequalities from a cold start, N pieces.
template <class Problem>
void inequalities(int num_pieces, bool as_constraints, LinearSolver solver) {
  Problem problem(num_pieces, as_constraints);
  IpoptOptions options;
  // Forces are differences of N y: no less is left of 1e5 pieces by rounding.
  options.tolerance = 1e-9;
  options.linear_solver = solver;
  const double start = process_cpu_seconds();
  const SolverResult result =
      solve_with_ipopt(problem, {problem.start(), {}}, options);
  const double seconds = process_cpu_seconds() - start;
  fmt::print(
      "{} unknowns: {}, {:.3f} s, {:.2e} s for each unknown and "
      "iteration, peak {:.3f} GB\n",
      problem.num_variables() + problem.num_constraints(), result.message,
      seconds,
      seconds /
          (result.iterations * static_cast<double>(problem.num_variables() +
                                                   problem.num_constraints())),
      benchmarks::peak_gigabytes());
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Time and memory of the chain solver on one mesh.");
  std::string task = "factor";
  bool general = false;
  bool with_floor = false;
  int degree = 5;
  int elements = 200;
  app.add_option("task", task, "what to time")
      ->check(CLI::IsMember(
          {"factor", "threads", "newton", "ipopt", "obstacle", "bang-bang"}));
  bool as_constraints = false;
  app.add_flag("--constraints", as_constraints,
               "obstacle, bang-bang: inequalities as constraints, not bounds");
  app.add_flag("--general", general, "sparse LU or MUMPS instead");
  app.add_flag(
      "--floor", with_floor,
      "factor: what the speed of the memory would allow; takes 0.5 GB");
  int num_threads = 2;
  app.add_option("--threads", num_threads, "threads: how many");
  app.add_option("--degree", degree, "p");
  app.add_option("--elements", elements, "N");
  CLI11_PARSE(app, argc, argv);

  const LinearSolver solver =
      general ? LinearSolver::Mumps : LinearSolver::Chain;
  if (task == "obstacle") {
    inequalities<testing::Obstacle>(elements, as_constraints, solver);
    return 0;
  }
  if (task == "bang-bang") {
    inequalities<testing::DoubleIntegrator>(elements, as_constraints, solver);
    return 0;
  }
  const Scene scene = testing::natural(testing::off_centred_scene());
  const Coarse coarse = solve_coarse(scene);
  RollingTime problem(scene, uniform_mesh(degree, elements), coarse.phi);
  const PrimalDual point = prolong(coarse.curve, problem);
  const double start = process_cpu_seconds();
  if (task == "factor") {
    factor(problem, point, with_floor);
  } else if (task == "threads") {
    threads(problem, point, num_threads);
  } else if (task == "newton") {
    ContactEquation contact(problem);
    NewtonOptions options;
    options.linear_solver = solver;
    const NewtonResult result = NewtonSolver(problem, &contact)
                                    .solve(point, coarse.phi + 1e-3, options);
    fmt::print("{} steps, residual {:.2e}, φ {:.15f}\n", result.iterations,
               result.residual, result.phi);
  } else {
    const auto arc = cycloid_between(start_of_centre(scene),
                                     end_of_centre(scene, coarse.phi));
    IpoptOptions options;
    options.linear_solver = solver;
    const SolverResult result =
        solve_with_ipopt(problem, cycloid_guess(problem, *arc), options);
    fmt::print("{}\n", result.message);
  }
  fmt::print("{} nodes: {:.3f} s, peak {:.3f} GB\n", problem.mesh().num_nodes(),
             process_cpu_seconds() - start, benchmarks::peak_gigabytes());
  return 0;
}
