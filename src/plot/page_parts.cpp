// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "plot/page_parts.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace brachisto::plot {

std::string script_html(std::string_view content) {
  return fmt::format("<script>//<![CDATA[\n{}\n//]]></script>\n", content);
}

std::string page_json(const report::Json& json) {
  const std::string text =
      json.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  std::string out;
  // Outside of strings JSON has none of these.
  for (const char c : text) {
    if (std::string_view("<>&").find(c) == std::string_view::npos) {
      out += c;
    } else {
      out += fmt::format("\\u{:04x}", static_cast<int>(c));
    }
  }
  return out;
}

std::string data_html(std::string_view json) {
  return fmt::format(
      "<script type=\"application/json\" id=\"data\">{}</script>\n", json);
}

std::string playback_html(std::string_view more) {
  return fmt::format(
      "<div class=\"controls\" role=\"group\" aria-label=\"Playback\">\n"
      "<button id=\"play\" type=\"button\">Play</button>\n"
      "<input id=\"time\" type=\"range\" min=\"0\" max=\"1\" step=\"any\" "
      "aria-label=\"Time\"/>\n"
      "<output id=\"clock\" aria-live=\"off\"></output>\n"
      "<fieldset id=\"rates\" aria-label=\"Speed\"></fieldset>\n{}</div>\n",
      more);
}

}  // namespace brachisto::plot
