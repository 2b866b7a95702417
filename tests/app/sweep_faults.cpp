// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What goes wrong in a sweep costs as little as it can, and is told.

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/command.hpp"
#include "app/sweep_command.hpp"
#include "app/tiny_disk.hpp"

namespace brachisto {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::content;
using testing::kScenes;
using testing::Output;
using testing::Process;
using testing::run;
using testing::ScratchDirectory;
using testing::small_sweep;
using testing::sweep;
using testing::table_of;
using testing::TinyDisk;
using testing::wait_for;

/// A program that does `mischief` the first `times` that it is run, and is a
/// good worker afterwards.
std::string bad_worker(const ScratchDirectory& scratch,
                       const std::string& mischief, int times) {
  const std::string counter = (scratch.path() / "runs").string();
  std::string path = scratch.file(
      "worker.sh", "#!/bin/sh\necho >> " + counter + "\nn=$(wc -l < " +
                       counter + ")\nif [ $n -le " + std::to_string(times) +
                       " ]; then\n" + mischief +
                       "\nfi\nexec " BRACHISTO_APP " worker\n");
  fs::permissions(path, fs::perms::owner_all);
  return path;
}

struct Mischief {
  std::string name;
  std::string script;
  std::string status;  ///< of the scene it costs if it happens twice
};

void PrintTo(const Mischief& mischief, std::ostream* out) {
  *out << mischief.name;
}

class BadWorker : public ::testing::TestWithParam<Mischief> {
 protected:
  /// Only who hangs has to be waited for; good workers answer in time.
  static std::string timeout() {
    return GetParam().status == "worker_timeout" ? "3" : "600";
  }
};

INSTANTIATE_TEST_SUITE_P(
    Kinds, BadWorker,
    ::testing::Values(
        Mischief{"crashes", "kill -SEGV $$", "worker_lost"},
        Mischief{"ends_with_an_error", "exit 3", "worker_lost"},
        Mischief{"ends_without_an_answer", "exit 0", "worker_lost"},
        Mischief{"hangs", "exec sleep 1000", "worker_timeout"},
        Mischief{"closes_its_output", "exec >&-; exec sleep 1000",
                 "worker_lost"},
        Mischief{"writes_rubbish", "echo rubbish; exec sleep 1000",
                 "worker_rubbish"},
        Mischief{"answers_for_another_scene",
                 R"(echo '{"scene":5,"result":{"status":"solved",)"
                 R"("verified":false},"state":""}'; exec sleep 1000)",
                 "worker_rubbish"},
        Mischief{"answers_without_end",
                 "yes '{\"a\":' | tr -d '\\n' | head -c 100000000; "
                 "exec sleep 1000",
                 "worker_timeout"},
        Mischief{"answers_without_end_in_short_lines", "exec yes",
                 "worker_rubbish"},
        Mischief{"answers_in_too_many_brackets",
                 "printf '{\"scene\":0,\"state\":\"\",\"result\":{"
                 "\"status\":\"x\",\"message\":\"\",\"verified\":false,"
                 "\"a\":'; yes '[' | tr -d '\\n' | head -c 300000; "
                 "yes ']' | tr -d '\\n' | head -c 300000; echo '}}'; "
                 "exec sleep 1000",
                 "worker_rubbish"},
        Mischief{"writes_half_a_line", "printf '{\"scene\":0,'; exit 0",
                 "worker_lost"}),
    [](const auto& one) { return one.param.name; });

TEST_P(BadWorker, OnceCostsNothing) {
  const ScratchDirectory scratch;
  ASSERT_EQ(sweep(scratch, "calm").code, 0);

  const Output output =
      sweep(scratch, "out",
            {"--jobs", "1", "--timeout", timeout(), "--worker",
             bad_worker(scratch, GetParam().script, 1)});

  EXPECT_EQ(output.code, 0) << output.out << output.err;
  EXPECT_EQ(table_of(scratch, "out"), table_of(scratch, "calm"));
}

TEST_P(BadWorker, TwiceCostsOneScene) {
  const ScratchDirectory scratch;

  const Output output =
      sweep(scratch, "out",
            {"--jobs", "1", "--timeout", timeout(), "--json", "--worker",
             bad_worker(scratch, GetParam().script, 2)});

  EXPECT_EQ(output.code, 4) << output.err;
  const json document = json::parse(output.out);
  EXPECT_EQ(document["verified"], kScenes - 1);
  EXPECT_EQ(document["failed"], 1);
  const json rows =
      json::parse(
          run({"export", (scratch.path() / "out").string(), "--json"}).out)
          .at("rows");
  EXPECT_EQ(rows[0]["status"], GetParam().status);
  EXPECT_TRUE(rows[0]["tau"].is_null());
  EXPECT_EQ(rows[1]["status"], "solved");
}

TEST(SweepFaults, TwoManagersDoNotMeet) {
  const ScratchDirectory scratch;
  const std::string out = (scratch.path() / "out").string();
  // A worker that hangs keeps the first manager busy.
  Process first({"sweep", small_sweep(scratch), "--out", out, "--worker",
                 bad_worker(scratch, "exec sleep 1000", 1000)});
  wait_for(scratch.path() / "out" / "sweep.sqlite");

  const Output second = sweep(scratch, "out", {"--resume"});

  EXPECT_EQ(second.code, 6);
  EXPECT_NE(second.err.find("another brachisto"), std::string::npos)
      << second.err;
}

TEST(SweepFaults, ResultsAreNotReplacedUnasked) {
  const ScratchDirectory scratch;
  ASSERT_EQ(sweep(scratch, "out").code, 0);
  const std::string before = table_of(scratch, "out");

  EXPECT_EQ(sweep(scratch, "out").code, 6);
  const Output changed =
      sweep(scratch, "out", {"--resume", "--set", "scene.body.k=0.4"});

  EXPECT_EQ(changed.code, 6);
  EXPECT_NE(changed.err.find("scene.body.k = 0.5"), std::string::npos)
      << changed.err;
  EXPECT_EQ(table_of(scratch, "out"), before);
  EXPECT_EQ(sweep(scratch, "out", {"--force"}).code, 0);
}

TEST(SweepFaults, AnotherShardIsNotGoneOnWith) {
  const ScratchDirectory scratch;
  ASSERT_EQ(sweep(scratch, "out", {"--shard", "1/2"}).code, 0);

  const Output other = sweep(scratch, "out", {"--resume", "--shard", "2/2"});

  EXPECT_EQ(other.code, 6);
  EXPECT_NE(other.err.find("shard 1/2"), std::string::npos) << other.err;
}

TEST(SweepFaults, AForeignOrTruncatedStoreIsLeftAlone) {
  const ScratchDirectory scratch;
  fs::create_directories(scratch.path() / "out");
  const fs::path store = scratch.path() / "out" / "sweep.sqlite";
  std::ofstream(store) << std::string(5000, 'x');

  const Output foreign = sweep(scratch, "out", {"--resume"});

  EXPECT_EQ(foreign.code, 6);
  EXPECT_NE(foreign.err.find(store.string()), std::string::npos) << foreign.err;
  EXPECT_EQ(fs::file_size(store), 5000U);

  fs::remove(store);
  ASSERT_EQ(sweep(scratch, "out").code, 0);
  fs::resize_file(store, fs::file_size(store) / 2);
  EXPECT_EQ(sweep(scratch, "out", {"--resume"}).code, 6);
  EXPECT_EQ(run({"export", (scratch.path() / "out").string(), "--csv"}).code,
            6);
}

/// Changes a digit of the τ of the n-th scene that has one, as a disk might.
void damage(const fs::path& store, int n) {
  std::string bytes = content(store);
  std::size_t place = 0;
  for (int i = 0; i <= n; ++i) place = bytes.find("\"tau\":", place + 1);
  ASSERT_NE(place, std::string::npos);
  char& digit = bytes[place + std::string("\"tau\":5.12").size()];
  digit = digit == '7' ? '8' : '7';
  std::ofstream(store, std::ios::binary) << bytes;
}

TEST(SweepFaults, ADamagedResultIsNamedAndSolvedAgain) {
  // Of a warm chain too, whose scenes begin with the ones before them.
  for (const std::string start : {"false", "true"}) {
    const ScratchDirectory scratch;
    const std::vector<std::string> set{"--set", "sweep.warm_start=" + start};
    ASSERT_EQ(sweep(scratch, "out", set).code, 0);
    const std::string out = (scratch.path() / "out").string();
    const std::string calm = table_of(scratch, "out");
    damage(scratch.path() / "out" / "sweep.sqlite", 7);

    const Output exported = run({"export", out, "--json"});
    const Output drawn = run({"report", out});
    const Output merged = run({"merge", out, "--out", out + "2"});

    const json document = json::parse(exported.out);
    ASSERT_EQ(document["damaged"].size(), 1U);
    const auto scene = document["damaged"][0].get<int>();
    for (const Output& output : {exported, drawn, merged}) {
      EXPECT_EQ(output.code, 6) << output.err;
      EXPECT_NE(output.err.find(out +
                                "/sweep.sqlite: damaged: the results of "
                                "scene " +
                                std::to_string(scene) + " do not match"),
                std::string::npos)
          << output.err;
    }
    EXPECT_EQ(document["rows"].size(), kScenes - 1U);
    EXPECT_NE(calm, table_of(scratch, "out"));

    std::vector<std::string> resume{"--resume", "--json"};
    resume.insert(resume.end(), set.begin(), set.end());
    const Output mended = sweep(scratch, "out", resume);
    EXPECT_EQ(mended.code, 0) << mended.err;
    EXPECT_NE(mended.err.find("scene " + std::to_string(scene)),
              std::string::npos)
        << mended.err;
    EXPECT_EQ(json::parse(mended.out)["new"], 1);
    EXPECT_EQ(table_of(scratch, "out"), calm);
    EXPECT_EQ(run({"export", out, "--csv"}).code, 0);
    // Where another part is sound, merging mends as well.
    EXPECT_EQ(run({"merge", out, "--out", out + "2"}).code, 0);
    EXPECT_EQ(table_of(scratch, "out2"), calm);
  }
}

TEST(SweepFaults, AStoreThatLostItsContentIsNotBegunAnewUnasked) {
  const ScratchDirectory scratch;
  fs::create_directories(scratch.path() / "out");
  const fs::path store = scratch.path() / "out" / "sweep.sqlite";
  std::ofstream{store};
  const std::string out = (scratch.path() / "out").string();

  for (const Output& output :
       {sweep(scratch, "out", {"--resume"}), sweep(scratch, "out"),
        run({"export", out, "--csv"}), run({"report", out}),
        run({"merge", out, "--out", out + "2"})}) {
    EXPECT_EQ(output.code, 6);
    EXPECT_NE(output.err.find(store.string() + ": is empty"), std::string::npos)
        << output.err;
  }
  EXPECT_EQ(fs::file_size(store), 0U);
  EXPECT_EQ(sweep(scratch, "out", {"--force"}).code, 0);
}

TEST(SweepFaults, AJournalThatIsGoneIsTold) {
  const ScratchDirectory scratch;
  ASSERT_EQ(sweep(scratch, "calm").code, 0);
  const fs::path out = scratch.path() / "out";
  {
    Process killed({"sweep", small_sweep(scratch), "--out", out.string(),
                    "--worker", bad_worker(scratch, "exec sleep 1000", 1000)});
    wait_for(scratch.path() / "runs");  // of the worker
    killed.signal(SIGKILL);
    ASSERT_TRUE(killed.wait());
  }
  fs::remove(out / "sweep.sqlite-wal");
  fs::remove(out / "sweep.sqlite-shm");

  for (int i = 0; i < 2; ++i) {
    const Output output = run({"export", out.string(), "--csv"});
    EXPECT_EQ(output.code, 6);
    EXPECT_NE(output.err.find("-wal"), std::string::npos) << output.err;
  }
  const Output resumed = sweep(scratch, "out", {"--resume"});
  EXPECT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_NE(resumed.err.find("-wal"), std::string::npos) << resumed.err;
  EXPECT_EQ(table_of(scratch, "out"), table_of(scratch, "calm"));
  EXPECT_EQ(run({"export", out.string(), "--csv"}).code, 0);
}

TEST(SweepFaults, AFullDiskIsToldAndCostsNothing) {
  const ScratchDirectory scratch;
  const fs::path disk = scratch.path() / "out";
  fs::create_directories(disk);
  const TinyDisk mounted(disk, "96k");
  if (!mounted) GTEST_SKIP() << "no file system can be mounted here";

  const Output output = sweep(scratch, "out");

  EXPECT_EQ(output.code, 6) << output.out << output.err;
  EXPECT_NE(output.err.find("full"), std::string::npos) << output.err;
  EXPECT_EQ(run({"export", disk.string(), "--csv"}).code, 0);
}

TEST(SweepFaults, WorkersThatAlwaysFailAreNotTheScenesFault) {
  const ScratchDirectory scratch;

  const Output output =
      sweep(scratch, "out", {"--worker", bad_worker(scratch, "exit 1", 1000)});

  EXPECT_EQ(output.code, 1);
  EXPECT_NE(output.err.find("in a row"), std::string::npos) << output.err;
  const Output resumed = sweep(scratch, "out", {"--resume", "--json"});
  EXPECT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_EQ(json::parse(resumed.out)["new"], kScenes) << "nothing was recorded";
}

TEST(SweepFaults, WhatNoWorkerAnsweredForIsTriedAgainOnDemand) {
  const ScratchDirectory scratch;
  const std::string worker = bad_worker(scratch, "exit 1", 2);
  ASSERT_EQ(sweep(scratch, "calm").code, 0);
  ASSERT_EQ(sweep(scratch, "out", {"--jobs", "1", "--worker", worker}).code, 4);
  EXPECT_EQ(sweep(scratch, "out", {"--resume"}).code, 4)
      << "a failure is a result";

  const Output again = sweep(scratch, "out", {"--resume", "--retry-failed"});

  EXPECT_EQ(again.code, 0) << again.out << again.err;
  EXPECT_EQ(table_of(scratch, "out"), table_of(scratch, "calm"));
}

TEST(SweepFaults, NobodyHasToListen) {
  const ScratchDirectory scratch;
  const std::string command =
      "'" BRACHISTO_APP "' sweep '" + small_sweep(scratch) + "' --out '" +
      (scratch.path() / "out").string() + "' --json 2>/dev/full";
  EXPECT_EQ(std::system((command + " >/dev/null").c_str()), 0);
}

TEST(SweepFaults, ASceneThatCannotBeSolvedIsOneFailure) {
  const ScratchDirectory scratch;
  const Output output =
      sweep(scratch, "out",
            {"--json", "--set",
             "sweep={scene.finish.L: [3, 0.01], scene.body.eta_m: [0, 1/2]}",
             "--set", "scene.finish.H=0.01"});

  EXPECT_EQ(output.code, 4) << output.err;
  const json document = json::parse(output.out);
  EXPECT_EQ(document["scenes"], 4);
  EXPECT_EQ(document["verified"], 2) << output.out;
  EXPECT_EQ(document["failed"], 2);
}

TEST(SweepFaults, WrongFilesAndFlagsAreRefusedAtOnce) {
  const ScratchDirectory scratch;
  const std::string out = (scratch.path() / "out").string();
  EXPECT_EQ(run({"sweep", testing::paper_problem("fig04_reference_case"),
                 "--out", out})
                .code,
            3);
  EXPECT_EQ(run({"solve", small_sweep(scratch)}).code, 3);
  EXPECT_EQ(sweep(scratch, "out", {"--shard", "3/2"}).code, 2);
  EXPECT_EQ(sweep(scratch, "out", {"--jobs", "0"}).code, 2);
  EXPECT_EQ(run({"export", out, "--csv"}).code, 6);
  EXPECT_EQ(run({"merge", out, "--out", out + "2"}).code, 6);
  EXPECT_EQ(run({"report", out}).code, 6);
  EXPECT_FALSE(fs::exists(out));
}

}  // namespace
}  // namespace brachisto
