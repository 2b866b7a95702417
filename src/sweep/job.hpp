// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What a sweep is to do, so that it can be told to others and recognised.

#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "brachisto/io/problem_file.hpp"

namespace brachisto::sweep {

/// A sweep as it was asked for.
struct Job {
  std::string name;  ///< of the problem file
  std::string text;  ///< its content
  std::vector<std::string> overrides;
  io::SweepFile file;
  /// Its scenes are starts of the file's design, to be searched from and not
  /// only solved.
  bool of_design = false;
};

/// A text that should be a job is none; what() says why.
class JobError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// \throws io::IoError, io::InputError
[[nodiscard]] Job read_job(const std::filesystem::path& path,
                           const std::vector<std::string>& overrides);

/// The searches of a design as a sweep over the bodies that they start from.
/// \param text, name  of its problem file
/// \throws io::IoError, io::InputError  also if the file has no design
[[nodiscard]] Job design_job(const std::string& text, const std::string& name,
                             const std::vector<std::string>& overrides);

/// A sweep over two numbers that a design leaves free, the offset and its
/// direction if they are among them, within their bounds.
/// \param best   has all other numbers
/// \param count  values of each
/// \throws io::InputError  if the design has less than two such numbers
[[nodiscard]] Job design_map_job(const std::string& text,
                                 const std::string& name,
                                 const std::vector<std::string>& overrides,
                                 const Body& best, int count);

/// The job as one line of JSON, and back. It has the points of scene.path with
/// it, so that no other file is wanted any more.
[[nodiscard]] std::string to_line(const Job& job);
/// \throws JobError        if the line is no job
/// \throws io::InputError  if the text, which was valid once, is not any more
[[nodiscard]] Job job_from_line(const std::string& line);

/// 128-bit hash, in hexadecimal digits, of the effective input of all scenes.
/// Files that mean the same have the same hash.
[[nodiscard]] std::string input_hash(const io::SweepFile& file);

/// What tells two sweeps apart, in one sentence; empty if nothing does.
[[nodiscard]] std::string difference(const io::SweepFile& stored,
                                     const io::SweepFile& wanted);

}  // namespace brachisto::sweep
