// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The path that a centre took, stated in its scene: others may be put on it.

#pragma once

#include "brachisto/model/scene.hpp"
#include "brachisto/trajectory/motion.hpp"

namespace brachisto {

/// As it was given, if it was; otherwise by the slopes of a fine sample, to the
/// fourth order of its steps where the joints of the motion are known and to
/// the second elsewhere, bent by as little so that the track ends at B.
[[nodiscard]] Scene on_its_path(const Motion& motion);

}  // namespace brachisto
