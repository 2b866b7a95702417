// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string>
#include <string_view>

namespace brachisto::app {

/// A text as one word of a shell, in single quotes if it needs them.
[[nodiscard]] std::string shell_word(std::string_view text);

}  // namespace brachisto::app
