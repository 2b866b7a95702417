// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// All methods on one scene.

#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "brachisto/io/problem_file.hpp"
#include "comparison/measurement.hpp"
#include "report/text_table.hpp"

namespace brachisto::comparison {

/// The problem that all methods get.
struct Subject {
  std::string file;
  std::vector<std::string> overrides;  ///< of the command line
  io::ProblemFile problem;             ///< what both say together

  /// Of the methods with a mesh only rolling_time solves it.
  [[nodiscard]] bool limited() const;
};

/// Reads it.
/// \throws io::IoError, io::InputError, the latter also of a scene that states
///         its path, on which there is nothing to compare
[[nodiscard]] Subject read_subject(const std::string& file,
                                   const std::vector<std::string>& overrides);

/// What a caller may hook into.
struct Hooks {
  const std::atomic<int>* interrupt = nullptr;       ///< nonzero: stop
  std::function<void(const std::string&)> announce;  ///< what is run next
};

/// What errors are taken against.
struct Reference {
  double tau = 0.0;
  double error = 0.0;            ///< relative, its own
  std::vector<Point> path = {};  ///< see places_along()
  std::string by = {};           ///< "the extremal method"
  ComparedMethod method = {};    ///< which that is
  /// Why those that come before have none, in words; empty if it is the first.
  std::string instead_of = {};
};

/// Who may have the reference for a subject.
struct Referee {
  ComparedMethod method;
  std::optional<double> tolerance;
  std::string name;  ///< "the extremal method"
  /// The reference in a measurement of it, if it is one.
  [[nodiscard]] std::optional<Reference> reference_in(
      const Measurement& run) const;
};
/// A reference, and why those who were asked before have none: "the extremal
/// method failed: …".
struct FoundReference {
  std::optional<Reference> reference = {};
  std::string why_not = {};
};
/// The reference of the first who has one: the extremal method, which under
/// limits begins on the arcs that rolling_time found and solves other equations
/// there; under limits rolling_time to 1e-12 after it.
/// \param run  what a referee makes of the subject
[[nodiscard]] FoundReference find_reference(
    const Subject& subject,
    const std::function<Measurement(const Referee&)>& run);
/// Relative error of a solution, |τ/τ_ref − 1|.
[[nodiscard]] double error_of(const Measurement& run,
                              const Reference& reference);

/// One method of a comparison.
struct ComparisonRow {
  std::string label;
  ComparedMethod method;
  Measurement run;
  std::optional<double> error = {};  ///< relative, of τ; needs a reference
};

/// "verified", "solved, first-order conditions" (of a discrete system, which
/// nothing verifies), "failed: …".
[[nodiscard]] std::string verdict(const ComparisonRow& row);

struct ComparisonOptions {
  int nodes = 101;
  int repetitions = 5;
  double seconds = 60.0;  ///< wall clock, of each method
  /// At which the iterations of all methods stop: of the KKT conditions, and of
  /// the discrete system. The hybrid method makes no progress below about 1e-8.
  double residual = DiscreteSystem{}.tolerance;
};

struct MethodComparison {
  Subject subject;
  ComparisonOptions options;
  std::optional<Reference> reference;
  std::vector<ComparisonRow> rows;
};

/// Runs each method in a process of its own, one after the other, from the
/// cycloid.
/// \throws Interrupted, std::system_error
[[nodiscard]] MethodComparison compare_methods(const Subject& subject,
                                               const ComparisonOptions& options,
                                               const Hooks& hooks);

/// A table for a person to read, and a document for programs.
[[nodiscard]] std::string summary(
    const MethodComparison& comparison,
    report::TableForm form = report::TableForm::Text);
[[nodiscard]] std::string to_json(const MethodComparison& comparison);

struct Machine {
  std::string cpu;     ///< model, by the kernel; "unknown" if it does not say
  std::string kernel;  ///< "Linux 6.1.0 x86_64"
  int cores = 0;       ///< that this process may use
};

[[nodiscard]] Machine this_machine();

}  // namespace brachisto::comparison
