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

TEST(Letters, OfAWidthFindRoomInIt) {
  EXPECT_LE(width_of(letters_within(390.0, 14.0), 14.0), 390.0);
  EXPECT_GT(width_of(letters_within(390.0, 14.0) + 1, 14.0), 390.0);
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
