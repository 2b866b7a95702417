// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Short ways to read a problem from text, and its error messages.

#pragma once

#include <string>
#include <vector>

#include "brachisto/io/problem_file.hpp"

namespace brachisto::io {

/// A good problem of one line, to which tests may add more.
inline const std::string kBead =
    "scene: {body: {shape: bead}, finish: {L: 3, H: 1}}\n";

inline ProblemFile read(const std::string& text,
                        const std::vector<std::string>& overrides = {}) {
  return read_problem_text(text, "p.yaml", overrides);
}

/// All messages, one per line; "" if the text is good.
inline std::string errors(const std::string& text,
                          const std::vector<std::string>& overrides = {}) {
  try {
    static_cast<void>(read(text, overrides));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// A cylinder whose flow map ends with the given keys.
inline std::string cylinder(const std::string& keys) {
  return "scene:\n  finish: {L: 3, H: 1}\n  body: {shape: cylinder, " + keys +
         "}\n";
}

}  // namespace brachisto::io
