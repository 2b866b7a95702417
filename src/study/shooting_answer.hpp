// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Method::Extremal: an extremal of the indirect method as an answer.

#pragma once

#include "brachisto/extremal/shooting.hpp"
#include "brachisto/model/units.hpp"
#include "brachisto/study/adaptive_mesh.hpp"

namespace brachisto {

/// The extremal on a mesh fine enough for the finite problem's conditions,
/// which it must satisfy, to be its certificate: elements are halved until the
/// residual passes, or no longer falls. Nothing is solved there.
///
/// The estimated error is what T by quadrature on the mesh and by the indirect
/// method differ by, and the error of the latter.
///
/// \param natural   the scene in natural units
/// \param units     of `natural`
/// \param extremal  usable()
[[nodiscard]] MeshAnswer answer_from_extremal(const Scene& natural,
                                              const Units& units,
                                              const ExtremalSolution& extremal,
                                              const StopCondition& stop);

}  // namespace brachisto
