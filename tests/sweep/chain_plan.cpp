// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/chain_plan.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <stdexcept>
#include <vector>

namespace brachisto::sweep {
namespace {

/// Rows of many lengths, shorter and longer than a chain may be.
const std::vector<std::size_t> kRows{1, 2, 15, 16, 17, 32, 33, 61, 1000};

TEST(ChainPlan, HasEverySceneOnce) {
  for (const std::size_t row : kRows) {
    const ChainPlan plan(3 * row, row, 16);
    std::size_t next = 0;
    for (std::size_t id = 0; id < plan.size(); ++id) {
      const Chain chain = plan[id];
      EXPECT_EQ(chain.id, id);
      EXPECT_EQ(chain.first, next);
      EXPECT_LT(chain.first, chain.last);
      next = chain.last;
    }
    EXPECT_EQ(next, 3 * row);
  }
}

TEST(ChainPlan, NeverLeavesARow) {
  for (const std::size_t row : kRows) {
    const ChainPlan plan(3 * row, row, 16);
    for (std::size_t id = 0; id < plan.size(); ++id) {
      const Chain chain = plan[id];
      EXPECT_EQ(chain.first / row, (chain.last - 1) / row);
      EXPECT_LE(chain.last - chain.first, 16U);
    }
  }
}

TEST(ChainPlan, CutsARowIntoNearlyEqualPieces) {
  const ChainPlan plan(61, 61, 16);
  ASSERT_EQ(plan.size(), 4U);
  for (std::size_t id = 0; id < plan.size(); ++id) {
    const std::size_t length = plan[id].last - plan[id].first;
    EXPECT_TRUE(length == 15 || length == 16) << length;
  }
}

TEST(ChainPlan, FindsTheChainOfAScene) {
  for (const std::size_t row : kRows) {
    const ChainPlan plan(3 * row, row, 16);
    for (std::size_t scene = 0; scene < 3 * row; ++scene) {
      const Chain chain = plan.of_scene(scene);
      EXPECT_LE(chain.first, scene);
      EXPECT_LT(scene, chain.last);
    }
  }
}

TEST(Shard, PartsShareTheChains) {
  for (std::size_t chain = 0; chain < 100; ++chain) {
    int owners = 0;
    for (std::size_t i = 1; i <= 7; ++i) owners += Shard{i, 7}.has(chain);
    EXPECT_EQ(owners, 1);
  }
}

TEST(Shard, IsReadAsWritten) {
  const Shard shard = Shard::parse("2/8");
  EXPECT_EQ(shard.index, 2U);
  EXPECT_EQ(shard.count, 8U);
  EXPECT_EQ(shard.name(), "2/8");
}

TEST(Shard, RefusesWhatIsNone) {
  for (const char* text : {"", "1", "0/3", "4/3", "1/0", "a/b", "1/2/3", "-1/2",
                           "1/2 ", "1//2", "/2", "1/"}) {
    EXPECT_THROW((void)Shard::parse(text), std::invalid_argument) << text;
  }
}

}  // namespace
}  // namespace brachisto::sweep
