// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Problems as JSON documents, which are problem files again.

#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "io/key_spec.hpp"
#include "io/yaml_tree.hpp"

namespace brachisto::io {

/// The sections `scene`, `discretisation` and `solver` of a problem, defaults
/// filled in, by the table of keys; null for what it does not have.
[[nodiscard]] Json effective_input(const Scene& scene,
                                   const SolveOptions& options);

/// The same as text, a line to each key.
[[nodiscard]] std::string effective_lines(const Scene& scene,
                                          const SolveOptions& options);

/// One section of a problem.
[[nodiscard]] Json effective_section(const ProblemFile& problem,
                                     std::string_view section);

/// A tree as it was written: expressions stay text.
[[nodiscard]] Json stated_input(const YamlValue& tree);

/// Makes the tree of a document that this program wrote (one with the key
/// schema_version) the tree of the problem in it: its key `input`, or else all
/// of it without schema_version and valid.
void take_input(YamlValue& root);

/// Takes keys of the table with the value null out of a tree.
void drop_nulls(YamlValue& root);

}  // namespace brachisto::io
