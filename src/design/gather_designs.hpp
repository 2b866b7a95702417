// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What many searches of a design came to.

#pragma once

#include <vector>

#include "design/design_search.hpp"

namespace brachisto {

/// The different minima of several searches, quickest first, and the best one.
[[nodiscard]] DesignAnswer gather_designs(const DesignPlan& plan,
                                          std::vector<DesignSearch> searches);

}  // namespace brachisto
