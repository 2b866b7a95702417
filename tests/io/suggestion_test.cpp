// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/visible_text.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace brachisto::io {
namespace {

TEST(EditDistance, CountsEachKindOfEditOnce) {
  EXPECT_EQ(edit_distance("radius", "radius"), 0);
  EXPECT_EQ(edit_distance("radius", "radus"), 1);
  EXPECT_EQ(edit_distance("radius", "raddius"), 1);
  EXPECT_EQ(edit_distance("radius", "rabius"), 1);
  EXPECT_EQ(edit_distance("radius", "raduis"), 1);
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
}

TEST(EditDistance, IsSymmetric) {
  EXPECT_EQ(edit_distance("theta", "eta_m"), edit_distance("eta_m", "theta"));
}

TEST(EditDistance, IgnoresCase) {
  EXPECT_EQ(edit_distance("l", "L"), 0);
}

TEST(Suggestion, NamesTheNearestCandidate) {
  constexpr std::array<std::string_view, 4> kKeys{"radius", "eta_m", "theta_m",
                                                  "k"};

  EXPECT_EQ(suggestion("raduis", kKeys), "; did you mean radius?");
  EXPECT_EQ(suggestion("etam", kKeys), "; did you mean eta_m?");
  EXPECT_EQ(suggestion("theta", kKeys), "; did you mean theta_m?");
  EXPECT_EQ(suggestion("K", kKeys), "; did you mean k?");
}

TEST(Suggestion, KeepsSilentIfNothingIsNear) {
  constexpr std::array<std::string_view, 2> kKeys{"radius", "k"};

  EXPECT_EQ(suggestion("friction", kKeys), "");
  EXPECT_EQ(suggestion("m", kKeys), "");
  EXPECT_EQ(suggestion("", kKeys), "");
  EXPECT_EQ(suggestion(std::string(1'000'000, 'x'), kKeys), "");
}

}  // namespace
}  // namespace brachisto::io
