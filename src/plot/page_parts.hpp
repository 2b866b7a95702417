// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What pages with motion have alike beside their script, web/motion.js.

#pragma once

#include <string>
#include <string_view>

#include "report/result_field.hpp"

namespace brachisto::plot {

/// A script within a page that is XML too.
[[nodiscard]] std::string script_html(std::string_view content);

/// JSON that HTML and XML leave alone.
[[nodiscard]] std::string page_json(const report::Json& json);

/// The JSON document from which the scripts of a page draw.
[[nodiscard]] std::string data_html(std::string_view json);

/// The controls of the time.
/// \param more  of them, HTML
[[nodiscard]] std::string playback_html(std::string_view more = {});

}  // namespace brachisto::plot
