// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Problem files: a scene and the options of its solve, in YAML.
///
/// Reading is strict. Whatever the program would not use as the author meant
/// it is an error: unknown, repeated and misplaced keys, values of the wrong
/// type, anchors, tags, further documents. docs/problem-files.md describes the
/// format.

#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "brachisto/io/diagnostics.hpp"
#include "brachisto/model/scene.hpp"
#include "brachisto/run/solve_options.hpp"
#include "brachisto/study/design_plan.hpp"

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

}  // namespace brachisto::io
