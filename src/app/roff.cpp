// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "app/roff.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "report/letters.hpp"

namespace brachisto::app {

namespace {

/// What roff would make something else of: a minus of a hyphen, a curly quote
/// of a straight one.
std::string_view roff_of(char c) {
  switch (c) {
    case '\\':
      return "\\e";
    case '-':
      return "\\-";
    case '\'':
      return "\\(aq";
    case '`':
      return "\\(ga";
    case '^':
      return "\\(ha";
    case '~':
      return "\\(ti";
    case '"':
      return "\\(dq";
    default:
      return {};
  }
}

std::string upper_case(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), [](unsigned char c) {
    return static_cast<char>(std::toupper(c));
  });
  return out;
}

}  // namespace

std::string roff(std::string_view text) {
  std::string out;
  for (const char c : text) {
    // At the beginning of a line it would be a request.
    if (c == '.' && (out.empty() || out.back() == '\n')) out += "\\&";
    const std::string_view escaped = roff_of(c);
    if (escaped.empty()) {
      out += c;
    } else {
      out += escaped;
    }
  }
  return out;
}

std::string roff_bold(std::string_view text) {
  return "\\fB" + roff(text) + "\\fR";
}

std::string roff_italic(std::string_view text) {
  return "\\fI" + roff(text) + "\\fR";
}

ManualPage::ManualPage(std::string_view title, int section,
                       std::string_view version, std::string_view text)
    : text_(fmt::format(".TH {} {} \"\" \"brachisto {}\"\n.nh\n.SH NAME\n{} "
                        "\\- {}\n",
                        roff(upper_case(title)), section, roff(version),
                        roff(title), roff(text))) {}

ManualPage& ManualPage::section(std::string_view title) {
  return roff_line(fmt::format(".SH {}", roff(upper_case(title))));
}

ManualPage& ManualPage::subsection(std::string_view title) {
  return roff_line(fmt::format(".SS {}", roff(title)));
}

ManualPage& ManualPage::paragraph(std::string_view text) {
  begin_paragraph();
  fill(text);
  return *this;
}

ManualPage& ManualPage::roff_line(std::string_view line) {
  text_ += line;
  text_ += '\n';
  return *this;
}

ManualPage& ManualPage::example(const std::vector<std::string>& lines) {
  begin_paragraph();
  roff_line(".nf");
  for (const std::string& line : lines) roff_line(roff(line));
  return roff_line(".fi");
}

ManualPage& ManualPage::entry(std::string_view head, std::string_view text) {
  roff_line(".TP").roff_line(head);
  fill(text);
  return *this;
}

void ManualPage::begin_paragraph() {
  const std::size_t line = text_.rfind('\n', text_.size() - 2) + 1;
  if (text_.compare(line, 2, ".S") != 0) roff_line(".PP");
}

void ManualPage::fill(std::string_view text) {
  constexpr std::size_t kLetters = 76;
  for (const std::string& line : report::words_in_lines(text, kLetters))
    roff_line(roff(line));
}

}  // namespace brachisto::app
