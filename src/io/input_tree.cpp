// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/input_tree.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <system_error>

#include "brachisto/io/problem_file.hpp"
#include "io/overrides.hpp"
#include "io/source_text.hpp"

namespace brachisto::io {

namespace {

/// The tree of a file, which has to contain something.
YamlValue read_tree(std::string_view text, const std::string& name,
                    Findings& findings) {
  try {
    YamlValue root = parse_yaml(prepared_text(text, 0), 0, findings);
    if (root.kind == YamlValue::Kind::Null) {
      throw SyntaxError({0, 1, 1},
                        "the file is empty; expected at least the "
                        "key scene");
    }
    return root;
  } catch (const SyntaxError& error) {
    throw InputError(
        {{name, error.position.line, error.position.column, "", error.what()}});
  }
}

}  // namespace

std::string read_bytes(const std::filesystem::path& path) {
  const auto fail = [&](const std::string& reason) {
    throw IoError(fmt::format("{}: {}", path.string(), reason));
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    fail("is a directory; expected a problem file");
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    fail("cannot be opened: " + std::generic_category().message(errno));
  }
  std::string bytes(kMaxFileSize + 1, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (file.bad()) {
    fail("cannot be read: " + std::generic_category().message(errno));
  }
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

InputTree read_input_tree(std::string_view text, const std::string& name,
                          const std::vector<std::string>& overrides,
                          Findings& findings) {
  InputTree input{read_tree(text, name, findings), {name}};
  for (const std::string& change : overrides) {
    input.sources.push_back("--set " + printable(change));
    apply_override(input.root, change,
                   static_cast<int>(input.sources.size()) - 1, findings);
  }
  return input;
}

}  // namespace brachisto::io
