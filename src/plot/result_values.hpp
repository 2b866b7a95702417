// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Values of a result document, which older ones may lack.

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "report/result_texts.hpp"

namespace brachisto::plot {

/// A part of a document; null if it is not there.
[[nodiscard]] const report::Json& at(const report::Json& json,
                                     std::string_view key);
/// NaN if there is none.
[[nodiscard]] double number(const report::Json& json, std::string_view key);
[[nodiscard]] bool is_true(const report::Json& json, std::string_view key);
/// "" if there is none.
[[nodiscard]] std::string text_of(const report::Json& json,
                                  std::string_view key);
[[nodiscard]] std::vector<std::string> words(const report::Json& json,
                                             std::string_view key);

/// T or τ with the digits that the error leaves.
[[nodiscard]] std::string time_text(const report::Json& result,
                                    std::string_view key);
/// "0.1 to 4.2 m g", what presses body and track; "" if there is none.
[[nodiscard]] std::string force_text(const report::Json& result);
/// Of the program that wrote the result; "" if it does not say.
[[nodiscard]] std::string version_in(const report::Json& result);

}  // namespace brachisto::plot
