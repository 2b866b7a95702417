// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/visible_text.hpp"

#include <gtest/gtest.h>

#include <string>

#include "brachisto/io/problem_file.hpp"

namespace brachisto::io {
namespace {

using namespace std::string_literals;

TEST(Visible, LeavesWordsAsTheyAre) {
  for (const char* text : {"", "case.yaml", "θ_m = −30°", "轨道.yaml", "a b"}) {
    EXPECT_EQ(visible(text), text);
  }
}

TEST(Visible, EscapesWhatATerminalObeys) {
  EXPECT_EQ(visible("a\x1b[31mb"), "a\\x1b[31mb");
  EXPECT_EQ(visible("\0\a\b\t\n\r\x7f"s),
            "\\x00\\x07\\x08\\x09\\x0a\\x0d\\x7f");
  // C1: U+009B is ESC [ in one character.
  EXPECT_EQ(visible("\u009B31m"), "\\xc2\\x9b31m");
  EXPECT_EQ(visible("\u0080\u009F\u00A0"), "\\xc2\\x80\\xc2\\x9f\u00A0");
  // Separators of lines, and marks that turn the direction of text.
  EXPECT_EQ(visible("\u2028\u2029"), "\\xe2\\x80\\xa8\\xe2\\x80\\xa9");
  EXPECT_EQ(visible("\u202E\u2066"), "\\xe2\\x80\\xae\\xe2\\x81\\xa6");
}

TEST(Visible, EscapesBytesThatAreNoUtf8) {
  EXPECT_EQ(visible("a\x9b\xff"), "a\\x9b\\xff");
  EXPECT_EQ(visible("\xE2\x82"), "\\xe2\\x82");
}

TEST(Visible, CutsBetweenCharacters) {
  EXPECT_EQ(visible("ηθη", 3), "ηθη");
  EXPECT_EQ(visible("ηθη", 2), "ηθ…");
  EXPECT_EQ(visible("\x1b\x1b", 1), "\\x1b…");
}

TEST(VisibleLines, KeepsLinesAndTabs) {
  EXPECT_EQ(visible_lines("a\tb\nc\x1b\r\n"), "a\tb\nc\\x1b\\x0d\n");
}

TEST(Diagnostic, IsOneLineWhateverItsNamesContain) {
  const std::string text = to_string(
      {"a\x1b]0;b\a\n.yaml", 3, 7, "scene.\u009Bk", "was read\nas nothing"});

  EXPECT_EQ(text,
            "a\\x1b]0;b\\x07\\x0a.yaml:3:7: scene.\\xc2\\x9bk: was "
            "read\\x0aas nothing");
}

}  // namespace
}  // namespace brachisto::io
