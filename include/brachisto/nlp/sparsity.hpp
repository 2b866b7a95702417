// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Sparsity patterns in coordinate form.

#pragma once

#include <cstddef>
#include <vector>

namespace brachisto::nlp {

/// Positions of the entries of a sparse matrix, 0-based, fixed for life. The
/// value arrays of a matrix follow the same order. A position may occur more
/// than once; its values then add up, as Ipopt and MUMPS have it.
struct SparsityPattern {
  std::vector<int> rows;
  std::vector<int> cols;

  [[nodiscard]] std::size_t num_entries() const { return rows.size(); }
};

}  // namespace brachisto::nlp
