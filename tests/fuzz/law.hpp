// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What has to hold whatever the bytes are.

#pragma once

#include <cstdlib>
#include <iostream>

namespace brachisto::fuzz {

/// Ends the program if something does not hold, which is a finding.
inline void law(bool holds, const char* what) {
  if (holds) return;
  std::cerr << "broken: " << what << std::endl;
  std::abort();
}

}  // namespace brachisto::fuzz
