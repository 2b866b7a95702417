// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto complete -- WORD...: what may stand for the last of some words, the
// others before it, one a line with its meaning behind a tab. For the
// completions of shells (src/app/share), which choose those that fit; a line
// :files or :directories leaves it to them. Not for people.

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/exit_code.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "io/key_spec.hpp"

namespace brachisto::app {

namespace {

std::string offer(std::string_view word, std::string_view meaning) {
  return fmt::format("{}\t{}\n", word, meaning);
}

/// Settings of keys, those of words with each of them.
std::string settings() {
  std::string offers;
  for (const io::KeySpec& key : io::key_table()) {
    if (key.type() == io::KeyType::Reserved || key.path == "version" ||
        (key.type() == io::KeyType::Map && key.parent().empty())) {
      continue;
    }
    if (key.value.words.empty()) offers += fmt::format("{}=\n", key.path);
    for (const std::string_view word : key.value.words) {
      offers += fmt::format("{}={}\n", key.path, word);
    }
  }
  return offers;
}

/// What a value of a flag, or a word without one, may be.
std::string values(const Flag& flag) {
  std::string offers;
  for (const std::string& word : flag.check.words) offers += word + "\n";
  if (!offers.empty()) return offers;
  const std::string_view kind = flag.is_word() ? flag.name : flag.placeholder;
  if (kind == "FILE") return ":files\n";
  if (kind == "DIR") return ":directories\n";
  return kind == "KEY=VALUE" ? settings() : "";
}

std::string offers(const CommandLine& command,
                   const std::vector<std::string>& words) {
  std::string found;
  if (words.size() < 2) {
    for (const Verb& verb : command.verbs) {
      if (!verb.hidden) found += offer(verb.name, verb.text);
    }
    return found + offer("--help", "Print this help message and exit") +
           offer("--version", "Print versions");
  }
  for (const Verb& verb : command.verbs) {
    if (verb.hidden || verb.name != words.front()) continue;
    const std::vector<Flag> flags = shown_flags(command, verb);
    const auto asked = std::ranges::find_if(flags, [&](const Flag& flag) {
      return flag.has_value() && flag.name == words[words.size() - 2];
    });
    if (asked != flags.end()) return values(*asked);
    if (!words.back().starts_with('-')) {
      const auto word = std::ranges::find_if(flags, &Flag::is_word);
      return word == flags.end() ? "" : values(*word);
    }
    for (const Flag& flag : flags) {
      if (!flag.is_word()) found += offer(flag.name, flag.text);
    }
  }
  return found;
}

}  // namespace

Verb complete_verb(CommandLine (*whole)()) {
  const auto words = std::make_shared<std::vector<std::string>>();
  return {.name = "complete",
          .flags = {{.name = "WORD", .value = words.get()}},
          .run =
              [=] {
                print_data(offers(whole(), *words));
                return static_cast<int>(kSuccess);
              },
          .hidden = true};
}

}  // namespace brachisto::app
