// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "support/processes.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <stdexcept>

namespace brachisto::benchmarks {

namespace {

constexpr int kThrew = 3;

/// The other end of a process at work.
struct Running {
  int index = 0;
  int pipe = -1;
};

[[noreturn]] void be_the_child(int index, int pipe, const ProcessLimits& limits,
                               const std::function<std::string(int)>& work) {
  alarm(limits.seconds);  // SIGALRM ends the process
  if (limits.cpu_seconds > 0) {
    const rlimit processor = {limits.cpu_seconds, RLIM_INFINITY};
    setrlimit(RLIMIT_CPU, &processor);  // SIGXCPU does
  }
  int code = EXIT_SUCCESS;
  try {
    const std::string bytes = work(index);
    // Fits into the pipe's buffer, so that nobody has to read meanwhile.
    if (write(pipe, bytes.data(), bytes.size()) !=
        static_cast<ssize_t>(bytes.size())) {
      code = EXIT_FAILURE;
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "case {}: {}\n", index, error.what());
    code = kThrew;
  }
  std::fflush(stderr);
  // Without the destructors and buffers that belong to the parent.
  _exit(code);
}

Running start(int index, const ProcessLimits& limits,
              const std::function<std::string(int)>& work, pid_t& child) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::runtime_error("pipe() failed");
  std::fflush(nullptr);
  child = fork();
  if (child < 0) throw std::runtime_error("fork() failed");
  if (child == 0) {
    close(ends[0]);
    be_the_child(index, ends[1], limits, work);
  }
  close(ends[1]);
  return {index, ends[0]};
}

std::string read_all(int pipe) {
  std::string bytes;
  std::array<char, 4096> buffer{};
  ssize_t n = 0;
  while ((n = read(pipe, buffer.data(), buffer.size())) > 0) {
    bytes.append(buffer.data(), static_cast<std::size_t>(n));
  }
  close(pipe);
  return bytes;
}

std::string fate_of(int status, const ProcessLimits& limits) {
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    if (signal == SIGALRM) {
      return fmt::format("not done after {} s", limits.seconds);
    }
    if (signal == SIGXCPU) {
      return fmt::format("not done after {} s of processor time",
                         limits.cpu_seconds);
    }
    return fmt::format("crashed with signal {}", signal);
  }
  if (WEXITSTATUS(status) == kThrew) return "threw an exception";
  if (WEXITSTATUS(status) != 0) {
    return fmt::format("ended with code {}", WEXITSTATUS(status));
  }
  return {};
}

}  // namespace

void run_in_processes(
    int count, const ProcessLimits& limits,
    const std::function<std::string(int)>& work,
    const std::function<void(int, const std::string& bytes,
                             const std::string& fate)>& done) {
  std::map<pid_t, Running> running;
  int next = 0;
  while (next < count || !running.empty()) {
    while (next < count && static_cast<int>(running.size()) < limits.jobs) {
      pid_t child = 0;
      const Running process = start(next++, limits, work, child);
      running[child] = process;
    }
    int status = 0;
    const auto ended = running.find(wait(&status));
    if (ended == running.end()) continue;
    const Running process = ended->second;
    running.erase(ended);
    const std::string bytes = read_all(process.pipe);
    done(process.index, bytes, fate_of(status, limits));
  }
}

}  // namespace brachisto::benchmarks
