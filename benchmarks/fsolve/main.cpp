// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The paper's discrete system, solved here and by the programs of others,
// beside rolling_time: speed against error, growth, and where ε ends it.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "fsolve/findings.hpp"
#include "fsolve/others.hpp"
#include "support/processes.hpp"
#include "support/scenes.hpp"
#include "support/table.hpp"

using namespace brachisto;
using namespace brachisto::benchmarks;

namespace {

using Datum = DiscreteReading::Datum;

struct Flags {
  std::vector<int> nodes{25, 50, 100, 200, 400};
  int step_nodes = 400;
  std::vector<double> steps{1e-2, 1e-3, 1e-4, 1e-5};
  std::vector<int> large{800, 1'600, 3'200, 6'400, 12'800};
  int largest_dense = 1'600;
  std::vector<int> rolling{100, 1'000, 10'000, 100'000};
  unsigned cap = 60;
  std::string from;
  std::string out = "fsolve";
};

Solution solve_reference(const Scene& scene) {
  SolveOptions options;
  options.method = Shooting{};
  Solution solution = solve(scene, options);
  if (!solution.verified()) {
    throw std::runtime_error("no verified reference: " + solution.message);
  }
  return solution;
}

/// Runs discrete tasks one after the other.
class Runner {
 public:
  Runner(const Scene& scene, double exact_tau, unsigned cap)
      : scene_(scene),
        exact_tau_(exact_tau),
        cap_(cap),
        octave_(find_octave()),
        scipy_(find_scipy()) {}

  [[nodiscard]] std::vector<std::string> versions() const {
    return {octave_ ? octave_->version : "GNU Octave: not installed, skipped",
            scipy_ ? scipy_->version
                   : "SciPy: not installed for any python3, skipped"};
  }

  [[nodiscard]] DiscretePoint point(const DiscreteTask& task) const {
    DiscreteRun run = run_task(task);
    if (run.solved()) run.error = std::abs(run.tau / exact_tau_ - 1.0);
    fmt::print(stderr, "{} {}, n = {}, ε = {:g}: ", name(task.arm),
               name(task.datum), task.nodes, task.epsilon);
    if (run.solved()) {
      fmt::print(stderr, "τ = {:.6f}, {:.3g} s\n", run.tau, run.cpu_seconds);
    } else if (run.outcome == DiscreteRun::Outcome::Capped) {
      fmt::print(stderr, "not done after {} s\n", cap_);
    } else {
      fmt::print(stderr, "{}\n", run.cause.str());
    }
    return {task, run};
  }

 private:
  [[nodiscard]] DiscreteRun run_task(const DiscreteTask& task) const {
    if (task.arm != Arm::Octave && task.arm != Arm::SciPy) {
      return run_capped(task);
    }
    const auto& other = task.arm == Arm::Octave ? octave_ : scipy_;
    if (other) return run_there(*other, scene_, task, cap_);
    DiscreteRun run;
    run.outcome = DiscreteRun::Outcome::Absent;
    run.cause = FixedText<200>("not installed");
    return run;
  }

  [[nodiscard]] DiscreteRun run_capped(const DiscreteTask& task) const {
    DiscreteRun run;
    run_isolated<DiscreteRun>(
        1, {.jobs = 1, .seconds = 0, .cpu_seconds = cap_},
        [&](int) { return run_here(scene_, task); },
        [&](int, const std::optional<DiscreteRun>& record,
            const std::string& fate) {
          if (record) {
            run = *record;
            return;
          }
          run.outcome = fate.starts_with("not done")
                            ? DiscreteRun::Outcome::Capped
                            : DiscreteRun::Outcome::Failed;
          run.cpu_seconds = cap_;
          run.cause = FixedText<200>(fate);
        });
    return run;
  }

  Scene scene_;
  double exact_tau_;
  unsigned cap_;
  std::optional<OtherProgram> octave_, scipy_;
};

void run_discrete(const Runner& runner, const Flags& flags,
                  FsolveFindings& found) {
  for (const Datum datum : {Datum::Rest, Datum::Release}) {
    for (const int nodes : flags.nodes) {
      for (const Arm arm :
           {Arm::Octave, Arm::SciPy, Arm::Hybrid, Arm::Newton, Arm::Lifted}) {
        found.arms.push_back(runner.point({arm, datum, nodes}));
      }
    }
  }
  for (const double step : flags.steps) {
    found.steps.push_back(
        runner.point({Arm::Hybrid, Datum::Rest, flags.step_nodes, step}));
  }
  for (const Arm arm : {Arm::Hybrid, Arm::Newton}) {
    for (const int nodes : flags.large) {
      if (nodes > flags.largest_dense) break;
      found.large.push_back(runner.point({arm, Datum::Rest, nodes}));
      // A larger one takes longer still.
      if (!found.large.back().run.solved()) break;
    }
  }
  for (const int nodes : flags.large) {
    for (const Datum datum : {Datum::Rest, Datum::Release}) {
      found.large.push_back(runner.point({Arm::Lifted, datum, nodes}));
    }
  }
  std::vector<int> all = flags.nodes;
  all.insert(all.end(), flags.large.begin(), flags.large.end());
  for (const int nodes : all) {
    found.large.push_back(runner.point({Arm::Simplified, Datum::Rest, nodes}));
    // On larger ones ε is longer still beside a chord.
    if (!found.large.back().run.solved()) break;
  }
}

void run_rolling(const Scene& scene, const Flags& flags,
                 FsolveFindings& found) {
  fmt::print(stderr, "rolling_time\n");
  found.menu = rolling_menu(scene, found.exact_tau);
  constexpr int kDegree = 5;
  for (const ProgramSolver method :
       {ProgramSolver::Ipopt, ProgramSolver::NewtonKkt}) {
    for (const int nodes : flags.rolling) {
      found.growth.push_back(time_whole(
          scene, on_mesh(method, kDegree, nodes / kDegree), found.exact_tau));
    }
  }
  for (const double tolerance : {1e-3, 1e-6, 1e-8, 1e-10, 1e-12}) {
    SolveOptions options;
    options.use<Collocation>().discretisation.tolerance = tolerance;
    found.wanted.push_back(time_whole(scene, options, found.exact_tau));
    found.tolerances.push_back(tolerance);
  }
}

int run(const Flags& flags) {
  // As the programs here: one thread each.
  ::setenv("OMP_NUM_THREADS", "1", 1);
  ::setenv("OPENBLAS_NUM_THREADS", "1", 1);
  const Scene scene = testing::off_centred_scene();
  const Solution reference = solve_reference(scene);
  FsolveFindings found;
  found.cap = flags.cap;
  found.exact_tau = reference.motion()->tau();
  found.exact_error = reference.estimated_error.value_or(0.0);
  const Runner runner(scene, found.exact_tau, flags.cap);
  found.others = runner.versions();
  run_discrete(runner, flags, found);
  run_rolling(scene, flags, found);
  const std::string text = benchmarks::report(found);
  fmt::print("{}", text);
  write_file(flags.out + ".md", text);
  write_file(flags.out + ".csv", csv(found));
  write_file(flags.out + ".json", origin_json(found));
  write_charts(found, flags.out);
  return 0;
}

/// The CSV file is written too: it is the one that was read if nothing was
/// lost.
int draw_again(const Flags& flags) {
  const FsolveFindings found = read_findings(flags.from);
  write_file(flags.out + ".csv", csv(found));
  write_charts(found, flags.out);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Flags flags;
  CLI::App app("The approach of the paper beside rolling_time");
  app.add_option("--nodes", flags.nodes, "n of every arm, on both data")
      ->capture_default_str();
  app.add_option("--step-nodes", flags.step_nodes, "n on which ε is varied")
      ->capture_default_str();
  app.add_option("--steps", flags.steps, "These ε")->capture_default_str();
  app.add_option("--large", flags.large, "Further n, datum rest")
      ->capture_default_str();
  app.add_option("--largest-dense", flags.largest_dense,
                 "Of these, for arms with dense matrices")
      ->capture_default_str();
  app.add_option("--rolling", flags.rolling, "Nodes of rolling_time, degree 5")
      ->capture_default_str();
  app.add_option("--seconds", flags.cap, "Processor time of a solve, at most")
      ->capture_default_str();
  app.add_option("--out", flags.out, "OUT.md, OUT.csv, OUT.json and figures")
      ->capture_default_str();
  app.add_option("--from", flags.from,
                 "Measure nothing: draw the run of FROM.csv and FROM.json");
  CLI11_PARSE(app, argc, argv);
  return flags.from.empty() ? run(flags) : draw_again(flags);
}
