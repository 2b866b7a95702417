// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// key_table(): every key of a problem file.

#include <utility>

#include "io/key_sections.hpp"

namespace brachisto::io {

namespace {

std::vector<KeySpec> all_keys() {
  std::vector<KeySpec> keys{{.path = "version",
                             .type = KeyType::Integer,
                             .fallback = "1",
                             .bounds = "1 (this program reads version 1)",
                             .description = "of the file format",
                             .interval = {1, 1},
                             .set = [](ProblemFile&, double) {}}};
  for (auto part :
       {scene_keys(), discretisation_keys(), solver_keys(), fsolve_keys()}) {
    keys.insert(keys.end(), part.begin(), part.end());
  }
  keys.push_back({.path = "sweep",
                  .type = KeyType::Sweep,
                  .description = "keys that vary, which makes one scene into "
                                 "many; see [Sweeps](#sweeps)"});
  for (KeySpec& key : work_precision_keys()) keys.push_back(std::move(key));
  keys.push_back({.path = "constraints"});
  return keys;
}

}  // namespace

std::span<const KeySpec> key_table() {
  static const std::vector<KeySpec> table = all_keys();
  return table;
}

}  // namespace brachisto::io
