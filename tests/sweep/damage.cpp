// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What is damaged in a store is found and costs no more than itself.

#include "sweep/damage.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "support/scratch_directory.hpp"
#include "sweep/merge.hpp"
#include "sweep/small_sweep.hpp"

namespace brachisto::sweep {
namespace {

namespace fs = std::filesystem;
using testing::content;
using testing::info_of;
using testing::ScratchDirectory;
using testing::small_job;

class DamageTest : public ::testing::Test {
 protected:
  DamageTest() {
    Store store = Store::create(scratch_.path(), info_of(job_));
    std::vector<Answer> answers;
    for (std::size_t scene = 0; scene < kStored; ++scene) {
      answers.push_back(testing::answer(scene, 0, "state"));
      // As long as real ones, some of them on several pages.
      answers.back().result.insert(
          1, "\"pad\":\"" + std::string(100 * scene, 'p') + "\",");
    }
    store.record(answers, ChainPlan(job_.file));
    whole_ = content(store);
  }

  [[nodiscard]] Store open(
      Database::Access access = Database::Access::ReadOnly) const {
    return Store::open(scratch_.path(), access);
  }
  /// Changes the store behind its back.
  void execute(const std::string& sql) const {
    Database database(file_.string(), Database::Access::ReadWrite);
    database.execute(sql.c_str());
  }
  [[nodiscard]] std::string bytes() const {
    std::ifstream in(file_, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void write(const std::string& bytes) const {
    std::ofstream(file_, std::ios::binary) << bytes;
  }
  [[nodiscard]] std::string refusal(Database::Access access) const {
    try {
      (void)open(access);
    } catch (const StoreError& error) {
      return error.what();
    }
    return "";
  }

  static constexpr std::size_t kStored = 38;
  ScratchDirectory scratch_;
  fs::path file_ = scratch_.path() / Store::kFileName;
  Job job_ = small_job();
  std::vector<std::pair<std::size_t, std::string>> whole_;
};

TEST_F(DamageTest, OfADigitCostsItsSceneOnly) {
  execute(
      "UPDATE result SET document = replace(document, 'solved', 'solvec') "
      "WHERE scene = 17");

  Store store = open();
  auto rest = whole_;
  rest.erase(rest.begin() + 17);
  EXPECT_EQ(content(store), rest);

  EXPECT_EQ(store.damage().scenes, std::set<std::size_t>{17});
  EXPECT_EQ(store.damage_text(),
            file_.string() +
                ": damaged: the results of scene 17 do not match their "
                "checksums");
}

TEST_F(DamageTest, OfAKeyIsNotTheResultOfAnotherScene) {
  execute("UPDATE result SET scene = 39 WHERE scene = 5");
  execute("UPDATE result SET scene = -7 WHERE scene = 8");
  execute("UPDATE result SET scene = 4000 WHERE scene = 9");

  Store store = open();

  EXPECT_EQ(content(store).size(), kStored - 3);
  EXPECT_EQ(store.damage().scenes, std::set<std::size_t>{39});
  EXPECT_EQ(store.damage().strays, 2U);
}

TEST_F(DamageTest, IsRemovedAndMayBeRecordedAnew) {
  execute("UPDATE result SET document = 'x' WHERE scene IN (1, 2, 3, 30)");
  execute("UPDATE result SET scene = 4000 WHERE scene = 9");
  execute("UPDATE state SET value = 'another'");
  execute("UPDATE info SET value = 'x' WHERE key = 'job'");
  {
    Store store = open(Database::Access::ReadWrite);
    store.check();
    EXPECT_NE(store.damage_text().find("scenes 1–3, 30"), std::string::npos)
        << store.damage_text();
    EXPECT_EQ(store.damage().strays, 1U);
    EXPECT_EQ(store.damage().states, 1U);
    EXPECT_EQ(store.state_after(3, kStored - 1), std::nullopt);

    store.mend(info_of(job_));

    std::vector<Answer> again;
    for (const std::size_t scene : {1U, 2U, 3U, 9U, 30U}) {
      again.push_back({scene, whole_[scene].second, "state"});
    }
    store.record(again, ChainPlan(job_.file));
  }
  Store store = open();
  store.check();
  EXPECT_FALSE(store.damage()) << store.damage_text();
  EXPECT_EQ(content(store), whole_);
  EXPECT_EQ(to_line(store.job()), to_line(job_));
}

TEST_F(DamageTest, OfTheProblemFileLeavesTheResultsReadable) {
  execute("UPDATE info SET value = 'x' WHERE key = 'job'");

  Store store = open();

  EXPECT_EQ(content(store), whole_);
  try {
    (void)store.job();
    FAIL();
  } catch (const StoreError& error) {
    EXPECT_NE(std::string(error.what()).find("--resume"), std::string::npos);
  }
}

TEST_F(DamageTest, OfWhatTheRestTellsCostsNothing) {
  for (const std::string key :
       {"input_hash", "version", "shard", "scenes", "provenance"}) {
    const std::string before = bytes();
    execute("UPDATE info SET value = '12' WHERE key = '" + key + "'");
    {
      Store store = open(Database::Access::ReadWrite);
      EXPECT_NE(store.damage_text().find("what it has as " + key +
                                         " does not match its checksum"),
                std::string::npos);
      EXPECT_EQ(content(store), whole_) << key;
      store.mend(info_of(job_));
    }
    const Store store = open();
    EXPECT_FALSE(store.damage()) << store.damage_text();
    EXPECT_EQ(store.info().input_hash, info_of(job_).input_hash) << key;
    EXPECT_EQ(store.info().version, info_of(job_).version) << key;
    EXPECT_EQ(store.info().shard, info_of(job_).shard) << key;
    EXPECT_EQ(store.info().num_scenes, info_of(job_).num_scenes) << key;
    write(before);
  }
}

TEST_F(DamageTest, OfWhatNothingElseTellsIsTheEnd) {
  for (const std::string keys :
       {"'job', 'scenes'", "'job', 'input_hash'", "'version', 'provenance'"}) {
    const std::string before = bytes();
    execute("UPDATE info SET value = '12' WHERE key IN (" + keys + ")");
    EXPECT_NE(refusal(Database::Access::ReadOnly).find("--force"),
              std::string::npos)
        << keys;
    write(before);
  }
}

TEST_F(DamageTest, IsWhatNoProgramOfOursCanHaveWritten) {
  // With a checksum that is right.
  const std::string deep =
      R"({"status":"","message":"","verified":false,"x":)" +
      std::string(300'000, '[') + std::string(300'000, ']') + "}";
  const std::string wide = [] {
    std::string text = R"({"status":"","message":"","verified":false)";
    for (int i = 0; i < 60'000; ++i) {
      text += ",\"" + std::to_string(i) + "\":0";
    }
    return text + "}";
  }();
  std::size_t scene = 0;
  for (const std::string& document :
       {deep, wide, std::string("{}"), std::string("rubbish")}) {
    Database database(file_.string(), Database::Access::ReadWrite);
    Statement update(
        database,
        "UPDATE result SET document = ?, checksum = ? WHERE scene = ?");
    update
        .with(document,
              row_checksum("result " + std::to_string(scene), document), scene)
        .run();
    ++scene;
  }

  Store store = open();

  EXPECT_EQ(content(store).size(), kStored - 4);
  EXPECT_EQ(store.damage().scenes, (std::set<std::size_t>{0, 1, 2, 3}));
}

TEST_F(DamageTest, OfAPageCostsWhatIsOnIt) {
  // The leaf that has the row, with everything that tells it is one.
  constexpr std::size_t kPage = 4096;
  std::string damaged = bytes();
  const std::size_t place = damaged.find(std::string(400, 'p'));
  ASSERT_NE(place, std::string::npos);
  std::fill_n(
      damaged.begin() + static_cast<std::ptrdiff_t>(place / kPage * kPage),
      kPage, '\x55');
  write(damaged);

  Store store = open();
  const auto rest = content(store);

  EXPECT_FALSE(store.damage().structure.empty());
  EXPECT_FALSE(store.damage().scenes.empty());
  EXPECT_EQ(rest.size() + store.damage().scenes.size(), kStored);
  EXPECT_TRUE(
      std::includes(whole_.begin(), whole_.end(), rest.begin(), rest.end()));

  EXPECT_NE(refusal(Database::Access::ReadWrite).find("brachisto merge"),
            std::string::npos);
  const fs::path saved = scratch_.path() / "saved";
  fs::create_directory(saved);
  Store target = Store::create(saved, info_of(job_));
  std::vector<Store> parts = open_parts({scratch_.path()}, info_of(job_));
  const MergeReport report = merge(parts, target, job_);
  EXPECT_EQ(content(target), rest);
  EXPECT_TRUE(report.damaged);
}

TEST_F(DamageTest, OfAnyByteChangesNoResult) {
  const std::string sound = bytes();
  std::mt19937 random(1);  // NOLINT: the same bytes each time
  int refused = 0, told = 0, harmless = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    std::string damaged = sound;
    const std::size_t place = random() % damaged.size();
    damaged[place] = static_cast<char>(damaged[place] ^ (1 << random() % 8));
    write(damaged);
    for (const char* suffix : {"-wal", "-shm"}) {
      fs::remove(file_.string() + suffix);
    }
    try {
      Store store = open();
      const auto rest = content(store);
      ASSERT_TRUE(
          std::includes(whole_.begin(), whole_.end(), rest.begin(), rest.end()))
          << "byte " << place;
      ASSERT_TRUE(rest == whole_ || store.damage()) << "byte " << place;
      ++(rest == whole_ ? harmless : told);
    } catch (const StoreError&) {
      ++refused;
    }
  }
  // Most of the file is results, the rest what is on no page in use.
  EXPECT_GT(told, 500) << refused << " refused, " << harmless << " harmless";
  EXPECT_LT(refused, 100);
}

TEST_F(DamageTest, OfTheJournalIsToldAndNotHidden) {
  const ScratchDirectory copy;
  {
    Store store = open(Database::Access::ReadWrite);
    store.record(std::vector{testing::answer(39)}, ChainPlan(job_.file));
    // What a kill leaves, but for the journal.
    fs::copy(file_, copy.path());
  }
  for (int i = 0; i < 2; ++i) {
    Store reader = Store::open(copy.path(), Database::Access::ReadOnly);
    EXPECT_EQ(content(reader), whole_);
    EXPECT_NE(reader.damage_text().find("-wal"), std::string::npos)
        << reader.damage_text();
  }
  {
    Store writer = Store::open(copy.path(), Database::Access::ReadWrite);
    EXPECT_TRUE(writer.damage().journal_lost);
    writer.mend(info_of(job_));
  }
  Store mended = Store::open(copy.path(), Database::Access::ReadOnly);
  EXPECT_EQ(content(mended), whole_);
  EXPECT_FALSE(mended.damage()) << mended.damage_text();
}

TEST_F(DamageTest, IsNotWhatAKillLeavesWithNothingInTheJournal) {
  // Between the moment when the file says that it has one and that when it is
  // there, or the other way round.
  const ScratchDirectory copy;
  {
    Database database(file_.string(), Database::Access::ReadWrite);
    database.use_journal();
    fs::copy(file_, copy.path());
  }
  ASSERT_TRUE(
      Database::lacks_journal((copy.path() / Store::kFileName).string()));
  Store reader = Store::open(copy.path(), Database::Access::ReadOnly);
  EXPECT_EQ(content(reader), whole_);
  EXPECT_FALSE(reader.damage()) << reader.damage_text();
}

TEST_F(DamageTest, OfEverythingIsToldAndNotBegunAnew) {
  write("");
  EXPECT_THROW((void)Store::exists(scratch_.path()), StoreError);
  EXPECT_THROW((void)Store::create(scratch_.path(), info_of(job_)), StoreError);
  EXPECT_NE(refusal(Database::Access::ReadWrite).find("is empty"),
            std::string::npos);
  EXPECT_EQ(fs::file_size(file_), 0U);

  fs::remove(file_);
  for (const char* journal : {"-wal", "-journal"}) {
    std::ofstream(file_.string() + journal) << "of a store that is gone";
    EXPECT_THROW((void)Store::exists(scratch_.path()), StoreError);
    EXPECT_THROW((void)Store::create(scratch_.path(), info_of(job_)),
                 StoreError);
    fs::remove(file_.string() + journal);
  }
  (void)scratch_.file("sweep.sqlite-wal", "of a store that is gone");
  Store::remove(scratch_.path());
  EXPECT_TRUE(fs::is_empty(scratch_.path()));
}

TEST_F(DamageTest, CannotBeSeenInAStoreWithoutChecksums) {
  execute("PRAGMA user_version = 1");
  const std::string told = refusal(Database::Access::ReadOnly);
  EXPECT_NE(told.find("format 1, which has no checksums"), std::string::npos)
      << told;
}

TEST(SceneRanges, NameRunsByTheirEnds) {
  EXPECT_EQ(scene_ranges({4}), "scene 4");
  EXPECT_EQ(scene_ranges({0, 1, 2, 7, 9, 10}), "scenes 0–2, 7, 9–10");
}

}  // namespace
}  // namespace brachisto::sweep
