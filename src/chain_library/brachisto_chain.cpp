// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "chain_library/brachisto_chain.h"

#include <cstddef>
#include <exception>

#include "brachisto/math/index.hpp"
#include "chain_library/matrix.hpp"
#include "solvers/ma97.hpp"

struct brachisto_chain {
  brachisto::chain_library::Matrix matrix;
  bool good = false;  ///< the last factorisation
};

namespace {

/// What `work` returns, or `failed`; nothing may be thrown through the caller.
template <class Result, class Work>
Result guarded(Result failed, Work&& work) {
  try {
    return work();
  } catch (const std::exception& error) {
    brachisto::chain_library::say_once(error.what());
    return failed;
  }
}

}  // namespace

extern "C" {

brachisto_chain* brachisto_chain_new(int n, const int ptr[], const int col[],
                                     int first) {
  return guarded<brachisto_chain*>(nullptr, [&] {
    return new brachisto_chain{
        {n, brachisto::triangle_pattern(n, ptr, col, first)}};
  });
}

brachisto_chain_status brachisto_chain_factorise(
    brachisto_chain* matrix, const double values[],
    brachisto_chain_inertia* inertia) {
  matrix->good = false;
  return guarded(BRACHISTO_CHAIN_FAILED, [&] {
    const brachisto::Inertia found =
        matrix->matrix.factorise({values, matrix->matrix.num_entries()});
    if (!found.known) return BRACHISTO_CHAIN_NONE;
    if (inertia != nullptr) {
      *inertia = {found.positive, found.negative, found.zero};
    }
    if (found.zero > 0) return BRACHISTO_CHAIN_SINGULAR;
    matrix->good = true;
    return BRACHISTO_CHAIN_OK;
  });
}

brachisto_chain_status brachisto_chain_solve(const brachisto_chain* matrix,
                                             int count, double x[]) {
  return guarded(BRACHISTO_CHAIN_FAILED, [&] {
    if (!matrix->good) return BRACHISTO_CHAIN_FAILED;
    const std::size_t n = brachisto::at(matrix->matrix.size());
    for (int k = 0; k < count; ++k) {
      matrix->matrix.solve({x + brachisto::at(k) * n, n});
    }
    return BRACHISTO_CHAIN_OK;
  });
}

void brachisto_chain_delete(brachisto_chain* matrix) {
  delete matrix;
}

}  // extern "C"
