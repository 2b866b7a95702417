// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// From the tree of a problem file to a scene and options.

#pragma once

#include <string_view>

#include "brachisto/io/problem_file.hpp"
#include "io/findings.hpp"
#include "io/key_spec.hpp"
#include "io/yaml_tree.hpp"

namespace brachisto::io {

/// Reads a tree by the table of keys. All mistakes go to the findings; the
/// problem is of use only if there are none.
class ProblemReader {
 public:
  explicit ProblemReader(Findings& findings) : findings_(findings) {}

  [[nodiscard]] ProblemFile read(const YamlValue& root);

 private:
  void read_map(const YamlValue& map, std::string_view path, Position position);
  void read_entry(const Entry& entry, std::string_view map);
  void read_value(const KeySpec& spec, const Entry& entry);
  void read_number(const KeySpec& spec, const YamlValue& node);
  void read_choice(const KeySpec& spec, const YamlValue& node);
  void refuse_unknown(const Entry& entry, std::string_view map);

  ProblemFile problem_;
  Findings& findings_;
};

}  // namespace brachisto::io
