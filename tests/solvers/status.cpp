// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/solvers/status.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <vector>

namespace brachisto {
namespace {

std::vector<Status> all() {
  std::vector<Status> values;
  for (int i = 0; i <= static_cast<int>(Status::InternalError); ++i) {
    values.push_back(static_cast<Status>(i));
  }
  return values;
}

TEST(StatusNames, AreUniqueWordsOfLowerCase) {
  std::set<std::string_view> seen;
  for (const Status status : all()) {
    const std::string_view word = name(status);

    EXPECT_TRUE(seen.insert(word).second) << word;
    EXPECT_NE(word, "unknown");
    EXPECT_TRUE(std::ranges::all_of(word, [](char c) {
      return (c >= 'a' && c <= 'z') || c == '_';
    })) << word;
  }
}

TEST(StatusNames, AreTheOnesThatScriptsRelyOn) {
  EXPECT_EQ(name(Status::Solved), "solved");
  EXPECT_EQ(name(Status::IterationLimit), "iteration_limit");
  EXPECT_EQ(name(Status::TimeLimit), "time_limit");
  EXPECT_EQ(name(Status::Interrupted), "interrupted");
  EXPECT_EQ(name(Status::NoAdmissiblePath), "no_admissible_path");
  EXPECT_EQ(name(Status::NoFastestTrack), "no_fastest_track");
}

TEST(StatusDescriptions, AreOneSentenceEachAndUnique) {
  std::set<std::string_view> seen;
  for (const Status status : all()) {
    const std::string_view sentence = describe(status);

    EXPECT_TRUE(seen.insert(sentence).second) << sentence;
    EXPECT_TRUE(sentence.ends_with('.')) << sentence;
    EXPECT_EQ(std::ranges::count(sentence, '.'), 1) << sentence;
    EXPECT_NE(sentence, "Unknown status.");
  }
}

}  // namespace
}  // namespace brachisto
