// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Problem files: a scene and the options of its solve, in YAML; sweeps, whose
/// section `sweep` makes one scene into many; and what is wrong with them.
///
/// Reading is strict. Whatever the program would not use as the author meant
/// it is an error: unknown, repeated and misplaced keys, values of the wrong
/// type, anchors, tags, further documents. docs/problem-files.md describes the
/// format.

#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "brachisto/model/scene.hpp"
#include "brachisto/run/solve_options.hpp"
#include "brachisto/study/design.hpp"

namespace brachisto::io {

/// One mistake in a problem file or in an override of the command line.
struct Diagnostic {
  std::string file;     ///< name of the file, or "--set KEY=VALUE"
  int line = 0;         ///< from 1; 0 if the mistake has no line (an override)
  int column = 0;       ///< from 1, in characters, not bytes; 0 as for `line`
  std::string key;      ///< dotted, "scene.body.k"; empty for the whole file
  std::string message;  ///< what was read; what is allowed; the nearest match
};

/// "file:line:column: key: message", without the parts that are not there.
[[nodiscard]] std::string to_string(const Diagnostic& diagnostic);

/// The content of a problem file is refused (exit code 3).
///
/// Holds all mistakes that were found, those of the file in file order and
/// then those of the overrides. what() has one of them per line, of very many
/// only the first kShownDiagnostics.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Diagnostic> diagnostics);

  [[nodiscard]] const std::vector<Diagnostic>& diagnostics() const {
    return diagnostics_;
  }

 private:
  std::vector<Diagnostic> diagnostics_;
};

/// How many mistakes InputError::what() spells out.
inline constexpr std::size_t kShownDiagnostics = 100;

/// A file cannot be opened, read or written (exit code 6).
class IoError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace brachisto::io

namespace brachisto {

/// A way to solve the paper's discrete system.
enum class DiscreteArm {
  Rest,     ///< hybrid, A as the zero level of the energy
  Release,  ///< hybrid, the first node as the zero level
  Newton,   ///< exact derivatives, dense
  Lifted,   ///< the same steps from a sparse system
};

/// A method, and so a line of a work–precision diagram.
struct ComparedMethod {
  enum class Kind {
    RollingTime,  ///< on meshes of equal elements, of one degree
    Adaptive,     ///< rolling_time on meshes that follow the wanted error
    ArcLength,
    Extremal,
    DiscreteSystem
  };

  Kind kind = Kind::RollingTime;
  int degree = 0;                          ///< p, of RollingTime alone
  DiscreteArm arm = DiscreteArm::Release;  ///< of DiscreteSystem alone

  friend bool operator==(const ComparedMethod&,
                         const ComparedMethod&) = default;
};

/// A method as collocation of degree p.
[[nodiscard]] constexpr ComparedMethod rolling_time(int degree) {
  return {.kind = ComparedMethod::Kind::RollingTime, .degree = degree};
}
/// A method as an arm of the discrete system.
[[nodiscard]] constexpr ComparedMethod discrete_system(DiscreteArm arm) {
  return {.kind = ComparedMethod::Kind::DiscreteSystem, .arm = arm};
}

/// The section `work_precision` of a problem file.
struct WorkPrecisionPlan {
  std::vector<ComparedMethod> methods{rolling_time(1),
                                      rolling_time(2),
                                      rolling_time(3),
                                      rolling_time(4),
                                      rolling_time(5),
                                      rolling_time(6),
                                      {.kind = ComparedMethod::Kind::Adaptive},
                                      {.kind = ComparedMethod::Kind::ArcLength},
                                      {.kind = ComparedMethod::Kind::Extremal},
                                      discrete_system(DiscreteArm::Rest),
                                      discrete_system(DiscreteArm::Release)};
  /// Elements of rolling_time, pieces of arc_length, nodes of fsolve.
  std::vector<int> meshes{10, 20, 40, 80};
  /// Relative errors of T that the adaptive line is to reach.
  std::vector<double> tolerances{1e-4, 1e-6, 1e-8, 1e-10, 1e-12};
  int repetitions = 5;              ///< ≥ 1
  double seconds_per_point = 60.0;  ///< wall clock, > 0
};

}  // namespace brachisto

namespace brachisto::io {

/// Content of a problem file after defaults.
struct ProblemFile {
  Scene scene;
  SolveOptions options;
  std::string points_file;  ///< of scene.path, as the file names it, or empty
  WorkPrecisionPlan work_precision;  ///< for comparisons alone
  DesignPlan design;                 ///< for designs alone
  std::vector<Diagnostic> warnings;  ///< of what is read, but hardly meant
};

/// Longest problem file that is read [bytes].
inline constexpr std::size_t kMaxFileSize = 1U << 20U;

/// Deepest nesting of maps and lists that is read.
inline constexpr std::size_t kMaxNesting = 32;

/// Reads a problem file.
///
/// \param path       of the file, which is UTF-8 with any line ends; "-" is
///                   standard input
/// \param overrides  "dotted.key=VALUE", VALUE in YAML; each replaces or adds
///                   its key, the last one wins
/// \return a scene that satisfies validate(), and options within their bounds
/// \throws IoError     if the file, or the one that scene.path names, cannot be
///                     read
/// \throws InputError  with every mistake of its content; a syntax error ends
///                     the reading and comes alone
[[nodiscard]] ProblemFile read_problem_file(
    const std::filesystem::path& path,
    const std::vector<std::string>& overrides = {});

/// Reads a problem from memory; `name` stands for the file in messages.
/// \throws IoError, InputError  as read_problem_file()
[[nodiscard]] ProblemFile read_problem_text(
    std::string_view text, const std::string& name,
    const std::vector<std::string>& overrides = {});

/// Value of a swept key in one scene: a number (SI units, rad) or a word.
using SweepValue = std::variant<double, std::string>;

/// A key of the problem file that differs between scenes.
struct SweepKey {
  std::string path;     ///< dotted, "scene.body.eta_m"
  bool numeric = true;  ///< false: its values are words
};

/// A direction of the product.
struct SweepFileAxis {
  std::vector<std::size_t> keys;  ///< indices of those that run along it
  std::size_t count = 0;          ///< values, ≥ 1
  bool ordered = true;            ///< false: a random sample
};

/// Most scenes that a sweep may have.
inline constexpr std::size_t kMaxScenes = 10'000'000;

/// A family of problems: the product of some axes.
///
/// Scenes are numbered from 0 in the order of the product, the last axis being
/// the fastest. Copies are cheap, and several threads may read one object.
class SweepFile {
 public:
  struct Content;
  explicit SweepFile(std::shared_ptr<const Content> content);

  /// All keys of the section in file order. One that belongs to no axis has the
  /// same value in all scenes or depends on other keys.
  [[nodiscard]] const std::vector<SweepKey>& keys() const;

  /// The axes in file order, the last one the fastest.
  [[nodiscard]] const std::vector<SweepFileAxis>& axes() const;

  /// Product of the counts of the axes.
  [[nodiscard]] std::size_t num_scenes() const;

  /// Whether a scene may start from the solution of a neighbour.
  [[nodiscard]] bool warm_start() const;

  /// Whether the track of each scene is kept beside its numbers.
  [[nodiscard]] bool keeps_tracks() const;

  /// The problem of a scene, as if the file had values(scene) in place of its
  /// own. Satisfies what read_problem_file() promises.
  /// \throws std::out_of_range  unless scene < num_scenes()
  [[nodiscard]] ProblemFile problem(std::size_t scene) const;

  /// The values of all keys() in a scene.
  /// \throws std::out_of_range  unless scene < num_scenes()
  [[nodiscard]] std::vector<SweepValue> values(std::size_t scene) const;

  /// What the file and its overrides state, as one JSON document, which is a
  /// problem file again. Expressions stay text.
  [[nodiscard]] const std::string& stated() const;

 private:
  std::shared_ptr<const Content> content_;
};

/// Reads a problem file with a section `sweep`, and checks all its scenes.
///
/// \param overrides  as of read_problem_file(); after "sweep." a dotted key of
///                   the problem counts as one key of the section
/// \throws IoError     if the file cannot be read
/// \throws InputError  with every mistake of its content, or if it has no
///                     section `sweep`. A mistake that comes with the values of
///                     scenes is told for the first few of them.
[[nodiscard]] SweepFile read_sweep_file(
    const std::filesystem::path& path,
    const std::vector<std::string>& overrides = {});

/// Reads a sweep from memory; `name` stands for the file in messages.
///
/// \param points  those of scene.path, where the file that it names was read
///                before; nullptr: it is read now
/// \throws IoError, InputError  as read_sweep_file()
[[nodiscard]] SweepFile read_sweep_text(
    std::string_view text, const std::string& name,
    const std::vector<std::string>& overrides = {},
    const std::vector<Point>* points = nullptr);

/// Reads a file once, as a sweep if it has a section `sweep`.
/// \throws IoError, InputError  as read_problem_file() and read_sweep_file()
[[nodiscard]] std::variant<ProblemFile, SweepFile> read_problem_or_sweep_file(
    const std::filesystem::path& path,
    const std::vector<std::string>& overrides = {});

}  // namespace brachisto::io
