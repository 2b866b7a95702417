// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/ma97_functions.hpp"

#include <IpoptConfig.h>

// 3.11.9 has a loader of its own with a function for it. 3.14 has a member of a
// class whose header is not installed: it is declared here as it stands there,
// with scales that are not const.
#if IPOPT_VERSION_MAJOR == 3 && IPOPT_VERSION_MINOR == 11 && \
    IPOPT_VERSION_RELEASE == 9 && __has_include(<HSLLoader.h>)
#define BRACHISTO_MA97_BY 11
#include <HSLLoader.h>
#elif IPOPT_VERSION_MAJOR == 3 && IPOPT_VERSION_MINOR == 14
#define BRACHISTO_MA97_BY 14
namespace Ipopt {
class Ma97SolverInterface {
 public:
  using Functions = brachisto::Ma97Functions;
  static void SetFunctions(
      decltype(Functions::default_control), decltype(Functions::analyse),
      void (*factor)(int, const int*, const int*, const double*, void**, void**,
                     const ma97_control_d*, ma97_info_d*, double*),
      void (*factor_solve)(int, const int*, const int*, const double*, int,
                           double*, int, void**, void**, const ma97_control_d*,
                           ma97_info_d*, double*),
      decltype(Functions::solve), decltype(Functions::finalise),
      decltype(Functions::free_akeep));
};
}  // namespace Ipopt
#else
#define BRACHISTO_MA97_BY 0
#endif

namespace brachisto {

bool takes_ma97_functions() {
  return BRACHISTO_MA97_BY != 0;
}

std::string_view ipopt_release() {
  return IPOPT_VERSION;
}

#if BRACHISTO_MA97_BY == 14
namespace {

Ma97Functions in_force;

void factor(int type, const int ptr[], const int row[], const double val[],
            void** akeep, void** fkeep, const ma97_control_d* control,
            ma97_info_d* info, double scale[]) {
  in_force.factor(type, ptr, row, val, akeep, fkeep, control, info, scale);
}

void factor_solve(int type, const int ptr[], const int row[],
                  const double val[], int nrhs, double x[], int ldx,
                  void** akeep, void** fkeep, const ma97_control_d* control,
                  ma97_info_d* info, double scale[]) {
  in_force.factor_solve(type, ptr, row, val, nrhs, x, ldx, akeep, fkeep,
                        control, info, scale);
}

}  // namespace
#endif

void set_ma97_functions([[maybe_unused]] const Ma97Functions& functions) {
#if BRACHISTO_MA97_BY == 11
  LSL_setMA97(functions.default_control, functions.analyse, functions.factor,
              functions.factor_solve, functions.solve, functions.finalise,
              functions.free_akeep);
#elif BRACHISTO_MA97_BY == 14
  in_force = functions;
  Ipopt::Ma97SolverInterface::SetFunctions(
      functions.default_control, functions.analyse, factor, factor_solve,
      functions.solve, functions.finalise, functions.free_akeep);
#endif
}

}  // namespace brachisto
