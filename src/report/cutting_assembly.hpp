// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How parts are put together: a picture and tables.

#pragma once

#include <vector>

#include "report/cutting_pieces.hpp"
#include "report/cutting_sheet.hpp"
#include "trajectory/displacement.hpp"

namespace brachisto::report::cutting {

/// "assembly-01" shows all pieces with their numbers, A and B, level and plumb
/// through A and where an error costs most; those that follow tell where each
/// piece hangs from A, and what an error costs along the track. Engraved alone.
///
/// \param sheet_of   of each piece, of two strips first those of one
/// \param stretches  times as built; none: nothing is told of errors
[[nodiscard]] std::vector<Drawing> assembly(
    const Edge& edge, const std::vector<Piece>& pieces,
    const std::vector<int>& sheet_of,
    const std::vector<DisplacedStretch>& stretches, const Build& build,
    const SheetFrame& frame);

/// A change of time in words, "+0.12 ms".
[[nodiscard]] std::string change_in_words(double seconds);

}  // namespace brachisto::report::cutting
