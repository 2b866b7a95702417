// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Names of problem files and table rows as tests want them.

#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>
#include <vector>

#include "support/reference_values.hpp"

namespace brachisto::testing {

/// The problem files of a folder, without extension, sorted.
[[nodiscard]] inline std::vector<std::string> problem_files(
    const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".yaml") {
      names.push_back(entry.path().stem().string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// A file's name as that of a test.
[[nodiscard]] inline std::string file_name(
    const ::testing::TestParamInfo<std::string>& file) {
  std::string text = file.param;
  std::replace_if(
      text.begin(), text.end(),
      [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return text;
}

/// A reference value's name as that of a test.
[[nodiscard]] inline std::string row_name(
    const ::testing::TestParamInfo<ReferenceValue>& row) {
  std::string text;
  for (const char c : std::string(row.param.name)) {
    if (c == '-') text += "minus_";
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) text += c;
    if (c == '_' || c == '.') text += '_';
  }
  return text;
}

}  // namespace brachisto::testing
