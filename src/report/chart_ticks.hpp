// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Numbers at the sides of a chart.

#pragma once

#include <vector>

#include "report/axis.hpp"

namespace brachisto::report {

/// A number as a journal prints it, rich text: "−2.5·10^{−6}".
/// \param digits  at most so many
[[nodiscard]] std::string number_words(double value, int digits = 6);

/// Ticks from `low` to `high`, in units of the axis, about `count` of them with
/// a number: round numbers, or powers of ten with short ticks between them.
[[nodiscard]] std::vector<Tick> chart_ticks(Scale scale, double low,
                                            double high, int count);

}  // namespace brachisto::report
