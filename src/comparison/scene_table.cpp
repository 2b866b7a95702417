// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "comparison/scene_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "brachisto/io/problem_file.hpp"
#include "comparison/comparison_text.hpp"
#include "comparison/statistics.hpp"

namespace brachisto::comparison {

namespace {

/// "verified", or what it is instead.
std::string verdict(const Measurement& run) {
  if (!run.solved()) return name(run.outcome);
  return run.verified ? "verified" : "NOT VERIFIED";
}

std::string tau_of(const Measurement& run) {
  if (!run.solved() || !run.verified) return "—";
  return report::with_error(run.tau,
                            run.estimated_error.value_or(0.0) * run.tau);
}

}  // namespace

std::vector<SolvedScene> solve_scenes(const std::vector<std::string>& files,
                                      const std::vector<std::string>& overrides,
                                      double seconds, const Hooks& hooks) {
  std::ranges::for_each(files, check_named);
  std::vector<SolvedScene> out;
  for (const std::string& file : files) {
    if (hooks.announce) {
      hooks.announce(
          fmt::format("{} of {}: {}", out.size() + 1, files.size(), file));
    }
    Measurement run;
    try {
      const io::ProblemFile problem = io::read_problem_file(file, overrides);
      run = measure({.file = file,
                     .overrides = overrides,
                     .options = problem.options,
                     .seconds = seconds},
                    hooks.interrupt);
    } catch (const io::InputError& error) {
      run.outcome = Measurement::Outcome::Refused;
      run.cause = io::to_string(error.diagnostics().front());
    }
    out.push_back({file, std::move(run)});
  }
  return out;
}

std::string summary(const std::vector<SolvedScene>& scenes,
                    report::TableForm form) {
  report::Rows rows{{"scene", "τ", "verdict", "iterations", "unknowns",
                     "processor time [s]", "memory"}};
  for (const auto& [file, run] : scenes) {
    rows.push_back(
        {std::filesystem::path(file).stem().string(), tau_of(run), verdict(run),
         iterations_text(run), report::or_dash(run.unknowns),
         run.cpu.empty() ? "—"
                         : report::seconds_text(spread_of(run.cpu).median),
         report::memory_text(run.peak_memory)});
  }
  std::string out = report::table(rows, form);
  const auto verified =
      std::ranges::count_if(scenes, [](const SolvedScene& scene) {
        return scene.run.solved() && scene.run.verified;
      });
  out += fmt::format("\n{} of {} verified\n", verified, scenes.size());
  for (const auto& [file, run] : scenes) {
    if (run.cause.empty()) continue;
    out += fmt::format("{}: {}\n", std::filesystem::path(file).stem().string(),
                       run.cause);
  }
  return out;
}

std::string to_json(const std::vector<SolvedScene>& scenes) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const auto& [file, run] : scenes) {
    nlohmann::ordered_json row = {{"file", file}};
    row.update(document_of(run));
    rows.push_back(std::move(row));
  }
  return rows.dump(2) + "\n";
}

}  // namespace brachisto::comparison
