// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The same nonlinear programs, from the same start to the same tolerance, by
// this program's Newton's method and chain, by Ipopt with the chain, by Ipopt
// with MUMPS, and by Ipopt with MUMPS from their .nl files, with the automatic
// derivatives of the AMPL Solver Library. Each solve runs in a process of its
// own, and one after the other.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "peers/measurement.hpp"
#include "peers/nl_program.hpp"
#include "support/processes.hpp"
#include "support/scratch_directory.hpp"
#include "support/table.hpp"

namespace {

using namespace brachisto;
using namespace brachisto::benchmarks;

struct Flags {
  std::vector<int> sizes{100, 1'000, 10'000, 100'000};
  int repeats = 5;
  int tried = 10'000;
  unsigned limit = 120;
  std::string from;
  std::string out = "peers";
};

const char* name_of(Formulation formulation) {
  return formulation == Formulation::ArcLength ? "arc_length" : "rolling_time";
}

/// Runs everything, each piece of work in a process.
class Runner {
 public:
  explicit Runner(const Flags& flags)
      : flags_(flags), reference_(ReferenceCase::make()) {}

  /// MUMPS with one set of options after the other: a row each. The quickest
  /// are those of measure().
  std::string try_options() {
    std::string text = "formulation,nodes,options,solved,iterations,seconds\n";
    for (const int way : {2, 6}) text += try_options(way);
    return text;
  }

  std::vector<Run> measure() {
    std::vector<Run> runs;
    for (const int nodes : flags_.sizes) {
      for (int first : {0, 4}) write(kWays[first].formulation, nodes);
      // In turns, so that a busy moment is not that of one alone.
      std::map<int, std::vector<Record>> records;
      std::map<int, std::string> fates;
      for (int i = 0; i < flags_.repeats; ++i) {
        for (int way = 0; way < static_cast<int>(std::size(kWays)); ++way) {
          if (kWays[way].peer == Peer::IpoptMumpsNl && !reads_nl_files()) {
            continue;
          }
          std::string fate;
          const auto record =
              once(way, nodes, best_[kWays[way].formulation], fate);
          if (record) records[way].push_back(*record);
          if (!record) fates[way] = fate;
        }
      }
      for (int way = 0; way < static_cast<int>(std::size(kWays)); ++way) {
        if (!records.contains(way) && !fates.contains(way)) continue;
        Run run{way, nodes, flags_.repeats, std::nullopt, fates[way]};
        if (fates[way].empty()) run.record = median(records[way]);
        runs.push_back(std::move(run));
      }
    }
    return runs;
  }

 private:
  std::string try_options(int way) {
    const char* const formulation = name_of(kWays[way].formulation);
    std::string text;
    double least = INFINITY;
    MumpsOptions& best = best_[kWays[way].formulation];
    const auto attempt = [&](const MumpsOptions& options) {
      std::string fate;
      const auto record = once(way, flags_.tried, options, fate);
      const bool solved = record && record->solved;
      const std::string row = fmt::format(
          "{},{},\"{}\",{}\n", formulation, flags_.tried, options.str(),
          solved ? fmt::format("true,{},{:.3g}", record->iterations,
                               record->solve_seconds)
                 : "false,,");
      fmt::print("{}", row);
      std::fflush(stdout);
      text += row;
      if (!solved || record->solve_seconds >= least) return;
      least = record->solve_seconds;
      best = options;
    };
    // The order first, then what goes on within it.
    for (const PivotOrder& order : kPivotOrders) attempt({order.number, 0, 0});
    const MumpsOptions plain = best;
    MumpsOptions other = plain;
    other.permuting_scaling = 7;
    attempt(other);
    other.scaling = 77;
    attempt(other);
    for (const double tolerance : {1e-8, 1e-4}) {
      other = plain;
      other.pivot_tolerance = tolerance;
      attempt(other);
    }
    fmt::print("taken: {}\n", best.str());
    return text;
  }

  std::optional<Record> once(int way, int nodes, const MumpsOptions& mumps,
                             std::string& fate) const {
    std::optional<Record> out;
    run_isolated<Record>(
        1, limits(),
        [&](int) {
          return benchmarks::measure(reference_, kWays[way], nodes,
                                     file_of(kWays[way].formulation), mumps);
        },
        [&](int, const std::optional<Record>& record, const std::string& why) {
          out = record;
          fate = why;
        });
    return out;
  }

  /// Writes the .nl file, in a process of its own, and compares it.
  void write(Formulation formulation, int nodes) const {
    if (!reads_nl_files()) return;
    run_isolated<double>(
        1, limits(),
        [&](int) {
          const std::filesystem::path file = file_of(formulation);
          PeerProgram(reference_, formulation, nodes).write(file);
          return difference_of_hessians(reference_, formulation, nodes, file);
        },
        [&](int, const std::optional<double>& difference,
            const std::string& fate) {
          fmt::print("{}, {} nodes, .nl: second derivatives differ by {}\n",
                     name_of(formulation), nodes,
                     difference ? fmt::format("{:.1e}", *difference) : fate);
          std::fflush(stdout);
        });
  }

  [[nodiscard]] ProcessLimits limits() const {
    // Other work may stretch it so much.
    constexpr unsigned kStretched = 20;
    return {.jobs = 1,
            .seconds = kStretched * flags_.limit,
            .cpu_seconds = flags_.limit};
  }

  [[nodiscard]] std::filesystem::path file_of(Formulation formulation) const {
    return scratch_.path() / fmt::format("{}.nl", name_of(formulation));
  }

  const Flags& flags_;
  ReferenceCase reference_;
  std::map<Formulation, MumpsOptions> best_;
  testing::ScratchDirectory scratch_;
};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("The same programs, solved by peers");
  Flags flags;
  app.add_option("--sizes", flags.sizes, "Numbers of nodes");
  app.add_option("--repeats", flags.repeats, "Of each solve")
      ->check(CLI::PositiveNumber);
  app.add_option("--try", flags.tried,
                 "Number of nodes on which options of MUMPS are tried");
  app.add_option("--seconds", flags.limit,
                 "Limit for one solve, of processor time");
  app.add_option("--from", flags.from,
                 "Measure nothing: draw the runs of FROM.csv");
  app.add_option("--out", flags.out,
                 "Write OUT.csv, OUT_mumps.csv and the figure OUT_time.svg");
  CLI11_PARSE(app, argc, argv);

  std::vector<Run> runs;
  if (flags.from.empty()) {
    fmt::print("{}.\n", machine());
    if (!reads_nl_files()) {
      fmt::print(
          "The AMPL Solver Library was missing when this was built (Debian: "
          "libamplsolver-dev): .nl files are left out.\n");
    }
    Runner runner(flags);
    write_file(flags.out + "_mumps.csv", runner.try_options());
    runs = runner.measure();
  } else {
    runs = read_runs(flags.from + ".csv");
  }
  fmt::print("{}", markdown(runs));
  write_file(flags.out + ".csv", csv(runs));
  write_figure(report::chart_figure(chart(runs, flags.out + "_time")),
               flags.out + "_time");
}
