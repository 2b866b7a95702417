// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "app/completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "app/shell_word.hpp"
#include "io/key_spec.hpp"

namespace brachisto::app {

namespace {

/// What a value is completed to.
enum class Offer { Nothing, Words, Keys, ProblemFiles, Directories };

Offer offer_of(const Flag& flag) {
  if (!flag.check.words.empty()) return Offer::Words;
  const std::string_view kind = flag.is_word() ? flag.name : flag.placeholder;
  if (kind == "FILE") return Offer::ProblemFiles;
  if (kind == "DIR") return Offer::Directories;
  if (kind == "KEY=VALUE") return Offer::Keys;
  return Offer::Nothing;
}

/// Keys that stand before the "=" of --set.
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

std::string verb_names(const CommandLine& command) {
  std::vector<std::string_view> names;
  for (const Verb* verb : shown_verbs(command)) names.push_back(verb->name);
  return fmt::format("{}", fmt::join(names, " "));
}

/// Cases of the words that a key may have.
std::string cases_of_keys() {
  std::string cases;
  for (const io::KeySpec* key : settable_keys()) {
    if (key->value.words.empty()) continue;
    cases += fmt::format("    {}) words='{}' ;;\n", key->path,
                         fmt::join(key->value.words, " "));
  }
  return cases;
}

std::string key_names() {
  std::string names;
  for (const io::KeySpec* key : settable_keys()) {
    names += fmt::format("\n{}=", key->path);
  }
  return names;
}

/// What bash calls for a value.
std::string bash_call(const Flag& flag) {
  switch (offer_of(flag)) {
    case Offer::Words:
      return fmt::format("_brachisto_offer '{}'",
                         fmt::join(flag.check.words, " "));
    case Offer::Keys:
      return "_brachisto_keys";
    case Offer::ProblemFiles:
      return "_brachisto_files";
    case Offer::Directories:
      return "_brachisto_directories";
    case Offer::Nothing:
      break;
  }
  return ":";
}

constexpr std::string_view kBashHead = R"(# Completion of brachisto for bash.

# Words that begin with what is typed.
_brachisto_offer() {
  mapfile -t COMPREPLY < <(compgen -W "$1" -- "$word")
}

_brachisto_directories() {
  compopt -o filenames 2> /dev/null
  mapfile -t COMPREPLY < <(compgen -d -- "$word")
}

# Problem files, results among them, and the directories that have more.
_brachisto_files() {
  compopt -o filenames 2> /dev/null
  mapfile -t COMPREPLY < <(
    compgen -f -X '!*.yaml' -- "$word"
    compgen -f -X '!*.json' -- "$word"
    compgen -d -- "$word"
  )
}

# Words that a key may have.
_brachisto_values() {
  local words=
  case $1 in
)";

constexpr std::string_view kBashKeys = R"(  esac
  _brachisto_offer "$words"
}

# Keys, or behind "=" their words. Readline takes "=" for a word of its own.
_brachisto_keys() {
  case $word in
    *=*)
      local key=${word%%=*}
      word=${word#*=}
      _brachisto_values "$key"
      COMPREPLY=("${COMPREPLY[@]/#/$key=}")
      ;;
    *)
      compopt -o nospace 2> /dev/null
      _brachisto_offer "$_brachisto_key_names"
      ;;
  esac
}

_brachisto() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
)";

constexpr std::string_view kBashSet = R"(    return
  fi
  if [[ $word == '=' ]]; then
    word=
    _brachisto_values "$before"
    return
  fi
  if [[ $before == '=' ]]; then
    _brachisto_values "${COMP_WORDS[COMP_CWORD - 2]}"
    return
  fi
  case ${COMP_WORDS[1]} in
)";

/// The branch of one verb.
std::string bash_case(const CommandLine& command, const Verb& verb) {
  std::vector<std::string_view> names;
  std::string values, word = ":";
  for (const Flag& flag : shown_flags(command, verb)) {
    if (flag.is_word()) {
      if (word == ":") word = bash_call(flag);
      continue;
    }
    names.push_back(flag.name);
    if (!flag.has_value()) continue;
    values += fmt::format("        {}) {} ;;\n", flag.name, bash_call(flag));
  }
  return fmt::format(
      "    {})\n"
      "      case $before in\n{}"
      "        *)\n"
      "          if [[ $word == -* ]]; then\n"
      "            _brachisto_offer '{}'\n"
      "          else\n"
      "            {}\n"
      "          fi\n"
      "          ;;\n"
      "      esac\n"
      "      ;;\n",
      verb.name, values, fmt::join(names, " "), word);
}

}  // namespace

std::string bash_completion(const CommandLine& command) {
  std::string text(kBashHead);
  text += cases_of_keys();
  text += kBashKeys;
  text += fmt::format("    _brachisto_offer '{} --help --version'\n",
                      verb_names(command));
  text += kBashSet;
  for (const Verb* verb : shown_verbs(command)) {
    text += bash_case(command, *verb);
  }
  text += "  esac\n}\n\n";
  text += fmt::format("_brachisto_key_names='{}'\n", key_names());
  return text + "complete -F _brachisto brachisto\n";
}

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
