// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Who factorises the KKT matrices.

#pragma once

#include <string_view>

namespace brachisto {

/// Factorisation of symmetric indefinite matrices.
enum class LinearSolver {
  Auto,   ///< Chain where the problem is a chain, Mumps otherwise
  Chain,  ///< along the chain of elements; only for such problems
  Mumps,  ///< multifrontal, for any sparsity
};

/// "auto", "chain", "mumps".
[[nodiscard]] std::string_view name(LinearSolver solver);

}  // namespace brachisto
