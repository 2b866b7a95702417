// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto table FILE…: many scenes, a row each.

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "app/exit_code.hpp"
#include "app/signals.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "brachisto/io/problem_file.hpp"
#include "comparison/comparison_text.hpp"
#include "comparison/statistics.hpp"

namespace brachisto::app {

namespace {

using comparison::Measurement;
using Json = nlohmann::ordered_json;

struct TableFlags {
  std::vector<std::string> files, overrides;
  double seconds = 60.0;
  bool json = false, quiet = false, markdown = false;
};

struct SolvedScene {
  std::string file;
  Measurement run;

  [[nodiscard]] bool verified() const { return run.solved() && run.verified; }
  [[nodiscard]] std::string name() const {
    return std::filesystem::path(file).stem().string();
  }
};

/// Each in a process of its own, one after the other, by the method that its
/// file asks for. All files are read before the first is solved. One with
/// mistakes is refused.
std::vector<SolvedScene> solve_scenes(const TableFlags& flags) {
  const std::atomic<int>& signal = catch_signals();
  const auto announce = progress_lines(flags.quiet);
  std::ranges::for_each(flags.files, comparison::check_named);
  std::vector<SolvedScene> out;
  std::vector<SolveOptions> options(flags.files.size());
  for (const std::string& file : flags.files) {
    Measurement& run = out.emplace_back(file, Measurement{}).run;
    try {
      options[out.size() - 1] =
          io::read_problem_file(file, flags.overrides).options;
    } catch (const io::InputError& error) {
      run.outcome = Measurement::Outcome::Refused;
      run.cause = io::to_string(error.diagnostics().front());
    }
  }
  for (std::size_t i = 0; i < out.size(); ++i) {
    auto& [file, run] = out[i];
    announce(fmt::format("{} of {}: {}", i + 1, out.size(), file));
    if (run.outcome == Measurement::Outcome::Refused) continue;
    run = comparison::measure({.file = file,
                               .overrides = flags.overrides,
                               .options = options[i],
                               .seconds = flags.seconds},
                              &signal);
  }
  return out;
}

/// A row for each scene, and how many are verified.
std::string summary(const std::vector<SolvedScene>& scenes,
                    report::TableForm form) {
  report::Rows rows{{"scene", "τ", "verdict", "iterations", "unknowns",
                     "processor time [s]", "memory"}};
  for (const SolvedScene& scene : scenes) {
    const Measurement& run = scene.run;
    rows.push_back(
        {scene.name(),
         scene.verified()
             ? report::with_error(run.tau,
                                  run.estimated_error.value_or(0.0) * run.tau)
             : "—",
         !run.solved()  ? name(run.outcome)
         : run.verified ? "verified"
                        : "NOT VERIFIED",
         comparison::iterations_text(run), report::or_dash(run.unknowns),
         run.cpu.empty()
             ? "—"
             : report::seconds_text(comparison::spread_of(run.cpu).median),
         report::memory_text(run.peak_memory)});
  }
  std::string out = report::table(rows, form);
  out += fmt::format("\n{} of {} verified\n",
                     std::ranges::count_if(scenes, &SolvedScene::verified),
                     scenes.size());
  for (const SolvedScene& scene : scenes) {
    if (scene.run.cause.empty()) continue;
    out += fmt::format("{}: {}\n", scene.name(), scene.run.cause);
  }
  return out;
}

std::string document_of(const std::vector<SolvedScene>& scenes) {
  Json rows = Json::array();
  for (const auto& [file, run] : scenes) {
    Json& row = rows.emplace_back(Json{{"file", file}});
    row.update(comparison::document_of(run));
  }
  return rows.dump(2) + "\n";
}

int run(const TableFlags& flags) {
  const std::vector<SolvedScene> scenes = solve_scenes(flags);
  if (flags.json) {
    print_data(document_of(scenes));
  } else {
    print(summary(scenes, flags.markdown ? report::TableForm::Markdown
                                         : report::TableForm::Text));
  }
  return kSuccess;
}

}  // namespace

Verb table_verb() {
  const auto flags = std::make_shared<TableFlags>();
  return {
      .name = "table",
      .text = "Solve many scenes, a row each: time, verdict, cost",
      .flags = {{.name = "FILE",
                 .value = &flags->files,
                 .text = "Problem files (YAML)",
                 .check = not_empty(),
                 .required = true},
                {.name = "--set",
                 .value = &flags->overrides,
                 .text = "Replace a value of all files, such as "
                         "solver.guess=straight",
                 .placeholder = "KEY=VALUE"},
                {.name = "--seconds",
                 .value = &flags->seconds,
                 .text = "Wall-clock limit of each scene",
                 .placeholder = "S",
                 .check = seconds(),
                 .shows_default = true},
                {"--json", &flags->json, "Print one JSON document"},
                markdown_flag(flags->markdown),
                {"--quiet", &flags->quiet, "Do not tell what is solved next"}},
      .footer =
          R"(Every scene is solved in a process of its own, by the method that its
file asks for. One that fails or is refused is a row, with the reason
below the table.
Example:
  brachisto table problems/hard/*.yaml
Exit codes: 0 if there is a table, whatever stands in it, 6 I/O, 130/143
after SIGINT/SIGTERM.)",
      .run = [flags] { return run(*flags); }};
}

}  // namespace brachisto::app
