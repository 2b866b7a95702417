// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// From the tree of a problem file to a scene and options.

#pragma once

#include <string_view>

#include "io/draft.hpp"
#include "io/findings.hpp"
#include "io/key_spec.hpp"
#include "io/yaml_tree.hpp"

namespace brachisto::io {

/// Reads a tree by the table of keys. All mistakes go to the findings; the
/// problem is of use only if there are none.
class ProblemReader {
 public:
  /// \param start  what holds for keys that are not read
  explicit ProblemReader(Findings& findings, const Draft& start = {})
      : problem_(start), findings_(findings) {}

  /// Reads a whole tree.
  [[nodiscard]] Draft read(const YamlValue& root);

  /// Reads the value of one key.
  void read_value(const KeySpec& spec, const Entry& entry);

  /// What was read so far.
  [[nodiscard]] const Draft& problem() const { return problem_; }

 private:
  void read_map(const YamlValue& map, std::string_view path, Position position);
  void read_entry(const Entry& entry, std::string_view map);
  void read_number(const KeySpec& spec, const YamlValue& node);
  [[nodiscard]] double read_angle(const KeySpec& spec, const YamlValue& node);
  void read_others(const KeySpec& spec, const Entry& entry);
  void refuse_unknown(const Entry& entry, std::string_view map);

  Draft problem_;
  Findings& findings_;
};

}  // namespace brachisto::io
