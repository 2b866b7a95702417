// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Results: as JSON, the form that other programs read, as a table, and for a
/// person; and files that are there in full or not at all.

#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "brachisto/study/design.hpp"
#include "brachisto/study/solution.hpp"

namespace brachisto::report {

/// Version of the layout of result documents; grows when a key changes its
/// meaning. New keys may come at any time.
inline constexpr int kSchemaVersion = 2;

/// The document of one solve. Numbers of the path are null unless the result is
/// verified; so is whatever the scene does not have.
/// \param design  that chose the body, if one did
[[nodiscard]] std::string result_json(const Solution& solution,
                                      const DesignAnswer* design = nullptr);

/// The reference of its keys as a Markdown table, made from the very table that
/// writes them. docs/results.md quotes it.
[[nodiscard]] std::string result_reference_markdown();

/// A JSON Schema of the document, made from the same table.
[[nodiscard]] std::string result_schema();

/// The effective input, defaults filled in, as `validate --json` prints it.
[[nodiscard]] std::string input_json(const Scene& scene,
                                     const SolveOptions& options);

/// A dozen lines: the scene, the answer if it is verified, how it was found,
/// and what each check of the certificate said if one failed.
/// \param design  that chose the body, if one did
[[nodiscard]] std::string summary(const Solution& solution,
                                  const DesignAnswer* design = nullptr);

/// Comma-separated values with a header line, one row per node, 17 digits:
/// u, t, x_c, z_c, x_cm, z_cm, x_b, z_b, theta, beta, v_c, omega, R_n, R_t,
/// kappa_b, in SI units, angles in radians, forces in m g. A bead has no theta,
/// omega and R_t, which stay empty.
[[nodiscard]] std::string trajectory_csv(const Motion& motion);

/// The same of a solution's motion; of one under limits with the further
/// columns `active`, names of the bounds that hold as equations there joined by
/// +, and for each bound of the scene `slack_` and its name, the distance from
/// it. \pre the solution has a motion
[[nodiscard]] std::string trajectory_csv(const Solution& solution);

/// A column of these: numbers, NaN where a bead has none, or words.
struct TrajectoryColumn {
  std::string name;
  std::vector<double> numbers;     ///< one per row; empty of `active`
  std::vector<std::string> words;  ///< of `active`
};

/// What trajectory_csv() writes, column by column.
/// \pre the solution has a motion
[[nodiscard]] std::vector<TrajectoryColumn> trajectory_columns(
    const Solution& solution);

/// What is told of a column.
struct TrajectoryColumnText {
  std::string_view name, unit, meaning;
};

/// Of the columns that every trajectory has.
[[nodiscard]] std::vector<TrajectoryColumnText> trajectory_column_texts();

/// Writing failed; what() names the file and the reason.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file to be written.
struct OutputFile {
  std::string name;  ///< without directory
  std::string content;
};

/// Writes files into a directory, made if need be: all of them or none. They
/// are written under temporary names and flushed to disk; then they get their
/// names in the given order, so that whoever sees the last one sees all of them
/// whole. Signals that ask the process to end wait meanwhile.
///
/// \param force     replace files that exist; otherwise they are an error
/// \param obsolete  names of files that go, if they are there, when the others
///                  come
/// \throws OutputError  and leaves the directory as it was, not made if it was
///                      not there
void write_files(const std::filesystem::path& directory,
                 const std::vector<OutputFile>& files, bool force,
                 const std::vector<std::string>& obsolete = {});

/// Checks beforehand what write_files() would refuse, as far as it can be
/// known. \throws OutputError
void check_writable(const std::filesystem::path& directory,
                    const std::vector<std::string>& names, bool force);

}  // namespace brachisto::report
