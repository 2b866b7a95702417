// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "app/command_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <sstream>
#include <string_view>
#include <thread>

#include "app/exit_code.hpp"
#include "app/terminal.hpp"
#include "io/findings.hpp"
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
Words verbs_of(const CLI::App& app) {
  Words names;
  for (const CLI::App* verb : app.get_subcommands(
           [](const CLI::App* one) { return !one->get_group().empty(); })) {
    names.push_back(verb->get_name());
  }
  return names;
}

Words flags_of(const CLI::App& app) {
  Words names;
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;
    for (const std::string& name : option->get_lnames()) {
      names.push_back("--" + name);
    }
  }
  // Groups of options are verbs without a name.
  for (const CLI::App* group : app.get_subcommands(
           [](const CLI::App* one) { return one->get_name().empty(); })) {
    for (std::string& name : flags_of(*group)) names.push_back(std::move(name));
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

/// Verbs that have a flag, as it is written.
Words verbs_with(const CLI::App& app, const std::string& flag) {
  Words names = verbs_of(app);
  std::erase_if(names, [&](const std::string& verb) {
    return std::ranges::count(flags_of(*app.get_subcommand(verb)), flag) == 0;
  });
  return names;
}

std::string unknown_verb(const CLI::App& app, const std::string& word) {
  const Words verbs = verbs_of(app);
  return fmt::format("{} is not a verb{}; there are {}", io::in_quotes(word),
                     suggestion(word, verbs), fmt::join(verbs, ", "));
}

std::string unknown_flag(const CLI::App& app, const CLI::App* verb,
                         const std::string& word) {
  const std::string name = name_of(word);
  const std::string shown = io::printable(name);
  if (verb != nullptr) {
    return fmt::format("{} is not a flag of {}{}", shown, verb->get_name(),
                       suggestion(name, flags_of(*verb)));
  }
  const Words behind = verbs_with(app, name);
  if (!behind.empty()) {
    return fmt::format(
        "{0} stands before the verb; it belongs behind it: "
        "brachisto {1} {0}",
        shown, behind.front());
  }
  Words known = flags_of(app);
  for (const std::string& one : verbs_of(app)) {
    const Words more = flags_of(*app.get_subcommand(one));
    known.insert(known.end(), more.begin(), more.end());
  }
  return fmt::format("{} is not a flag{}", shown, suggestion(name, known));
}

/// What nobody asked for: a verb or a flag that there is not comes before a
/// word too many, which may only be the value of such a flag.
std::string unexpected(const CLI::App& app) {
  const std::vector<CLI::App*> parsed = app.get_subcommands();
  const CLI::App* verb = parsed.empty() ? nullptr : parsed.front();
  // What stands before the verb, or behind "--".
  Words left = app.remaining(false);
  if (!left.empty() && is_flag(left.front())) {
    return unknown_flag(app, nullptr, left.front());
  }
  if (verb == nullptr) {
    return left.empty() ? std::string() : unknown_verb(app, left.front());
  }
  const Words of_verb = verb->remaining(false);
  const auto flag = std::ranges::find_if(of_verb, is_flag);
  if (flag != of_verb.end()) return unknown_flag(app, verb, *flag);
  left.insert(left.begin(), of_verb.begin(), of_verb.end());
  std::erase(left, "--");
  if (left.empty()) return {};
  return fmt::format("{} is one word too many", io::in_quotes(left.front()));
}

std::string asked(const CLI::App& app) {
  const std::vector<CLI::App*> parsed = app.get_subcommands();
  return parsed.empty() ? app.get_name()
                        : app.get_name() + " " + parsed.front()->get_name();
}

UsageError explained(const CLI::App& app, const CLI::ParseError& error) {
  std::string what = unexpected(app);
  if (what.empty() && app.get_subcommands().empty()) {
    what = fmt::format("a verb is missing; there are {}",
                       fmt::join(verbs_of(app), ", "));
  }
  if (what.empty()) what = io::visible(error.what());
  return {asked(app), what};
}

}  // namespace

Command::Command(const std::string& text, const std::string& footer,
                 const std::function<std::string()>& version)
    : app_(text, "brachisto") {
  app_.set_version_flag("--version", version,
                        "Print versions of the program and its libraries");
  app_.require_subcommand(1);
  app_.footer(footer);
}

CLI::App& Command::add(const std::string& name, const std::string& text,
                       const std::string& footer, Run run) {
  runs_[name] = std::move(run);
  CLI::App* const verb = app_.add_subcommand(name, text);
  verb->footer(footer);
  return *verb;
}

Run Command::read(int argc, char** argv) {
  try {
    app_.parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    std::ostringstream text;
    app_.exit(help_or_version, text);
    return [text = text.str()] {
      print(text);
      return static_cast<int>(kSuccess);
    };
  } catch (const CLI::ParseError& error) {
    throw explained(app_, error);
  }
  return runs_.at(app_.get_subcommands().front()->get_name());
}

CLI::Validator not_empty() {
  return {[](const std::string& text) -> std::string {
            return text.empty() ? "an empty text was read; a name is expected"
                                : "";
          },
          ""};
}

CLI::Validator number(const std::string& kind, double least, double most) {
  return {[=](const std::string& text) {
            double value = 0.0;
            const bool fine = CLI::detail::lexical_cast(text, value);
            return fine && value >= least && value <= most
                       ? std::string()
                       : fmt::format("{} was read; expected a number {}",
                                     io::in_quotes(text), kind);
          },
          ""};
}

CLI::Validator seconds() {
  return number("greater than 0, at most 1e9",
                std::numeric_limits<double>::denorm_min(), 1e9);
}

void add_json(CLI::App& verb, bool& json) {
  verb.add_flag("--json", json, "Print one JSON document to stdout");
}

void add_quiet(CLI::App& verb, bool& quiet) {
  verb.add_flag("--quiet", quiet, "Print no results and no progress");
}

void add_jobs(CLI::App& verb, int& jobs) {
  add_value(verb, "--jobs", jobs, "N",
            "Worker processes; default: one per core")
      ->check(CLI::Range(1, 1024));
}

CLI::Option* add_directory(CLI::App& verb, const std::string& name,
                           std::string& directory, const std::string& text) {
  return add_value(verb, name, directory, "DIR", text)->check(not_empty());
}

void add_sweep_directory(CLI::App& verb, std::string& directory) {
  add_value(verb, "DIR", directory, "TEXT", "Directory of the sweep")
      ->check(not_empty())
      ->required();
}

void CommonFlags::add_to(CLI::App& verb) {
  add_value(verb, "FILE", file, "TEXT",
            "Problem file (YAML); - is standard input")
      ->required();
  add_value(verb, "--set", overrides, "KEY=VALUE",
            "Replace a value of the file, such as scene.body.k=1/4")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  add_json(verb, json);
  add_quiet(verb, quiet);
}

int jobs_or_cores(int jobs) {
  const auto cores = static_cast<int>(std::thread::hardware_concurrency());
  return jobs > 0 ? jobs : std::max(1, cores);
}

}  // namespace brachisto::app
