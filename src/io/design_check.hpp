// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What a design asks of a problem.

#pragma once

#include "io/check.hpp"

namespace brachisto::io {

/// Refuses designs without a body or without a best one, and ways of solving
/// that a design does not go.
void check_design(const Check& check);

}  // namespace brachisto::io
