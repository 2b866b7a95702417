// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Where a solve stands, for those who wait.

#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace brachisto {

/// Called now and then from within a solve: which phase it is in, in a word or
/// two, and what is known so far.
using ProgressHook =
    std::function<void(std::string_view phase, const std::string& text)>;

}  // namespace brachisto
