// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "comparison/methods.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "brachisto/study/solve_options.hpp"

namespace brachisto::comparison {

namespace {

using Kind = ComparedMethod::Kind;

const char* name(DiscreteArm arm) {
  switch (arm) {
    case DiscreteArm::Rest:
      return "rest";
    case DiscreteArm::Release:
      return "release";
    case DiscreteArm::Newton:
      return "newton";
    case DiscreteArm::Lifted:
      return "lifted";
  }
  return "";
}

void take_arm(DiscreteArm arm, DiscreteSystem& system) {
  using Datum = DiscreteReading::Datum;
  switch (arm) {
    case DiscreteArm::Rest:
    case DiscreteArm::Release:
      system.solver = DiscreteSolver::Hybrid;
      system.reading.datum =
          arm == DiscreteArm::Rest ? Datum::Rest : Datum::Release;
      break;
    case DiscreteArm::Newton:
      system.solver = DiscreteSolver::Newton;
      break;
    case DiscreteArm::Lifted:
      system.solver = DiscreteSolver::Lifted;
  }
}

}  // namespace

std::string label(const ComparedMethod& method) {
  switch (method.kind) {
    case Kind::RollingTime:
      return fmt::format("rolling_time p = {}", method.degree);
    case Kind::ArcLength:
      return "arc_length";
    case Kind::Extremal:
      return "extremal";
    case Kind::DiscreteSystem:
      return fmt::format("fsolve {}", name(method.arm));
  }
  return "";
}

std::string identifier(const ComparedMethod& method) {
  std::string id = label(method);
  if (method.kind == Kind::RollingTime) {
    id = fmt::format("rolling_time_{}", method.degree);
  }
  std::ranges::replace(id, ' ', '_');
  return id;
}

bool has_meshes(const ComparedMethod& method) {
  return method.kind != Kind::Extremal;
}

int smallest_mesh(const ComparedMethod& method) {
  switch (method.kind) {
    case Kind::ArcLength:
    case Kind::DiscreteSystem:  // with fewer, too: chords that make no path
      return kFewestPieces;
    case Kind::RollingTime:
    case Kind::Extremal:
      break;
  }
  return 1;
}

std::optional<int> promised_order(const ComparedMethod& method) {
  switch (method.kind) {
    case Kind::RollingTime:
      return 2 * method.degree;
    case Kind::ArcLength:
      return 2;
    case Kind::Extremal:
    case Kind::DiscreteSystem:
      break;
  }
  return std::nullopt;
}

SolveOptions options_of(const ComparedMethod& method, int mesh,
                        const SolveOptions& base) {
  SolveOptions options{.method = {}, .limits = base.limits};
  const auto stated = base.or_default<Collocation>();
  auto& program = options.use<Collocation>();
  program.linear_solver = stated.linear_solver;
  program.tolerance = stated.tolerance;
  program.polish = stated.polish;
  program.discretisation.elements = mesh;
  switch (method.kind) {
    case Kind::RollingTime:
      program.discretisation.degree = method.degree;
      break;
    case Kind::ArcLength:
      program.discretisation.formulation = Formulation::ArcLength;
      break;
    case Kind::Extremal:
      options.method = Shooting{};
      break;
    case Kind::DiscreteSystem: {
      auto system = base.or_default<DiscreteSystem>();
      system.nodes = mesh;
      take_arm(method.arm, system);
      options.method = system;
    }
  }
  return options;
}

}  // namespace brachisto::comparison
