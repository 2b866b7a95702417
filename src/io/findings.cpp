// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/findings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "brachisto/io/problem_file.hpp"
#include "io/visible_text.hpp"

namespace brachisto::io {

void Findings::add(Position position, std::string key, std::string message) {
  findings_.push_back({position, std::move(key), std::move(message)});
}

void Findings::warn(Position position, std::string key, std::string message) {
  warnings_.push_back({position, std::move(key), std::move(message)});
}

bool Findings::concern(std::string_view key) const {
  return std::ranges::any_of(findings_,
                             [&](const Finding& f) { return f.key == key; });
}

namespace {

/// In the order of the inputs.
std::vector<Diagnostic> diagnostics_of(
    std::vector<Finding> ordered, const std::vector<std::string>& sources) {
  std::ranges::stable_sort(ordered, {}, &Finding::position);
  std::vector<Diagnostic> diagnostics;
  diagnostics.reserve(ordered.size());
  for (Finding& finding : ordered) {
    const auto [source, line, column] = finding.position;
    const bool in_file = source == 0;
    diagnostics.push_back({sources.at(static_cast<std::size_t>(source)),
                           in_file ? line : 0, in_file ? column : 0,
                           std::move(finding.key), std::move(finding.message)});
  }
  return diagnostics;
}

}  // namespace

void Findings::throw_if_any(const std::vector<std::string>& sources) const {
  if (findings_.empty()) return;
  throw InputError(diagnostics_of(findings_, sources));
}

std::vector<Diagnostic> Findings::warnings(
    const std::vector<std::string>& sources) const {
  return diagnostics_of(warnings_, sources);
}

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
