// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/io/diagnostics.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/visible_text.hpp"

namespace brachisto::io {

namespace {

std::string joined(const std::vector<Diagnostic>& diagnostics) {
  const std::size_t shown = std::min(diagnostics.size(), kShownDiagnostics);
  std::string lines;
  for (std::size_t i = 0; i < shown; ++i) {
    if (i > 0) lines += '\n';
    lines += to_string(diagnostics[i]);
  }
  if (shown < diagnostics.size()) {
    lines += fmt::format("\n… and {} more errors", diagnostics.size() - shown);
  }
  return lines;
}

}  // namespace

std::string to_string(const Diagnostic& diagnostic) {
  std::string text = visible(diagnostic.file);
  if (diagnostic.line > 0) {
    text += fmt::format(":{}:{}", diagnostic.line, diagnostic.column);
  }
  if (!diagnostic.key.empty()) text += ": " + visible(diagnostic.key);
  return text + ": " + visible(diagnostic.message);
}

InputError::InputError(std::vector<Diagnostic> diagnostics)
    : std::runtime_error(joined(diagnostics)),
      diagnostics_(std::move(diagnostics)) {}

}  // namespace brachisto::io
