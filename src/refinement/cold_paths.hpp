// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Coarse paths under limits that owe nothing to the free extremal.

#pragma once

#include <vector>

#include "refinement/refinement.hpp"
#include "transcription/limited_curve.hpp"

namespace brachisto {

struct PassProtocol;

/// What Tightening::tighten_cold() finds from `starts` of random_ways(), once
/// where several are alike().
///
/// \param scene      in natural units, with limits
/// \param free       the extremal without them, with the end angle φ: a measure
///                   of sizes alone
/// \param options    of the solver, for all of them
/// \param most_work  of each start; see PassProtocol
/// \return fastest first
[[nodiscard]] std::vector<LimitedCurve> cold_paths(const Scene& scene,
                                                   const ExtremalCurve& free,
                                                   double phi,
                                                   const IpoptOptions& options,
                                                   int starts, double most_work,
                                                   PassProtocol& protocol);

}  // namespace brachisto
