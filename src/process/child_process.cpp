// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "process/child_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

#include "math/wall_clock.hpp"

namespace brachisto {

namespace {

// What a process that could not become what it should ends with.
constexpr int kCannotRun = 127;

void close_both(std::array<int, 2>& pipe) {
  for (int& end : pipe) {
    if (end >= 0) ::close(end);
    end = -1;
  }
}

/// A file in memory with that content, to be read from its start: unlike a
/// pipe it takes all of it at once, whoever reads.
class UnnamedFile {
 public:
  explicit UnnamedFile(std::string_view content)
      : descriptor_(::memfd_create("input", MFD_CLOEXEC)) {
    while (descriptor_ >= 0 && !content.empty()) {
      const ssize_t count =
          ::write(descriptor_, content.data(), content.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) close();
      if (count > 0) content.remove_prefix(static_cast<std::size_t>(count));
    }
    if (descriptor_ < 0 || ::lseek(descriptor_, 0, SEEK_SET) < 0) {
      const int error = errno;
      close();
      throw std::system_error(error, std::generic_category(),
                              "a file in memory");
    }
  }
  ~UnnamedFile() { close(); }
  UnnamedFile(const UnnamedFile&) = delete;
  UnnamedFile& operator=(const UnnamedFile&) = delete;

  [[nodiscard]] int descriptor() const { return descriptor_; }

 private:
  void close() {
    if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
  }

  int descriptor_;
};

/// Runs in the child: only what is safe after a fork.
void set_up(const std::array<int, 3>& theirs, const ChildLimits& limits,
            pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(kCannotRun);  // it is gone already
  // Ctrl-C is for the parent, which then ends its children.
  ::signal(SIGINT, SIG_IGN);
  ::signal(SIGPIPE, SIG_DFL);
  const auto limit = [](auto resource, rlim_t soft, rlim_t hard) {
    const struct rlimit value = {soft, hard};
    ::setrlimit(resource, &value);
  };
  if (limits.memory > 0) limit(RLIMIT_AS, limits.memory, limits.memory);
  if (limits.cpu_seconds > 0) {
    limit(RLIMIT_CPU, limits.cpu_seconds, RLIM_INFINITY);
  }
  limit(RLIMIT_CORE, 0, 0);
  for (int stream = 0; stream < 3; ++stream) {
    const int end = theirs[static_cast<std::size_t>(stream)];
    if (end >= 0) ::dup2(end, stream);
  }
}

/// Reads both streams until they end or it is time to stop.
/// \return Exited if they ended
ChildRun::End collect(ChildRun& run, const ChildProcess& child,
                      WallClock::time_point until,
                      const std::atomic<int>* interrupt) {
  constexpr int kLook = 50;  // for a reason to stop [ms]
  std::array<pollfd, 2> streams{
      {{child.output(), POLLIN, 0}, {child.error(), POLLIN, 0}}};
  std::array<std::string*, 2> texts{&run.out, &run.err};
  while (streams[0].fd >= 0 || streams[1].fd >= 0) {
    if (interrupt != nullptr && interrupt->load() != 0) {
      return ChildRun::End::Interrupted;
    }
    if (WallClock::now() >= until) return ChildRun::End::OutOfTime;
    if (::poll(streams.data(), streams.size(), kLook) <= 0) continue;
    for (std::size_t i = 0; i < streams.size(); ++i) {
      if (streams[i].fd < 0 || streams[i].revents == 0) continue;
      if (read_some(streams[i].fd, *texts[i]) == 0) streams[i].fd = -1;
    }
  }
  return ChildRun::End::Exited;
}

}  // namespace

std::string ChildEnd::in_words() const {
  if (signal != 0) {
    return fmt::format("was ended by signal {} ({})", signal,
                       ::strsignal(signal));
  }
  return code == kCannotRun ? "could not be run"
                            : fmt::format("ended with exit code {}", code);
}

ChildProcess::ChildProcess(const Work& work, const Pipes& pipes,
                           const ChildLimits& limits) {
  const std::array wanted{pipes.input, pipes.output, pipes.error};
  std::array<int, 3> theirs{-1, -1, -1};
  std::array<std::array<int, 2>, 3> ends{{{-1, -1}, {-1, -1}, {-1, -1}}};
  const auto fail = [&](const char* what) {
    const int error = errno;
    for (auto& pipe : ends) close_both(pipe);
    throw std::system_error(error, std::generic_category(), what);
  };
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (!wanted[i]) continue;
    if (::pipe2(ends[i].data(), O_CLOEXEC) != 0) fail("pipe");
    const std::size_t child_reads = i == 0 ? 0 : 1;
    theirs[i] = ends[i][child_reads];
    ours_[i] = ends[i][1 - child_reads];
    ::fcntl(ours_[i], F_SETFL, O_NONBLOCK);
  }
  const pid_t parent = ::getpid();
  pid_ = ::fork();
  if (pid_ < 0) fail("fork");
  if (pid_ == 0) {
    set_up(theirs, limits, parent);
    // Without the destructors and buffers that belong to the parent.
    ::_exit(work());
  }
  for (const int end : theirs) {
    if (end >= 0) ::close(end);
  }
}

ChildProcess::~ChildProcess() {
  kill();
  finish(0.0);
  for (const int end : ours_) {
    if (end >= 0) ::close(end);
  }
}

void ChildProcess::kill() const {
  if (pid_ > 0) ::kill(pid_, SIGKILL);
}

ChildEnd ChildProcess::finish(double seconds) {
  constexpr useconds_t kShortest = 50, kLongest = 1000;  // of a pause [µs]
  ChildEnd end;
  if (pid_ <= 0) return end;
  const WallClock::time_point until = seconds_from_now(seconds);
  bool killed = false;
  int status = 0;
  struct rusage usage = {};
  for (useconds_t pause = kShortest;; pause = std::min(2 * pause, kLongest)) {
    const pid_t ended = ::wait4(pid_, &status, killed ? 0 : WNOHANG, &usage);
    if (ended == pid_ || (ended < 0 && errno != EINTR)) break;
    if (killed) continue;
    killed = WallClock::now() >= until;
    if (killed) {
      kill();
    } else {
      ::usleep(pause);
    }
  }
  pid_ = -1;
  constexpr double kKibibyte = 1024.0;
  end.peak_memory = kKibibyte * static_cast<double>(usage.ru_maxrss);
  if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
  if (WIFEXITED(status)) end.code = WEXITSTATUS(status);
  return end;
}

ChildProcess::Work run_program(const std::filesystem::path& program,
                               const std::vector<std::string>& arguments) {
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  // The pointers are made before the fork, after which nothing is allocated.
  auto kept = std::make_shared<std::vector<std::string>>(std::move(words));
  std::vector<char*> argv;
  for (std::string& word : *kept) argv.push_back(word.data());
  argv.push_back(nullptr);
  return [kept, argv] {
    ::execv(argv.front(), argv.data());
    return kCannotRun;
  };
}

std::vector<std::filesystem::path> programs_on_path(const std::string& name) {
  const char* path = std::getenv("PATH");  // NOLINT: nobody sets it here
  std::istringstream folders(path == nullptr ? "" : path);
  std::vector<std::filesystem::path> found;
  for (std::string folder; std::getline(folders, folder, ':');) {
    std::filesystem::path file = std::filesystem::path(folder) / name;
    if (::access(file.c_str(), X_OK) == 0) found.push_back(std::move(file));
  }
  return found;
}

ssize_t read_some(int file, std::string& text) {
  std::array<char, 1U << 16U> buffer{};
  while (true) {
    const ssize_t count = ::read(file, buffer.data(), buffer.size());
    if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
    if (count >= 0 || errno == EAGAIN) return count;
    if (errno != EINTR) return 0;
  }
}

ChildRun run_child(const std::filesystem::path& program,
                   const std::vector<std::string>& arguments, double seconds,
                   const std::atomic<int>* interrupt,
                   const std::optional<std::string>& input) {
  const WallClock::time_point begin = WallClock::now();
  const WallClock::time_point until = seconds_from_now(seconds);
  ChildProcess::Work work = run_program(program, arguments);
  std::optional<UnnamedFile> file;
  if (input) {
    file.emplace(*input);
    work = [run = std::move(work), descriptor = file->descriptor()] {
      return ::dup2(descriptor, STDIN_FILENO) < 0 ? kCannotRun : run();
    };
  }
  ChildProcess child(work, {.input = false, .output = true, .error = true}, {});
  ChildRun run;
  run.end = collect(run, child, until, interrupt);
  if (run.end != ChildRun::End::Exited) child.kill();
  const ChildEnd end = child.finish(seconds_between(WallClock::now(), until));
  run.seconds = seconds_since(begin);
  run.peak_memory = end.peak_memory;
  run.code = end.code;
  if (run.end == ChildRun::End::Exited && end.signal != 0) {
    run.end = run.seconds >= seconds ? ChildRun::End::OutOfTime
                                     : ChildRun::End::Signalled;
    run.code = end.signal;
  }
  return run;
}

}  // namespace brachisto
