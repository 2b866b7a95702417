// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How methods look in pictures.

#pragma once

#include <cstddef>
#include <string>

#include "brachisto/io/problem_file.hpp"
#include "report/chart.hpp"

namespace brachisto::comparison {

/// Different in grey too.
struct Look {
  std::string colour;
  report::Stroke stroke;
  report::Mark mark;
};

/// \param degrees  number of lines of collocation, and which of them this is
[[nodiscard]] Look look_of(const ComparedMethod& method, std::size_t degrees,
                           std::size_t index);

/// Its label without what rich text would lower.
[[nodiscard]] std::string words(const ComparedMethod& method);

/// Upright at kSpokenError, from one time to another.
[[nodiscard]] report::Curve line_of_spoken_error(double low, double high);

}  // namespace brachisto::comparison
