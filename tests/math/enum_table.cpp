// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "math/enum_table.hpp"

#include <gtest/gtest.h>

namespace brachisto {
namespace {

enum class Card { Ace, King, Rank10 };

TEST(EnumTable, TellsEnumeratorsFromOtherValues) {
  EXPECT_TRUE(is_enumerator<Card::Ace>());
  EXPECT_TRUE(is_enumerator<static_cast<Card>(2)>()) << "digits in the name";
  EXPECT_FALSE(is_enumerator<static_cast<Card>(3)>());
}

TEST(EnumTable, HasTheValueOfEachEnumerator) {
  constexpr auto kNames = table_by<Card>("ace", "king", "ten");

  EXPECT_STREQ(kNames[Card::Ace], "ace");
  EXPECT_STREQ(kNames[Card::Rank10], "ten");
}

}  // namespace
}  // namespace brachisto
