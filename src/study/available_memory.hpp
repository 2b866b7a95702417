// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// available_memory().

#pragma once

namespace brachisto {

/// How much more memory this process may take before something else has to
/// give way [bytes]: the least of what the kernel says is available, what is
/// left of the address space that RLIMIT_AS allows, and what the control group
/// of the process may have. Infinite where nothing is known.
[[nodiscard]] double available_memory();

}  // namespace brachisto
