// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "app/terminal.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>

#include "io/visible_text.hpp"
#include "report/letters.hpp"

namespace brachisto::app {

namespace {

void write(std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) < bytes.size()) {
    throw std::system_error(errno, std::generic_category(),
                            "cannot write to stdout");
  }
}

/// https://no-color.org
bool wants_colour() {
  const char* terminal = std::getenv("TERM");
  const char* no_colour = std::getenv("NO_COLOR");
  return ::isatty(STDOUT_FILENO) == 1 && terminal != nullptr &&
         std::string_view(terminal) != "dumb" &&
         (no_colour == nullptr || *no_colour == '\0');
}

}  // namespace

void print(std::string_view text) {
  write(io::visible_lines(text));
}

void print_with_verdict(std::string_view text, Colour colour) {
  std::string shown = io::visible_lines(text);
  const std::size_t begin = shown.find("\n  verdict");
  if (wants_colour() && begin != std::string::npos) {
    const std::size_t end = shown.find('\n', begin + 1);
    shown.insert(end == std::string::npos ? shown.size() : end, "\033[0m");
    shown.insert(begin + 1, fmt::format("\033[{}m", static_cast<int>(colour)));
  }
  write(shown);
}

void print_data(std::string_view data) {
  if (::isatty(STDOUT_FILENO) == 1) return print(data);
  write(data);
}

void print_json(const nlohmann::ordered_json& document) {
  constexpr auto kReplace = nlohmann::json::error_handler_t::replace;
  print_data(document.dump(2, ' ', false, kReplace) + "\n");
}

void tell(std::string_view text) {
  std::fputs(io::visible_lines(text).c_str(), stderr);
}

void warn(std::string_view text) {
  if (!text.empty()) tell(fmt::format("warning: {}\n", text));
}

void tell_progress(std::string_view line) {
  tell(report::shortened(io::visible(line), report::columns_for_a_line()) +
       "\n");
}

std::function<void(const std::string&)> progress_lines(bool quiet) {
  return [quiet](const std::string& line) {
    if (!quiet) tell_progress(line);
  };
}

bool flush_results() {
  return std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
}

}  // namespace brachisto::app
