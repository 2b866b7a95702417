// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What a solve costs as the mesh grows: both formulations, the chain
// factorisation beside MUMPS, Newton's method beside Ipopt. Each solve, from
// the scene to the certificate, runs in a process of its own.

#include <fmt/format.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "brachisto/math/phase_clock.hpp"
#include "brachisto/study/solve.hpp"
#include "report/chart.hpp"
#include "support/power_law.hpp"
#include "support/processes.hpp"
#include "support/table.hpp"

namespace {

using namespace brachisto;

/// A way to solve, in words and as options.
struct Way {
  const char* name;
  Formulation formulation;
  ProgramSolver method;
  LinearSolver linear_solver;
};

constexpr Way kWays[] = {
    {"rolling_time, Newton, chain", Formulation::RollingTime,
     ProgramSolver::NewtonKkt, LinearSolver::Chain},
    {"rolling_time, Ipopt, chain", Formulation::RollingTime,
     ProgramSolver::Ipopt, LinearSolver::Chain},
    {"rolling_time, Ipopt, MUMPS", Formulation::RollingTime,
     ProgramSolver::Ipopt, LinearSolver::Mumps},
    {"arc_length, Newton, chain", Formulation::ArcLength,
     ProgramSolver::NewtonKkt, LinearSolver::Chain},
    {"arc_length, Ipopt, chain", Formulation::ArcLength, ProgramSolver::Ipopt,
     LinearSolver::Chain},
    {"arc_length, Ipopt, MUMPS", Formulation::ArcLength, ProgramSolver::Ipopt,
     LinearSolver::Mumps}};

/// The phases that the table shows; the CSV has all.
constexpr Phase kShown[] = {Phase::SetUp,         Phase::Evaluation,
                            Phase::Factorisation, Phase::Solution,
                            Phase::Ipopt,         Phase::Certificate};

/// One solve to be measured.
struct Task {
  int way;
  int nodes;
};

/// What it came to; copied between processes byte by byte.
struct Record {
  bool verified;
  int nodes, iterations, newton_steps;
  double tau, estimated_error;
  double user_seconds, system_seconds;  ///< the whole process
  PhaseSeconds phases;                  ///< user and system, of solve()
  double gigabytes;                     ///< peak
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

Record run(const Task& task) {
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
  record.estimated_error = solution.estimated_error.value_or(NAN);
  record.phases = solution.effort.phases;
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  record.user_seconds = seconds(usage.ru_utime);
  record.system_seconds = seconds(usage.ru_stime);
  record.gigabytes = 1024e-9 * static_cast<double>(usage.ru_maxrss);
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

void write(const std::string& name, const std::string& content) {
  std::ofstream out(name);
  out << content;
  if (!out.flush()) throw std::runtime_error(name + ": cannot be written");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Cost of a solve against the size of its mesh");
  std::vector<int> sizes{100, 1'000, 10'000, 100'000};
  int mumps_up_to = 100'000;
  unsigned limit = 600;
  std::string out = "scaling";
  app.add_option("--sizes", sizes, "Numbers of nodes");
  app.add_option("--mumps-up-to", mumps_up_to,
                 "Largest number of nodes with MUMPS");
  app.add_option("--seconds", limit, "Limit for one solve");
  app.add_option("--out", out, "Write OUT.csv, OUT.svg and OUT.gp");
  CLI11_PARSE(app, argc, argv);

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
  std::string csv =
      "way,nodes,verified,user_seconds,system_seconds,gigabytes,"
      "ipopt_iterations,newton_steps,tau,error,estimated_error,";
  for (std::size_t i = 0; i < kNumPhases; ++i) {
    csv += fmt::format("{},", name(static_cast<Phase>(i)));
  }
  csv += "fate\n";
  std::vector<std::vector<report::Datum>> curves(std::size(kWays));
  fmt::print("{:<28} {:>8} {:>8} {:>7} {:>6} {:>5} {:>6} {:>8}", "way", "nodes",
             "user s", "sys. s", "GB", "Ipopt", "Newton", "error");
  for (const Phase phase : kShown) fmt::print(" {:>13}", name(phase));
  fmt::print("\n");
  benchmarks::run_isolated<Record>(
      static_cast<int>(tasks.size()), {.jobs = 1, .seconds = limit},
      [&](int i) { return run(tasks[static_cast<std::size_t>(i)]); },
      [&](int i, const std::optional<Record>& record, const std::string& fate) {
        const Task& task = tasks[static_cast<std::size_t>(i)];
        const Way& way = kWays[task.way];
        if (!record) {
          fmt::print("{:<28} {:>8} {}\n", way.name, task.nodes, fate);
          csv += fmt::format("\"{}\",{}{}{}\n", way.name, task.nodes,
                             std::string(10 + kNumPhases, ','), fate);
          return;
        }
        const double error = record->tau / exact - 1.0;
        fmt::print(
            "{:<28} {:>8} {:>8.3f} {:>7.3f} {:>6.3f} {:>5} {:>6} {:>8.1e}",
            way.name, record->nodes, record->user_seconds,
            record->system_seconds, record->gigabytes, record->iterations,
            record->newton_steps, error);
        for (const Phase phase : kShown) {
          fmt::print(" {:>13.3f}", record->phases.of(phase));
        }
        fmt::print("{}\n", record->verified ? "" : " NOT VERIFIED");
        std::fflush(stdout);
        csv += fmt::format(
            "\"{}\",{},{},{:.4g},{:.4g},{:.4g},{},{},{:.15g},"
            "{:.2e},{:.2e},",
            way.name, record->nodes, record->verified, record->user_seconds,
            record->system_seconds, record->gigabytes, record->iterations,
            record->newton_steps, record->tau, error, record->estimated_error);
        for (const double phase : record->phases.seconds) {
          csv += fmt::format("{:.3g},", phase);
        }
        csv += "\n";
        if (record->verified) {
          curves[static_cast<std::size_t>(task.way)].push_back(
              {static_cast<double>(record->nodes), record->user_seconds});
        }
      });

  report::Chart chart;
  chart.name = out.substr(out.find_last_of('/') + 1);
  chart.title = "Cost of a solve against the size of its mesh";
  chart.x.label = "nodes";
  chart.x.scale = report::Scale::Logarithmic;
  chart.y.label = "user CPU time of the process [s]";
  chart.y.scale = report::Scale::Logarithmic;
  constexpr report::Mark kMarks[] = {
      report::Mark::Disc,   report::Mark::Square,  report::Mark::Triangle,
      report::Mark::Circle, report::Mark::Diamond, report::Mark::Cross};
  const std::vector<std::string> colours =
      report::family_colours(std::size(kWays));
  for (std::size_t w = 0; w < std::size(kWays); ++w) {
    std::vector<report::Datum> large;
    for (const report::Datum& point : curves[w]) {
      if (point.x > 5e3) large.push_back(point);
    }
    report::Curve curve;
    curve.name = kWays[w].name;
    std::replace(curve.name.begin(), curve.name.end(), '_', ' ');
    if (const auto law = benchmarks::fit_power(large)) {
      curve.name += fmt::format(" (n^{{{:.2f}}})", law->exponent);
      fmt::print("{}: n^{:.2f} from 1e4 on\n", kWays[w].name, law->exponent);
    }
    curve.id = kWays[w].name;
    curve.points = curves[w];
    curve.colour = colours[w];
    curve.mark = kMarks[w];
    curve.stroke = w < 3 ? report::Stroke::Solid : report::Stroke::Dashed;
    chart.curves.push_back(std::move(curve));
  }
  write(out + "_table.csv", csv);
  benchmarks::write_figure(report::chart_figure(chart), out);
}
