// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The structs of HSL's MA97, release 2, as Ipopt has them.

#pragma once

#include "brachisto/nlp/problem.hpp"

// NOLINTBEGIN: names and layout are those of the C interface.
struct ma97_control_d {
  int f_arrays;  ///< whether indices count from 1
  int action, nemin;
  double multiplier;
  int ordering, print_level, scaling;
  double small, u;
  int unit_diagnostics, unit_error, unit_warning;
  long factor_min;
  int solve_blas3;
  long solve_min;
  int solve_mf;
  double consist_tol;
  int ispare[5];
  double rspare[10];
};
struct ma97_info_d {
  int flag;  ///< 0: fine; −7: singular; other negative numbers: given up
  int flag68, flag77, matrix_dup;
  int matrix_rank;
  int matrix_outrange, matrix_missing_diag, maxdepth;
  int maxfront, num_delay;
  long num_factor, num_flops;
  int num_neg;
  int num_sup, num_two, ordering, stat;
  int ispare[5];
  double rspare[10];
};
// NOLINTEND

namespace brachisto {

/// Values of ma97_info_d::flag.
inline constexpr int kMa97Singular = -7;
inline constexpr int kMa97GivenUp = -1;

/// The rows of a triangle as MA97 gets them.
/// \param first  0 or 1, from which places and indices count
/// \throws std::invalid_argument  if they are no rows, or of no such matrix
[[nodiscard]] nlp::SparsityPattern triangle_pattern(int size, const int ptr[],
                                                    const int row[], int first);

}  // namespace brachisto
