// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/sweep_keys.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <vector>

#include "io/suggestion.hpp"

namespace brachisto::io {

namespace {

using Paths = std::vector<std::string_view>;

/// Keys that may vary and fulfil a condition.
template <class Condition>
Paths swept_keys(Condition condition) {
  Paths paths;
  for (const KeySpec& spec : key_table()) {
    if (is_value_key(spec.path) && condition(spec.path)) {
      paths.push_back(spec.path);
    }
  }
  return paths;
}

}  // namespace

const KeySpec* find_swept_key(std::string_view key) {
  return is_value_key(key) ? find_key(key) : nullptr;
}

std::string objection_to_swept_key(std::string_view key) {
  const KeySpec* spec = find_key(key);
  if (key == "version") return "the version of the file format cannot vary";
  if (spec != nullptr && spec->type == KeyType::Reserved) {
    return "reserved for a later version of brachisto";
  }
  const Paths below = swept_keys([&](std::string_view path) {
    return path.starts_with(fmt::format("{}.", key));
  });
  if (!below.empty()) {
    return fmt::format(
        "a map; its keys vary one by one, each written with dots: {}",
        fmt::join(below, ", "));
  }
  const Paths ends = swept_keys([&](std::string_view path) {
    return path.ends_with(fmt::format(".{}", key));
  });
  if (!ends.empty()) {
    return fmt::format("a key that varies is written in full: {}",
                       fmt::join(ends, " or "));
  }
  Paths known = swept_keys([](std::string_view) { return true; });
  known.insert(known.end(), {"zip", "random", "warm_start"});
  return fmt::format(
      "unknown key; allowed in sweep: keys of the problem in full, such as "
      "scene.body.eta_m, and zip, random, warm_start{}",
      suggestion(key, known));
}

}  // namespace brachisto::io
