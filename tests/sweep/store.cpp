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
using testing::content;
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
  EXPECT_EQ(store.info().job, to_line(job_));
  EXPECT_EQ(store.info().input_hash, input_hash(job_.file));
  EXPECT_EQ(store.info().num_scenes, 40U);
  store.check();
  EXPECT_FALSE(store.damage()) << store.damage_text();
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
  EXPECT_EQ(store.state_after(1, chain.first + 1), "two");
  EXPECT_EQ(store.state_after(1, chain.first), std::nullopt);
  EXPECT_EQ(store.state_after(0, 0), std::nullopt);

  store.record(std::vector{answer(chain.first + 2, 0, "")}, plan_);
  EXPECT_EQ(store.state_after(1, chain.first + 2), "")
      << "after a failure the next scene starts from the cycloid";
}

TEST_F(StoreTest, KeepsTheStateOfALaterSceneOfTheChain) {
  Store store = create();
  store.record(std::vector{answer(5, 0, "five")}, plan_);

  store.record(std::vector{answer(3, 0, "three")}, plan_);

  EXPECT_EQ(store.state_after(0, 5), "five");
  EXPECT_EQ(store.state_after(0, 3), std::nullopt);
}

TEST_F(StoreTest, ForgetsTheStateOfAFinishedChain) {
  Store store = create();
  const Chain chain = plan_[0];
  for (std::size_t scene = chain.first; scene < chain.last; ++scene) {
    store.record(std::vector{answer(scene, 0, "state")}, plan_);
  }
  EXPECT_EQ(store.state_after(0, chain.last - 1), std::nullopt);
}

TEST_F(StoreTest, CanBeReadWhileItIsWritten) {
  Store writer = create();
  writer.record(std::vector{answer(0)}, plan_);
  Store reader = open(Database::Access::ReadOnly);
  writer.record(std::vector{answer(1)}, plan_);
  EXPECT_EQ(content(reader).size(), 2U);
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

TEST_F(StoreTest, IsMadeInFullOrNotAtAll) {
  // What a process leaves that was killed on the way.
  (void)scratch_.file("sweep.sqlite.new", "half of it");
  EXPECT_FALSE(Store::exists(scratch_.path()));
  (void)create();
  EXPECT_EQ(std::distance(fs::directory_iterator(scratch_.path()), {}), 1);
}

TEST_F(StoreTest, IsOneFileOnceItIsClosed) {
  {
    Store store = create();
    store.record(std::vector{answer(0)}, plan_);
    EXPECT_TRUE(fs::exists(scratch_.path() / "sweep.sqlite-wal"));
  }
  {
    Store reader = open(Database::Access::ReadOnly);
    EXPECT_EQ(content(reader).size(), 1U);
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(scratch_.path()), {}), 1);
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
  EXPECT_TRUE(fs::is_empty(scratch.path())) << "nothing came into it";
}

TEST(DirectoryLock, KeepsADirectoryThatSomethingCameInto) {
  const ScratchDirectory scratch;
  const fs::path directory = scratch.path() / "new" / "one";
  {
    const DirectoryLock lock(directory);
    (void)scratch.file("new/one/file", "text");
  }
  EXPECT_TRUE(fs::exists(directory / "file"));
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
