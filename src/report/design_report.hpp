// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A design in words, and as a picture: τ over two numbers of the body, and how
/// the searches went there.

#pragma once

#include <string>
#include <vector>

#include "brachisto/study/design.hpp"
#include "report/figure.hpp"
#include "report/sweep_table.hpp"

namespace brachisto::report {

/// A map with the ways of the searches across it.
/// \param table  a product of two axes with one numeric column each, keys of
///               the scene's body
[[nodiscard]] Figure design_map_figure(const SweepTable& table,
                                       const std::vector<DesignPath>& paths);

/// The bodies that it has found, and what it took.
void add_design(std::string& out, const DesignAnswer& design);

}  // namespace brachisto::report
