// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How a program gives Ipopt functions of its own for those of HSL's MA97: the
/// one place that knows how releases of Ipopt differ.

#pragma once

#include <string_view>

#include "solvers/ma97.hpp"

namespace brachisto {

/// The functions of MA97, as Ipopt calls them.
struct Ma97Functions {
  void (*default_control)(ma97_control_d*);
  void (*analyse)(int check, int n, const int ptr[], const int row[],
                  double val[], void** akeep, const ma97_control_d*,
                  ma97_info_d*, int order[]);
  void (*factor)(int type, const int ptr[], const int row[], const double val[],
                 void** akeep, void** fkeep, const ma97_control_d*,
                 ma97_info_d*, const double scale[]);
  void (*factor_solve)(int type, const int ptr[], const int row[],
                       const double val[], int nrhs, double x[], int ldx,
                       void** akeep, void** fkeep, const ma97_control_d*,
                       ma97_info_d*, const double scale[]);
  void (*solve)(int job, int nrhs, double x[], int ldx, void** akeep,
                void** fkeep, const ma97_control_d*, ma97_info_d*);
  void (*finalise)(void** akeep, void** fkeep);
  void (*free_akeep)(void** akeep);
};

/// Whether the Ipopt this is compiled against has a way in for them: 3.11.9,
/// and 3.14.
[[nodiscard]] bool takes_ma97_functions();
/// The release that this is compiled against: its structs are those of MA97
/// here, and its KKT matrix is known.
[[nodiscard]] std::string_view ipopt_release();
/// \pre takes_ma97_functions()
void set_ma97_functions(const Ma97Functions& functions);

}  // namespace brachisto
