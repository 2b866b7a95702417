// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The files of the reproduction.

#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "report/figure.hpp"
#include "report/text_table.hpp"
#include "reproduction/claims.hpp"
#include "reproduction/figures.hpp"
#include "reproduction/printed_numbers.hpp"

namespace brachisto::reproduction {

/// All that is found, ready to be written.
struct Reproduction {
  std::vector<PrintedNumber> comparisons;
  std::vector<Claim> claims;
  std::vector<Figure> figures;
};

[[nodiscard]] Reproduction reproduce(const Results& found);

/// index.html, which needs nothing beside it; comparison.csv, claims.csv,
/// cases.csv, orientations.csv, boundary.csv; of every figure an SVG document,
/// its numbers and a gnuplot script.
///
/// \param interrupt  nonzero: stop; may be null
/// \throws Stopped
[[nodiscard]] report::DrawnFiles files(const Results& found,
                                       const Reproduction& made,
                                       const std::atomic<int>* interrupt);

/// The comparison and the claims for a terminal.
[[nodiscard]] std::string numbers_text(const Reproduction& made,
                                       report::TableForm form);

/// The same as one JSON document.
[[nodiscard]] std::string to_json(const Results& found,
                                  const Reproduction& made);

}  // namespace brachisto::reproduction
