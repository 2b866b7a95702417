// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Second-order sufficiency: the inertia of the KKT matrix.

#pragma once

#include "brachisto/nlp/problem.hpp"
#include "brachisto/solvers/status.hpp"

namespace brachisto {

/// Numbers of eigenvalues by sign.
struct Inertia {
  int positive = 0;
  int negative = 0;
  int zero = 0;
  bool known = false;  ///< else the numbers mean nothing
};

/// Inertia of the KKT matrix [H Jᵀ; J 0] of the free variables and the
/// constraints at a point, both as nlp::active_set() has it there, from an LDLᵀ
/// factorisation with pivoting. With LinearSolver::Chain it is unknown for a
/// problem that states no chain structure; Auto tries the chain, then MUMPS.
///
/// More constraints than variables depend on each other, and fewer may; rounding
/// gives the zero eigenvalues any sign. Where there are more constraints, or
/// more positive eigenvalues than variables, which no such matrix has, −δ I
/// takes the place of 0, by MUMPS alone: with it the matrix has as many positive
/// eigenvalues as H + Jᵀ J/δ, and if these are n, H is positive definite on the
/// null space of J whatever δ > 0 is. If they are fewer nothing is known. The
/// others are of that matrix.
///
/// (n, m, 0) for n free variables and m constraints means that the Hessian of
/// the Lagrangian is positive definite on the null space of J: at a stationary
/// point, a strict local minimum if the inequalities that hold as equations
/// have multipliers of the right sign, none zero. Of the *discrete* problem at
/// fixed end points, no more.
///
/// \throws std::domain_error if the problem is not evaluable at x
[[nodiscard]] Inertia kkt_inertia(nlp::Problem& problem,
                                  const PrimalDual& point,
                                  LinearSolver solver = LinearSolver::Auto);

}  // namespace brachisto
