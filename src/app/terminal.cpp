// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "app/terminal.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
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

enum class When { Auto, Always, Never };
When when_coloured = When::Auto;

bool wants_colour(int descriptor) {
  if (when_coloured != When::Auto) return when_coloured == When::Always;
  const char* terminal = std::getenv("TERM");
  const char* no_colour = std::getenv("NO_COLOR");
  return ::isatty(descriptor) == 1 && terminal != nullptr &&
         std::string_view(terminal) != "dumb" &&
         (no_colour == nullptr || *no_colour == '\0');
}

std::string coloured(std::string_view text, Colour colour) {
  return fmt::format("\033[{}m{}\033[0m", static_cast<int>(colour), text);
}

/// Every line on its own, changed by `paint`.
template <class Paint>
std::string line_by_line(std::string_view text, Paint&& paint) {
  std::string out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    out += paint(text.substr(0, end));
    text.remove_prefix(end);
    if (text.empty()) break;
    out += '\n';
    text.remove_prefix(1);
  }
  return out;
}

}  // namespace

void set_colour(std::string_view when) {
  when_coloured = when == "always"  ? When::Always
                  : when == "never" ? When::Never
                                    : When::Auto;
}

void print(std::string_view text) {
  write(io::visible_lines(text));
}

void print_paths(const std::filesystem::path& directory,
                 const std::vector<report::OutputFile>& files) {
  for (const report::OutputFile& file : files) {
    print(io::visible((directory / file.name).string()) + "\n");
  }
}

void print_with_verdict(std::string_view text, Colour colour) {
  const std::string shown = io::visible_lines(text);
  if (!wants_colour(STDOUT_FILENO)) return write(shown);
  write(line_by_line(shown, [&](std::string_view line) {
    const bool judges = line.starts_with("  verdict ") ||
                        line.starts_with("  failed check ") ||
                        line.starts_with("  because ");
    return judges ? coloured(line, colour) : std::string(line);
  }));
}

void print_data(std::string_view data) {
  if (::isatty(STDOUT_FILENO) == 1) return print(data);
  write(data);
}

std::string json_text(const nlohmann::ordered_json& document) {
  constexpr auto kReplace = nlohmann::json::error_handler_t::replace;
  return document.dump(2, ' ', false, kReplace) + "\n";
}

void print_json(const nlohmann::ordered_json& document) {
  print_data(json_text(document));
}

void tell(std::string_view text) {
  std::fputs(io::visible_lines(text).c_str(), stderr);
}

void tell_error(std::string_view text) {
  const std::string shown = io::visible_lines(text);
  const std::string painted =
      !wants_colour(STDERR_FILENO)
          ? shown
          : line_by_line(shown, [](std::string_view line) {
              const std::size_t colon = line.find(": ");
              if (colon == std::string_view::npos) return std::string(line);
              return coloured(line.substr(0, colon + 1), Colour::Red) +
                     std::string(line.substr(colon + 1));
            });
  std::fputs(painted.c_str(), stderr);
}

void warn(std::string_view text) {
  if (text.empty()) return;
  std::string head = "warning:";
  if (wants_colour(STDERR_FILENO)) head = coloured(head, Colour::Yellow);
  std::fputs(fmt::format("{} {}\n", head, io::visible_lines(text)).c_str(),
             stderr);
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
