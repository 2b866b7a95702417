// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// From keys that vary to the axes of their product.

#pragma once

#include "io/sweep_section.hpp"

namespace brachisto::io {

/// Fills in the axes of a section whose entries are known.
///
/// An entry makes an axis of its own, but for those that `zip` makes run
/// together and for random ones, all of which share one; an axis stands where
/// the first of its entries does.
///
/// \param sweep  the whole section
/// Mistakes in `zip`, and too many scenes, go to the findings.
void build_axes(const Entry& sweep, SweepSection& section, Findings& findings);

}  // namespace brachisto::io
