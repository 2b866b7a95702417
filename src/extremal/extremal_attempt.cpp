// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/extremal_attempt.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace brachisto::shooting {

void ExtremalAttempt::fail(ExtremalStatus status, std::string_view details) {
  solution_.status = status;
  solution_.message = fmt::format("{}: {}", describe(status), details);
}

void ExtremalAttempt::stop(std::string_view where) {
  fail(options_.stop.interrupted() ? ExtremalStatus::Interrupted
                                   : ExtremalStatus::TimeLimit,
       where);
}

void ExtremalAttempt::judge() {
  Regularity& found = solution_.regularity;
  found = solution_.path.regularity();
  if (!found.keeps_moving()) {
    fail(ExtremalStatus::Stalls,
         fmt::format("its speed falls to {:.3g} of the largest; try another "
                     "guess",
                     found.min_w));
  } else if (!found.free_of_loops()) {
    fail(ExtremalStatus::Loop,
         fmt::format("its slope angle runs from {:.4g} to {:.4g}; try another "
                     "guess",
                     found.min_beta, found.max_beta));
  } else if (!found.legendre_holds()) {
    fail(ExtremalStatus::NotMinimal,
         fmt::format("∂²𝓗/∂β² falls to {:.3g}; try another guess",
                     found.min_legendre));
  } else if (!(solution_.error_estimate <=
               std::max(options_.tolerance, 1e-14))) {
    fail(ExtremalStatus::AccuracyNotReached,
         fmt::format("the relative error of T is about {:.1e} instead of "
                     "{:.1e}, because of rounding or a sharply bent path",
                     solution_.error_estimate, options_.tolerance));
  } else {
    solution_.status = ExtremalStatus::Solved;
    solution_.message = describe(ExtremalStatus::Solved);
  }
}

}  // namespace brachisto::shooting
