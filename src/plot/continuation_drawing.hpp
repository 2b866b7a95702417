// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The way from the uniform cylinder to the body.

#pragma once

#include <string>

#include "report/result_field.hpp"

namespace brachisto::plot {

/// φ over η_m, step by step: a small drawing in HTML, empty of fewer than three
/// steps.
/// \param steps  `continuation` of a result
[[nodiscard]] std::string continuation_drawing(const report::Json& steps);

}  // namespace brachisto::plot
