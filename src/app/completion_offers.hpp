// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What the completions of all shells offer.

#pragma once

#include <string>
#include <vector>

#include "app/command_line.hpp"
#include "io/key_spec.hpp"

namespace brachisto::app {

/// What a value is completed to.
enum class Offer { Nothing, Words, Keys, ProblemFiles, Directories };
[[nodiscard]] Offer offer_of(const Flag& flag);

/// Keys that stand before the "=" of --set.
[[nodiscard]] std::vector<const io::KeySpec*> settable_keys();

/// The same with their "=", one a line.
[[nodiscard]] std::string key_names();

/// Branches of `case` in bash and zsh: the words that a key may have.
[[nodiscard]] std::string cases_of_keys();

}  // namespace brachisto::app
