// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/letters.hpp"

#include <gtest/gtest.h>

namespace brachisto::report {
namespace {

TEST(Letters, AreThoseOfUtf8) {
  EXPECT_EQ(letters("θ_m = −30°"), 10u);
  EXPECT_EQ(letters(""), 0u);
}

TEST(LinesOf, BreaksAListAfterCommas) {
  using Lines = std::vector<std::string>;
  EXPECT_EQ(lines_of("a = 1, b = 2, c = 3", 13),
            (Lines{"a = 1, b = 2,", "c = 3"}));
  EXPECT_EQ(lines_of("a long item, b", 3), (Lines{"a long item,", "b"}));
  EXPECT_EQ(lines_of("", 3), Lines{""});
}

TEST(WordsInLines, BreaksATextAtSpaces) {
  using Lines = std::vector<std::string>;
  EXPECT_EQ(words_in_lines("η_m and θ_m,  of\nthe body", 11),
            (Lines{"η_m and", "θ_m, of the", "body"}));
  EXPECT_EQ(words_in_lines("a longer word", 3), (Lines{"a", "longer", "word"}));
  EXPECT_EQ(words_in_lines("", 3), Lines{""});
}

TEST(Shortened, EndsInAnEllipsis) {
  EXPECT_EQ(shortened("smooth", 6), "smooth");
  EXPECT_EQ(shortened("smooth", 5), "smoo…");
  EXPECT_EQ(shortened("ηθηθ", 3), "ηθ…");
}

TEST(ShortenedKey, KeepsItsEnd) {
  const char* key = "solver.limits.iterations";
  EXPECT_EQ(shortened_key(key, 24), key);
  EXPECT_EQ(shortened_key(key, 23), "…limits.iterations");
  EXPECT_EQ(shortened_key(key, 17), "…iterations");
  EXPECT_EQ(shortened_key(key, 8), "…iterat…");
}

}  // namespace
}  // namespace brachisto::report
