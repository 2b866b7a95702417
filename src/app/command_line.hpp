// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The command line: what verbs there are, what each may be told, and what is
// said of one that nobody understands. CLI11 reads it.

#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace brachisto::app {

/// What is to be done; returns the exit code.
using Run = std::function<int()>;

/// A command line that is refused; what() begins with the verb.
class UsageError : public std::runtime_error {
 public:
  /// \param asked  "brachisto solve", or "brachisto" if there is no verb
  UsageError(std::string asked, const std::string& what)
      : std::runtime_error(asked + ": " + what), asked_(std::move(asked)) {}

  [[nodiscard]] const std::string& asked() const { return asked_; }

 private:
  std::string asked_;
};

/// The whole command.
class Command {
 public:
  Command(const std::string& text, const std::string& footer,
          const std::function<std::string()>& version);

  /// A further verb, whose flags are still to be described.
  CLI::App& add(const std::string& name, const std::string& text,
                const std::string& footer, Run run);

  /// What a command line asks for: a verb, whose flags are read, or to print
  /// the help or the version.
  ///
  /// \throws UsageError  of what is wrong first the verb or the flag that
  ///         nobody knows, with the nearest one, or the word too many, and only
  ///         then what follows from it
  [[nodiscard]] Run read(int argc, char** argv);

 private:
  CLI::App app_;
  std::map<std::string, Run> runs_;
};

/// Refuses an empty text, such as the name of a directory in a variable that is
/// not set.
[[nodiscard]] CLI::Validator not_empty();
/// Refuses what is no number or outside of an interval, NaN included.
/// \param kind  what is allowed, "from 0 to 1e12"
[[nodiscard]] CLI::Validator number(const std::string& kind, double least,
                                    double most);
/// Of a limit of time: greater than 0, at most 1e9.
[[nodiscard]] CLI::Validator seconds();

/// A flag with a value, or a word without a flag. A list is given again and
/// again.
/// \param placeholder  of the value, in the help
template <class Value>
CLI::Option* add_value(CLI::App& verb, const std::string& name, Value& value,
                       const std::string& placeholder,
                       const std::string& text) {
  return verb.add_option(name, value, text)->type_name(placeholder);
}

/// Flags of several verbs: --json; --quiet; --jobs, 0 unless it is given; a
/// directory under whatever name; the DIR of a finished sweep.
void add_json(CLI::App& verb, bool& json);
void add_quiet(CLI::App& verb, bool& quiet);
void add_jobs(CLI::App& verb, int& jobs);
CLI::Option* add_directory(CLI::App& verb, const std::string& name,
                           std::string& directory, const std::string& text);
void add_sweep_directory(CLI::App& verb, std::string& directory);

/// Flags that every verb with a problem file shares.
struct CommonFlags {
  std::string file;
  std::vector<std::string> overrides;  ///< --set KEY=VALUE
  bool json = false;
  bool quiet = false;

  /// Describes them.
  void add_to(CLI::App& verb);
};

/// `jobs`, or one for each core if that is 0.
[[nodiscard]] int jobs_or_cores(int jobs);

}  // namespace brachisto::app
