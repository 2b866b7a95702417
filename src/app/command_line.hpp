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
