// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/pose.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>
#include <variant>

#include "math/angle.hpp"

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

void check_mesh(const Discretisation& mesh, Checker& check) {
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
  check.within("discretisation.nodes", *mesh.nodes, 2, kMaxNodes);
  check.require(!mesh.elements,
                "discretisation.elements and discretisation.nodes both fix the "
                "mesh; allowed is one of them");
  const int p = mesh.degree_of_fixed();
  check.require(p < 1 || (*mesh.nodes - 1) % p == 0,
                fmt::format("discretisation.nodes is {}; nodes − 1 is a "
                            "multiple of the degree {}",
                            *mesh.nodes, p));
}

void check_arc_length(const Collocation& program, Checker& check) {
  const Discretisation& mesh = program.discretisation;
  if (mesh.formulation != Formulation::ArcLength) return;
  const int pieces = mesh.elements ? *mesh.elements
                     : mesh.nodes  ? *mesh.nodes - 1
                                   : kFewestPieces;
  check.require(
      !mesh.degree && pieces >= kFewestPieces &&
          program.search == Search::Principal &&
          program.guess == Guess::Cycloid &&
          program.sensitivities == SensitivityOrder::None &&
          mesh.wanted_tolerance() >= kSmallestArcLengthTolerance,
      fmt::format(
          "the formulation arc_length has no degree, {} pieces or more, "
          "the search principal, the guess cycloid, no sensitivities, and a "
          "tolerance of {:g} or more",
          kFewestPieces, kSmallestArcLengthTolerance));
}

void check_method(const Collocation& program, Checker& check) {
  check.known("solver", program.solver, ProgramSolver::NewtonKkt);
  check.known("linear_solver", program.linear_solver, LinearSolver::Mumps);
  check.within("threads", program.threads, 1, kMostThreads);
  check.known("search", program.search, Search::Global);
  check.known("certify", program.certify, Certify::Proof);
  check.known("sensitivities", program.sensitivities, SensitivityOrder::Second);
  check.known("guess", program.guess, Guess::Random);
  check.require(
      program.guess == Guess::Cycloid || program.solver == ProgramSolver::Ipopt,
      "the guess is other than the cycloid, and the solver Newton's "
      "method; allowed is Ipopt, which needs no multipliers");
  check.within("tolerance", program.tolerance, kSmallestResidual,
               kLargestResidual);
  check_mesh(program.discretisation, check);
  check_arc_length(program, check);
}

void check_method(const Shooting& shooting, Checker& check) {
  check.within("tolerance", shooting.tolerance, kSmallestTolerance,
               kLargestTolerance);
}

void check_method(const DiscreteSystem& system, Checker& check) {
  using Reading = DiscreteReading;
  check.within("nodes", system.nodes, kFewestDiscreteNodes, kMaxNodes);
  check.known("solver", system.solver, DiscreteSolver::Lifted);
  check.known("quadrature", system.reading.quadrature,
              Reading::Quadrature::Trapezoid);
  check.known("datum", system.reading.datum, Reading::Datum::Printed);
  check.known("slopes", system.reading.slopes, Reading::Slopes::Smooth);
  check.within("epsilon", system.reading.epsilon, 0.0, kLargestEpsilon);
  check.within("tolerance", system.tolerance,
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
  check.within("limits.iterations", options.limits.iterations, 1,
               std::numeric_limits<int>::max());
  check.within("limits.seconds", options.limits.seconds,
               std::numeric_limits<double>::min(),
               std::numeric_limits<double>::infinity());
  std::visit([&](const auto& method) { check_method(method, check); },
             options.method);
  return check.take();
}

/// What is derived for an ordinary world alone; files have it said with its
/// reasons before.
std::vector<std::string> world_errors(const Scene& scene,
                                      const SolveOptions& options) {
  if (scene.world.ordinary()) return {};
  const auto* program = options.of<Collocation>();
  const bool known =
      options.of<DiscreteSystem>() == nullptr &&
      (program == nullptr ||
       ((program->search == Search::Principal || scene.limits.any()) &&
        program->guess == Guess::Cycloid &&
        program->discretisation.formulation == Formulation::RollingTime));
  if (known) return {};
  return {
      "in a field that varies, with a start speed, in air or with losses the "
      "formulation is rolling_time, the search without limits principal, the "
      "guess cycloid, and the method not the discrete system"};
}

Collocation program_of(const SolveOptions& options) {
  auto program = options.or_default<Collocation>();
  if (const auto* shooting = options.of<Shooting>()) {
    program.discretisation.tolerance = shooting->tolerance;
  }
  return program;
}

}  // namespace

Scene without_limits(Scene scene) {
  if (scene.contact != Contact::Centre) scene.contact = Contact::Smooth;
  scene.limits = {};
  scene.end_slope.reset();
  return scene;
}

bool is_limited(const Scene& scene) {
  const bool own_slopes =
      scene.contact == Contact::Smooth || scene.contact == Contact::Centre;
  return scene.limits.any() || (!own_slopes && scene.body.rolls());
}

MeshOptions PosedProblem::mesh_options_after(const Work& done) const {
  MeshOptions left = mesh_options;
  left.ipopt.max_iterations =
      std::max(0, options.limits.iterations - done.iterations);
  return left;
}

/// What the solve starts from, of a scene in natural units.
static void prepare(PosedProblem& posed) {
  posed.limited.reset();
  if (is_limited(posed.asked)) {
    posed.limited = posed.natural;
    // A bead's slopes at A and B cost nothing: sought, they would be anything.
    if (!posed.asked.body.rolls() && posed.asked.contact == Contact::Optimal) {
      posed.limited->contact = Contact::Smooth;
    }
  }
  posed.natural = without_limits(posed.natural);
  posed.cycloid.reset();
  if (!posed.asked.path) posed.cycloid = axisymmetric_optimum(posed.natural);
}

PosedProblem pose(const Scene& scene, const SolveOptions& options,
                  const SolveHooks& hooks) {
  refuse("the scene is not valid", errors_of(scene));
  refuse("the options are not valid", option_errors(options));
  refuse("the options do not fit the scene", world_errors(scene, options));
  PosedProblem out{PosedScene(with_implied_limits(scene)),
                   options,
                   program_of(options),
                   {},
                   {},
                   {},
                   warnings_of(scene)};
  MeshOptions& mesh = out.mesh_options;
  mesh.ipopt.tolerance = out.program.tolerance;
  mesh.ipopt.linear_solver = out.program.linear_solver;
  mesh.ipopt.verbose = hooks.verbose;
  mesh.ipopt.stop = StopCondition(options.limits.seconds, hooks.interrupt);
  mesh.polish = out.program.polish;
  mesh.progress = hooks.progress;
  mesh.newton_alone = out.program.solver == ProgramSolver::NewtonKkt;
  prepare(out);
  return out;
}

PosedProblem with_scene(const PosedProblem& posed, const Scene& scene) {
  PosedProblem out = posed;
  static_cast<PosedScene&>(out) = PosedScene(scene);
  prepare(out);
  return out;
}

}  // namespace brachisto
