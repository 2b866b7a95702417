// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The files of the reproduction.

#pragma once

#include <string>
#include <vector>

#include "brachisto/report/output_files.hpp"
#include "reproduction/comparison.hpp"
#include "reproduction/figures.hpp"

namespace brachisto::reproduction {

/// All that is found, ready to be written.
struct Reproduction {
  std::vector<Comparison> comparisons;
  std::vector<Claim> claims;
  std::vector<Figure> figures;
};

[[nodiscard]] Reproduction reproduce(const Findings& found);

/// index.html, which needs nothing beside it; comparison.csv, claims.csv,
/// cases.csv, orientations.csv, boundary.csv; of every figure an SVG document,
/// its numbers and a gnuplot script.
[[nodiscard]] std::vector<report::OutputFile> files(const Findings& found,
                                                    const Reproduction& made);

/// The comparison and the claims for a terminal.
[[nodiscard]] std::string summary(const Reproduction& made);

/// The same as one JSON document.
[[nodiscard]] std::string to_json(const Findings& found,
                                  const Reproduction& made);

}  // namespace brachisto::reproduction
