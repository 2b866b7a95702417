// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/pose.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "brachisto/math/angle.hpp"

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
      !mesh.degree && pieces >= kFewestPieces && options.solves_the_program() &&
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

/// \throws std::invalid_argument  with all that is wrong, unless it is nothing
void refuse(const char* what, const std::vector<std::string>& errors) {
  if (errors.empty()) return;
  throw std::invalid_argument(
      fmt::format("{}:\n  {}", what, fmt::join(errors, "\n  ")));
}

std::vector<std::string> errors_of(const Scene& scene) {
  std::vector<std::string> errors;
  for (const SceneError& error : validate(scene)) {
    errors.push_back(fmt::format("{}: {}", error.key, error.message));
  }
  return errors;
}

std::vector<std::string> warnings_of(const Scene& scene) {
  const double theta_m = scene.body.theta_m;
  const double within = math::within_a_turn(theta_m);
  if (within == theta_m) return {};
  return {
      fmt::format("scene.body.theta_m: {} rad is more than a turn; whole "
                  "turns mean nothing, and {:.10g} rad is solved for",
                  theta_m, within)};
}

/// Options from a problem file have passed the same bounds before.
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

}  // namespace

MeshOptions PosedProblem::mesh_options_after(const Work& done) const {
  MeshOptions left = mesh_options;
  left.ipopt.max_iterations =
      std::max(0, options.limits.iterations - done.iterations);
  return left;
}

PosedProblem pose(const Scene& scene, const SolveOptions& options,
                  const SolveHooks& hooks) {
  refuse("the scene is not valid", errors_of(scene));
  refuse("the options are not valid", option_errors(options));
  PosedProblem out{PosedScene(scene), options, {}, {}, warnings_of(scene)};
  MeshOptions& mesh = out.mesh_options;
  mesh.ipopt.tolerance = options.tolerance;
  mesh.ipopt.linear_solver = options.linear_solver;
  mesh.ipopt.verbose = hooks.verbose;
  mesh.ipopt.stop = StopCondition(options.limits.seconds, hooks.interrupt);
  mesh.polish = options.polish;
  mesh.progress = hooks.progress;
  mesh.newton_alone = options.method == Method::NewtonKkt;
  if (!scene.path) out.cycloid = axisymmetric_optimum(out.natural);
  return out;
}

}  // namespace brachisto
