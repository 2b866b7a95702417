// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/math/jet.hpp"

#include <gtest/gtest.h>

#include <array>

namespace brachisto::math {
namespace {

using On = Dependence<3>;

const On x = On::variable(0), y = On::variable(1), z = On::variable(2);

TEST(Dependence, IsOnWhatAFormulaContains) {
  EXPECT_EQ((x * 2.0 - z).any, 0b101);
  EXPECT_EQ((On(1.0) / y + 3.0).any, 0b010);
  EXPECT_EQ((sin(x) * cos(y) + sqrt(z)).any, 0b111);
  EXPECT_TRUE(On(4.0).any.none());
}

using Pairs = std::array<On::Set, 3>;

TEST(Dependence, HasNoSecondDerivativesOfSumsAndMultiples) {
  EXPECT_EQ((2.0 * x - y / 3.0 + 1.0).second, Pairs{});
  EXPECT_EQ(sqrt(On(4.0)).second, Pairs{});
}

TEST(Dependence, KnowsByWhichPairsThereAreSecondDerivatives) {
  EXPECT_EQ((x * y + z).second, (Pairs{0b010, 0b001, 0}));
  EXPECT_EQ((x + y / z).second, (Pairs{0, 0b100, 0b110}));
  EXPECT_EQ((sin(x + y) - z).second, (Pairs{0b011, 0b011, 0}));
  EXPECT_EQ((x * x).second, (Pairs{0b001, 0, 0}));
  EXPECT_EQ((x * cos(z)).second, (Pairs{0b100, 0, 0b101}));
}

}  // namespace
}  // namespace brachisto::math
