// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What accuracy costs: every method on a sequence of meshes.

#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "comparison/comparison.hpp"
#include "comparison/methods.hpp"
#include "comparison/statistics.hpp"
#include "report/text_table.hpp"

namespace brachisto::comparison {

/// The referee has no answer that errors could be taken against.
class NoReference : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A method on one mesh, or to one wanted error.
struct PrecisionPoint {
  Fineness fineness;
  Measurement run;
  std::optional<double> error;  ///< relative, of τ; nothing unless solved
  /// Largest distance from the path of the reference, in max(L, H); nothing for
  /// the method that has it.
  std::optional<double> path_error;

  [[nodiscard]] bool refused() const {
    return run.outcome == Measurement::Outcome::Refused;
  }
};

/// A method on all meshes, or to all wanted errors.
struct PrecisionLine {
  ComparedMethod method;
  std::vector<PrecisionPoint> points;
  AsymptoticOrder order = {};  ///< in the size of the mesh
};

/// A method of the plan that was not measured.
struct LeftOut {
  ComparedMethod method;
  std::string reason;  ///< in words
};

struct WorkPrecision {
  Subject subject;
  WorkPrecisionPlan plan;
  Reference reference;
  std::vector<PrecisionLine> lines = {};
  std::vector<LeftOut> left_out = {};

  /// Relative error below which there is no order to be seen: ten times what
  /// the solver and the reference leave open, so that a tenth of the error at
  /// most is not of the discretisation. The solver leaves the KKT tolerance or,
  /// if the last digits are polished, rounding.
  [[nodiscard]] double floor() const;
  [[nodiscard]] bool polished() const { return program().polish; }
  /// The KKT tolerance of the problem.
  [[nodiscard]] double tolerance() const { return program().tolerance; }

 private:
  [[nodiscard]] Collocation program() const {
    return subject.problem.options.or_default<Collocation>();
  }
};

/// Runs the plan, each point in a process of its own, one after the other.
/// A method that refuses the scene is left out, and so is the extremal method
/// under limits, which has its arcs from the program.
/// \throws NoReference, Interrupted, std::system_error
[[nodiscard]] WorkPrecision run_work_precision(const Subject& subject,
                                               const WorkPrecisionPlan& plan,
                                               const Hooks& hooks);

[[nodiscard]] std::string summary(
    const WorkPrecision& found,
    report::TableForm form = report::TableForm::Text);
[[nodiscard]] std::string to_json(const WorkPrecision& found);

}  // namespace brachisto::comparison
