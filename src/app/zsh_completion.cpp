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

/// A text in the brackets of _arguments, or behind its colons.
std::string zsh_text(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') out += '\\';
    out += c;
  }
  return out;
}

/// What _arguments runs for a value.
std::string zsh_action(const Flag& flag) {
  switch (offer_of(flag)) {
    case Offer::Words:
      return fmt::format("({})", fmt::join(flag.check.words, " "));
    case Offer::Keys:
      return "_brachisto_keys";
    case Offer::ProblemFiles:
      return "_files -g \"*.(yaml|json)\"";
    case Offer::Directories:
      return "_files -/";
    case Offer::Nothing:
      break;
  }
  return " ";
}

std::string zsh_argument(const Flag& flag, int place) {
  const std::string action = zsh_action(flag);
  if (flag.is_word()) {
    return shell_word(
        fmt::format("{}:{}:{}", flag.repeats() ? "*" : fmt::format("{}", place),
                    zsh_text(flag.name), action));
  }
  std::string text = fmt::format("{}{}[{}]", flag.repeats() ? "*" : "",
                                 flag.name, zsh_text(flag.text));
  if (flag.has_value()) {
    text += fmt::format(":{}:{}", zsh_text(flag.placeholder), action);
  }
  return shell_word(text);
}

constexpr std::string_view kZshKeys = R"(  esac
  if compset -P '*='; then
    compadd -- ${=words}
  else
    compadd -S '' -- ${=_brachisto_key_names}
  fi
}

_brachisto() {
  local -a verbs
  verbs=(
)";

constexpr std::string_view kZshVerbs = R"(  )
  if ((CURRENT == 2)); then
    _describe verb verbs
    _arguments '--help[Print this help message and exit]' '--version[Print versions]'
    return
  fi
  local verb=$words[2]
  shift words
  ((CURRENT--))
  case $verb in
)";

}  // namespace

std::string zsh_completion(const CommandLine& command) {
  std::string text =
      "#compdef brachisto\n"
      "# Completion of brachisto for zsh.\n\n";
  text += fmt::format("_brachisto_key_names='{}'\n\n", key_names());
  text +=
      "# Keys, or behind \"=\" their words.\n"
      "_brachisto_keys() {\n"
      "  local words=\n"
      "  case ${PREFIX%%=*} in\n";
  text += cases_of_keys();
  text += kZshKeys;
  for (const Verb* verb : shown_verbs(command)) {
    text += fmt::format(
        "    {}\n",
        shell_word(fmt::format("{}:{}", verb->name, zsh_text(verb->text))));
  }
  text += kZshVerbs;
  for (const Verb* verb : shown_verbs(command)) {
    text += fmt::format("    {})\n      _arguments", verb->name);
    int place = 0;
    for (const Flag& flag : shown_flags(command, *verb)) {
      if (flag.is_word()) ++place;
      text += " \\\n        " + zsh_argument(flag, place);
    }
    text += "\n      ;;\n";
  }
  return text + "  esac\n}\n\n_brachisto \"$@\"\n";
}

}  // namespace brachisto::app
