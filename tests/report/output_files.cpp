// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/report/result.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "brachisto/math/clock.hpp"
#include "support/scratch_directory.hpp"

namespace brachisto::report {
namespace {

namespace fs = std::filesystem;
using brachisto::testing::content;
using brachisto::testing::names;

class OutputFiles : public ::testing::Test {
 protected:
  /// What a failing call says; "" if it does not fail.
  [[nodiscard]] std::string failure(const fs::path& where, bool force,
                                    const std::vector<OutputFile>& files) {
    try {
      write_files(where, files, force);
    } catch (const OutputError& error) {
      return error.what();
    }
    return "";
  }

  const brachisto::testing::ScratchDirectory scratch;
  const fs::path directory = scratch.path();
};

using Names = std::set<std::string>;

/// Sends the process a signal every millisecond as long as this lives, of which
/// it takes no notice.
class SteadySignals {
 public:
  explicit SteadySignals(int signal)
      : signal_(signal), handler_(std::signal(signal, [](int) {})) {
    sigevent event = {};
    event.sigev_notify = SIGEV_SIGNAL;
    event.sigev_signo = signal;
    ::timer_create(CLOCK_MONOTONIC, &event, &timer_);
    const itimerspec every = {{0, 1'000'000}, {0, 1'000'000}};
    ::timer_settime(timer_, 0, &every, nullptr);
  }
  ~SteadySignals() {
    ::timer_delete(timer_);
    std::signal(signal_, handler_);
  }
  SteadySignals(const SteadySignals&) = delete;
  SteadySignals& operator=(const SteadySignals&) = delete;

 private:
  int signal_;
  void (*handler_)(int);
  timer_t timer_ = {};
};

/// No file may become larger as long as this lives.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes)
      : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const struct rlimit limit = {bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  void (*handler_)(int);
  struct rlimit before_ {};
};

TEST_F(OutputFiles, AreThereInFull) {
  // Larger than any buffer, with bytes that a text mode would change.
  const std::string large(3'000'000, 'x');
  const std::string odd("a\r\nb\0c\n", 7);

  write_files(directory, {{"large", large}, {"odd", odd}, {"empty", ""}},
              false);

  EXPECT_EQ(content(directory / "large"), large);
  EXPECT_EQ(content(directory / "odd"), odd);
  EXPECT_EQ(content(directory / "empty"), "");
  EXPECT_EQ(names(directory), (Names{"large", "odd", "empty"}));
}

TEST_F(OutputFiles, AreGivenUpWhenASignalComes) {
  // Sixteen pieces, of which no disk takes the first in less than the
  // millisecond that the signal lets it wait for.
  const std::string large(std::size_t{128} << 20U, 'x');
  {
    const SteadySignals signals(SIGTERM);
    EXPECT_THROW(write_files(directory / "new",
                             {{"large", large}, {"small", "text"}}, false),
                 Stopped);
  }
  EXPECT_EQ(names(directory), Names{});
}

TEST_F(OutputFiles, MakeTheirDirectory) {
  const fs::path deep = directory / "a" / "b" / "c";

  write_files(deep, {{"file", "text"}}, false);

  EXPECT_EQ(content(deep / "file"), "text");
}

TEST_F(OutputFiles, AreNotReplacedWithoutForce) {
  write_files(directory, {{"second", "old"}}, false);

  const std::string what =
      failure(directory, false, {{"first", "new"}, {"second", "new"}});

  EXPECT_NE(what.find("second"), std::string::npos) << what;
  EXPECT_NE(what.find("--force"), std::string::npos) << what;
  // Nothing is written, not even the file that was not there.
  EXPECT_EQ(names(directory), Names{"second"});
  EXPECT_EQ(content(directory / "second"), "old");
}

TEST_F(OutputFiles, AreReplacedWithForce) {
  write_files(directory, {{"file", "a long old text"}}, false);

  write_files(directory, {{"file", "new"}}, true);

  EXPECT_EQ(content(directory / "file"), "new");
  EXPECT_EQ(names(directory), Names{"file"});
}

TEST_F(OutputFiles, ReplaceTheNameAndNotTheFileBehindIt) {
  // Whoever has the old file open, or linked, keeps it whole.
  write_files(directory, {{"file", "old"}}, false);
  fs::create_hard_link(directory / "file", directory / "kept");

  write_files(directory, {{"file", "new"}}, true);

  EXPECT_EQ(content(directory / "file"), "new");
  EXPECT_EQ(content(directory / "kept"), "old");
}

TEST_F(OutputFiles, FailUnderAParentThatIsAFile) {
  write_files(directory, {{"file", "text"}}, false);

  for (const bool force : {false, true}) {
    const std::string what =
        failure(directory / "file" / "below", force, {{"x", "y"}});

    // It names what is in the way.
    const std::string file = (directory / "file").string();
    EXPECT_NE(what.find(file + ": "), std::string::npos) << what;
    EXPECT_NE(what.find("not a directory"), std::string::npos) << what;
  }
  EXPECT_EQ(names(directory), Names{"file"});
}

TEST_F(OutputFiles, FailInADirectoryThatIsAFile) {
  write_files(directory, {{"file", "text"}}, false);

  const std::string what = failure(directory / "file", true, {{"x", "y"}});

  EXPECT_NE(what.find("not a directory"), std::string::npos) << what;
  EXPECT_EQ(content(directory / "file"), "text");
}

TEST_F(OutputFiles, FailUnderANameThatIsADirectoryAndLeaveNothingBehind) {
  fs::create_directory(directory / "taken");

  for (const bool force : {false, true}) {
    const std::string what = failure(directory, force, {{"taken", "text"}});

    EXPECT_NE(what.find("taken"), std::string::npos) << what;
    EXPECT_EQ(names(directory), Names{"taken"});
  }
}

TEST_F(OutputFiles, FailInADirectoryThatDoesNotExistUnderProc) {
  // A file system that nobody may write to, not even root.
  const std::string what = failure("/proc/brachisto", false, {{"x", "y"}});

  EXPECT_NE(what.find("/proc/brachisto"), std::string::npos) << what;
}

TEST_F(OutputFiles, AreNotWrittenIfOneOfThemCannotBe) {
  write_files(directory, {{"first", "old"}, {"stale", "old"}}, false);
  const std::vector<OutputFile> files{{"first", "new"},
                                      {"large", std::string(100'000, 'x')}};
  std::string what, what_of_new;
  {
    const FileSizeLimit limit(50'000);
    try {
      write_files(directory, files, true, {"stale"});
    } catch (const OutputError& error) {
      what = error.what();
    }
    what_of_new = failure(directory / "a" / "b", false, files);
  }

  EXPECT_NE(what.find("large"), std::string::npos) << what;
  EXPECT_NE(what.find(std::strerror(EFBIG)), std::string::npos) << what;
  EXPECT_EQ(names(directory), (Names{"first", "stale"}));
  EXPECT_EQ(content(directory / "first"), "old");
  EXPECT_NE(what_of_new, "");
  EXPECT_FALSE(fs::exists(directory / "a"));
}

TEST_F(OutputFiles, TakeThePlaceOfWhatIsObsolete) {
  write_files(directory, {{"kept", "old"}, {"stale", "old"}}, false);

  write_files(directory, {{"new", "text"}}, false, {"stale", "never there"});

  EXPECT_EQ(names(directory), (Names{"kept", "new"}));
}

TEST_F(OutputFiles, CheckedBeforehandRefuseTheSame) {
  write_files(directory, {{"file", "text"}}, false);

  EXPECT_THROW(check_writable(directory, {"other", "file"}, false),
               OutputError);
  EXPECT_THROW(check_writable(directory / "file", {"x"}, true), OutputError);
  EXPECT_NO_THROW(check_writable(directory, {"other"}, false));
  EXPECT_NO_THROW(check_writable(directory, {"file"}, true));
  EXPECT_NO_THROW(check_writable(directory / "new", {"file"}, false));
}

TEST_F(OutputFiles, CheckedBeforehandRefuseWhatCannotBeWritten) {
  // Nobody should solve for an hour to be told afterwards.
  write_files(directory, {{"file", "text"}}, false);
  fs::create_directory(directory / "taken");

  EXPECT_THROW(check_writable(directory / "file" / "below", {"x"}, true),
               OutputError);
  EXPECT_THROW(check_writable(directory, {"taken"}, true), OutputError);
}

}  // namespace
}  // namespace brachisto::report
