// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "comparison/methods.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "math/enum_table.hpp"

namespace brachisto::comparison {

namespace {

using Kind = ComparedMethod::Kind;

/// What an arm of the discrete system is run with.
struct Arm {
  const char* name;
  DiscreteSolver solver;
  std::optional<DiscreteReading::Datum> datum = {};  ///< else the problem's
};

Arm arm_of(const ComparedMethod& method) {
  using Datum = DiscreteReading::Datum;
  constexpr auto kArms = table_by<DiscreteArm>(
      Arm{"rest", DiscreteSolver::Hybrid, Datum::Rest},
      Arm{"release", DiscreteSolver::Hybrid, Datum::Release},
      Arm{"newton", DiscreteSolver::Newton},
      Arm{"lifted", DiscreteSolver::Lifted});
  return kArms[method.arm];
}

/// \param degree  between the name of collocation and its degree
std::string named(const ComparedMethod& method, const char* degree) {
  switch (method.kind) {
    case Kind::RollingTime:
      return fmt::format("rolling_time{}{}", degree, method.degree);
    case Kind::Adaptive:
      return "adaptive";
    case Kind::ArcLength:
      return "arc_length";
    case Kind::Extremal:
      return "extremal";
    case Kind::DiscreteSystem:
      return fmt::format("fsolve {}", arm_of(method).name);
  }
  return "";
}

}  // namespace

std::string label(const ComparedMethod& method) {
  return named(method, " p = ");
}

std::string identifier(const ComparedMethod& method) {
  std::string id = named(method, "_");
  std::ranges::replace(id, ' ', '_');
  return id;
}

bool has_meshes(const ComparedMethod& method) {
  return method.kind != Kind::Extremal && method.kind != Kind::Adaptive;
}

std::string text(const Fineness& fineness) {
  if (fineness.mesh > 0) return std::to_string(fineness.mesh);
  if (fineness.tolerance) return fmt::format("{:.0e}", *fineness.tolerance);
  return "";
}

std::vector<Fineness> points_of(const ComparedMethod& method,
                                const WorkPrecisionPlan& plan) {
  std::vector<Fineness> points;
  if (has_meshes(method)) {
    for (const int mesh : plan.meshes) {
      if (mesh >= smallest_mesh(method)) points.push_back({.mesh = mesh});
    }
  } else if (method.kind == Kind::Adaptive) {
    for (const double tolerance : plan.tolerances) {
      points.push_back({.tolerance = tolerance});
    }
  } else {
    points.emplace_back();
  }
  return points;
}

std::string party(const ComparedMethod& method) {
  switch (method.kind) {
    case Kind::RollingTime:
    case Kind::Adaptive:
      return "the program";
    case Kind::Extremal:
      return "the extremal method";
    case Kind::DiscreteSystem:
      return "fsolve";
    case Kind::ArcLength:
      break;
  }
  return named(method, "");
}

int smallest_mesh(const ComparedMethod& method) {
  // With fewer the discrete system, too, has chords that make no path.
  const bool needs_pieces =
      method.kind == Kind::ArcLength || method.kind == Kind::DiscreteSystem;
  return needs_pieces ? kFewestPieces : 1;
}

std::optional<int> promised_order(const ComparedMethod& method, bool limited) {
  if (method.kind == Kind::RollingTime) {
    return 2 * method.degree - (limited ? 1 : 0);
  }
  if (method.kind == Kind::ArcLength) return 2;
  return std::nullopt;
}

SolveOptions options_of(const ComparedMethod& method, const Fineness& fineness,
                        const SolveOptions& base) {
  SolveOptions options{.limits = base.limits};
  const auto stated = base.or_default<Collocation>();
  auto& program = options.use<Collocation>();
  program.linear_solver = stated.linear_solver;
  program.threads = stated.threads;
  program.tolerance = stated.tolerance;
  program.polish = stated.polish;
  if (has_meshes(method)) program.discretisation.elements = fineness.mesh;
  switch (method.kind) {
    case Kind::RollingTime:
      program.discretisation.degree = method.degree;
      break;
    case Kind::Adaptive:
      program.discretisation.tolerance = fineness.tolerance;
      break;
    case Kind::ArcLength:
      program.discretisation.formulation = Formulation::ArcLength;
      break;
    case Kind::Extremal:
      options.method = Shooting{};
      break;
    case Kind::DiscreteSystem: {
      auto system = base.or_default<DiscreteSystem>();
      system.nodes = fineness.mesh;
      const Arm arm = arm_of(method);
      system.solver = arm.solver;
      system.reading.datum = arm.datum.value_or(system.reading.datum);
      options.method = system;
    }
  }
  return options;
}

}  // namespace brachisto::comparison
