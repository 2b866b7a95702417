// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The lines of a summary that tell of a design.

#pragma once

#include <string>

#include "brachisto/study/design_answer.hpp"

namespace brachisto::report {

/// The bodies that it has found, and what it took.
void add_design(std::string& out, const DesignAnswer& design);

}  // namespace brachisto::report
