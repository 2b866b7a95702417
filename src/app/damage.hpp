// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Damage to stores, told on stderr.

#pragma once

#include <string_view>

#include "sweep/store.hpp"

namespace brachisto::app {

/// Tells what is damaged in a store, if anything, and what is done about it.
void tell_damage(const sweep::Store& store, std::string_view remedy = "");

/// Tells it. \return the exit code of a verb that read the store and mended
/// nothing
[[nodiscard]] int exit_code(const sweep::Store& store);

}  // namespace brachisto::app
