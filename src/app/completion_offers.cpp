// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "app/completion_offers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>

namespace brachisto::app {

Offer offer_of(const Flag& flag) {
  if (!flag.check.words.empty()) return Offer::Words;
  const std::string_view kind = flag.is_word() ? flag.name : flag.placeholder;
  if (kind == "FILE") return Offer::ProblemFiles;
  if (kind == "DIR") return Offer::Directories;
  if (kind == "KEY=VALUE") return Offer::Keys;
  return Offer::Nothing;
}

std::vector<const io::KeySpec*> settable_keys() {
  std::vector<const io::KeySpec*> keys;
  for (const io::KeySpec& spec : io::key_table()) {
    if (spec.type() != io::KeyType::Reserved && spec.path != "version" &&
        (spec.type() != io::KeyType::Map || !spec.parent().empty())) {
      keys.push_back(&spec);
    }
  }
  return keys;
}

std::string key_names() {
  std::string names;
  for (const io::KeySpec* key : settable_keys()) {
    names += fmt::format("\n{}=", key->path);
  }
  return names;
}

std::string cases_of_keys() {
  std::string cases;
  for (const io::KeySpec* key : settable_keys()) {
    if (key->value.words.empty()) continue;
    cases += fmt::format("    {}) words='{}' ;;\n", key->path,
                         fmt::join(key->value.words, " "));
  }
  return cases;
}

}  // namespace brachisto::app
