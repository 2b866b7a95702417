// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "comparison/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <system_error>

namespace brachisto::comparison {

namespace {

using Clock = std::chrono::steady_clock;

// What a process that could not become the program ends with.
constexpr int kCannotRun = 127;

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

/// The reading end stays here, the writing end goes to the child.
class Pipe {
 public:
  Pipe() {
    if (::pipe2(ends_.data(), O_CLOEXEC) != 0) fail("pipe");
  }
  ~Pipe() {
    ::close(ends_[0]);
    close_writing_end();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  void close_writing_end() {
    if (ends_[1] >= 0) ::close(ends_[1]);
    ends_[1] = -1;
  }
  [[nodiscard]] int reading_end() const { return ends_[0]; }
  [[nodiscard]] int writing_end() const { return ends_[1]; }

 private:
  std::array<int, 2> ends_{-1, -1};
};

/// Runs in the child: only what is safe after a fork.
[[noreturn]] void become(const char* program, char* const* argv, int out,
                         int err, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(kCannotRun);  // it is gone already
  // Ctrl-C is for the parent, which then ends its child.
  ::signal(SIGINT, SIG_IGN);
  const struct rlimit no_core = {0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(err, STDERR_FILENO);
  ::execv(program, argv);
  ::_exit(kCannotRun);
}

/// Reads both streams until they end or it is time to stop.
/// \return Exited if they ended
ChildRun::End collect(ChildRun& run, int out, int err, Clock::time_point until,
                      const std::atomic<int>* interrupt) {
  constexpr int kLook = 50;  // for a reason to stop [ms]
  std::array<pollfd, 2> streams{{{out, POLLIN, 0}, {err, POLLIN, 0}}};
  std::array<std::string*, 2> texts{&run.out, &run.err};
  while (streams[0].fd >= 0 || streams[1].fd >= 0) {
    if (interrupt != nullptr && interrupt->load() != 0) {
      return ChildRun::End::Interrupted;
    }
    if (Clock::now() >= until) return ChildRun::End::OutOfTime;
    if (::poll(streams.data(), streams.size(), kLook) <= 0) continue;
    for (std::size_t i = 0; i < streams.size(); ++i) {
      if (streams[i].fd < 0 || streams[i].revents == 0) continue;
      std::array<char, 1U << 16U> buffer{};
      const ssize_t count = ::read(streams[i].fd, buffer.data(), buffer.size());
      if (count > 0) {
        texts[i]->append(buffer.data(), static_cast<std::size_t>(count));
      } else if (count == 0 || errno != EINTR) {
        streams[i].fd = -1;
      }
    }
  }
  return ChildRun::End::Exited;
}

}  // namespace

ChildRun run_child(const std::filesystem::path& program,
                   const std::vector<std::string>& arguments, double seconds,
                   const std::atomic<int>* interrupt) {
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  Pipe out, err;
  const Clock::time_point begin = Clock::now();
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child < 0) fail("fork");
  if (child == 0) {
    become(program.c_str(), argv.data(), out.writing_end(), err.writing_end(),
           parent);
  }
  out.close_writing_end();
  err.close_writing_end();

  ChildRun run;
  const auto until = begin + std::chrono::duration_cast<Clock::duration>(
                                 std::chrono::duration<double>(seconds));
  run.end =
      collect(run, out.reading_end(), err.reading_end(), until, interrupt);
  if (run.end != ChildRun::End::Exited) ::kill(child, SIGKILL);
  int status = 0;
  struct rusage usage = {};
  while (::wait4(child, &status, 0, &usage) < 0) {
    if (errno != EINTR) fail("wait4");
  }
  run.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  constexpr double kKibibyte = 1024.0;
  run.peak_memory = kKibibyte * static_cast<double>(usage.ru_maxrss);
  if (run.end == ChildRun::End::Exited && WIFSIGNALED(status)) {
    run.end = ChildRun::End::Signalled;
    run.code = WTERMSIG(status);
  } else if (WIFEXITED(status)) {
    run.code = WEXITSTATUS(status);
  }
  return run;
}

}  // namespace brachisto::comparison
