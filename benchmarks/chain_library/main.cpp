// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// libbrachisto-chain.so against MUMPS under an Ipopt that is used through its C
// interface, on programs that are not this project's. Each solve runs in a
// process of its own, both solvers in turn. Times are those of Ipopt and its
// linear solver, without the evaluation of the programs.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "brachisto/math/index.hpp"
#include "chain_library/separable_program.hpp"
#include "process/child_process.hpp"

namespace {

using namespace brachisto;
using namespace brachisto::benchmarks;

struct Row {
  ProgramRun run;
  double megabytes = 0.0;
  std::string said;  ///< on stderr
  bool ended = false;
};

Row run_apart(const std::string& family, const std::string& solver, int size,
              double seconds) {
  const ChildRun child = run_child(
      "/proc/self/exe",
      {"--one", family, "--solver", solver, "--size", fmt::format("{}", size)},
      seconds, nullptr);
  Row row;
  row.said = child.err.substr(0, child.err.find('\n'));
  row.megabytes = child.peak_memory * 1e-6;
  row.ended =
      child.end == ChildRun::End::Exited && child.code == 0 &&
      std::sscanf(child.out.c_str(), "%d %d %lf %lf", &row.run.status,
                  &row.run.iterations, &row.run.cost, &row.run.cpu) == 4;
  return row;
}

std::string in_words(const Row& row) {
  if (!row.ended) return "not done";
  return fmt::format("{} in {:.2f} s, {:.0f} MB", row.run.iterations,
                     row.run.cpu, row.megabytes);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("The chain library against MUMPS, on programs of others");
  std::string one, solver = "mumps";
  int size = 1000;
  double seconds = 300.0;
  std::vector<int> sizes{1'000, 10'000, 100'000, 1'000'000};
  app.add_option("--one", one, "Solve one family and print how it ended");
  app.add_option("--solver", solver, "Of --one: mumps or ma97");
  app.add_option("--size", size, "Of --one: variables, at least");
  app.add_option("--sizes", sizes, "Numbers of variables, at least");
  app.add_option("--seconds", seconds, "For each solve");
  CLI11_PARSE(app, argc, argv);
  if (!one.empty()) {
    const ProgramRun run = solve(make_program(one, size), solver);
    std::printf("%d %d %.15g %.4f\n", run.status, run.iterations, run.cost,
                run.cpu);
    return 0;
  }

  std::printf(
      "| family | variables | MUMPS | chain | cost differs by | "
      "growth |\n| --- | --- | --- | --- | --- | --- |\n");
  for (const std::string& family : chain_families()) {
    double before = 0.0;
    for (const int n : sizes) {
      const Row chain = run_apart(family, "ma97", n, seconds);
      const Row mumps = run_apart(family, "mumps", n, seconds);
      // Of the time for one iteration, between this size and the one before.
      const double each = chain.run.cpu / (chain.run.iterations + 1);
      const std::string growth =
          before > 0.0 && chain.ended
              ? fmt::format("{:.2f}", std::log10(each / before))
              : "";
      before = chain.ended ? each : 0.0;
      std::printf(
          "| %s | %d | %s | %s | %s | %s |\n", family.c_str(), n,
          in_words(mumps).c_str(), in_words(chain).c_str(),
          chain.ended && mumps.ended
              ? fmt::format("{:.0e}",
                            std::abs(chain.run.cost / mumps.run.cost - 1.0))
                    .c_str()
              : "",
          growth.c_str());
      std::fflush(stdout);
    }
  }
  std::printf(
      "\n| without a chain | status | what it says |\n"
      "| --- | --- | --- |\n");
  for (const std::string& family : other_families()) {
    const int n = family == "cube" ? 64'000 : 4'000;
    const Row row = run_apart(family, "ma97", n, seconds);
    std::printf("| %s | %d | %s |\n", family.c_str(), row.run.status,
                row.said.empty() ? "solves it" : row.said.c_str());
  }
}
