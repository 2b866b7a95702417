// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Which keys of a problem may vary.

#pragma once

#include <string>
#include <string_view>

#include "io/key_spec.hpp"

namespace brachisto::io {

/// The key of the problem that a key of the section `sweep` stands for, or
/// nullptr if it is none that may vary.
[[nodiscard]] const KeySpec* find_swept_key(std::string_view key);

/// Why there is none.
[[nodiscard]] std::string objection_to_swept_key(std::string_view key);

}  // namespace brachisto::io
