// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// All that the command says to people goes this way. Names and words of others
// are part of it: no control character of theirs gets through.

#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "brachisto/report/result.hpp"

namespace brachisto::app {

/// Results for people, to stdout, control characters escaped.
/// \throws std::system_error  if they cannot be written
void print(std::string_view text);

/// The paths of files in a directory, one a line.
void print_paths(const std::filesystem::path& directory,
                 const std::vector<report::OutputFile>& files);

/// As terminals number them.
enum class Colour { Red = 31, Green = 32, Yellow = 33 };

/// Whether there are colours: "always", "never", or "auto", which is also any
/// other word: on a terminal that knows colours, unless NO_COLOR is set
/// (https://no-color.org). It holds for stdout and stderr apart.
void set_colour(std::string_view when);

/// Results for people whose verdict, with what failed, has a colour.
/// \throws std::system_error  if they cannot be written
void print_with_verdict(std::string_view text, Colour colour);

/// Data for programs, to stdout, byte by byte; to a terminal like print().
/// \throws std::system_error  if they cannot be written
void print_data(std::string_view data);
/// A document with two spaces per level; bytes that are no UTF-8 are replaced.
[[nodiscard]] std::string json_text(const nlohmann::ordered_json& document);
/// The same to stdout.
void print_json(const nlohmann::ordered_json& document);

/// Everything else, to stderr, control characters escaped. Nobody may listen.
void tell(std::string_view text);

/// The same for what went wrong. Who or where says so, up to the first colon
/// of each line, is red.
void tell_error(std::string_view text);

/// The same for what went well, but not quite; nothing if there is nothing to
/// say.
void warn(std::string_view text);

/// A line on how it gets on, without its line feed: no longer than the terminal
/// is wide.
void tell_progress(std::string_view line);

/// The same for whoever announces what comes next; silent if `quiet`.
[[nodiscard]] std::function<void(const std::string&)> progress_lines(
    bool quiet);

/// Writes out what stdout still buffers.
/// \return false if any of it was lost: a full disk, a closed pipe
[[nodiscard]] bool flush_results();

}  // namespace brachisto::app
