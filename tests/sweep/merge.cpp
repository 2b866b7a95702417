// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/merge.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <numeric>
#include <string>
#include <vector>

#include "support/scratch_directory.hpp"
#include "sweep/small_sweep.hpp"

namespace brachisto::sweep {
namespace {

namespace fs = std::filesystem;
using testing::answer;
using testing::content;
using testing::info_of;
using testing::ScratchDirectory;
using testing::small_job;

class MergeTest : public ::testing::Test {
 protected:
  ScratchDirectory scratch_;
  Job job_ = small_job();

  /// A store with scenes first … last − 1.
  fs::path part(const std::string& name, std::size_t first, std::size_t last,
                int value = 0, const std::string& state = "") {
    const fs::path directory = scratch_.path() / name;
    fs::create_directories(directory);
    Store store = Store::create(directory, info_of(job_));
    std::vector<Answer> answers;
    for (std::size_t scene = first; scene < last; ++scene) {
      answers.push_back(answer(scene, value, state));
    }
    store.record(answers, ChainPlan(job_.file));
    return directory;
  }
  MergeReport merge_parts(const std::vector<fs::path>& parts, Store& whole) {
    std::vector<Store> stores = open_parts(parts, whole.info());
    return merge(stores, whole, job_);
  }
  Store target(const std::string& name = "target") {
    return Store::open(part(name, 0, 0), Database::Access::ReadWrite);
  }
};

TEST_F(MergeTest, JoinsPartsAndListsGaps) {
  const fs::path a = part("a", 0, 10), b = part("b", 12, 40);
  Store whole = target();

  const MergeReport report = merge_parts({a, b}, whole);

  EXPECT_EQ(report.added, 38U);
  EXPECT_EQ(content(whole).size(), 38U);
  EXPECT_EQ(report.gaps, (std::vector<std::size_t>{10, 11}));
  EXPECT_TRUE(report.overlaps.empty());
  EXPECT_TRUE(report.conflicts.empty());
}

TEST_F(MergeTest, IsIdempotent) {
  const fs::path a = part("a", 0, 10), b = part("b", 10, 40);
  Store whole = target();
  (void)merge_parts({a, b}, whole);

  const MergeReport again = merge_parts({a, b}, whole);

  EXPECT_EQ(again.added, 0U);
  EXPECT_TRUE(again.overlaps.empty()) << "the target is no part";
  EXPECT_EQ(content(whole).size(), 40U);
  EXPECT_TRUE(again.conflicts.empty());
}

TEST_F(MergeTest, ListsOverlapsThatDifferInTimesAtMost) {
  const fs::path a = part("a", 0, 6), b = part("b", 4, 10);
  Store whole = target();

  const MergeReport report = merge_parts({a, b}, whole);

  EXPECT_EQ(report.overlaps, (std::vector<std::size_t>{4, 5}));
  EXPECT_TRUE(report.conflicts.empty());
}

TEST_F(MergeTest, APartNamedTwiceIsOne) {
  const fs::path a = part("a", 0, 6);
  Store whole = target();

  const MergeReport report = merge_parts({a, a / ".." / "a"}, whole);

  EXPECT_EQ(report.added, 6U);
  EXPECT_TRUE(report.overlaps.empty());
}

TEST_F(MergeTest, ListsConflictsAndKeepsTheFirst) {
  const fs::path a = part("a", 0, 6, 1), b = part("b", 5, 8, 2);
  Store whole = target();

  const MergeReport report = merge_parts({a, b}, whole);

  EXPECT_EQ(report.conflicts, (std::vector<std::size_t>{5}));
  whole.for_each_result([](std::size_t scene, const std::string& document) {
    const int value = scene < 6 ? 1 : 2;
    EXPECT_EQ(document, answer(scene, value).result);
  });
}

TEST_F(MergeTest, BringsTheStateOfAnUnfinishedChain) {
  const fs::path a = part("a", 0, 4, 0, "state");
  Store whole = target();

  (void)merge_parts({a}, whole);

  EXPECT_EQ(whole.state_after(0, 3), "state");
}

TEST_F(MergeTest, LeavesAFailedSceneWithoutTheStateOfAnotherPart) {
  const fs::path a = part("a", 0, 4), b = part("b", 0, 3, 0, "state");
  Store whole = target();

  (void)merge_parts({a, b}, whole);

  EXPECT_EQ(whole.state_after(0, 3), "") << "scene 3 of part a left nothing";
}

TEST_F(MergeTest, MakesTheTargetAMergedStore) {
  Store whole = target();
  (void)merge_parts({part("a", 0, 4)}, whole);
  EXPECT_EQ(Store::open(scratch_.path() / "target", Database::Access::ReadOnly)
                .info()
                .shard,
            kMerged);
}

TEST_F(MergeTest, RefusesPartsOfAnotherSweepAndAddsNothing) {
  const fs::path a = part("a", 0, 4);
  job_ = small_job(20, "0.4");
  const fs::path other = part("other", 4, 8);
  job_ = small_job();
  Store whole = target();

  EXPECT_THROW((void)merge_parts({a, other}, whole), StoreError);
  EXPECT_EQ(content(whole).size(), 0U);
}

}  // namespace
}  // namespace brachisto::sweep
