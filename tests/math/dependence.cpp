// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "math/dependence.hpp"

#include <gtest/gtest.h>

namespace brachisto::math {
namespace {

using On = Dependence<3>;

const On x = On::variable(0), y = On::variable(1), z = On::variable(2);

TEST(Dependence, IsOnWhatAFormulaContains) {
  EXPECT_EQ((x * 2.0 - z).any, 0b101);
  EXPECT_EQ((On(1.0) / y + 3.0).any, 0b010);
  EXPECT_EQ((sin(x) * cos(y) + sqrt(z)).any, 0b111);
  EXPECT_TRUE(On(4.0).any.none());
  EXPECT_TRUE(sqrt(On(4.0)).curved.none());
}

TEST(Dependence, IsAffineUnderSumsAndMultiples) {
  EXPECT_TRUE((2.0 * x - y / 3.0 + 1.0).curved.none());
  EXPECT_EQ((x * y + z).curved, 0b011);
  EXPECT_EQ((x + y / z).curved, 0b110);
  EXPECT_EQ((sin(x + y) - z).curved, 0b011);
  EXPECT_EQ((x * x).curved, 0b001);
}

}  // namespace
}  // namespace brachisto::math
