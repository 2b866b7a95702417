// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Short ways to read a sweep from text, and its error messages.

#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "brachisto/io/problem_file.hpp"

namespace brachisto::io {

/// A good problem of three lines; a section `sweep` follows in line 4.
inline const std::string kCylinder =
    "scene:\n"
    "  body: {shape: cylinder, radius: 1/3, k: 1/2}\n"
    "  finish: {L: 3, H: 1}\n";

/// The section, one key in each line from line 5 on.
inline std::string section(const std::vector<std::string>& lines) {
  std::string text = "sweep:\n";
  for (const std::string& line : lines) text += "  " + line + "\n";
  return text;
}

/// A sweep of that cylinder.
inline SweepFile sweep(const std::vector<std::string>& lines,
                       const std::vector<std::string>& overrides = {}) {
  return read_sweep_text(kCylinder + section(lines), "p.yaml", overrides);
}

/// All messages, one per line; "" if the text is good.
inline std::string sweep_text_errors(
    const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    static_cast<void>(read_sweep_text(text, "p.yaml", overrides));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// Those of a sweep of the cylinder.
inline std::string sweep_errors(
    const std::vector<std::string>& lines,
    const std::vector<std::string>& overrides = {}) {
  return sweep_text_errors(kCylinder + section(lines), overrides);
}

/// The number that a key has in a scene; keys count from 0.
inline double number(const SweepFile& file, std::size_t scene,
                     std::size_t key) {
  return std::get<double>(file.values(scene).at(key));
}

/// The numbers of a key in all scenes.
inline std::vector<double> numbers(const SweepFile& file, std::size_t key = 0) {
  std::vector<double> all;
  for (std::size_t i = 0; i < file.num_scenes(); ++i) {
    all.push_back(number(file, i, key));
  }
  return all;
}

}  // namespace brachisto::io
