// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Numeric factorisation of several matrices that share one symbolic analysis,
// one to a lane, and solutions with them.

#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "solvers/symbolic_analysis.hpp"

namespace brachisto {

inline constexpr int kLanes = 8;

/// One number of each lane.
struct alignas(64) Lanes {
  double lane[kLanes];
};

/// What a factorisation found, lane by lane.
struct FactorisationOutcome {
  Lanes negative;  ///< number of negative pivots
  /// Σ of the squares of all multipliers; not finite if a pivot is zero. This
  /// measures how much the factorisation may have magnified rounding.
  Lanes growth;
};

/// The numbers that a slot takes from one array, one to a lane: those of link i
/// are at first + stride i.
struct LaneSource {
  int array = 0;
  int slot = 0;          ///< 0: none, for they are zero
  bool adds = false;     ///< to what is there
  int row = 0, col = 0;  ///< local unknowns
  std::ptrdiff_t first = 0, stride = 0;
};
/// The link of each lane.
using LaneLinks = std::array<std::ptrdiff_t, kLanes>;

/// Fills slots from arrays.
///
/// \param scale    of the local unknowns, which the numbers are multiplied by;
///                 may be null
/// \param largest  [in,out] largest absolute value; not a number stays
/// \return a bit to each lane with a number that is not zero for slot 0
[[nodiscard]] unsigned gather(std::span<const LaneSource> sources,
                              const double* const* arrays,
                              const LaneLinks& links, const Lanes* scale,
                              Lanes* slots, Lanes& largest);

/// Factorises: on entry the slots hold the matrix, zero elsewhere; on exit the
/// factor and the Schur complement.
///
/// \param lanes  the first so many are asked for, here and below
void numeric_factorisation(const SymbolicAnalysis& analysis, Lanes* slots,
                           FactorisationOutcome& outcome, int lanes = kLanes);

/// Solves with the unit lower factor and the block diagonal one: `y`, one
/// number to a local unknown, holds the right-hand side of the interior; on
/// exit the solution so far there, and in the other unknowns what is to be
/// added to their right-hand side.
void forward_substitution(const SymbolicAnalysis& analysis, const Lanes* slots,
                          Lanes* y, int lanes = kLanes);

/// Solves with the transposed factor, the unknowns outside the interior known.
void backward_substitution(const SymbolicAnalysis& analysis, const Lanes* slots,
                           Lanes* y, int lanes = kLanes);

/// The largest absolute value; what is not a number is passed over.
[[nodiscard]] double largest_of(const double* values, int count);

/// Subtracts l pᵀ, or l pᵀ + m qᵀ, from the rows and columns of a square matrix
/// from `from` on, but columns with zeros alone in p and q.
///
/// \param matrix  column by column; p and q may be columns of it before `from`
/// \return the columns that it changed
int subtract_outer(double* matrix, int size, int from, const double* l,
                   const double* p);
int subtract_outer(double* matrix, int size, int from, const double* l,
                   const double* p, const double* m, const double* q);

}  // namespace brachisto
