// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/rich_text.hpp"

#include <fmt/format.h>

#include <vector>

#include "report/figure.hpp"

namespace brachisto::report {

namespace {

enum class Level { Line, Lowered, Raised };

/// Words at one level.
struct Run {
  std::string text;
  Level level = Level::Line;
};

/// Bytes of the letter of UTF-8 that the text begins with.
std::size_t first_letter(std::string_view text) {
  std::size_t end = 1;
  while (end < text.size() && (text[end] & 0xC0) == 0x80) ++end;
  return end;
}

std::vector<Run> runs(std::string_view source) {
  std::vector<Run> out;
  const auto put = [&](std::string_view text, Level level) {
    if (out.empty() || out.back().level != level) {
      out.push_back({std::string(text), level});
    } else {
      out.back().text += text;
    }
  };
  while (!source.empty()) {
    const std::size_t mark = source.find_first_of("_^");
    if (mark != std::string_view::npos && mark > 0 &&
        source[mark - 1] == '\\') {
      put(source.substr(0, mark - 1), Level::Line);
      put(source.substr(mark, 1), Level::Line);
      source = source.substr(mark + 1);
      continue;
    }
    put(source.substr(0, mark), Level::Line);
    if (mark == std::string_view::npos) break;
    const Level level = source[mark] == '_' ? Level::Lowered : Level::Raised;
    const std::string_view rest = source.substr(mark + 1);
    const std::size_t brace = rest.find('}');
    if (rest.empty()) {  // A mark without a letter stands for itself.
      put(source.substr(mark), Level::Line);
      break;
    }
    if (rest.front() == '{' && brace != std::string_view::npos) {
      put(rest.substr(1, brace - 1), level);
      source = rest.substr(brace + 1);
    } else {
      const std::size_t letter = first_letter(rest);
      put(rest.substr(0, letter), level);
      source = rest.substr(letter);
    }
  }
  std::erase_if(out, [](const Run& run) { return run.text.empty(); });
  return out;
}

}  // namespace

std::string xml_escaped(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '"') {
      out += "&quot;";
    } else if (code < 0x20 && c != '\t' && c != '\n' && c != '\r') {
      out += "\uFFFD";
    } else {
      out += c;
    }
  }
  return out;
}

std::string html_words(std::string_view source) {
  std::string out;
  for (const Run& run : runs(source)) {
    const std::string text = xml_escaped(run.text);
    switch (run.level) {
      case Level::Line:
        out += text;
        break;
      case Level::Lowered:
        out += "<sub>" + text + "</sub>";
        break;
      case Level::Raised:
        out += "<sup>" + text + "</sup>";
        break;
    }
  }
  return out;
}

std::string gnuplot_words(std::string_view source) {
  std::string out;
  for (const Run& run : runs(source)) {
    const std::string text = gnuplot_escaped(run.text);
    switch (run.level) {
      case Level::Line:
        out += text;
        break;
      case Level::Lowered:
        out += "_{" + text + "}";
        break;
      case Level::Raised:
        out += "^{" + text + "}";
        break;
    }
  }
  return out;
}

std::string plain_words(std::string_view source) {
  std::string out;
  for (const Run& run : runs(source)) out += run.text;
  return out;
}

std::string as_rich_text(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '_' || c == '^') out += '\\';
    out += c;
  }
  return out;
}

}  // namespace brachisto::report
