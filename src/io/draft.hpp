// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A problem while its keys are read, in whatever order they come.

#pragma once

#include <utility>

#include "brachisto/io/problem_file.hpp"
#include "model/field.hpp"

namespace brachisto::io {

/// What `solver.method` names.
enum class MethodWord { Auto, Ipopt, NewtonKkt, Extremal, Fsolve };

/// A problem with a place for the keys of every method; which of them mean
/// something, the method decides in the end. Its body has the numbers that are
/// written: those of a ball are its own.
struct Draft : ProblemFile {
  MethodWord method = MethodWord::Ipopt;
  Collocation program;
  Shooting shooting;
  DiscreteSystem system;

  Draft() = default;
  explicit Draft(ProblemFile problem) : ProblemFile(std::move(problem)) {
    scene.body = as_stated(scene.body);
    if (const auto* stated = options.of<Collocation>()) {
      program = *stated;
      method = program.in_lanes                         ? MethodWord::Auto
               : program.solver == ProgramSolver::Ipopt ? MethodWord::Ipopt
                                                        : MethodWord::NewtonKkt;
    } else if (const auto* shoots = options.of<Shooting>()) {
      shooting = *shoots;
      method = MethodWord::Extremal;
    } else {
      system = options.or_default<DiscreteSystem>();
      method = MethodWord::Fsolve;
    }
  }

  [[nodiscard]] constexpr bool poses_the_program() const {
    return uses_ipopt() || method == MethodWord::NewtonKkt;
  }
  [[nodiscard]] constexpr bool uses_ipopt() const {
    return method == MethodWord::Ipopt || method == MethodWord::Auto;
  }
  [[nodiscard]] constexpr bool of_pieces() const {
    return poses_the_program() &&
           program.discretisation.formulation == Formulation::ArcLength;
  }

  /// The problem with the options of its method alone, with the gravity at A of
  /// its field and the limits that it implies.
  [[nodiscard]] ProblemFile problem() const {
    ProblemFile out = *this;
    out.scene = with_implied_limits(scene);
    out.scene.body = as_it_rolls(scene.body);
    out.scene.gravity = gravity_at_A(scene);
    if (method == MethodWord::Extremal) {
      out.options.method = shooting;
    } else if (method == MethodWord::Fsolve) {
      out.options.method = system;
    } else {
      auto& chosen = out.options.use<Collocation>();
      chosen = program;
      chosen.solver =
          uses_ipopt() ? ProgramSolver::Ipopt : ProgramSolver::NewtonKkt;
      chosen.in_lanes = method == MethodWord::Auto;
    }
    return out;
  }
};

}  // namespace brachisto::io
