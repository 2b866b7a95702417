// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What is to be done in full or not at all: no signal in the middle of it, no
/// directory that nothing came into, no file that ends too early.

#pragma once

#include <array>
#include <csignal>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace brachisto::report {

/// Lets the signals that ask the process to end wait as long as this lives; one
/// that came meanwhile is raised then. One object at a time.
class HeldSignals {
 public:
  HeldSignals();
  ~HeldSignals();
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;

  /// Whether one waits.
  [[nodiscard]] static bool waiting();

 private:
  static constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP, SIGQUIT};
  std::array<struct sigaction, kSignals.size()> before_{};
};

/// A directory for what is about to be written, made if need be with those
/// above it. What was made and is empty in the end is removed again.
class NewDirectories {
 public:
  NewDirectories(const std::filesystem::path& directory,
                 std::error_code& error);
  ~NewDirectories();
  NewDirectories(const NewDirectories&) = delete;
  NewDirectories& operator=(const NewDirectories&) = delete;

 private:
  std::vector<std::filesystem::path> made_;  ///< the innermost first
};

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
