// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The chain factorisation of a problem's KKT matrix.

#pragma once

#include <memory>

#include "brachisto/nlp/active_set.hpp"
#include "brachisto/nlp/problem.hpp"
#include "solvers/chain_ldlt.hpp"

namespace brachisto {

/// For the matrix [H Jᵀ; J 0] of variables that are not held and constraints
/// that are, values in two arrays: those of hess_lag_pattern() and those of
/// jac_g_pattern(). Unknowns are numbered as they are in the problem,
/// variables, then multipliers.
///
/// \return null if the problem states no chain structure that fits its patterns
[[nodiscard]] std::unique_ptr<ChainLdlt> make_chain_ldlt(
    const nlp::Problem& problem, const nlp::ActiveSet& active);

}  // namespace brachisto
