// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/input_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <system_error>
#include <vector>

#include "brachisto/io/problem_file.hpp"
#include "io/effective_input.hpp"
#include "io/key_spec.hpp"

namespace brachisto::io {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& path, const std::string& reason) {
  throw IoError(fmt::format("{}: {}", path.string(), reason));
}

/// At most one byte more than `most`.
std::string read_all(std::istream& in, const fs::path& path, std::size_t most) {
  std::string bytes;
  std::array<char, 1U << 12U> piece;
  while (in && bytes.size() <= most) {
    const std::size_t wanted = std::min(piece.size(), most + 1 - bytes.size());
    in.read(piece.data(), static_cast<std::streamsize>(wanted));
    bytes.append(piece.data(), static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad()) {
    fail(path, "cannot be read: " + std::generic_category().message(errno));
  }
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

std::string read_file_bytes(const fs::path& path, std::string_view what) {
  // What is no file has no size and is refused.
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  return read_file_bytes(path, error ? 0 : size, what);
}

namespace {

/// Joins the parts that together are a key of the problem: in the section
/// sweep, and only there, such a key is one word with dots.
void join_swept_keys(std::vector<std::string>& parts) {
  for (std::size_t i = 1; i < parts.size(); ++i) {
    std::string key = parts[i];
    for (std::size_t j = i + 1; j < parts.size(); ++j) {
      key += '.' + parts[j];
      if (!is_value_key(key)) continue;
      // Of a key and one below it, the longer one.
      const bool longer =
          j + 1 < parts.size() && is_value_key(key + '.' + parts[j + 1]);
      if (longer) continue;
      const auto first = parts.begin() + static_cast<std::ptrdiff_t>(i);
      *first = key;
      parts.erase(first + 1,
                  parts.begin() + static_cast<std::ptrdiff_t>(j + 1));
      break;
    }
  }
}

/// Reads the value; one that is not YAML becomes a refused node.
YamlValue read_value(const std::string& text, const std::string& key,
                     int source, Findings& findings) {
  try {
    return parse_yaml(text, source, findings, key);
  } catch (const SyntaxError& error) {
    findings.add(error.position, printable(key), error.what());
    return YamlValue::of(YamlValue::Kind::Refused, error.position);
  }
}

/// Takes the word away that stands where a map of keys may stand.
void make_room(YamlValue& root, std::string_view key, Position position) {
  for (const KeySpec& spec : key_table()) {
    if (!is_choice_or_map(spec) || spec.path != key.substr(0, key.rfind('.'))) {
      continue;
    }
    Entry* entry = make_entry(root, parts_of(spec.path), position);
    if (entry != nullptr && entry->value.kind == YamlValue::Kind::Scalar) {
      entry->value = YamlValue::of(YamlValue::Kind::Null, position);
    }
  }
}

/// Replaces or adds a value in a tree; maps on the way that are absent or
/// empty come into being. Behind "sweep." a key of the problem is one key of
/// the section, dots and all.
///
/// \param text    KEY=VALUE, VALUE in YAML
/// \param source  number of the input, ≥ 1, see Position
/// Mistakes in `text` itself go to `findings`.
void apply_override(YamlValue& root, const std::string& text, int source,
                    Findings& findings) {
  const Position position{source, 1, 1};
  const std::size_t equals = text.find('=');
  const std::string key = text.substr(0, equals);
  std::vector<std::string> parts = parts_of(key);
  if (equals == std::string::npos || std::ranges::count(parts, "") > 0) {
    findings.add(position, "",
                 "not an override; expected KEY=VALUE, as in "
                 "scene.body.k=1/2");
    return;
  }
  if (parts.size() > kMaxNesting) {
    findings.add(position, printable(key),
                 fmt::format("nests more than {} levels", kMaxNesting));
    return;
  }
  if (parts.front() == "sweep") join_swept_keys(parts);

  make_room(root, key, position);
  Entry* entry = make_entry(root, parts, position);
  if (entry == nullptr) {
    // Of a text where a map is expected, reading tells.
    const YamlValue* above = &root;
    std::string path;
    for (const std::string& part : parts) {
      const Entry* next = above->find(part);
      if (next == nullptr) break;
      above = &next->value;
      path += (path.empty() ? "" : ".") + part;
      const bool list = above->kind == YamlValue::Kind::List;
      if (!list && !is_value_key(path)) continue;
      findings.add(
          position, printable(key),
          list ? fmt::format("{} is a list; expected one for all of it, as in "
                             "{}=[…]",
                             path, path)
               : fmt::format("{} has a value, and no keys of its own", path));
      break;
    }
    return;
  }
  YamlValue& value = entry->value;
  value = read_value(text.substr(equals + 1), key, source, findings);
  if (value.kind == YamlValue::Kind::Null) value.position = position;
}

/// The tree of a file, which has to contain something.
YamlValue read_tree(std::string_view text, const std::string& name,
                    Findings& findings) {
  try {
    YamlValue root = parse_yaml(text, 0, findings);
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

InputTree read_input_tree(std::string_view text, const std::string& name,
                          const std::vector<std::string>& overrides,
                          Findings& findings) {
  InputTree input{read_tree(text, name, findings), {name}};
  take_input(input.root);
  for (const std::string& change : overrides) {
    input.sources.push_back("--set " + printable(change));
    apply_override(input.root, change,
                   static_cast<int>(input.sources.size()) - 1, findings);
  }
  drop_nulls(input.root);
  return input;
}

}  // namespace brachisto::io
