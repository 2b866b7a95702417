// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The command line as data: what verbs there are, and what each may be told.
// Only command_line.cpp knows the library that reads it.

#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace brachisto::app {

/// What a text has to be.
struct TextCheck {
  std::function<std::string(const std::string&)> objection;  ///< "": none
  std::string kind = {};                                     ///< for the help
  std::vector<std::string> words = {};  ///< if it is one of a few
};

/// Refuses an empty text, such as the name of a directory in a variable that is
/// not set.
[[nodiscard]] TextCheck not_empty();
/// Refuses what is no number or not of the kind, NaN included.
///
/// \param kind     what is allowed, "greater than 0, at most 1e9"
/// \param allowed  whether a number is, false for NaN
[[nodiscard]] TextCheck number(const std::string& kind,
                               bool (*allowed)(double));
/// Of a limit of time: greater than 0, at most 1e9.
[[nodiscard]] TextCheck seconds();
[[nodiscard]] TextCheck integer_within(int least, int most);
[[nodiscard]] TextCheck positive();
[[nodiscard]] TextCheck existing_file();
[[nodiscard]] TextCheck existing_directory();
[[nodiscard]] TextCheck one_of(std::vector<std::string> words);

/// A word that a key of problem files may have, which its reader checks.
[[nodiscard]] TextCheck word_of(std::string_view key);

/// A flag, or a word without one, and what it is read into.
struct Flag {
  const char* name;  ///< "--jobs"; "FILE" of a word
  std::variant<bool*, int*, double*, std::string*, std::vector<std::string>*>
      value;              ///< a list: given again and again
  const char* text = "";  ///< in the help
  /// Of the value, in the help. FILE, DIR and KEY=VALUE, or a word with one of
  /// these names, tell shells what to offer.
  const char* placeholder = "TEXT";
  TextCheck check = {};
  bool required = false;
  bool shows_default = false;
  bool hidden = false;
  std::vector<const char*> needs = {};  ///< flags one of which has to be there
  const char* excludes = nullptr;       ///< another flag
  /// Of the flags that name the same choice one has to be given.
  const char* choice = nullptr;

  [[nodiscard]] bool is_word() const { return *name != '-'; }
  [[nodiscard]] bool has_value() const {
    return !std::holds_alternative<bool*>(value);
  }
};

/// Flags of several verbs: --json; --markdown in its place; --jobs, 0 unless it
/// is given; --force where there is --resume; the program of workers, for
/// tests; a directory under whatever name; the DIR of a finished sweep.
[[nodiscard]] Flag json_flag(bool& json);
[[nodiscard]] Flag markdown_flag(bool& markdown);
[[nodiscard]] Flag jobs_flag(int& jobs);
[[nodiscard]] Flag unless_resumed(bool& force);
[[nodiscard]] Flag worker_flag(std::string& program);
[[nodiscard]] Flag directory_flag(const char* name, std::string& directory,
                                  const char* text, bool required = false);

[[nodiscard]] Flag sweep_directory(std::string& directory);

/// `jobs`, or one for each core if that is 0.
[[nodiscard]] int jobs_or_cores(int jobs);

struct Verb {
  const char* name;
  const char* text = "";  ///< in the help
  std::vector<Flag> flags = {};
  std::string footer = {};
  std::function<int()> run;  ///< once the flags are read; returns the exit code
  bool hidden = false;
  bool takes_anything = false;  ///< of which nothing is read
};

/// The whole command.
struct CommandLine {
  const char* text;
  const char* footer;
  std::string (*version)();
  std::vector<Verb> verbs;
  std::vector<Flag> everywhere = {};  ///< flags of every verb
};

/// What the help of a verb shows: its words and flags, those of every verb, and
/// --help, which has no value.
[[nodiscard]] std::vector<Flag> shown_flags(const CommandLine& command,
                                            const Verb& verb);

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

/// What a command line asks for: a verb, whose flags are read, or a text, of
/// the help or the version.
using Asked = std::variant<const Verb*, std::string>;

/// \throws UsageError  of what is wrong first the verb or the flag that nobody
///         knows, with the nearest one, or the word too many, and only then
///         what follows from it
[[nodiscard]] Asked read_command_line(const CommandLine& command, int argc,
                                      char** argv);

}  // namespace brachisto::app
