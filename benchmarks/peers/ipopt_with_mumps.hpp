// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Ipopt with MUMPS as one who uses both would call them, so that all that
/// MUMPS can be told may be tried.

#pragma once

#include <array>
#include <string>

#include "brachisto/nlp/problem.hpp"
#include "brachisto/solvers/program_solvers.hpp"

namespace brachisto::benchmarks {

/// Options of Ipopt that go to MUMPS; the defaults are Ipopt's.
struct MumpsOptions {
  int pivot_order = 7;        ///< fill-reducing order; see kPivotOrders
  int permuting_scaling = 7;  ///< 0: none; 7: MUMPS decides
  int scaling = 77;           ///< 0: none; 77: MUMPS decides
  double pivot_tolerance = 1e-6;

  /// "QAMD, permuting_scaling 0, scaling 0, pivtol 1e-6".
  [[nodiscard]] std::string str() const;
};

struct PivotOrder {
  int number;
  const char* name;
};
/// 1, an order that is given, cannot be told through Ipopt.
inline constexpr std::array<PivotOrder, 7> kPivotOrders{{{0, "AMD"},
                                                         {2, "AMF"},
                                                         {3, "SCOTCH"},
                                                         {4, "PORD"},
                                                         {5, "METIS"},
                                                         {6, "QAMD"},
                                                         {7, "automatic"}}};

/// Solves a problem without inequalities from a start with multipliers, with
/// the options of solve_with_ipopt() but for MUMPS.
[[nodiscard]] SolverResult solve_with_mumps(nlp::Problem& problem,
                                            const PrimalDual& start,
                                            double tolerance,
                                            int max_iterations,
                                            const MumpsOptions& mumps);

}  // namespace brachisto::benchmarks
