// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>
#include <vector>

#include "app/completion.hpp"
#include "app/completion_offers.hpp"

namespace brachisto::app {

namespace {

std::string verb_names(const CommandLine& command) {
  std::vector<std::string_view> names;
  for (const Verb* verb : shown_verbs(command)) names.push_back(verb->name);
  return fmt::format("{}", fmt::join(names, " "));
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

}  // namespace brachisto::app
