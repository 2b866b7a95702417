// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/ma97_functions.hpp"

#include <IpoptConfig.h>

// 3.11.9 has a loader of its own with a function for it. 3.14 has a member of a
// class whose header is not installed: it is declared here as it stands there.
#if IPOPT_VERSION_MAJOR == 3 && IPOPT_VERSION_MINOR == 11 && \
    IPOPT_VERSION_RELEASE == 9 && __has_include(<HSLLoader.h>)
#define BRACHISTO_MA97_BY 11
#include <HSLLoader.h>
#elif IPOPT_VERSION_MAJOR == 3 && IPOPT_VERSION_MINOR == 14
#define BRACHISTO_MA97_BY 14
namespace Ipopt {
class Ma97SolverInterface {
 public:
  static void SetFunctions(decltype(brachisto::Ma97Functions::default_control),
                           decltype(brachisto::Ma97Functions::analyse),
                           decltype(brachisto::Ma97Functions::factor),
                           decltype(brachisto::Ma97Functions::factor_solve),
                           decltype(brachisto::Ma97Functions::solve),
                           decltype(brachisto::Ma97Functions::finalise),
                           decltype(brachisto::Ma97Functions::free_akeep));
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

void set_ma97_functions([[maybe_unused]] const Ma97Functions& functions) {
#if BRACHISTO_MA97_BY == 11
  LSL_setMA97(functions.default_control, functions.analyse, functions.factor,
              functions.factor_solve, functions.solve, functions.finalise,
              functions.free_akeep);
#elif BRACHISTO_MA97_BY == 14
  Ipopt::Ma97SolverInterface::SetFunctions(
      functions.default_control, functions.analyse, functions.factor,
      functions.factor_solve, functions.solve, functions.finalise,
      functions.free_akeep);
#endif
}

}  // namespace brachisto
