// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The part of YAML that problem files consist of: maps, lists and scalars,
/// with the place of each.

#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "io/findings.hpp"

namespace brachisto::io {

struct Entry;

/// A value in a YAML document.
struct YamlValue {
  enum class Kind {
    Null,
    Scalar,
    List,
    Map,
    Refused,  ///< a mistake was already reported; readers pass it over
  };

  Kind kind = Kind::Null;
  Position position;
  std::string text;              ///< of a scalar, unquoted; of a null that is
                                 ///< written out, its word
  std::vector<YamlValue> items;  ///< of a list
  std::vector<Entry> entries;    ///< of a map, in file order, keys unique

  [[nodiscard]] static YamlValue of(Kind kind, Position position,
                                    std::string text = "");

  /// The entry of a map with this key, or nullptr.
  [[nodiscard]] const Entry* find(std::string_view key) const;
  [[nodiscard]] Entry* find(std::string_view key);
};

/// A key of a map with its value.
struct Entry {
  std::string key;
  Position position;  ///< of the key
  YamlValue value;
};

/// What a node is, for messages: "a map", "a list", …
[[nodiscard]] std::string_view kind_name(YamlValue::Kind kind);

/// Reports that a value is of another kind than is expected, unless a mistake
/// in it was reported already.
void refuse_kind(const YamlValue& value, std::string key,
                 std::string_view expected, Findings& findings);

/// The entry with a dotted key, or nullptr.
[[nodiscard]] const Entry* find_entry(const YamlValue& root,
                                      std::string_view path);

/// The entry at the end of a path, made if it is not there; so are maps on the
/// way that are absent or empty.
///
/// \param parts     of the path, at least one
/// \param position  of what is made
/// \return nullptr if something else than a map stands in the way; valid until
///         the next entry is made
[[nodiscard]] Entry* make_entry(YamlValue& root,
                                const std::vector<std::string>& parts,
                                Position position);

/// Parts of a dotted key, some of which may be empty.
[[nodiscard]] std::vector<std::string> parts_of(std::string_view key);
/// Whether a key stands below another one.
[[nodiscard]] inline bool below(std::string_view path, std::string_view key) {
  return path.size() > key.size() && path[key.size()] == '.' &&
         path.starts_with(key);
}

/// Place of the value of a dotted key, of the nearest map above it if the key
/// is absent.
[[nodiscard]] Position position_of(const YamlValue& root, std::string_view key);

/// The input cannot be read any further.
class SyntaxError : public std::runtime_error {
 public:
  SyntaxError(Position where, const std::string& message)
      : std::runtime_error(message), position(where) {}

  Position position;
};

/// Builds the tree of a text that holds one document.
///
/// Repeated keys (the first one counts), anchors, aliases, tags, merge keys and
/// keys that are not words go to `findings`.
///
/// \param source  number of the input, see Position
/// \param key     dotted key under which the text stands, for messages
/// \return the document; Kind::Null if there is none
/// \throws SyntaxError  if the text is too long, is not UTF-8, contains control
///         characters or a tab in an indentation, is not YAML, nests more than
///         kMaxNesting levels, or holds more than one document
[[nodiscard]] YamlValue parse_yaml(std::string_view bytes, int source,
                                   Findings& findings,
                                   const std::string& key = "");

}  // namespace brachisto::io
