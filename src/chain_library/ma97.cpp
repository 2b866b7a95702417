// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The chain factorisation under the names of HSL's MA97, for any Ipopt that
// loads its linear solvers from a shared library.

#include "solvers/ma97.hpp"

#include <cstddef>
#include <exception>

#include "brachisto/math/index.hpp"
#include "chain_library/matrix.hpp"

namespace {

using brachisto::at;
using brachisto::kMa97GivenUp;
using brachisto::kMa97Singular;
using brachisto::chain_library::Matrix;
using brachisto::chain_library::say_once;

/// Runs `work`; nothing may be thrown through the caller.
template <class Work>
void guarded(ma97_info_d* info, Work&& work) {
  try {
    work();
  } catch (const std::exception& error) {
    say_once(error.what());
    info->flag = kMa97GivenUp;
  }
}

}  // namespace

extern "C" {

void ma97_default_control_d(ma97_control_d* control) {
  *control = {};
  control->u = 0.01;
  control->small = 1e-20;
}

void ma97_analyse_d(int /*check*/, int n, const int ptr[], const int row[],
                    double /*val*/[], void** akeep,
                    const ma97_control_d* control, ma97_info_d* info,
                    int /*order*/[]) {
  *info = {};
  *akeep = nullptr;
  guarded(info, [&] {
    *akeep = new Matrix(n, brachisto::triangle_pattern(
                               n, ptr, row, control->f_arrays != 0 ? 1 : 0));
  });
}

void ma97_factor_d(int /*type*/, const int /*ptr*/[], const int /*row*/[],
                   const double val[], void** akeep, void** /*fkeep*/,
                   const ma97_control_d* control, ma97_info_d* info,
                   const double /*scale*/[]) {
  *info = {};
  guarded(info, [&] {
    // Ipopt leaves analyse out where an ordering asks for values.
    auto* const matrix = static_cast<Matrix*>(*akeep);
    if (matrix == nullptr) {
      say_once("matched orderings are not known; ma97_order best is");
      info->flag = kMa97GivenUp;
      return;
    }
    const brachisto::Inertia inertia =
        matrix->factorise({val, matrix->num_entries()}, control->u);
    if (!inertia.known) info->flag = kMa97GivenUp;
    if (inertia.zero > 0) info->flag = kMa97Singular;
    info->matrix_rank = matrix->size() - inertia.zero;
    info->num_neg = inertia.negative;
  });
}

void ma97_solve_d(int job, int nrhs, double x[], int ldx, void** akeep,
                  void** /*fkeep*/, const ma97_control_d* /*control*/,
                  ma97_info_d* info) {
  // What the factorisation told stays; partial solutions are none of ours.
  info->flag = 0;
  guarded(info, [&] {
    const auto* const matrix = static_cast<const Matrix*>(*akeep);
    if (job != 0 || matrix == nullptr || !matrix->factorised()) {
      info->flag = kMa97GivenUp;
      return;
    }
    for (int k = 0; k < nrhs; ++k) {
      matrix->solve(
          {x + static_cast<std::ptrdiff_t>(k) * ldx, at(matrix->size())});
    }
  });
}

void ma97_factor_solve_d(int type, const int ptr[], const int row[],
                         const double val[], int nrhs, double x[], int ldx,
                         void** akeep, void** fkeep,
                         const ma97_control_d* control, ma97_info_d* info,
                         const double scale[]) {
  ma97_factor_d(type, ptr, row, val, akeep, fkeep, control, info, scale);
  if (info->flag == 0) {
    ma97_solve_d(0, nrhs, x, ldx, akeep, fkeep, control, info);
  }
}

void ma97_free_akeep_d(void** akeep) {
  delete static_cast<Matrix*>(*akeep);
  *akeep = nullptr;
}

void ma97_finalise_d(void** akeep, void** /*fkeep*/) {
  ma97_free_akeep_d(akeep);
}

}  // extern "C"
