// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What the verbs have in common on the command line.

#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace brachisto::app {

/// Refuses an empty text, such as the name of a directory in a variable that is
/// not set.
[[nodiscard]] CLI::Validator not_empty();

/// Refuses what is no number or not of the kind, NaN included.
///
/// \param kind     what is allowed, "greater than 0, at most 1e9"
/// \param allowed  whether a number is, false for NaN
[[nodiscard]] CLI::Validator number(std::string kind, bool (*allowed)(double));

/// Of a limit of time: greater than 0, at most 1e9.
[[nodiscard]] CLI::Validator seconds();

/// Flags of several verbs: --json; --jobs, 0 unless it is given; a directory
/// under whatever name.
void add_json(CLI::App& verb, bool& json);
void add_jobs(CLI::App& verb, int& jobs);
CLI::Option* add_directory(CLI::App& verb, const char* name,
                           std::string& directory, const char* text);

/// `jobs`, or one for each core if that is 0.
[[nodiscard]] int jobs_or_cores(int jobs);

/// "brachisto solve", or "brachisto" as long as there is no verb.
[[nodiscard]] std::string asked(const CLI::App& app);

/// What is wrong with a command line that was refused: the verb or the flag
/// nobody knows and the nearest one, or the word too many, before what follows
/// from it.
///
/// \param app    after its parse() threw
/// \param error  what it threw
[[nodiscard]] std::string explain(const CLI::App& app,
                                  const CLI::ParseError& error);

}  // namespace brachisto::app
