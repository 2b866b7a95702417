// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What is said of an optimal-control problem beside its formulas: names,
/// bounds, ends, guesses; and its answer, with what is known of its error.

#pragma once

#include <concepts>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "brachisto/math/clock.hpp"
#include "brachisto/nlp/problem.hpp"
#include "brachisto/ocp/mesh.hpp"
#include "brachisto/ocp/point_function.hpp"
#include "brachisto/solvers/status.hpp"

namespace brachisto::ocp {

inline constexpr double kNoBound = std::numeric_limits<double>::infinity();

/// Where the search of a variable begins: a number, a function of the share of
/// the duration, from 0 to 1, or values at equal steps of it. Nothing: straight
/// from its start to its end, as far as they are given, within its bounds.
class Guess {
 public:
  using Function = std::function<double(double)>;

  Guess() = default;
  template <std::convertible_to<double> Number>
  Guess(Number value)  // NOLINT: a number is a guess
      : is_(static_cast<double>(value)) {}
  Guess(std::vector<double> values)  // NOLINT: so are values
      : is_(std::move(values)) {}
  template <class F>
  requires(std::is_invocable_r_v<double, F, double> &&
           !std::convertible_to<F, double>)
      Guess(F function)  // NOLINT: and a function
      : is_(Function(std::move(function))) {}

  [[nodiscard]] bool given() const { return is_.index() != 0; }
  /// By fewer than two values.
  [[nodiscard]] bool too_few() const;
  /// \throws std::invalid_argument  if there are too few values
  [[nodiscard]] double at(double share) const;

 private:
  std::variant<std::monostate, double, Function, std::vector<double>> is_;
};

/// A state, a control or a parameter.
struct Variable {
  std::string name;
  std::string unit = {};  ///< for tables and pictures
  double lower = -kNoBound, upper = kNoBound;
  /// Of a state, where it is given.
  std::optional<double> start = {}, end = {};
  Guess guess = {};
  /// A size that it has; 0: from bounds, ends and guess.
  double scale = 0.0;
};

/// A limit of the path or a condition of its ends: lower ≤ value ≤ upper.
struct Limit {
  std::string name;
  double lower = -kNoBound, upper = kNoBound;
};

/// How long it takes.
struct Duration {
  double lower = 0.0, upper = kNoBound;
  double guess = 1.0;

  [[nodiscard]] static Duration fixed(double value) {
    return {value, value, value};
  }
};

/// All that is said.
struct Statement {
  std::string name;
  std::vector<Variable> states, controls, parameters = {};
  std::vector<Limit> limits = {}, end_conditions = {};
  Duration duration = {};
  std::string time_unit = {};
};

/// What its scale, bounds, ends and guess tell of a variable's size, if they
/// do.
[[nodiscard]] std::optional<double> size_of(const Variable& variable);

/// Powers of two by which states, parameters behind them, and controls are
/// divided, next to their sizes.
[[nodiscard]] std::vector<double> scales_of(const Statement& statement);

/// \throws std::invalid_argument  a sentence that names what cannot be: an
/// empty
///         range, an end outside of it, a number that is not finite, a name
///         that is missing or used twice
void check(const Statement& statement);

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
