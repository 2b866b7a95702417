// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/option_errors.hpp"

#include <fmt/format.h>

#include <limits>

#include "study/solve_run.hpp"

namespace brachisto {

namespace {

/// Collects what is out of bounds.
class Checker {
 public:
  /// NaN lies in no interval.
  template <class Number>
  void within(const char* name, Number value, double lower, double upper) {
    const auto number = static_cast<double>(value);
    if (number >= lower && number <= upper) return;
    errors_.push_back(fmt::format("{} is {}; allowed is {:.9g} to {:.9g}", name,
                                  value, lower, upper));
  }
  /// \param last  of the enumerators, which count from 0
  template <class Enum>
  void known(const char* name, Enum value, Enum last) {
    const auto number = static_cast<int>(value);
    if (number >= 0 && number <= static_cast<int>(last)) return;
    errors_.push_back(fmt::format("{} has no value {}", name, number));
  }
  void require(bool condition, std::string message) {
    if (!condition) errors_.push_back(std::move(message));
  }
  [[nodiscard]] std::vector<std::string> take() { return std::move(errors_); }

 private:
  std::vector<std::string> errors_;
};

void check_mesh(const SolveOptions& options, Checker& check) {
  const Discretisation& mesh = options.discretisation;
  check.known("discretisation.formulation", mesh.formulation,
              Formulation::ArcLength);
  if (mesh.tolerance) {
    check.within("discretisation.tolerance", *mesh.tolerance,
                 kSmallestTolerance, kLargestTolerance);
  }
  if (mesh.degree) {
    check.within("discretisation.degree", *mesh.degree, kMinDegree, kMaxDegree);
  }
  if (mesh.elements) {
    check.within("discretisation.elements", *mesh.elements, 1, kMaxElements);
  }
  if (!mesh.nodes) return;
  const bool discrete = options.method == Method::Fsolve;
  check.within("discretisation.nodes", *mesh.nodes,
               discrete ? kFewestDiscreteNodes : 2, kMaxNodes);
  check.require(!mesh.elements,
                "discretisation.elements and discretisation.nodes both fix the "
                "mesh; allowed is one of them");
  const int p = mesh.degree_of_fixed();
  check.require(discrete || p < 1 || (*mesh.nodes - 1) % p == 0,
                fmt::format("discretisation.nodes is {}; nodes − 1 is a "
                            "multiple of the degree {}",
                            *mesh.nodes, p));
}

void check_arc_length(const SolveOptions& options, Checker& check) {
  const Discretisation& mesh = options.discretisation;
  if (mesh.formulation != Formulation::ArcLength) return;
  const int pieces = mesh.elements ? *mesh.elements
                     : mesh.nodes  ? *mesh.nodes - 1
                                   : kFewestPieces;
  check.require(
      !mesh.degree && pieces >= kFewestPieces &&
          solves_the_program(options.method) &&
          options.search == Search::Principal &&
          options.guess == Guess::Cycloid &&
          mesh.wanted_tolerance() >= kSmallestArcLengthTolerance,
      fmt::format(
          "the formulation arc_length has no degree, {} pieces or more, "
          "the method ipopt or newton_kkt, the search principal, the "
          "guess cycloid, and a tolerance of {:g} or more",
          kFewestPieces, kSmallestArcLengthTolerance));
}

void check_fsolve(const FsolveOptions& options, Checker& check) {
  using Reading = DiscreteReading;
  check.known("fsolve.variant", options.variant, FsolveVariant::Lifted);
  check.known("fsolve.quadrature", options.reading.quadrature,
              Reading::Quadrature::Trapezoid);
  check.known("fsolve.datum", options.reading.datum, Reading::Datum::Printed);
  check.known("fsolve.slopes", options.reading.slopes, Reading::Slopes::Smooth);
  check.within("fsolve.epsilon", options.reading.epsilon, 0.0, kLargestEpsilon);
  check.within("fsolve.tolerance", options.tolerance,
               std::numeric_limits<double>::min(), 1.0);
}

}  // namespace

std::vector<std::string> option_errors(const SolveOptions& options) {
  Checker check;
  check.known("method", options.method, Method::Fsolve);
  check.known("linear_solver", options.linear_solver, LinearSolver::Mumps);
  check.known("search", options.search, Search::Global);
  check.known("certify", options.certify, Certify::Extremal);
  check.known("guess", options.guess, Guess::Random);
  check.within("tolerance", options.tolerance, kSmallestResidual,
               kLargestResidual);
  check.within("limits.iterations", options.limits.iterations, 1,
               std::numeric_limits<int>::max());
  check.within("limits.seconds", options.limits.seconds,
               std::numeric_limits<double>::min(),
               std::numeric_limits<double>::infinity());
  check_mesh(options, check);
  check_arc_length(options, check);
  check_fsolve(options.fsolve, check);
  return check.take();
}

}  // namespace brachisto
