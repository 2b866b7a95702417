// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What to ask for where the principal extremal is no answer.

#pragma once

#include <string>

#include "brachisto/model/scene.hpp"
#include "brachisto/study/solve_options.hpp"

namespace brachisto {

/// "search: global", with the key that has to change for it to be allowed;
/// empty if that search was made, or there is none with Contact::Centre.
[[nodiscard]] std::string wider_search(Contact contact,
                                       const SolveOptions& options);

}  // namespace brachisto
