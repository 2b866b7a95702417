// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto show DIR: the page of a result that was written before.

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "app/exit_code.hpp"
#include "app/signals.hpp"
#include "app/solution_output.hpp"
#include "app/sweep_run.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "brachisto/io/problem_file.hpp"
#include "io/input_tree.hpp"
#include "plot/trajectory_table.hpp"
#include "sweep/store.hpp"

namespace brachisto::app {

namespace {

namespace fs = std::filesystem;

struct ShowFlags {
  std::string directory;
  bool gif = false;
  bool quiet = false;
};

[[noreturn]] void refuse(const fs::path& where, const std::string& why) {
  throw io::IoError(where.string() + ": " + why);
}

/// The whole file; its absence is told with what there would have to be.
std::string whole(const fs::path& file, const std::string& absent) {
  std::error_code error;
  if (!fs::exists(file, error)) refuse(file.parent_path(), absent);
  return io::read_file_bytes(file, "a file of `brachisto solve --out`");
}

/// Whether a motion ends when the result says. Pieces of arc length say T of
/// themselves, and the motion is on a smooth curve through them.
void check_end(const report::Json& result, const io::ProblemFile& problem,
               const plot::TrajectoryTable& table) {
  const bool of_pieces =
      problem.options.or_default<Collocation>().discretisation.formulation ==
      Formulation::ArcLength;
  const double close = of_pieces ? 0.01 : 1e-6;
  const double T = result.at("transit_time").get<double>();
  const double last = table.time().back();
  if (std::abs(last - T) <= close * T) return;
  throw plot::NoTrajectory(fmt::format(
      "it ends at t = {:.6g} s, and the motion of result.json at {:.6g} s",
      last, T));
}

report::Json document(const fs::path& directory) {
  std::error_code error;
  if (!fs::is_directory(directory, error)) refuse(directory, "no directory");
  const fs::path file = directory / kResultFile;
  const char* const hint =
      "has no result.json; `brachisto solve FILE --out DIR` writes one";
  report::Json result = report::Json::parse(whole(file, hint), nullptr, false);
  const bool known = result.is_object() && result.contains("verified") &&
                     result.contains("certificate") && result.contains("input");
  if (!known) refuse(file, "no result of `brachisto solve`");
  if (result["verified"] != true) {
    refuse(file, "the result is not verified: there is no motion to show");
  }
  return result;
}

int run(const ShowFlags& flags) {
  const fs::path directory = flags.directory;
  std::error_code unknown;
  if (!fs::exists(directory / kResultFile, unknown) &&
      sweep::Store::exists(directory)) {
    if (flags.gif) refuse(directory, "--gif is of one motion, not of a sweep");
    return write_sweep_report(flags.directory, true, flags.quiet);
  }
  const std::atomic<int>& signal = catch_signals();
  const report::Json result = document(directory);
  const std::string csv =
      whole(directory / kTrajectoryFile,
            "has no trajectory.csv, the motion of its result.json");
  const io::ProblemFile problem =
      io::read_problem_file(directory / kResultFile);
  try {
    const auto table = plot::TrajectoryTable::read(csv);
    check_end(result, problem, table);
    const report::DrawnFiles made =
        page_files(result, problem.scene, table, flags.gif, signal);
    warn(made.missing);
    report::write_files(directory, made.files, true);
    if (!flags.quiet) print_paths(directory, made.files);
  } catch (const plot::NoTrajectory& error) {
    refuse(directory / kTrajectoryFile, error.what());
  } catch (const report::Json::exception& error) {
    refuse(directory / kResultFile, error.what());
  }
  return kSuccess;
}

}  // namespace

Verb show_verb() {
  const auto flags = std::make_shared<ShowFlags>();
  return {
      .name = "show",
      .text =
          "Write the page of a result anew: the motion to be played, "
          "curves and the certificate; of a sweep, its report",
      .flags = {{.name = "DIR",
                 .value = &flags->directory,
                 .text = "Directory of `brachisto solve --out` or of a sweep",
                 .check = not_empty(),
                 .required = true},
                {"--gif", &flags->gif, "Write motion.gif too"},
                {"--quiet", &flags->quiet, "Do not list what was written"}},
      .footer =
          R"(Example:
  brachisto solve problems/case.yaml --out results
  brachisto show results --gif
Exit codes: 0 written, 6 there is no verified result, or I/O.)",
      .run = [flags] { return run(*flags); }};
}

}  // namespace brachisto::app
