// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// XML documents, judged by expat.

#pragma once

#include <expat.h>

#include <memory>
#include <string>

namespace brachisto::testing {

/// What is not well formed about a document; "" if nothing is.
[[nodiscard]] inline std::string xml_flaw(const std::string& text) {
  const std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser(
      XML_ParserCreate("UTF-8"), &XML_ParserFree);
  const XML_Status status = XML_Parse(parser.get(), text.data(),
                                      static_cast<int>(text.size()), XML_TRUE);
  if (status == XML_STATUS_OK) return "";
  return XML_ErrorString(XML_GetErrorCode(parser.get()));
}

}  // namespace brachisto::testing
