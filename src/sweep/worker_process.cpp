// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/worker_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string_view>
#include <system_error>
#include <utility>

namespace brachisto::sweep {

namespace {

// What a process that could not become a worker ends with.
constexpr int kCannotRun = 127;

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

/// Runs in the child: only what is safe after a fork.
[[noreturn]] void become_worker(const char* program, int input, int output,
                                std::size_t memory, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(kCannotRun);  // it is gone already
  // Ctrl-C is for the manager, which then ends its workers.
  ::signal(SIGINT, SIG_IGN);
  ::signal(SIGPIPE, SIG_DFL);
  if (memory > 0) {
    const struct rlimit limit = {memory, memory};
    ::setrlimit(RLIMIT_AS, &limit);
  }
  const struct rlimit no_core = {0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  ::dup2(input, STDIN_FILENO);
  ::dup2(output, STDOUT_FILENO);
  ::execl(program, program, "worker", static_cast<char*>(nullptr));
  ::_exit(kCannotRun);
}

std::string how_it_ended(int status) {
  if (WIFSIGNALED(status)) {
    return fmt::format("was ended by signal {} ({})", WTERMSIG(status),
                       ::strsignal(WTERMSIG(status)));
  }
  const int code = WEXITSTATUS(status);
  return code == kCannotRun ? "could not be run"
                            : fmt::format("ended with exit code {}", code);
}

}  // namespace

WorkerProcess::WorkerProcess(const std::string& program, std::size_t memory) {
  std::array<int, 2> to_child{}, from_child{};
  if (::pipe2(to_child.data(), O_CLOEXEC) != 0) fail("pipe");
  if (::pipe2(from_child.data(), O_CLOEXEC) != 0) {
    ::close(to_child[0]);
    ::close(to_child[1]);
    fail("pipe");
  }
  const pid_t parent = ::getpid();
  pid_ = ::fork();
  if (pid_ == 0) {
    become_worker(program.c_str(), to_child[0], from_child[1], memory, parent);
  }
  ::close(to_child[0]);
  ::close(from_child[1]);
  input_ = to_child[1];
  output_ = from_child[0];
  if (pid_ < 0) {
    ::close(input_);
    ::close(output_);
    fail("fork");
  }
  ::fcntl(input_, F_SETFL, O_NONBLOCK);
  ::fcntl(output_, F_SETFL, O_NONBLOCK);
}

WorkerProcess::~WorkerProcess() {
  finish();
  ::close(input_);
  ::close(output_);
}

void WorkerProcess::flush() {
  while (!outbox_.empty()) {
    const ssize_t count = ::write(input_, outbox_.data(), outbox_.size());
    if (count < 0 && errno == EINTR) continue;
    // A full pipe is tried again; a broken one shows at the other end.
    if (count < 0) {
      if (errno != EAGAIN) outbox_.clear();
      return;
    }
    outbox_.erase(0, static_cast<std::size_t>(count));
  }
}

std::vector<std::string> WorkerProcess::read_lines() {
  // More than any answer: whoever writes that much without an end of line
  // writes rubbish, and the manager is to see it as such.
  constexpr std::size_t kLongestLine = std::size_t{1} << 28U;
  std::array<char, 1U << 16U> buffer{};
  std::vector<std::string> lines;
  // What comes after a line waits: there may be no end of it.
  while (lines.empty()) {
    const ssize_t count = ::read(output_, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    ended_ = count == 0;
    if (count <= 0) break;
    std::string_view text(buffer.data(), static_cast<std::size_t>(count));
    for (std::size_t end = text.find('\n'); end != std::string_view::npos;
         end = text.find('\n')) {
      inbox_ += text.substr(0, end);
      lines.push_back(std::exchange(inbox_, {}));
      text.remove_prefix(end + 1);
    }
    inbox_ += text;
    if (inbox_.size() >= kLongestLine) {
      lines.push_back(std::exchange(inbox_, {}));
    }
  }
  return lines;
}

std::string WorkerProcess::finish() {
  if (pid_ <= 0) return "";
  if (!ended_) ::kill(pid_, SIGKILL);
  int status = 0;
  // One that closed its output and stays is not waited for.
  for (int attempt = 0; ::waitpid(pid_, &status, WNOHANG) == 0; ++attempt) {
    if (attempt == 100) ::kill(pid_, SIGKILL);
    ::usleep(1000);
  }
  pid_ = -1;
  return how_it_ended(status);
}

}  // namespace brachisto::sweep
