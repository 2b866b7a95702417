// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What shells offer when a user types TAB, made from the tables that the help
// and the reader of problem files are made from: verbs, flags, words that a
// value may be, keys behind --set, problem files, directories.

#pragma once

#include <string>

#include "app/command_line.hpp"

namespace brachisto::app {

[[nodiscard]] std::string bash_completion(const CommandLine& command);
[[nodiscard]] std::string zsh_completion(const CommandLine& command);
[[nodiscard]] std::string fish_completion(const CommandLine& command);

}  // namespace brachisto::app
