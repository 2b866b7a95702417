// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// How a process ended is told apart, and what it wrote is kept.

#include "process/child_process.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <string>

namespace brachisto {
namespace {

using End = ChildRun::End;

constexpr double kPatience = 60.0;  // [s], which nothing here needs

ChildRun shell(const std::string& script, double seconds = kPatience,
               const std::atomic<int>* interrupt = nullptr) {
  return run_child("/bin/sh", {"-c", script}, seconds, interrupt);
}

TEST(ChildProcess, KeepsBothStreamsAndTheExitCode) {
  const ChildRun run = shell("echo out; echo err >&2; exit 3");

  EXPECT_EQ(run.end, End::Exited);
  EXPECT_EQ(run.code, 3);
  EXPECT_EQ(run.out, "out\n");
  EXPECT_EQ(run.err, "err\n");
  EXPECT_GT(run.peak_memory, 0.0);
}

TEST(ChildProcess, IsGivenMoreThanAPipeHolds) {
  const std::string input(300000, 'x');

  const ChildRun run =
      run_child("/bin/sh", {"-c", "cat"}, kPatience, nullptr, input);

  EXPECT_EQ(run.end, End::Exited);
  EXPECT_TRUE(run.out == input) << run.out.size() << " bytes came back";
}

TEST(ChildProcess, NeedNotReadWhatItIsGiven) {
  const ChildRun run = run_child("/bin/sh", {"-c", "exit 4"}, kPatience,
                                 nullptr, std::string(300000, 'x'));

  EXPECT_EQ(run.end, End::Exited);
  EXPECT_EQ(run.code, 4);
}

TEST(ChildProcess, ReadsMoreThanAPipeHolds) {
  const ChildRun run = shell(
      "head -c 300000 /dev/zero; head -c 200000 "
      "/dev/zero >&2");

  EXPECT_EQ(run.out.size(), 300000U);
  EXPECT_EQ(run.err.size(), 200000U);
}

TEST(ChildProcess, TellsASignal) {
  const ChildRun run = shell("kill -SEGV $$");

  EXPECT_EQ(run.end, End::Signalled);
  EXPECT_EQ(run.code, SIGSEGV);
}

TEST(ChildProcess, IsKilledAtTheLimit) {
  EXPECT_EQ(shell("echo begun; exec sleep 600", 0.2).end, End::OutOfTime);
}

TEST(ChildProcess, IsKilledWhenItsCallerIsToStop) {
  const std::atomic<int> signal{SIGINT};

  EXPECT_EQ(shell("exec sleep 600", kPatience, &signal).end, End::Interrupted);
}

TEST(ChildProcess, AProgramThatIsNotThereExits) {
  const ChildRun run = run_child("/no/such/program", {}, kPatience, nullptr);

  EXPECT_EQ(run.end, End::Exited);
  EXPECT_NE(run.code, 0);
}

TEST(ChildProcess, DoesWorkOfThisProgramInAForkOfIt) {
  const std::string word = "done";
  ChildProcess child(
      [&] {
        return ::write(STDOUT_FILENO, word.data(), word.size()) == 4 ? 5 : 1;
      },
      {.input = false, .output = true, .error = false}, {});

  const ChildEnd end = child.finish(kPatience);
  std::string text;

  EXPECT_EQ(end.code, 5);
  EXPECT_EQ(end.in_words(), "ended with exit code 5");
  EXPECT_EQ(read_some(child.output(), text), 4);
  EXPECT_EQ(read_some(child.output(), text), 0);
  EXPECT_EQ(text, word);
}

TEST(ChildProcess, IsKilledIfItDoesNotEnd) {
  ChildProcess child(run_program("/bin/sh", {"-c", "exec sleep 600"}), {}, {});

  EXPECT_EQ(child.finish(0.1).signal, SIGKILL);
}

TEST(ChildProcess, HasALimitOfProcessorTime) {
  ChildProcess child(run_program("/bin/sh", {"-c", "while :; do :; done"}), {},
                     {.memory = 0, .cpu_seconds = 1});

  EXPECT_EQ(child.finish(kPatience).signal, SIGXCPU);
}

}  // namespace
}  // namespace brachisto
