// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The chain factorisation of a problem's KKT matrix.

#pragma once

#include <memory>

#include "brachisto/nlp/problem.hpp"
#include "solvers/chain_ldlt.hpp"

namespace brachisto {

/// The structure that the problem states, fixed variables absent.
[[nodiscard]] nlp::ChainStructure chain_of_free_unknowns(
    const nlp::Problem& problem);

/// For the matrix [H Jᵀ; J 0] of free variables and multipliers, values in two
/// arrays: those of hess_lag_pattern() and those of jac_g_pattern(). Unknowns
/// are numbered as they are in the problem, variables, then multipliers.
///
/// \return null if the problem states no chain structure that fits its patterns
[[nodiscard]] std::unique_ptr<ChainLdlt> make_chain_ldlt(
    const nlp::Problem& problem);

}  // namespace brachisto
