// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What the bytes of a problem file may be.

#include <gtest/gtest.h>

#include <string>

#include "io/reading.hpp"

namespace brachisto::io {
namespace {

using namespace std::string_literals;

TEST(Bytes, WindowsLineEndsAreRead) {
  const std::string text =
      "scene:\r\n  body: {shape: bead}\r\n  finish: {L: 3, H: 1}\r\n";

  EXPECT_EQ(errors(text), "");
}

TEST(Bytes, WindowsLineEndsDoNotShiftPositions) {
  EXPECT_EQ(errors("# a\r\n# b\r\n" + kBead + "solver: {guess: 3}\r\n"),
            "p.yaml:4:17: solver.guess: \"3\" was read; expected cycloid or "
            "straight or random");
}

TEST(Bytes, AByteOrderMarkIsRead) {
  EXPECT_EQ(errors("\xEF\xBB\xBF" + kBead), "");
}

TEST(Bytes, OtherEncodingsAreRefused) {
  EXPECT_EQ(errors("\xFF\xFEs\0c\0"s),
            "p.yaml:1:1: byte 0xff is not UTF-8; save the file in the encoding "
            "UTF-8");
  EXPECT_EQ(errors("# \xC3\xA9 \xE9\n" + kBead),
            "p.yaml:1:5: byte 0xe9 is not UTF-8; save the file in the encoding "
            "UTF-8");
}

TEST(Bytes, IllFormedCharactersAreRefused) {
  for (const std::string bytes :
       {"\xC0\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xE2\x82", "\x80",
        "\xF0\x80\x80\x80", "\xF5\x80\x80\x80", "\xE2\x28\xA1"}) {
    EXPECT_NE(errors("# " + bytes).find("is not UTF-8"), std::string::npos)
        << ::testing::PrintToString(bytes);
  }
}

TEST(Bytes, ControlCharactersAreRefused) {
  EXPECT_EQ(errors("a: \0b"s),
            "p.yaml:1:4: control character U+0000 is not allowed in a text");
  EXPECT_EQ(errors(kBead + "# \x04 is the end of input to yaml-cpp"),
            "p.yaml:2:3: control character U+0004 is not allowed in a text");
  EXPECT_EQ(errors("a: 1\rb: 2"),
            "p.yaml:1:5: control character U+000D is not allowed in a text");
}

TEST(Bytes, TabsAreRefusedAsIndentation) {
  EXPECT_EQ(errors("scene:\n\tbody: {shape: bead}\n"),
            "p.yaml:2:1: tab in the indentation; YAML indents with spaces");
  EXPECT_EQ(errors("scene:\n  \tbody: {shape: bead}\n"),
            "p.yaml:2:3: tab in the indentation; YAML indents with spaces");
}

TEST(Bytes, TabsAreReadBetweenValuesAndComments) {
  EXPECT_EQ(errors("version:\t1\t# first\n" + kBead), "");
}

TEST(Bytes, ColumnsCountCharacters) {
  EXPECT_EQ(errors("# β\n" + kBead + "solver: {\"θθ\": 1, guess: ö}\n"),
            "p.yaml:3:10: solver.θθ: unknown key; allowed in solver: method, "
            "linear_solver, threads, tolerance, search, polish, certify, "
            "sensitivities, guess, seed, limits, fsolve\n"
            "p.yaml:3:26: solver.guess: \"ö\" was read; expected cycloid or "
            "straight or random");
}

TEST(Bytes, LengthIsLimited) {
  const std::string comment = "# " + std::string(kMaxFileSize, 'x');

  EXPECT_EQ(errors(kBead + comment),
            "p.yaml:1:1: longer than 1048576 bytes, which no problem file "
            "needs to be");
}

TEST(Bytes, EmptyFilesAreRefused) {
  for (const std::string text :
       {"", "\n\n", "# only\n# comments\n", "---\n", "\xEF\xBB\xBF", "~"}) {
    EXPECT_EQ(errors(text),
              "p.yaml:1:1: the file is empty; expected at least the key scene")
        << ::testing::PrintToString(text);
  }
}

}  // namespace
}  // namespace brachisto::io
