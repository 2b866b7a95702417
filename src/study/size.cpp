// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "math/machine_speed.hpp"
#include "model/path_inequality.hpp"
#include "refinement/turn_meshes.hpp"

namespace brachisto {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Measured on one core of an AMD EPYC (docs/benchmarks.md), in seconds and
// bytes. What a process has before it solves anything:
constexpr double kBytesOfProgram = 16e6;
constexpr double kSecondsOfProgram = 0.01;
constexpr double kBytesPerTurn = 0.21e6;

struct Cost {
  double nodes = 0.0, bytes = 0.0, seconds = 0.0;
};

/// What a mesh costs more or less per node than one of degree 5: elements have
/// dense blocks, which grow with p, and ends, of which there are 1/p per node.
double cost_by_degree(double p) {
  const auto cost = [](double q) { return 0.10 + 3.2 / q + 0.28 * q; };
  return cost(p) / cost(kDefaultDegree);
}

/// A fixed mesh. Ipopt keeps vectors of its own; meshes of many pieces it meets
/// near the solution, for they climb from coarse ones. Times are half as much
/// again as on that core: on another machine large meshes took twice as much,
/// which machine_speed() does not see.
Cost of_fixed_mesh(double nodes, const Collocation& program, bool limited) {
  const Discretisation& mesh = program.discretisation;
  if (mesh.formulation == Formulation::ArcLength) {
    return program.solver == ProgramSolver::NewtonKkt
               ? Cost{nodes, 1.05e3 * nodes, 4e-6 * nodes}
               : Cost{nodes, std::min(3.6e3 * nodes, 20e6 + 2.4e3 * nodes),
                      2.2e-5 * nodes};
  }
  const double n = nodes * cost_by_degree(mesh.degree_of_fixed());
  if (limited) return {nodes, 5e6 + 6e3 * n, 0.1 + 8e-5 * n};
  if (program.solver == ProgramSolver::NewtonKkt) {
    return {nodes, 2.1e3 * n, 1.05e-5 * n};
  }
  if (program.linear_solver == LinearSolver::Mumps) {
    return {nodes, 12e3 * n, 6e-5 * n};
  }
  return {nodes, std::min(7.3e3 * n, 40e6 + 2.7e3 * n),
          std::min(3.7e-5 * n, 0.2 + 1.4e-5 * n)};
}

/// Nodes a turn, about, under limits: they grow with the arcs and the
/// corrections of what is held along them. Bounds of the place bend the path
/// more gently than those of the control, and so does friction that holds where
/// it is steepest alone, at slopes of 35 deg and more.
double nodes_per_turn(const Scene& limited) {
  constexpr double kSteep = 0.7;
  const auto of_control =
      std::ranges::count_if(inequalities(limited.body, limited.limits),
                            [](const PathInequality& limit) {
                              switch (limit.kind) {
                                case PathInequality::Kind::FrictionForward:
                                  return limit.number < kSteep;
                                case PathInequality::Kind::FrictionBackward:
                                  return false;  // one limit of both signs
                                default:
                                  return limit.bounds_control();
                              }
                            });
  return 200.0 + 90.0 * static_cast<double>(of_control);
}

/// The way of a branch turn by turn, and the mesh that it ends on.
///
/// \param limited  null without limits
Cost of_adaptive_mesh(double turns, const Discretisation& mesh,
                      const Scene* limited) {
  const double tolerance = mesh.wanted_tolerance();
  if (mesh.formulation == Formulation::ArcLength) {
    // The error of straight pieces falls with the square of their number.
    const double nodes = (0.6 + 0.3 * turns) / std::sqrt(tolerance);
    return {nodes, 3.4e3 * nodes, 1.8e-5 * nodes};
  }
  constexpr double kOrder = 12.0;  // 2 p of the degree 6
  const double finer = std::pow(kDefaultTolerance / tolerance, 1.0 / kOrder);
  const Cost way{(40.0 + 26.0 * turns) * finer,
                 (2e6 + kBytesPerTurn * turns) * finer,
                 1.6e-3 * turns + 9e-5 * std::pow(turns, 1.5)};
  if (limited == nullptr) return way;
  // The program is solved on several meshes, each from another guess of the
  // arcs.
  const double nodes =
      std::max(150.0, nodes_per_turn(*limited) * turns) * finer;
  return {nodes, way.bytes + 20e3 * nodes, way.seconds + 2.0e-4 * nodes};
}

/// The indirect method, and the mesh on which its extremal is judged: see
/// fine_mesh().
Cost of_shooting(double turns) {
  return {1.0 + 128.0 * (turns + 0.5), 3e6 + 0.35e6 * turns, 8e-3 * turns};
}

/// The paper's system: dense matrices of its 2 n + 1 equations, or a band.
Cost of_discrete_system(const DiscreteSystem& system) {
  const double n = system.nodes;
  const double matrix = sizeof(double) * std::pow(2.0 * n + 1.0, 2);
  switch (system.solver) {
    case DiscreteSolver::Hybrid:
      return {n, 3.3 * matrix, 5.5e-8 * std::pow(n, 3)};
    case DiscreteSolver::Newton:
      return {n, 2.2 * matrix, 2.6e-9 * std::pow(n, 3)};
    case DiscreteSolver::Lifted:
      break;
  }
  return {n, 3e3 * n, 1.6e-4 * n};
}

/// N p + 1 of a mesh that is fixed.
std::optional<double> nodes_of(const Discretisation& mesh) {
  if (mesh.nodes) return *mesh.nodes;
  if (mesh.elements) return 1.0 + 1.0 * *mesh.elements * mesh.degree_of_fixed();
  return std::nullopt;
}

/// The other extremals, each with its mesh, of which the answer may be one.
Cost with_search(Cost cost, double turns) {
  return {1.3 * cost.nodes, cost.bytes + 0.5e6 * turns, cost.seconds};
}

/// Of the mesh on which sensitivities are found: those by an offset make turns
/// matter that did not; see resolve_turns().
double nodes_of_sensitivities(const PosedProblem& posed, double nodes) {
  const double way = posed.cycloid->arc_length(posed.cycloid->psi_end);
  return std::max(nodes, most_resolving_nodes(posed.natural.body, way));
}

/// What is asked for besides the answer [s].
double seconds_beside(const PosedProblem& posed, double turns, double nodes) {
  double seconds = 0.0;
  if (posed.options.searches()) seconds += 0.8 + 0.5 * turns;
  // 3 to 16 s were measured (docs/numerics.md).
  if (posed.options.searches() && posed.limited) seconds += 3.0 + 4.0 * turns;
  if (posed.program.certify == Certify::Extremal) {
    seconds += 0.02 + 3e-3 * turns;
  }
  switch (posed.program.sensitivities) {
    case SensitivityOrder::None:
      break;
    case SensitivityOrder::First:
      seconds += 4e-5 * nodes_of_sensitivities(posed, nodes);
      break;
    case SensitivityOrder::Second:
      seconds += 1.2e-3 * nodes_of_sensitivities(posed, nodes);
  }
  return seconds;
}

/// "21 GB".
std::string in_bytes(double bytes) {
  constexpr std::array kUnits{"B", "kB", "MB", "GB", "TB"};
  std::size_t unit = 0;
  while (bytes >= 1e3 && unit + 1 < kUnits.size()) {
    bytes *= 1e-3;
    ++unit;
  }
  return fmt::format("{:.3g} {}", bytes, kUnits.at(unit));
}

}  // namespace

Forecast forecast(const PosedProblem& posed) {
  Forecast out;
  out.turns = turns(posed.natural.body,
                    posed.cycloid->arc_length(posed.cycloid->psi_end));
  const Scene* limited = posed.limited ? &*posed.limited : nullptr;
  const Cost way = of_adaptive_mesh(out.turns, {}, nullptr);
  Cost cost = way;
  if (posed.options.of<Shooting>() != nullptr) {
    cost = of_shooting(out.turns);
    out.adaptive = true;
  } else if (const auto* system = posed.options.of<DiscreteSystem>()) {
    cost = of_discrete_system(*system);
  } else if (const std::optional<double> nodes =
                 nodes_of(posed.program.discretisation)) {
    cost = of_fixed_mesh(*nodes, posed.program, limited != nullptr);
  } else {
    cost = of_adaptive_mesh(out.turns, posed.program.discretisation, limited);
    out.adaptive = true;
  }
  if (posed.options.searches() && out.adaptive) {
    cost = with_search(cost, out.turns);
  }
  if (posed.program.sensitivities != SensitivityOrder::None) {
    constexpr double kBytesPerNode = 4e3;
    const double nodes = nodes_of_sensitivities(posed, 0.0);
    cost.bytes = std::max(cost.bytes, kBytesPerNode * nodes);
  }
  // Every method but the paper's begins with the branch on a coarse mesh.
  out.nodes = std::ceil(cost.nodes);
  out.bytes = std::ceil(kBytesOfProgram + std::max(cost.bytes, way.bytes));
  // What is refused for want of time must be too long for certain.
  constexpr double kLeastShare = 0.05;
  const double answer = kSecondsOfProgram + std::max(cost.seconds, way.seconds);
  const double speed = machine_speed();
  out.seconds = (answer + seconds_beside(posed, out.turns, out.nodes)) / speed;
  out.least_seconds = kLeastShare * answer / speed;
  return out;
}

std::optional<Forecast> forecast(const Scene& scene,
                                 const SolveOptions& options) {
  const PosedProblem posed = pose(scene, options, {});
  if (!posed.cycloid) return std::nullopt;
  return forecast(posed);
}

std::optional<Outcome> too_large(const Forecast& size, double available_bytes,
                                 double seconds) {
  const bool too_much = size.bytes > available_bytes;
  if (!too_much && !(size.least_seconds > seconds)) return std::nullopt;
  const bool by_turns = kBytesPerTurn * size.turns >= 0.5 * size.bytes;
  const std::string what =
      by_turns ? fmt::format("the body turns about {:.2g} times on its way",
                             size.turns)
               : fmt::format("the mesh has {:.3g} nodes", size.nodes);
  return Outcome{
      too_much ? Status::OutOfMemory : Status::TimeLimit,
      fmt::format("{}, which takes about {} of memory and {:.2g} s; there "
                  "are {}, and limits.seconds is {:g}. Nothing was computed. "
                  "{}",
                  what, in_bytes(size.bytes), size.seconds,
                  std::isfinite(available_bytes) ? in_bytes(available_bytes)
                                                 : "no bounds on memory",
                  seconds,
                  by_turns ? "Try a larger radius, or a nearer point B"
                           : "Try fewer nodes")};
}

std::optional<Outcome> too_large(const Forecast& size, double seconds) {
  // To ask the kernel takes a per cent or so of a small solve.
  constexpr double kLittle = 32e6;
  return too_large(size, size.bytes <= kLittle ? kInfinity : available_memory(),
                   seconds);
}

std::string in_words(const Forecast& size) {
  return fmt::format("about {:.3g} nodes{}, {} of memory, {:.2g} s", size.nodes,
                     size.adaptive ? " at most" : "", in_bytes(size.bytes),
                     size.seconds);
}

}  // namespace brachisto
