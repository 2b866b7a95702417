// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Small drawings of a page: what the matrix that was factorised looks like,
/// and how the answer was come by.

#pragma once

#include <string>

#include "brachisto/model/scene.hpp"
#include "report/result_texts.hpp"

namespace brachisto::plot {

/// Which entries of the KKT matrix of one element may be other than zero, of
/// the formulation rolling_time without limits in an ordinary world: HTML.
/// \param degree    p
/// \param elements  of the mesh, told in the words below it
/// \pre scene.world.ordinary(), and no limits and no given path
[[nodiscard]] std::string block_drawing(const Scene& scene, int degree,
                                        int elements);

/// φ over η_m, step by step: a small drawing in HTML, empty of fewer than three
/// steps.
/// \param steps  `continuation` of a result
[[nodiscard]] std::string continuation_drawing(const report::Json& steps);

}  // namespace brachisto::plot
