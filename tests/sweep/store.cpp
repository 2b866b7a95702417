// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/store.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "support/scratch_directory.hpp"
#include "sweep/directory_lock.hpp"
#include "sweep/small_sweep.hpp"

namespace brachisto::sweep {
namespace {

namespace fs = std::filesystem;
using testing::answer;
using testing::info_of;
using testing::ScratchDirectory;
using testing::small_job;

class StoreTest : public ::testing::Test {
 protected:
  ScratchDirectory scratch_;
  Job job_ = small_job();
  ChainPlan plan_{job_.file};

  [[nodiscard]] Store create() const {
    return Store::create(scratch_.path(), info_of(job_));
  }
  [[nodiscard]] Store open(
      Database::Access access = Database::Access::ReadWrite) const {
    return Store::open(scratch_.path(), access);
  }
  [[nodiscard]] static std::vector<std::pair<std::size_t, std::string>> content(
      Store& store) {
    std::vector<std::pair<std::size_t, std::string>> rows;
    store.for_each_result([&](std::size_t scene, const std::string& document) {
      rows.emplace_back(scene, document);
    });
    return rows;
  }
};

TEST_F(StoreTest, KeepsWhatItWasGiven) {
  {
    Store store = create();
    store.record(std::vector{answer(3), answer(1)}, plan_);
    store.record(std::vector{answer(2)}, plan_);
  }
  Store store = open();
  EXPECT_EQ(content(store), (std::vector<std::pair<std::size_t, std::string>>{
                                {1, answer(1).result},
                                {2, answer(2).result},
                                {3, answer(3).result}}));
  EXPECT_EQ(store.num_results(), 3U);
  EXPECT_EQ(store.info().job, to_line(job_));
  EXPECT_EQ(store.info().input_hash, input_hash(job_.file));
  const std::vector<bool> finished = store.finished(40);
  EXPECT_TRUE(finished[1] && finished[2] && finished[3]);
  EXPECT_FALSE(finished[0] || finished[4]);
}

TEST_F(StoreTest, RefusesASecondResultAndKeepsTheFirst) {
  Store store = create();
  store.record(std::vector{answer(1, 1)}, plan_);

  EXPECT_THROW(store.record(std::vector{answer(2), answer(1, 2)}, plan_),
               StoreError);

  // All or none: scene 2 was in the same call.
  EXPECT_EQ(content(store).size(), 1U);
  EXPECT_EQ(content(store)[0].second, answer(1, 1).result);
}

TEST_F(StoreTest, RemembersTheStateOfTheLastSceneOfAChain) {
  Store store = create();
  const Chain chain = plan_[1];

  store.record(std::vector{answer(chain.first, 0, "one"),
                           answer(chain.first + 1, 0, "two")},
               plan_);
  EXPECT_EQ(store.state_of(1), "two");
  EXPECT_EQ(store.state_of(0), "");

  store.record(std::vector{answer(chain.first + 2, 0, "")}, plan_);
  EXPECT_EQ(store.state_of(1), "") << "a failure leaves nothing to start from";
}

TEST_F(StoreTest, ForgetsTheStateOfAFinishedChain) {
  Store store = create();
  const Chain chain = plan_[0];
  for (std::size_t scene = chain.first; scene < chain.last; ++scene) {
    store.record(std::vector{answer(scene, 0, "state")}, plan_);
  }
  EXPECT_EQ(store.state_of(0), "");
}

TEST_F(StoreTest, CanBeReadWhileItIsWritten) {
  Store writer = create();
  writer.record(std::vector{answer(0)}, plan_);
  Store reader = open(Database::Access::ReadOnly);
  writer.record(std::vector{answer(1)}, plan_);
  EXPECT_EQ(reader.num_results(), 2U);
}

TEST_F(StoreTest, IsNotThereBeforeItIsMade) {
  EXPECT_FALSE(Store::exists(scratch_.path()));
  EXPECT_THROW((void)open(), StoreError);
  (void)create();
  EXPECT_TRUE(Store::exists(scratch_.path()));
  EXPECT_THROW((void)create(), StoreError);
  Store::remove(scratch_.path());
  EXPECT_TRUE(fs::is_empty(scratch_.path()));
}

TEST_F(StoreTest, AnEmptyFileIsNoStoreYet) {
  // What a process leaves that was killed before its first transaction.
  (void)scratch_.file(Store::kFileName, "");
  EXPECT_FALSE(Store::exists(scratch_.path()));
  Store store = create();
  store.record(std::vector{answer(0)}, plan_);
  EXPECT_EQ(store.num_results(), 1U);
}

TEST_F(StoreTest, RefusesAFileOfSomethingElse) {
  (void)scratch_.file(Store::kFileName, std::string(4096, 'x'));
  EXPECT_THROW((void)open(), StoreError);
  fs::remove(scratch_.path() / Store::kFileName);
  {
    Database other((scratch_.path() / Store::kFileName).string(),
                   Database::Access::Create);
    other.execute("CREATE TABLE cats (name TEXT)");
  }
  EXPECT_THROW((void)open(), StoreError);
}

TEST_F(StoreTest, RefusesATruncatedFile) {
  {
    Store store = create();
    std::vector<Answer> answers;
    for (std::size_t scene = 0; scene < 40; ++scene) {
      answers.push_back(answer(scene, 0, std::string(500, 's')));
      answers.back().result.insert(
          1, "\"pad\":\"" + std::string(3000, 'p') + "\",");
    }
    store.record(answers, plan_);
  }
  const fs::path file = scratch_.path() / Store::kFileName;
  fs::resize_file(file, fs::file_size(file) / 2);

  EXPECT_THROW((void)open(), StoreError);
}

TEST(DirectoryLock, IsHeldByOneAtATime) {
  const ScratchDirectory scratch;
  const fs::path directory = scratch.path() / "new" / "one";
  {
    const DirectoryLock lock(directory);
    EXPECT_THROW(DirectoryLock second(directory), StoreError);
  }
  EXPECT_NO_THROW(DirectoryLock third(directory));
  EXPECT_TRUE(fs::is_empty(directory));
}

TEST(InputHash, IsTheSameForFilesThatMeanTheSame) {
  Job other = small_job();
  other.text = "# a comment\n" + other.text;
  other.file = io::read_sweep_text(other.text, "other.yaml");
  EXPECT_EQ(input_hash(small_job().file), input_hash(other.file));
  EXPECT_EQ(input_hash(small_job(20, "0.5").file), input_hash(other.file));
}

TEST(InputHash, DiffersWithWhatTheScenesMean) {
  const std::string hash = input_hash(small_job().file);
  EXPECT_NE(input_hash(small_job(21).file), hash);
  EXPECT_NE(input_hash(small_job(20, "0.5000000000000001").file), hash);
}

TEST(Difference, NamesTheKeyAndBothValues) {
  const std::string told =
      difference(small_job().file, small_job(20, "0.4").file);
  EXPECT_NE(told.find("scene.body.k = 0.5"), std::string::npos) << told;
  EXPECT_NE(told.find("0.4"), std::string::npos) << told;
  EXPECT_NE(difference(small_job().file, small_job(21).file).find("42"),
            std::string::npos);
}

}  // namespace
}  // namespace brachisto::sweep
