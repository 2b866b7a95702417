// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>

#include "app/completion.hpp"
#include "app/completion_offers.hpp"
#include "app/shell_word.hpp"

namespace brachisto::app {

namespace {

/// The options of `complete` for a value, with a space before them.
std::string fish_value(const Flag& flag) {
  switch (offer_of(flag)) {
    case Offer::Words:
      return fmt::format(" -a '{}'", fmt::join(flag.check.words, " "));
    case Offer::Keys:
      return " -a '(__brachisto_keys)'";
    case Offer::ProblemFiles:
      return " -k -a '(__fish_complete_suffix .yaml; __fish_complete_suffix "
             ".json)'";
    case Offer::Directories:
      return " -a '(__fish_complete_directories)'";
    case Offer::Nothing:
      break;
  }
  return "";
}

std::string fish_line(const Verb& verb, const Flag& flag) {
  std::string line = fmt::format(
      "complete -c brachisto -n '__fish_seen_subcommand_from {}' -f",
      verb.name);
  if (!flag.is_word()) {
    line += fmt::format(" -l {}{} -d {}", flag.name + 2,
                        flag.has_value() ? " -r" : "", shell_word(flag.text));
  }
  return line + fish_value(flag) + "\n";
}

}  // namespace

std::string fish_completion(const CommandLine& command) {
  std::string text =
      "# Completion of brachisto for fish.\n\n"
      "# Keys, and with \"=\" their words.\n"
      "function __brachisto_keys\n";
  for (const io::KeySpec* key : settable_keys()) {
    text += fmt::format("  echo {}=\n", key->path);
    for (const std::string_view word : key->value.words) {
      text += fmt::format("  echo {}={}\n", key->path, word);
    }
  }
  text +=
      "end\n\n"
      "complete -c brachisto -f\n"
      "complete -c brachisto -n __fish_use_subcommand -l help -d 'Print this "
      "help message and exit'\n"
      "complete -c brachisto -n __fish_use_subcommand -l version -d 'Print "
      "versions'\n";
  for (const Verb* verb : shown_verbs(command)) {
    text += fmt::format(
        "complete -c brachisto -n __fish_use_subcommand -a {} -d {}\n",
        verb->name, shell_word(verb->text));
  }
  for (const Verb* verb : shown_verbs(command)) {
    for (const Flag& flag : shown_flags(command, *verb)) {
      text += fish_line(*verb, flag);
    }
  }
  return text;
}

}  // namespace brachisto::app
