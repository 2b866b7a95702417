// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The machine on which times were measured.

#pragma once

#include <string>

namespace brachisto::comparison {

struct Machine {
  std::string cpu;     ///< model, by the kernel; "unknown" if it does not say
  std::string kernel;  ///< "Linux 6.1.0 x86_64"
  int cores = 0;       ///< that this process may use
};

[[nodiscard]] Machine this_machine();

}  // namespace brachisto::comparison
