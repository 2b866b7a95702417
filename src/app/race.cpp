// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto race FILE…: bodies that start together, each on its own track or
// all on one.

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "app/exit_code.hpp"
#include "app/signals.hpp"
#include "app/solution_output.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "brachisto/io/problem_file.hpp"
#include "brachisto/math/clock.hpp"
#include "brachisto/report/result.hpp"
#include "brachisto/study/solve.hpp"
#include "io/visible_text.hpp"
#include "plot/race_page.hpp"
#include "plot/racers.hpp"
#include "report/text_table.hpp"

namespace brachisto::app {

namespace {

namespace fs = std::filesystem;
using plot::Racer;

struct RaceFlags {
  std::vector<std::string> files;
  std::string out;
  std::vector<std::string> overrides;
  bool same_track = false;
  bool force = false;
  bool quiet = false;
};

/// On a track that is a spline times are exact to some 1e-6 of them at the
/// worst.
void print_arrivals(const std::vector<Racer>& racers, bool same_track) {
  report::Rows rows{{"", "body", "T [s]", "behind [ms]", ""}};
  for (std::size_t i = 0; i < racers.size(); ++i) {
    const report::Json& result = racers[i].result;
    const double T = result.at("transit_time").get<double>();
    rows.push_back(
        {fmt::format("{}", i + 1), racers[i].name,
         same_track ? fmt::format("{:.7g}", T) : fmt::format("{:.9f}", T),
         behind(racers[0], racers[i]),
         result.at("feasible") == true ? "" : "infeasible"});
  }
  print(report::text_table(rows));
}

int run(const RaceFlags& flags) {
  if (flags.files.size() < plot::kFewestRacers ||
      flags.files.size() > plot::kMostRacers) {
    throw UsageError("brachisto race",
                     fmt::format("{} to {} problem files can race, not {}",
                                 plot::kFewestRacers, plot::kMostRacers,
                                 flags.files.size()));
  }
  const fs::path out = flags.out;
  const fs::path directory = out.has_parent_path() ? out.parent_path() : ".";
  const std::string page = out.filename().string();
  report::check_writable(directory, {page}, flags.force);
  const std::vector<std::string> racer_names = plot::racer_names(flags.files);
  // All files are read before the first one is solved.
  std::vector<io::ProblemFile> problems;
  for (const std::string& file : flags.files) {
    problems.push_back(io::read_problem_file(file, flags.overrides));
    warn_of(problems.back());
    if (flags.same_track) {
      if (problems.size() == 1) plot::check_track(file, problems[0].scene);
      plot::check_finish(file, problems.back().scene, racer_names.front(),
                         problems.front().scene);
    }
  }

  const std::atomic<int>& signal = catch_signals();
  std::vector<Racer> racers;
  std::shared_ptr<const GivenPath> track;  // of the first, if it is that of all
  for (std::size_t i = 0; i < problems.size(); ++i) {
    const std::string& file = flags.files[i];
    if (flags.same_track && i > 0) {
      problems[i].scene = plot::on_track(problems[i].scene, track);
    }
    const Solution solution =
        solve_in_time(problems[i], false, {.interrupt = &signal});
    if (!solution.verified()) {
      tell(fmt::format("brachisto: {}: {}\n", file, complaint(solution)));
      return exit_code(solution, signal.load());
    }
    if (flags.same_track && i == 0) track = plot::track_of(solution);
    racers.push_back(plot::racer_of(racer_names[i], solution));
    plot::check_ends(file, racers.front(), racers.back());
  }
  const std::string html = [&] {
    const StopScope scope{StopCondition(&signal)};
    return plot::race_page(racers, flags.same_track);
  }();
  report::write_files(directory, {{page, html}}, flags.force);
  if (!flags.quiet) {
    print_arrivals(plot::in_order_of_arrival(std::move(racers)),
                   flags.same_track);
    print(io::visible(out.string()) + "\n");
  }
  return kSuccess;
}

}  // namespace

Verb race_verb() {
  const auto flags = std::make_shared<RaceFlags>();
  return {.name = "race",
          .text =
              "Let several bodies start together, each on its own track or all "
              "on one: a page with clocks, on which the first may be guessed",
          .flags = {{.name = "FILE",
                     .value = &flags->files,
                     .text = "Problem files (YAML), named after what they are; "
                             "with the same A and B",
                     .check = not_empty(),
                     .required = true},
                    {.name = "--out",
                     .value = &flags->out,
                     .text = "Write the page there, race.html",
                     .placeholder = "PAGE",
                     .check = not_empty(),
                     .required = true},
                    {.name = "--set",
                     .value = &flags->overrides,
                     .text = "Replace a value of all files, such as "
                             "scene.finish.L=4",
                     .placeholder = "KEY=VALUE"},
                    {"--same-track", &flags->same_track,
                     "Let all run on the track of the first file"},
                    {"--force", &flags->force, "Replace an existing page"},
                    {"--quiet", &flags->quiet, "Do not print the order"}},
          .footer =
              R"(Example:
  brachisto race problems/race/*.yaml --out race.html
With --same-track limits and paths of the other files do not count.
Bodies that would lift off race too and are marked. Exit codes: 0
written, 3 bad input file, 6 I/O; of a scene that fails, which is told,
those of solve, and nothing is written.)",
          .run = [flags] { return run(*flags); }};
}

}  // namespace brachisto::app
