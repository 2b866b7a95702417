// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/rich_text.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>
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

/// What stands before and behind words at each level.
using Marks = std::array<std::pair<std::string_view, std::string_view>, 3>;

std::string marked(std::string_view source,
                   std::string (*escaped)(std::string_view),
                   const Marks& marks) {
  std::string out;
  for (const Run& run : runs(source)) {
    const auto& [before, behind] = marks[static_cast<std::size_t>(run.level)];
    out += fmt::format("{}{}{}", before, escaped(run.text), behind);
  }
  return out;
}

}  // namespace

std::string xml_escaped(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    const bool known = code >= 0x20 || c == '\t' || c == '\n' || c == '\r';
    const std::size_t special = std::string_view("&<>\"").find(c);
    if (special != std::string_view::npos) {
      constexpr std::array kEntities{"&amp;", "&lt;", "&gt;", "&quot;"};
      out += kEntities[special];
    } else if (known) {
      out += c;
    } else {
      out += "\uFFFD";
    }
  }
  return out;
}

std::string html_words(std::string_view source) {
  return marked(source, xml_escaped,
                {{{"", ""}, {"<sub>", "</sub>"}, {"<sup>", "</sup>"}}});
}

std::string gnuplot_words(std::string_view source) {
  return marked(source, gnuplot_escaped,
                {{{"", ""}, {"_{", "}"}, {"^{", "}"}}});
}

std::string plain_words(std::string_view source) {
  return marked(source, [](std::string_view text) { return std::string(text); },
                {});
}

std::string as_rich_text(std::string_view text) {
  return replaced(replaced(text, "_", "\\_"), "^", "\\^");
}

std::string replaced(std::string_view text, std::string_view old,
                     std::string_view by) {
  std::string out;
  for (std::size_t at = text.find(old); at != std::string_view::npos;
       at = text.find(old)) {
    out.append(text.substr(0, at)).append(by);
    text.remove_prefix(at + old.size());
  }
  return out.append(text);
}

}  // namespace brachisto::report
