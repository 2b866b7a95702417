// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Files of output_files.hpp that are too large to be held in memory.

#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace brachisto::report {

/// Takes a file's content piece by piece.
using TextSink = std::function<void(std::string_view piece)>;

/// A file to be written, and who tells its content.
struct StreamedFile {
  std::string name;  ///< without directory
  std::function<void(const TextSink& put)> tell;
};

/// write_files() of content that is told.
void write_streamed_files(const std::filesystem::path& directory,
                          const std::vector<StreamedFile>& files, bool force,
                          const std::vector<std::string>& obsolete = {});

}  // namespace brachisto::report
