// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Every problem of problems/hard, judged by the criterion in its own comment.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "brachisto/io/problem_file.hpp"
#include "study/answer_kinds.hpp"
#include "support/criterion.hpp"
#include "support/csv.hpp"
#include "support/processes.hpp"
#include "support/table.hpp"
#include "support/text.hpp"

using namespace brachisto;
using namespace brachisto::benchmarks;

namespace {

/// What became of one file.
struct Row {
  bool passed = false, solved = false, verified = false, feasible = false;
  double seconds = 0.0, tau = 0.0, estimated_error = 0.0;
  int iterations = 0, newton_steps = 0, degree = 0, elements = 0, folds = 0;
  FixedText<500> objection;
};

Row run(const std::string& path) {
  const Criterion criterion = read_intent(path).criterion;
  Row row;
  const auto judge = [&](const std::string& objection) {
    row.passed = objection.empty();
    row.objection = FixedText<500>(objection);
    return row;
  };
  io::ProblemFile problem;
  try {
    problem = io::read_problem_file(path);
  } catch (const io::InputError& error) {
    return judge(objection(criterion, error.what()));
  }
  const Solution solution = solve(problem.scene, problem.options);
  row.solved = solution.status == Status::Solved;
  row.verified = solution.verified();
  row.feasible = solution.verified() && solution.feasible();
  row.seconds = solution.effort.seconds;
  row.iterations = solution.effort.iterations;
  row.newton_steps = solution.effort.newton_steps;
  row.folds = static_cast<int>(solution.folds.size());
  if (trajectory_of(solution)) {
    row.tau = solution.motion()->tau();
    row.estimated_error = solution.estimated_error.value_or(0.0);
    row.degree = trajectory_of(solution)->curve().mesh().degree;
    row.elements = trajectory_of(solution)->curve().mesh().num_elements();
  }
  return judge(objection(criterion, solution));
}

std::vector<std::string> cells(const std::string& path, const Row& row) {
  const auto if_solved = [&](std::string text) {
    return row.solved ? std::move(text) : std::string();
  };
  std::string verdict = row.passed ? "pass" : "FAIL: " + row.objection.str();
  return {std::filesystem::path(path).stem().string(),
          fmt::format("{:.3g}", row.seconds),
          std::to_string(row.iterations),
          std::to_string(row.newton_steps),
          if_solved(fmt::format("{} × {}", row.degree, row.elements)),
          if_solved(fmt::format("{:.0e}", row.estimated_error)),
          if_solved(fmt::format("{:.10g}", row.tau)),
          if_solved(row.verified ? "yes" : "no"),
          if_solved(row.feasible ? "yes" : "no"),
          read_intent(path).pass,
          std::move(verdict)};
}

std::string csv(const std::vector<std::string>& files,
                const std::vector<Row>& rows) {
  std::string text =
      "file,passed,seconds,iterations,newton_steps,degree,elements,folds,"
      "estimated_error,tau,solved,verified,feasible,criterion,objection\n";
  for (std::size_t i = 0; i < files.size(); ++i) {
    const Row& row = rows[i];
    text += fmt::format(
        "{},{:d},{:.4f},{},{},{},{},{},{:.3g},{:.15g},{:d},{:d},{:d},{},{}\n",
        std::filesystem::path(files[i]).filename().string(), row.passed,
        row.seconds, row.iterations, row.newton_steps, row.degree, row.elements,
        row.folds, row.estimated_error, row.tau, row.solved, row.verified,
        row.feasible, csv_field(read_intent(files[i]).pass),
        csv_field(row.objection.str()));
  }
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  std::string folder = BRACHISTO_SOURCE_DIR "/problems/hard";
  std::string out = BRACHISTO_SOURCE_DIR "/benchmarks/results/gallery.csv";
  std::string only;
  ProcessLimits limits{.jobs = 1, .seconds = 1800};
  CLI::App app{"Every hard problem, judged by its own pass criterion"};
  app.add_option("--folder", folder, "Of the problems")->capture_default_str();
  app.add_option("--only", only, "Part of the names of the files to run");
  app.add_option("--jobs", limits.jobs, "Processes at a time")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--seconds", limits.seconds, "For one problem, at most")
      ->capture_default_str();
  app.add_option("--out", out, "CSV file")->capture_default_str();
  CLI11_PARSE(app, argc, argv);

  const std::vector<std::string> files = problem_files(folder, only);

  std::vector<Row> rows(files.size());
  run_isolated<Row>(
      static_cast<int>(files.size()), limits,
      [&](int i) { return run(files[static_cast<std::size_t>(i)]); },
      [&](int i, const std::optional<Row>& row, const std::string& fate) {
        const auto at = static_cast<std::size_t>(i);
        if (row) {
          rows[at] = *row;
        } else {
          rows[at].objection = FixedText<500>(fate);
        }
      });

  Rows table{{"problem", "seconds", "iterations", "Newton steps", "mesh",
              "estimated", "τ", "verified", "feasible", "wanted", "verdict"}};
  for (std::size_t i = 0; i < files.size(); ++i) {
    table.push_back(cells(files[i], rows[i]));
  }
  const auto failed = std::count_if(rows.begin(), rows.end(),
                                    [](const Row& row) { return !row.passed; });
  fmt::print("{}\n\n{}\n{} of {} pass\n", machine(), markdown_table(table),
             static_cast<std::ptrdiff_t>(rows.size()) - failed, rows.size());
  write_file(out, csv(files, rows));
  return failed == 0 ? 0 : 1;
}
