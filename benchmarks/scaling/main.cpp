// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What a solve costs as the mesh grows: both formulations, the chain
// factorisation beside MUMPS, Newton's method beside Ipopt. Each solve, from
// the scene to the certificate, runs in a process of its own.

#include <fmt/format.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "scaling/runs.hpp"
#include "support/peak_memory.hpp"
#include "support/processes.hpp"
#include "support/table.hpp"

namespace {

using namespace brachisto;
using namespace brachisto::benchmarks;

/// The phases that the table shows; the CSV has all.
constexpr Phase kShown[] = {Phase::SetUp,         Phase::Evaluation,
                            Phase::Factorisation, Phase::Solution,
                            Phase::Ipopt,         Phase::Certificate};

/// One solve to be measured.
struct Task {
  int way;
  int nodes;
};

Scene reference_case() {
  Scene scene;
  scene.body = Body::cylinder(1.0 / 3.0, 2.0 / 3.0, 0.0, 0.5);
  scene.L = 3.0;
  scene.H = 1.0;
  return scene;
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) +
         1e-6 * static_cast<double>(time.tv_usec);
}

/// The nearest number of nodes that the formulation has with degree 5.
int nodes_of(const Way& way, int wanted) {
  constexpr int kDegree = 5;
  return way.formulation == Formulation::ArcLength
             ? wanted + 1
             : wanted / kDegree * kDegree + 1;
}

Record run(const Task& task, double exact_tau) {
  const Way& way = kWays[task.way];
  SolveOptions options;
  auto& program = options.use<Collocation>();
  program.solver = way.method;
  program.linear_solver = way.linear_solver;
  program.discretisation.formulation = way.formulation;
  program.discretisation.nodes = nodes_of(way, task.nodes);
  const Solution solution = solve(reference_case(), options);
  Record record{};
  record.verified = solution.verified();
  record.nodes = solution.program() ? solution.program()->nodes : 0;
  record.iterations = solution.effort.iterations;
  record.newton_steps = solution.effort.newton_steps;
  if (solution.motion() != nullptr) record.tau = solution.motion()->tau();
  record.error = record.tau / exact_tau - 1.0;
  record.estimated_error = solution.estimated_error.value_or(NAN);
  record.phases = solution.effort.phases;
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  record.user_seconds = seconds(usage.ru_utime);
  record.system_seconds = seconds(usage.ru_stime);
  record.gigabytes = peak_gigabytes();
  return record;
}

double exact_tau() {
  SolveOptions options;
  options.method = Shooting{};
  const Solution solution = solve(reference_case(), options);
  if (!solution.verified()) {
    throw std::runtime_error("no verified reference: " + solution.message);
  }
  return solution.motion()->tau();
}

void print_head() {
  fmt::print("{:<28} {:>8} {:>8} {:>7} {:>6} {:>5} {:>6} {:>8}", "way", "nodes",
             "user s", "sys. s", "GB", "Ipopt", "Newton", "error");
  for (const Phase phase : kShown) fmt::print(" {:>13}", name(phase));
  fmt::print("\n");
}

void print(const Run& run) {
  const char* const way = kWays[run.way].name;
  if (!run.record) {
    fmt::print("{:<28} {:>8} {}\n", way, run.nodes, run.fate);
    return;
  }
  const Record& record = *run.record;
  fmt::print("{:<28} {:>8} {:>8.3f} {:>7.3f} {:>6.3f} {:>5} {:>6} {:>8.1e}",
             way, record.nodes, record.user_seconds, record.system_seconds,
             record.gigabytes, record.iterations, record.newton_steps,
             record.error);
  for (const Phase phase : kShown) {
    fmt::print(" {:>13.3f}", record.phases.of(phase));
  }
  fmt::print("{}\n", record.verified ? "" : " NOT VERIFIED");
  std::fflush(stdout);
}

std::vector<Run> measure(const std::vector<int>& sizes, int mumps_up_to,
                         unsigned limit) {
  std::vector<Task> tasks;
  for (const int size : sizes) {
    for (int way = 0; way < static_cast<int>(std::size(kWays)); ++way) {
      if (kWays[way].linear_solver == LinearSolver::Mumps &&
          size > mumps_up_to) {
        continue;
      }
      tasks.push_back({way, size});
    }
  }
  const double exact = exact_tau();
  std::vector<Run> runs;
  run_isolated<Record>(
      static_cast<int>(tasks.size()), {.jobs = 1, .seconds = limit},
      [&](int i) { return run(tasks[static_cast<std::size_t>(i)], exact); },
      [&](int i, const std::optional<Record>& record, const std::string& fate) {
        const Task& task = tasks[static_cast<std::size_t>(i)];
        runs.push_back({task.way, task.nodes, record, fate});
        print(runs.back());
      });
  return runs;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Cost of a solve against the size of its mesh");
  std::vector<int> sizes{100, 1'000, 10'000, 100'000};
  int mumps_up_to = 100'000;
  unsigned limit = 600;
  std::string from, out = "scaling";
  app.add_option("--sizes", sizes, "Numbers of nodes");
  app.add_option("--mumps-up-to", mumps_up_to,
                 "Largest number of nodes with MUMPS");
  app.add_option("--seconds", limit, "Limit for one solve");
  app.add_option("--from", from, "Measure nothing: draw the runs of FROM.csv");
  app.add_option("--out", out, "Write OUT.csv and the figure OUT_time.svg");
  CLI11_PARSE(app, argc, argv);

  print_head();
  std::vector<Run> runs;
  if (from.empty()) {
    runs = measure(sizes, mumps_up_to, limit);
  } else {
    runs = read_runs(from + ".csv");
    for (const Run& run : runs) print(run);
  }
  write_file(out + ".csv", csv(runs));
  write_figure(report::chart_figure(chart(runs, out + "_time")), out + "_time");
}
