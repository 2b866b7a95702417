// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "app/installed.hpp"

#include <system_error>

namespace brachisto::app {

namespace fs = std::filesystem;

std::optional<fs::path> installed(std::string_view name) {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) return std::nullopt;
  const fs::path file = fs::weakly_canonical(
      program.parent_path() / BRACHISTO_DATA_FROM_BINARY / name, error);
  if (error || !fs::exists(file, error)) return std::nullopt;
  return file;
}

}  // namespace brachisto::app
