// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A picture of the path.

#pragma once

#include "brachisto/study/solution.hpp"
#include "report/figure.hpp"

namespace brachisto::report {

/// The track, the path of the centre and, for an off-centred body, that of the
/// centre of mass, to scale, z down, with the body at equal time steps and
/// marks where it could not run; bands where limits hold as equations, and what
/// they forbid. What the track is, the body and the scene
/// stand above. Where the body is too small to be seen, the flattest piece of
/// the track is shown enlarged below.
///
/// \pre the solution has a motion that arrives
[[nodiscard]] Figure path_figure(const Solution& solution);

}  // namespace brachisto::report
