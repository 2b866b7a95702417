// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The optimality conditions of an arc_length problem once more, by other
/// means.

#pragma once

#include "brachisto/nlp/primal_dual.hpp"
#include "brachisto/trajectory/extended_residual.hpp"
#include "brachisto/transcription/arc_length.hpp"

namespace brachisto {

/// Recomputes the residual at (x, λ) in long double. The derivatives come from
/// jets through the functions of the model; of the problem's own code only the
/// layout and the mesh are used.
[[nodiscard]] ExtendedResidual extended_residual(const ArcLength& problem,
                                                 const PrimalDual& point);

}  // namespace brachisto
