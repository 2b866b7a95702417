// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Problem files to begin with: keys that matter, each with what the table of
// keys says of it.

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace brachisto::app {

/// "case", "limits", …
[[nodiscard]] std::vector<std::string> new_problem_kinds();

/// A problem file of a kind, with comments. A key behind a # and no space may
/// be stated too: the file is as good without any of these #, if those before
/// the maps that the key is in go with it. \param name  as it is called in its
/// first line, without control characters
[[nodiscard]] std::string new_problem(std::string_view kind,
                                      std::string_view name);

/// What is done with such a file: "solve track.yaml".
[[nodiscard]] std::string next_command(std::string_view kind,
                                       std::string_view file,
                                       std::string_view name);

}  // namespace brachisto::app
