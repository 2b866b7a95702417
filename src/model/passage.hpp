// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Whether obstacles leave a way from A to B at all.

#pragma once

#include <vector>

#include "model/path_inequality.hpp"

namespace brachisto {

/// False only if there is none: squares of the plane in which the centre breaks
/// a limit of the place everywhere, or, in an ordinary world, has less than no
/// kinetic energy whatever its θ, part where it starts from where it ends. A
/// way that is left may be too sharp, too steep or too narrow all the same.
/// What lies further off than L, H and r on every side counts as open. The
/// start is that of a smooth contact, where the extremal's slope places it; of
/// other starts nothing is said. Takes some milliseconds.
[[nodiscard]] bool way_is_open(const Scene& scene,
                               const std::vector<PathInequality>& limits);

}  // namespace brachisto
