// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The chain factorisation as a linear solver of Ipopt, which is not made for
// further ones: it takes the place of HSL's MA97.

#pragma once

#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "brachisto/nlp/problem.hpp"
#include "brachisto/solvers/program_solvers.hpp"

namespace brachisto {

/// Puts the chain factorisation of one problem in the place of MA97 as long as
/// it lives; Ipopt uses it if its option linear_solver says ma97.
///
/// Ipopt lets a program set the functions of MA97 (set_ma97_functions()) but
/// hands no pointer of ours to them, so the hook in force is a variable of the
/// process: it lives within a OneAtATime, as MUMPS has to.
struct ChainHook {
  /// Whether the Ipopt this was compiled against lets it in.
  [[nodiscard]] static bool available();

  /// \pre available(), the problem states a chain structure, and no other hook
  ///      lives
  ChainHook(const nlp::Problem& problem, std::string_view wanted);
  ~ChainHook();
  ChainHook(const ChainHook&) = delete;
  ChainHook& operator=(const ChainHook&) = delete;

  /// The release to insist on, ipopt_release() but in tests.
  std::string_view wanted_release;
  /// That of the Ipopt that runs, by its own words; empty until then.
  std::string release;
  /// In Ipopt's numbering of the KKT matrix: free variables, slacks of
  /// inequalities, multipliers of equations, multipliers of inequalities.
  nlp::ChainStructure structure;
  /// Of these the ones with bounds, whose diagonal entries grow without limit.
  std::vector<int> bounded;
  struct Inequality {
    int slack, multiplier;
  };
  std::vector<Inequality> inequalities;  ///< by unknowns
  /// Of all factorisations, see ChainLdlt::effort().
  double effort = 0.0;
  /// Why the matrix Ipopt came with is not the chain it should be; empty if it
  /// is. Ipopt itself then ends with an internal error.
  std::string refusal;
  /// What the factorisation threw, if it did.
  std::exception_ptr exception;
};

/// The same as without a release, for the chain to insist on another one.
[[nodiscard]] SolverResult solve_with_ipopt(nlp::Problem& problem,
                                            const PrimalDual& start,
                                            const IpoptOptions& options,
                                            std::string_view release);

}  // namespace brachisto
