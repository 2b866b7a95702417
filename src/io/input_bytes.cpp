// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/input_bytes.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <iostream>
#include <system_error>

#include "brachisto/io/problem_file.hpp"

namespace brachisto::io {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& path, const std::string& reason) {
  throw IoError(fmt::format("{}: {}", path.string(), reason));
}

std::string read_all(std::istream& in, const fs::path& path, std::size_t most) {
  std::string bytes(most + 1, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (in.bad()) {
    fail(path, "cannot be read: " + std::generic_category().message(errno));
  }
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  return bytes;
}

}  // namespace

std::string read_problem_bytes(const fs::path& path) {
  if (path == kStandardInput) return read_all(std::cin, path, kMaxFileSize);
  return read_file_bytes(path, kMaxFileSize,
                         "a problem file, or - for standard input");
}

std::string read_file_bytes(const fs::path& path, std::size_t most,
                            std::string_view what) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::is_directory(status)) {
    fail(path, fmt::format("is a directory; expected {}", what));
  }
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    fail(path, fmt::format("is {}; expected {}",
                           fs::is_fifo(status) ? "a pipe" : "a device", what));
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    fail(path, "cannot be opened: " + std::generic_category().message(errno));
  }
  return read_all(file, path, most);
}

}  // namespace brachisto::io
