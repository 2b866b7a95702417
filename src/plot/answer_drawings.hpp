// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A small drawing of a page: what the matrix that was factorised looks like.

#pragma once

#include <string>

#include "brachisto/model/scene.hpp"

namespace brachisto::plot {

/// Which entries of the KKT matrix of one element may be other than zero, of
/// the formulation rolling_time without limits in an ordinary world: HTML.
/// \param degree    p
/// \param elements  of the mesh, told in the words below it
/// \pre scene.world.ordinary(), and no limits and no given path
[[nodiscard]] std::string block_drawing(const Scene& scene, int degree,
                                        int elements);

}  // namespace brachisto::plot
