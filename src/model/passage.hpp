// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Whether obstacles leave a way from A to B at all.

#pragma once

#include <string_view>
#include <vector>

#include "model/path_inequality.hpp"

namespace brachisto {

/// False only if there is none: squares of the plane in which the centre breaks
/// a limit of the place everywhere, or, if it is let go from rest, has less
/// than no kinetic energy, part where it starts from where it ends. An
/// off-centred body has to lift its mass as it turns, θ = θ_m + s/r, and may
/// not come to where it could go on. A way that is left may be too sharp, too
/// steep or too narrow all the same. What lies further off than L, H and r on
/// every side counts as open. The start is that of a smooth contact, where the
/// extremal's slope places it; of other starts nothing is said. It took 2 to 8
/// ms where a floor lets the body turn over or just not, and looks at no more
/// than five million states.
///
/// \throws Stopped  see check_stop()
[[nodiscard]] bool way_is_open(const Scene& scene,
                               const std::vector<PathInequality>& limits);

/// What to say where it is not.
inline constexpr std::string_view kNoWay =
    "no path leads from the start to B: what is in the way leaves the body no "
    "room to pass, or to turn over";

}  // namespace brachisto
