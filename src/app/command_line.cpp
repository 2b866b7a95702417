// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "app/command_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <sstream>
#include <thread>
#include <type_traits>
#include <utility>

#include "app/verbs.hpp"
#include "io/findings.hpp"
#include "io/key_spec.hpp"
#include "io/visible_text.hpp"

namespace brachisto::app {

namespace {

using Words = std::vector<std::string>;

/// "; did you mean NEAREST?", or nothing.
std::string suggestion(std::string_view word, const Words& known) {
  return io::suggestion(
      word, std::vector<std::string_view>(known.begin(), known.end()));
}

/// Those that the help shows.
Words verbs_of(const CommandLine& command) {
  Words names;
  for (const Verb& verb : command.verbs) {
    if (!verb.hidden) names.emplace_back(verb.name);
  }
  return names;
}

Words flags_of(const CommandLine& command, const Verb& verb) {
  Words names;
  for (const Flag& flag : shown_flags(command, verb)) {
    if (!flag.is_word()) names.emplace_back(flag.name);
  }
  return names;
}

/// "--jsno" of "--jsno=1".
std::string name_of(const std::string& flag) {
  return flag.substr(0, flag.find('='));
}

bool is_flag(const std::string& word) {
  return word.starts_with("-") && word != "-" && word != "--";
}

std::string unknown_verb(const CommandLine& command, const std::string& word) {
  const Words verbs = verbs_of(command);
  return fmt::format("{} is not a verb{}; there are {}", io::in_quotes(word),
                     suggestion(word, verbs), fmt::join(verbs, ", "));
}

/// \param verb  before it, nullptr if there is none
std::string unknown_flag(const CommandLine& command, const Verb* verb,
                         const std::string& word) {
  const std::string name = name_of(word);
  const std::string shown = io::printable(name);
  if (verb != nullptr) {
    return fmt::format("{} is not a flag of {}{}", shown, verb->name,
                       suggestion(name, flags_of(command, *verb)));
  }
  Words known{"--help", "--version"};
  for (const Verb& one : command.verbs) {
    if (one.hidden) continue;
    const Words flags = flags_of(command, one);
    if (std::ranges::count(flags, name) > 0) {
      return fmt::format(
          "{0} stands before the verb; it belongs behind it: "
          "brachisto {1} {0}",
          shown, one.name);
    }
    known.insert(known.end(), flags.begin(), flags.end());
  }
  return fmt::format("{} is not a flag{}", shown, suggestion(name, known));
}

/// The verb that was read, nullptr if there is none.
const Verb* verb_of(const CommandLine& command, const CLI::App& app) {
  const std::vector<CLI::App*> parsed = app.get_subcommands();
  if (parsed.empty()) return nullptr;
  return &*std::ranges::find(command.verbs, parsed.front()->get_name(),
                             &Verb::name);
}

/// What nobody asked for: a verb or a flag that there is not comes before a
/// word too many, which may only be the value of such a flag.
std::string unexpected(const CommandLine& command, const CLI::App& app) {
  const Verb* const verb = verb_of(command, app);
  // What stands before the verb, or behind "--".
  Words left = app.remaining(false);
  if (!left.empty() && is_flag(left.front())) {
    return unknown_flag(command, nullptr, left.front());
  }
  if (verb == nullptr) {
    return left.empty() ? std::string() : unknown_verb(command, left.front());
  }
  const Words of_verb = app.get_subcommands().front()->remaining(false);
  const auto flag = std::ranges::find_if(of_verb, is_flag);
  if (flag != of_verb.end()) return unknown_flag(command, verb, *flag);
  left.insert(left.begin(), of_verb.begin(), of_verb.end());
  std::erase(left, "--");
  if (left.empty()) return {};
  return fmt::format("{} is one word too many", io::in_quotes(left.front()));
}

UsageError explained(const CommandLine& command, const CLI::App& app,
                     const CLI::ParseError& error) {
  const Verb* const verb = verb_of(command, app);
  std::string what = unexpected(command, app);
  if (what.empty()) {
    what = verb != nullptr ? io::visible(error.what())
                           : fmt::format("a verb is missing; there are {}",
                                         fmt::join(verbs_of(command), ", "));
  }
  return {
      verb != nullptr ? fmt::format("brachisto {}", verb->name) : "brachisto",
      what};
}

/// A check of the library's own.
TextCheck of_library(const CLI::Validator& check) {
  return {[check](const std::string& text) { return check(text); },
          check.get_description()};
}

void describe(const Flag& flag, CLI::App& verb) {
  const auto valued = [&](auto* value) {
    CLI::Option* option = verb.add_option(flag.name, *value, flag.text);
    option->type_name(flag.placeholder)->required(flag.required);
    if (flag.shows_default) option->capture_default_str();
    if (flag.check.objection) {
      option->check(CLI::Validator(flag.check.objection, flag.check.kind));
    }
    return option;
  };
  CLI::Option* const option = std::visit(
      [&](auto* value) -> CLI::Option* {
        using Value = std::remove_pointer_t<decltype(value)>;
        if constexpr (std::is_same_v<Value, bool>) {
          return verb.add_flag(flag.name, *value, flag.text);
        } else if constexpr (std::is_same_v<Value, Words>) {
          CLI::Option* list = valued(value);
          if (!is_flag(flag.name)) return list;
          return list->expected(1)->multi_option_policy(
              CLI::MultiOptionPolicy::TakeAll);
        } else {
          return valued(value);
        }
      },
      flag.value);
  if (flag.hidden) option->group("");
  if (flag.needs.size() == 1) option->needs(flag.needs.front());
  if (flag.excludes != nullptr) option->excludes(flag.excludes);
}

/// The library knows no flag that needs one of several.
/// \throws CLI::RequiresError
void refuse_alone(const Verb& verb, const CLI::App& read) {
  for (const Flag& flag : verb.flags) {
    if (flag.needs.size() < 2 || read.count(flag.name) == 0) continue;
    if (std::ranges::none_of(flag.needs, [&](const char* other) {
          return read.count(other) > 0;
        })) {
      throw CLI::RequiresError(
          flag.name, fmt::format("{}", fmt::join(flag.needs, " or ")));
    }
  }
}

void describe_flags(const Verb& verb, const std::vector<Flag>& everywhere,
                    CLI::App* out) {
  std::map<std::string, CLI::App*> choices;
  for (const Flag& flag : verb.flags) {
    if (flag.choice == nullptr) {
      describe(flag, *out);
      continue;
    }
    CLI::App*& group = choices[flag.choice];
    if (group == nullptr) {
      group = out->add_option_group(flag.choice);
      group->require_option(1);
    }
    describe(flag, *group);
  }
  for (const Flag& flag : everywhere) describe(flag, *out);
  out->parse_complete_callback([&verb, out] { refuse_alone(verb, *out); });
}

}  // namespace

TextCheck not_empty() {
  return {[](const std::string& text) -> std::string {
    return text.empty() ? "an empty text was read; a name is expected" : "";
  }};
}

TextCheck number(const std::string& kind, bool (*allowed)(double)) {
  return {[kind, allowed](const std::string& text) {
    double value = 0.0;
    const bool fine = CLI::detail::lexical_cast(text, value);
    return fine && allowed(value)
               ? std::string()
               : fmt::format("{} was read; expected a number {}",
                             io::in_quotes(text), kind);
  }};
}

TextCheck seconds() {
  return number("greater than 0, at most 1e9",
                [](double value) { return value > 0.0 && value <= 1e9; });
}

TextCheck integer_within(int least, int most) {
  return of_library(CLI::Range(least, most));
}

TextCheck positive() {
  return of_library(CLI::PositiveNumber);
}

TextCheck existing_file() {
  return of_library(CLI::ExistingFile);
}

TextCheck existing_directory() {
  return of_library(CLI::ExistingDirectory);
}

TextCheck one_of(std::vector<std::string> words) {
  TextCheck check = of_library(CLI::IsMember(words));
  check.words = std::move(words);
  return check;
}

TextCheck word_of(std::string_view key) {
  TextCheck check = not_empty();
  const io::KeySpec* spec = io::find_key(key);
  check.words.assign(spec->value.words.begin(), spec->value.words.end());
  return check;
}

Flag json_flag(bool& json) {
  return {"--json", &json, "Print one JSON document to stdout"};
}

Flag markdown_flag(bool& markdown) {
  return {.name = "--markdown",
          .value = &markdown,
          .text = "Print tables in Markdown",
          .excludes = "--json"};
}

Flag jobs_flag(int& jobs) {
  return {.name = "--jobs",
          .value = &jobs,
          .text = "Worker processes; default: one per core",
          .placeholder = "N",
          .check = integer_within(1, 1024)};
}

Flag unless_resumed(bool& force) {
  return {.name = "--force",
          .value = &force,
          .text = "Replace the results in DIR",
          .excludes = "--resume"};
}

Flag worker_flag(std::string& program) {
  return {.name = "--worker",
          .value = &program,
          .text = "Program to run as worker, for tests",
          .placeholder = "PROGRAM",
          .check = existing_file(),
          .hidden = true};
}

Flag directory_flag(const char* name, std::string& directory, const char* text,
                    bool required) {
  return {.name = name,
          .value = &directory,
          .text = text,
          .placeholder = "DIR",
          .check = not_empty(),
          .required = required};
}

Flag sweep_directory(std::string& directory) {
  return {.name = "DIR",
          .value = &directory,
          .text = "Directory of the sweep",
          .check = not_empty(),
          .required = true};
}

std::vector<Flag> CommonFlags::with(std::vector<Flag> own,
                                    const char* text_of_file) {
  std::vector<Flag> flags{
      {.name = "FILE", .value = &file, .text = text_of_file, .required = true},
      {.name = "--set",
       .value = &overrides,
       .text = "Replace a value of the file, such as scene.body.k=1/4",
       .placeholder = "KEY=VALUE"},
      json_flag(json),
      {"--quiet", &quiet, "Print no results and no progress"}};
  std::ranges::move(own, std::back_inserter(flags));
  return flags;
}

int jobs_or_cores(int jobs) {
  return jobs > 0
             ? jobs
             : std::max(1,
                        static_cast<int>(std::thread::hardware_concurrency()));
}

std::vector<Flag> shown_flags(const CommandLine& command, const Verb& verb) {
  // The library adds the first by itself.
  std::vector<Flag> shown{{"--help", static_cast<bool*>(nullptr),
                           "Print this help message and exit"}};
  std::ranges::copy(verb.flags, std::back_inserter(shown));
  std::ranges::copy(command.everywhere, std::back_inserter(shown));
  std::erase_if(shown, &Flag::hidden);
  return shown;
}

Asked read_command_line(const CommandLine& command, int argc, char** argv) {
  CLI::App app(command.text, "brachisto");
  app.set_version_flag("--version", command.version,
                       "Print versions of the program and its libraries");
  app.require_subcommand(1);
  app.footer(command.footer);
  for (const Verb& verb : command.verbs) {
    CLI::App* const out = app.add_subcommand(verb.name, verb.text);
    out->footer(verb.footer);
    if (verb.hidden) out->group("");
    if (verb.takes_anything) out->allow_extras();
    // Those of other verbs would only take time.
    if (std::count(argv, argv + argc, std::string_view(verb.name)) > 0) {
      describe_flags(verb, command.everywhere, out);
    }
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    std::ostringstream text;
    app.exit(help_or_version, text);
    return text.str();
  } catch (const CLI::ParseError& error) {
    throw explained(command, app, error);
  }
  return verb_of(command, app);
}

}  // namespace brachisto::app
