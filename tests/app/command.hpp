// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Runs the command `brachisto` and collects what it writes.

#pragma once

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "math/cpu_clock.hpp"
#include "support/scratch_directory.hpp"

namespace brachisto::testing {

/// A problem file of the paper.
[[nodiscard]] inline std::string paper_problem(const std::string& name) {
  return BRACHISTO_PROBLEMS_DIR "/paper/" + name + ".yaml";
}

/// What a finished process left.
struct Output {
  int code = -1;  ///< exit code, or minus the signal that killed it
  std::string out, err;
  double cpu_seconds = 0.0;  ///< processor time of the process
  double peak_memory = 0.0;  ///< its largest resident set [bytes]
};

/// A process that takes longer hangs, however busy the machine is.
constexpr std::chrono::seconds kPatience{600};

/// A running command.
class Process {
 public:
  explicit Process(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), BRACHISTO_APP);
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    const auto redirect = [&](int descriptor, const fs::path& to) {
      ::posix_spawn_file_actions_addopen(&actions, descriptor, to.c_str(),
                                         O_WRONLY | O_CREAT | O_TRUNC, 0600);
    };
    redirect(STDOUT_FILENO, files_.path() / "out");
    redirect(STDERR_FILENO, files_.path() / "err");
    const int error = ::posix_spawn(&pid_, BRACHISTO_APP, &actions, nullptr,
                                    argv.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    if (error != 0) throw std::runtime_error("cannot run " BRACHISTO_APP);
  }
  ~Process() {
    if (pid_ <= 0) return;
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  void signal(int number) const { ::kill(pid_, number); }

  /// Processor time so far; nothing once it has ended.
  [[nodiscard]] std::optional<double> cpu_seconds() const {
    siginfo_t end = {};
    ::waitid(P_PID, static_cast<id_t>(pid_), &end, WEXITED | WNOHANG | WNOWAIT);
    clockid_t clock = 0;
    if (end.si_pid != 0 || ::clock_getcpuclockid(pid_, &clock) != 0) return {};
    return clock_seconds(clock);
  }

  /// Waits until it has worked so long, or has ended.
  void work(double seconds) const {
    for (auto now = cpu_seconds(); now && *now < seconds; now = cpu_seconds()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }

  /// Waits for the end; nothing if it does not come in time.
  [[nodiscard]] std::optional<Output> wait(
      std::chrono::seconds patience = kPatience) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    int status = 0;
    rusage used = {};
    while (::wait4(pid_, &status, WNOHANG, &used) == 0) {
      if (std::chrono::steady_clock::now() > deadline) return std::nullopt;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    pid_ = -1;
    return Output{WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status),
                  content("out"), content("err"),
                  seconds(used.ru_utime) + seconds(used.ru_stime),
                  1024.0 * static_cast<double>(used.ru_maxrss)};
  }

 private:
  static double seconds(const timeval& time) {
    constexpr double kMicro = 1e-6;
    return static_cast<double>(time.tv_sec) +
           kMicro * static_cast<double>(time.tv_usec);
  }

  [[nodiscard]] std::string content(const char* name) const {
    std::ifstream in(files_.path() / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  ScratchDirectory files_;
  pid_t pid_ = -1;
};

/// Runs to the end.
[[nodiscard]] inline Output run(std::vector<std::string> arguments) {
  auto output = Process(std::move(arguments)).wait();
  if (!output) throw std::runtime_error("the command does not end");
  return *output;
}

[[nodiscard]] inline bool says(const std::string& text,
                               const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Processor time that goes by until the command can answer anything: that of
/// loading its libraries, which is 15 ms on one system and 150 ms on another.
[[nodiscard]] inline double seconds_to_load() {
  static const double seconds =
      std::max({run({"--version"}).cpu_seconds, run({"--version"}).cpu_seconds,
                run({"--version"}).cpu_seconds});
  return seconds;
}

}  // namespace brachisto::testing
