// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Where other extremals and paths are sought.

#pragma once

#include <string>

#include "brachisto/model/scene.hpp"
#include "brachisto/run/solve_options.hpp"

namespace brachisto {

/// What to ask for where the principal extremal is no answer: "search: global",
/// with the key that has to change for it to be allowed; empty if that search
/// was made, or there is none: along a given path; without limits in other
/// worlds, and of bodies that are not off-centred, which have one extremal.
[[nodiscard]] std::string wider_search(const Scene& scene,
                                       const SolveOptions& options);

}  // namespace brachisto
