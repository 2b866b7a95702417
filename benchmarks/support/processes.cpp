// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "support/processes.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <list>
#include <vector>

#include "process/child_process.hpp"

namespace brachisto::benchmarks {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kThrew = 3;

/// Runs in the child: writes what the work returns.
int answer(int index, const std::function<std::string(int)>& work) {
  int code = EXIT_SUCCESS;
  try {
    const std::string bytes = work(index);
    for (std::size_t sent = 0; sent < bytes.size();) {
      const ssize_t count =
          ::write(STDOUT_FILENO, bytes.data() + sent, bytes.size() - sent);
      if (count <= 0) return EXIT_FAILURE;
      sent += static_cast<std::size_t>(count);
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "case {}: {}\n", index, error.what());
    code = kThrew;
  }
  std::fflush(stderr);
  return code;
}

/// A child at work.
struct Running {
  int index;
  Clock::time_point until;
  ChildProcess child;
  std::string bytes{};

  Running(int i, const ProcessLimits& limits,
          const std::function<std::string(int)>& work)
      : index(i),
        until(Clock::now() + std::chrono::seconds(limits.seconds)),
        child([&] { return answer(i, work); },
              {.input = false, .output = true, .error = false},
              {.memory = 0, .cpu_seconds = limits.cpu_seconds}) {}
};

std::string fate_of(const ChildEnd& end, const ProcessLimits& limits) {
  if (end.signal == SIGXCPU) {
    return fmt::format("not done after {} s of processor time",
                       limits.cpu_seconds);
  }
  if (end.signal != 0) return fmt::format("crashed with signal {}", end.signal);
  if (end.code == kThrew) return "threw an exception";
  return end.code == EXIT_SUCCESS ? "" : end.in_words();
}

}  // namespace

void run_in_processes(
    int count, const ProcessLimits& limits,
    const std::function<std::string(int)>& work,
    const std::function<void(int, const std::string& bytes,
                             const std::string& fate)>& done) {
  constexpr int kLook = 50;         // for one that takes too long [ms]
  constexpr double kPatience = 10;  // for one that has said all [s]
  std::list<Running> running;
  int next = 0;
  while (next < count || !running.empty()) {
    while (next < count && static_cast<int>(running.size()) < limits.jobs) {
      std::fflush(nullptr);
      running.emplace_back(next++, limits, work);
    }
    std::vector<pollfd> files;
    for (const Running& one : running) {
      files.push_back({one.child.output(), POLLIN, 0});
    }
    (void)::poll(files.data(), files.size(), kLook);
    for (auto one = running.begin(); one != running.end();) {
      const bool ended = read_some(one->child.output(), one->bytes) == 0;
      if (!ended && Clock::now() < one->until) {
        ++one;
        continue;
      }
      const ChildEnd end = one->child.finish(ended ? kPatience : 0.0);
      done(one->index, one->bytes,
           ended ? fate_of(end, limits)
                 : fmt::format("not done after {} s", limits.seconds));
      one = running.erase(one);
    }
  }
}

}  // namespace brachisto::benchmarks
