// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/nlp/problem.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/random_points.hpp"

namespace brachisto::testing {
namespace {

using nlp::SparsityPattern;
using Position = SparsityPattern::Position;

/// A pattern beside a list of all its positions, one by one.
struct Listed {
  SparsityPattern pattern;
  std::vector<Position> positions;

  void add(int row, int col) {
    pattern.add(row, col);
    positions.push_back({row, col});
  }
  /// Entries first[k] + i strides[k] for i < times, of which two are told.
  void add_repeated(const std::vector<Position>& first,
                    const std::vector<Position>& strides, int times) {
    for (int i = 0; i < times; ++i) {
      for (std::size_t k = 0; k < first.size(); ++k) {
        const int row = first[k].row + i * strides[k].row;
        const int col = first[k].col + i * strides[k].col;
        if (i < 2) pattern.add(row, col);
        positions.push_back({row, col});
      }
    }
    if (times > 2) {
      pattern.repeat(first.size(), static_cast<std::size_t>(times) - 2);
    }
  }
};

void expect_the_same(const Listed& listed, const std::string& what) {
  const auto& [pattern, positions] = listed;
  ASSERT_EQ(pattern.num_entries(), positions.size()) << what;
  std::size_t next = 0;
  pattern.for_each([&](std::size_t entry, int row, int col) {
    ASSERT_EQ(entry, next++) << what;
    EXPECT_EQ((Position{row, col}), positions[entry])
        << what << ", entry " << entry;
    EXPECT_EQ(pattern[entry], positions[entry]) << what << ", entry " << entry;
  });
  EXPECT_EQ(next, positions.size()) << what;
}

TEST(SparsityPattern, OfNothingHasNoEntries) {
  const SparsityPattern none;

  none.for_each([](std::size_t, int, int) { ADD_FAILURE() << "an entry"; });

  EXPECT_EQ(none.num_entries(), 0U);
}

TEST(SparsityPattern, KeepsTheOrderInWhichEntriesAreAdded) {
  Listed listed;
  for (const Position& one : {Position{3, 1}, {0, 2}, {3, 1}, {2, 2}}) {
    listed.add(one.row, one.col);
  }

  expect_the_same(listed, "one by one");
  EXPECT_EQ(listed.pattern, (SparsityPattern{{3, 1}, {0, 2}, {3, 1}, {2, 2}}));
}

TEST(SparsityPattern, GoesOnAsItsLastEntriesSay) {
  // An element of five unknowns and three rows; one that all share; one
  // position twice; one that goes back.
  const std::vector<Position> first{{0, 0},   {0, 5}, {1, 2},  {99, 3},
                                    {99, 99}, {1, 2}, {60, 70}};
  const std::vector<Position> strides{{3, 5}, {3, 5}, {3, 5},  {0, 5},
                                      {0, 0}, {3, 5}, {-2, -1}};
  for (const int times : {1, 2, 3, 4, 20}) {
    Listed listed;
    listed.add_repeated(first, strides, times);

    expect_the_same(listed, std::to_string(times) + " times");
  }
}

TEST(SparsityPattern, RepeatsBetweenOtherEntries) {
  Listed listed;
  listed.add(7, 7);
  listed.add_repeated({{0, 0}}, {{1, 1}}, 9);
  listed.add_repeated({{1, 0}, {2, 0}}, {{2, 1}, {2, 1}}, 5);
  listed.add(40, 41);
  listed.add(42, 43);
  listed.add_repeated({{5, 4}}, {{0, 3}}, 3);
  listed.add(8, 8);

  expect_the_same(listed, "mixed");
}

TEST(SparsityPattern, OfAnyMixtureIsWhatWasAdded) {
  for (std::uint32_t seed = 1; seed <= 50; ++seed) {
    Random random(seed);
    const auto any = [&](int below) {
      return static_cast<int>(random.uniform(0.0, below));
    };
    Listed listed;
    for (int part = any(6); part >= 0; --part) {
      std::vector<Position> first, strides;
      for (int k = any(5); k >= 0; --k) {
        first.push_back({50 + any(50), 50 + any(50)});
        strides.push_back({any(7) - 3, any(7) - 3});
      }
      listed.add_repeated(first, strides, any(9));
      for (int k = any(3); k > 0; --k) listed.add(any(100), any(100));
    }

    expect_the_same(listed, "seed " + std::to_string(seed));
  }
}

TEST(SparsityPattern, SaysWhichEntriesItRepeats) {
  Listed listed;
  listed.add(7, 7);
  listed.add_repeated({{1, 0}, {2, 0}}, {{2, 1}, {2, 1}}, 5);
  listed.add(40, 41);

  EXPECT_EQ(listed.pattern.repetition_of(0), nullptr);
  for (std::size_t entry = 1; entry < 11; ++entry) {
    const auto* const repetition = listed.pattern.repetition_of(entry);
    ASSERT_NE(repetition, nullptr) << "entry " << entry;
    EXPECT_EQ(repetition->begin, 1U);
    EXPECT_EQ(repetition->length, 2U);
    EXPECT_EQ(repetition->end(), 11U);
  }
  EXPECT_EQ(listed.pattern.repetition_of(11), nullptr);
}

TEST(SparsityPattern, NeedsTwoTimesToGoOn) {
  SparsityPattern pattern{{0, 0}, {1, 1}, {2, 2}};

  EXPECT_THROW(pattern.repeat(2, 1), std::invalid_argument);
  pattern.repeat(1, 4);
  EXPECT_EQ(pattern.num_entries(), 7U);
  pattern.add(9, 9);
  EXPECT_THROW(pattern.repeat(1, 1), std::invalid_argument);
  pattern.repeat(0, 5);
  EXPECT_EQ(pattern.num_entries(), 8U);
}

}  // namespace
}  // namespace brachisto::testing
