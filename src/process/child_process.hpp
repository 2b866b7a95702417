// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Child processes: the one place that forks.

#pragma once

#include <sys/types.h>

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "brachisto/math/clock.hpp"

namespace brachisto {

/// What a signal leaves work of many solves with.
class Interrupted : public Stopped {
 public:
  [[nodiscard]] const char* what() const noexcept override {
    return "stopped by a signal";
  }
};

/// What a child may use; 0: as much as it wants.
struct ChildLimits {
  std::size_t memory = 0;    ///< address space [bytes]
  unsigned cpu_seconds = 0;  ///< then SIGXCPU ends it
};

/// How a child ended.
struct ChildEnd {
  int signal = 0;            ///< that ended it; 0: it exited
  int code = 0;              ///< with which it exited
  double peak_memory = 0.0;  ///< largest resident set [bytes]

  /// "ended with exit code 3".
  [[nodiscard]] std::string in_words() const;
};

/// A process of our own. It is killed with its owner, even if the owner is
/// killed, is not reached by Ctrl-C, and leaves no core file.
class ChildProcess {
 public:
  /// What the child does, and the code it then exits with.
  using Work = std::function<int()>;
  /// Its standard streams that are pipes to us; the others it shares with us.
  struct Pipes {
    bool input = false, output = false, error = false;
  };

  /// \throws std::system_error
  ChildProcess(const Work& work, const Pipes& pipes, const ChildLimits& limits);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  // Our ends of the pipes, −1 if there is none.
  [[nodiscard]] int input() const { return ours_[0]; }
  [[nodiscard]] int output() const { return ours_[1]; }
  [[nodiscard]] int error() const { return ours_[2]; }

  void kill() const;
  /// Waits for its end, and kills it if that takes longer than `seconds`.
  ChildEnd finish(double seconds);

 private:
  pid_t pid_ = -1;
  int ours_[3] = {-1, -1, -1};
};

/// Work that becomes another program, or exits as one that cannot be run.
[[nodiscard]] ChildProcess::Work run_program(
    const std::filesystem::path& program,
    const std::vector<std::string>& arguments);

/// All files of that name on the PATH that can be run, in its order.
[[nodiscard]] std::vector<std::filesystem::path> programs_on_path(
    const std::string& name);

/// Appends what can be read at once. \return as read() of the system does: the
/// number of bytes, 0 at the end of the stream, −1 if there is nothing yet
ssize_t read_some(int file, std::string& text);

/// A run of a program that has ended, and how.
struct ChildRun {
  enum class End {
    Exited,       ///< by itself, with `code`
    Signalled,    ///< by a signal, `code`, that we did not send
    OutOfTime,    ///< killed at the limit
    Interrupted,  ///< killed because the caller is to stop
  };

  End end = End::Exited;
  int code = 0;
  std::string out, err;
  double seconds = 0.0;      ///< wall clock, from start to end
  double peak_memory = 0.0;  ///< largest resident set [bytes]
};

/// Runs a program with its output in pipes, and kills it at the limit.
///
/// The kernel counts as peak memory at least what the caller had resident when
/// it started the program. A caller that is the same program and has solved
/// nothing has less than any run of it.
///
/// \param seconds    wall-clock limit
/// \param interrupt  nonzero: stop; may be null
/// \param input      what it reads; none: it shares our standard input
/// \throws std::system_error if it cannot be started
[[nodiscard]] ChildRun run_child(const std::filesystem::path& program,
                                 const std::vector<std::string>& arguments,
                                 double seconds,
                                 const std::atomic<int>* interrupt,
                                 const std::optional<std::string>& input = {});

}  // namespace brachisto
