// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Every problem of problems/limits_in_worlds by the nonlinear program, by the
// witness over the arcs of that, and by shooting; and Newton's and Euler's laws
// along the answer.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "brachisto/io/problem_file.hpp"
#include "brachisto/study/solve.hpp"
#include "support/csv.hpp"
#include "support/newton_euler.hpp"
#include "support/processes.hpp"
#include "support/table.hpp"
#include "support/text.hpp"

using namespace brachisto;
using namespace brachisto::benchmarks;

namespace {

/// Relative, of τ.
constexpr double kAgreement = 1e-9;

/// What became of one file. Differences are |τ/τ of the other − 1|.
struct Row {
  bool verified = false, witnessed = false, shot = false, feasible = false;
  double tau = 0.0, of_witness = 0.0, of_shooting = 0.0;
  double residual = 0.0, reintegration = 0.0, estimate = 0.0;
  double laws = 0.0;  ///< what they leave over, the largest
  double seconds = 0.0, shooting_seconds = 0.0;
  int checks = 0, passed = 0, arcs = 0;
  FixedText<300> failure;   ///< of the program or of its witness
  FixedText<300> shooting;  ///< why there is no answer by shooting
  FixedText<300> infeasible;

  [[nodiscard]] bool agreed() const {
    return verified && witnessed && of_witness <= kAgreement && shot &&
           of_shooting <= kAgreement;
  }
};

double value_of(const Solution& solution, const char* name) {
  const Check* check = solution.certificate.find(name);
  return check != nullptr ? check->value : std::nan("");
}

Row run(const std::string& path) {
  const io::ProblemFile problem = io::read_problem_file(path);
  SolveOptions options = problem.options;
  options.use<Collocation>().certify = Certify::Extremal;
  const Solution found = solve(problem.scene, options);
  options.method = Shooting{};
  const Solution other = solve(problem.scene, options);

  Row row;
  row.verified = found.verified();
  row.shot = other.verified();
  row.seconds = found.effort.seconds;
  row.shooting_seconds = other.effort.seconds;
  row.failure = FixedText<300>(why_not_verified(found));
  row.shooting = FixedText<300>(why_not_verified(other));
  row.checks = static_cast<int>(found.certificate.checks.size());
  row.passed = static_cast<int>(
      std::ranges::count_if(found.certificate.checks, &Check::passed));
  if (found.motion() == nullptr) return row;
  row.tau = found.motion()->tau();
  row.estimate = found.estimated_error.value_or(std::nan(""));
  row.residual = value_of(found, "kkt_residual");
  row.reintegration = value_of(found, "reintegration_error");
  row.laws =
      testing::left_over(*found.motion(), testing::rigid_body_of(problem.scene))
          .largest();
  for (const LimitOnPath& limit : found.limits) {
    row.arcs += static_cast<int>(limit.active.size());
  }
  if (found.extremal && found.extremal->solved) {
    row.witnessed = true;
    row.of_witness = found.extremal->difference;
  }
  if (row.shot) {
    row.of_shooting = std::abs(row.tau / other.motion()->tau() - 1.0);
  }
  row.feasible = found.verified() && found.feasible();
  if (!row.feasible && found.verified()) {
    row.infeasible = FixedText<300>(found.infeasible_because().front());
  }
  return row;
}

std::string stem(const std::string& path) {
  return std::filesystem::path(path).stem().string();
}

std::vector<std::string> cells(const std::string& path, const Row& row) {
  return {
      stem(path),
      row.verified ? fmt::format("{:.12f}", row.tau) : row.failure.str(),
      row.witnessed ? fmt::format("{:.1e}", row.of_witness) : "none",
      row.shot ? fmt::format("{:.1e}", row.of_shooting) : row.shooting.str(),
      fmt::format("{:.0e}", row.residual),
      fmt::format("{:.0e}", row.reintegration),
      fmt::format("{:.0e}", row.laws),
      fmt::format("{} of {}", row.passed, row.checks),
      row.feasible ? "yes" : row.infeasible.str()};
}

std::string csv_line(const std::string& path, const Row& row) {
  return fmt::format(
      "{},{:d},{},{},{},{:.15g},{:.2g},{:.2g},{:d},{:.2g},{:d},{:.2g},{:.2g},"
      "{:.2g},{:d},{:.3f},{:.3f},{},{},{}\n",
      stem(path), row.verified, row.passed, row.checks, row.arcs, row.tau,
      row.estimate, row.residual, row.witnessed, row.of_witness, row.shot,
      row.of_shooting, row.reintegration, row.laws, row.feasible, row.seconds,
      row.shooting_seconds, csv_field(row.failure.str()),
      csv_field(row.shooting.str()), csv_field(row.infeasible.str()));
}

}  // namespace

int main(int argc, char** argv) {
  std::string folder = BRACHISTO_SOURCE_DIR "/problems/limits_in_worlds";
  std::string out =
      BRACHISTO_SOURCE_DIR "/benchmarks/results/limited_worlds.csv";
  ProcessLimits limits{.jobs = 1, .seconds = 120};
  CLI::App app{"Limits in other worlds, by the program and by shooting"};
  app.add_option("--folder", folder, "Of the problems")->capture_default_str();
  app.add_option("--jobs", limits.jobs, "Processes at a time")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--seconds", limits.seconds, "For one problem, at most")
      ->capture_default_str();
  app.add_option("--out", out, "CSV file")->capture_default_str();
  CLI11_PARSE(app, argc, argv);

  const std::vector<std::string> files = problem_files(folder);

  std::vector<Row> rows(files.size());
  run_isolated<Row>(
      static_cast<int>(files.size()), limits,
      [&](int i) { return run(files[static_cast<std::size_t>(i)]); },
      [&](int i, const std::optional<Row>& row, const std::string& fate) {
        Row& here = rows[static_cast<std::size_t>(i)];
        if (row) {
          here = *row;
        } else {
          here.failure = FixedText<300>(fate);
          here.shooting = here.failure;
        }
      });

  Rows table{{"scene", "τ", "witness", "shooting", "residual",
              "integrated again", "laws", "checks", "can be rolled on"}};
  std::string csv =
      "scene,verified,checks_passed,checks,arcs,tau,estimated_error,"
      "kkt_residual,witnessed,of_witness,shot,of_shooting,reintegration_error,"
      "laws,feasible,seconds,shooting_seconds,failure,shooting_failure,"
      "infeasible\n";
  for (std::size_t i = 0; i < files.size(); ++i) {
    table.push_back(cells(files[i], rows[i]));
    csv += csv_line(files[i], rows[i]);
  }
  write_file(out, csv);
  const auto agreed = std::ranges::count_if(rows, &Row::agreed);
  fmt::print("{}\n\n{}\n{} of {} verified by both, τ the same to {:.0e}\n",
             machine(), markdown_table(table), agreed, rows.size(), kAgreement);
  return agreed == static_cast<std::ptrdiff_t>(rows.size()) ? 0 : 1;
}
