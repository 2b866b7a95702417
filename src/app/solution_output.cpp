// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "app/solution_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "app/exit_code.hpp"
#include "app/proofs.hpp"
#include "app/signals.hpp"
#include "app/terminal.hpp"
#include "brachisto/math/clock.hpp"
#include "plot/answer_page.hpp"
#include "plot/motion_data.hpp"
#include "report/path_figure.hpp"

namespace brachisto::app {

namespace {

/// The picture of the path, its table and script.
constexpr std::array kPathFiles{"path.csv", "path.gp", "path.svg"};

/// The page of an answer, and the motion as a picture with its table and
/// script.
constexpr std::array kPageFiles{"index.html", "motion.csv", "motion.gp",
                                "motion.gif"};

/// The files of --out but the result and its page; without a verified path
/// none. A picture that is missing becomes a warning of the solution. Of a
/// million nodes this takes seconds, so that a signal ends it.
std::vector<report::OutputFile> path_files(Solution& solution,
                                           const std::atomic<int>& signal) {
  if (!solution.verified()) return {};
  report::DrawnFiles picture =
      report::draw(report::path_figure(solution), report::Format::Svg, &signal);
  if (!picture.missing.empty()) {
    warn(picture.missing);
    solution.warnings.push_back(picture.missing);
  }
  picture.files.push_back({kTrajectoryFile, report::trajectory_csv(solution)});
  return std::move(picture.files);
}

/// The page of what is written; a picture that is missing is told.
void add_page(const Solution& solution, const std::string& json, bool gif,
              const std::atomic<int>& signal,
              std::vector<report::OutputFile>& files) {
  if (!solution.verified()) return;
  const auto csv =
      std::ranges::find(files, kTrajectoryFile, &report::OutputFile::name);
  report::DrawnFiles page =
      page_files(report::Json::parse(json), solution.scene,
                 plot::TrajectoryTable::read(csv->content), gif, signal);
  warn(page.missing);
  std::ranges::move(page.files, std::back_inserter(files));
}

/// No path of an earlier result stays beside one that has none; the result
/// comes last.
void write_results(const SolutionOutput& output,
                   std::vector<report::OutputFile> files,
                   const std::string& json) {
  std::vector<std::string> obsolete = solution_files();
  files.push_back({kResultFile, json});
  for (const report::OutputFile& file : files) {
    std::erase(obsolete, file.name);
  }
  report::write_files(output.out, files, output.force, obsolete);
}

}  // namespace

report::DrawnFiles page_files(const report::Json& result, const Scene& scene,
                              const plot::TrajectoryTable& table, bool gif,
                              const std::atomic<int>& signal) {
  report::DrawnFiles out;
  if (gif) {
    out = report::draw(plot::moving_figure(scene, table), report::Format::Gif,
                       &signal);
  }
  out.files.push_back({"index.html", plot::answer_page(result, scene, table)});
  return out;
}

std::vector<std::string> solution_files() {
  std::vector<std::string> names{kResultFile, kTrajectoryFile, kProofDocument,
                                 kProofPage};
  names.insert(names.end(), kPathFiles.begin(), kPathFiles.end());
  names.insert(names.end(), kPageFiles.begin(), kPageFiles.end());
  return names;
}

std::string complaint(const Solution& solution) {
  if (solution.status != Status::Solved) return solution.message;
  for (const Check& check : solution.certificate.checks) {
    if (check.passed) continue;
    const std::string advice = solution.advice();
    return "not verified: failed check " + check.name +
           (advice.empty() ? "" : "; to try: " + advice);
  }
  for (const std::string& reason : solution.infeasible_because()) {
    return "verified, but infeasible: " + reason;
  }
  for (const std::string& reason : solution.undecided_because()) {
    return "verified, feasible within the error of its mesh: " + reason;
  }
  return {};
}

void warn_of(const io::ProblemFile& problem) {
  for (const io::Diagnostic& warning : problem.warnings) {
    warn(io::to_string(warning));
  }
}

Solution solve_in_time(const io::ProblemFile& problem, bool json,
                       const SolveHooks& hooks) {
  const LastResort last_resort(problem.options.limits.seconds, json);
  return solve(problem.scene, problem.options, hooks);
}

int hand_out(Solution& solution, SolutionOutput output,
             const std::atomic<int>& signal) {
  std::string json;
  if (output.out.empty()) {
    if (output.json) json = report::result_json(solution, output.design);
  } else {
    // What a signal has ended already is written all the same.
    std::optional<StopScope> scope;
    if (solution.verified()) scope.emplace(StopCondition(&signal));
    std::vector<report::OutputFile> files = path_files(solution, signal);
    std::ranges::move(output.further, std::back_inserter(files));
    json = report::result_json(solution, output.design);
    add_page(solution, json, output.gif, signal, files);
    write_results(output, std::move(files), json);
  }
  if (output.json) {
    print_data(json);
  } else if (!output.quiet) {
    print_with_verdict(report::summary(solution, output.design),
                       !solution.verified()  ? Colour::Red
                       : solution.feasible() ? Colour::Green
                                             : Colour::Yellow);
  }
  const std::string why = complaint(solution);
  if (output.quiet && !why.empty())
    tell_error(fmt::format("brachisto: {}\n", why));
  return exit_code(solution, signal.load(), output.design);
}

}  // namespace brachisto::app
