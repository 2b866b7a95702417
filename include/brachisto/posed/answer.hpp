// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The answer to an optimal-control problem, with what is known of its error.

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "brachisto/math/clock.hpp"
#include "brachisto/nlp/problem.hpp"
#include "brachisto/ocp/mesh.hpp"
#include "brachisto/posed/statement.hpp"
#include "brachisto/solvers/status.hpp"

namespace brachisto::ocp {

/// How to solve a stated problem.
struct SolveBy {
  /// Wanted error of the cost, relative to the larger of its size and that of
  /// ∫ |L| dt.
  double tolerance = 1e-10;
  int degree = 5;     ///< of polynomials, 2 … 11
  int elements = 10;  ///< of the first mesh
  int most_elements = 4000;
  int most_passes = 25;
  int most_iterations = 500;  ///< of the solver, each time
  LinearSolver linear_solver = LinearSolver::Auto;
  StopCondition stop = {};
  bool verbose = false;  ///< passes to stderr
};

/// One question that was put to the answer.
struct Check {
  std::string name;
  double value = 0.0, allowed = 0.0;
  std::string where = {};  ///< in words, where it is worst
  [[nodiscard]] bool passed() const { return value <= allowed; }
};

/// A place of the path.
struct Place {
  double time = 0.0;
  std::vector<double> states = {}, controls = {};
  /// What the least cost to go changes by with each state.
  std::vector<double> costates = {};
};

/// One pass of the refinement, or one try with places of junctions as unknowns.
struct Pass {
  int elements = 0, iterations = 0;
  double cost = 0.0;
  double change = 0.0;  ///< by cutting each element in two
};

/// An answer is a value. Its path is that on the mesh with the elements of the
/// last pass cut in two.
class Answer {
 public:
  Status status = Status::InternalError;
  std::string message;  ///< a sentence
  double cost = 0.0;
  double estimated_error = 0.0;  ///< of the cost, in its unit
  double duration = 0.0;
  std::vector<double> parameters;
  /// By how much the cost changes with the given starts and ends of states, NaN
  /// where one is free, and with the duration if it is given.
  std::vector<double> by_start, by_end;
  double by_duration = 0.0;
  /// By how much the cost changes with each lower and upper bound that holds,
  /// all along the path, of states, parameters, controls, limits and conditions
  /// of the ends.
  struct Price {
    std::string name;
    double by_lower = 0.0, by_upper = 0.0;
  };
  std::vector<Price> prices;
  std::vector<double> junctions;  ///< times at which bounds begin or cease
  std::vector<Check> certificate;
  std::vector<Pass> passes;
  double seconds = 0.0;  ///< of processor time

  /// Solved, and every check passed.
  [[nodiscard]] bool verified() const;
  /// The first check that failed, in words, or the message.
  [[nodiscard]] std::string why_not() const;

  /// \param time  0 … duration
  [[nodiscard]] Place at(double time) const;
  /// The start and the collocation points.
  [[nodiscard]] std::vector<Place> nodes() const;
  [[nodiscard]] const Statement& statement() const { return made_of.statement; }
  /// Names with units in the first line, then nodes().
  [[nodiscard]] std::string csv() const;
  /// Curves of states and controls over time, one below the other.
  [[nodiscard]] std::string svg() const;

  /// What the path is read from.
  struct Source {
    Statement statement;
    Mesh mesh;
    PrimalDual point;  ///< in scaled variables
    std::vector<double> scales;
  } made_of;
};

}  // namespace brachisto::ocp
