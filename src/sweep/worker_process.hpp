// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A worker as its manager sees it: a process behind two pipes.

#pragma once

#include <sys/types.h>

#include <cstddef>
#include <string>
#include <vector>

namespace brachisto::sweep {

/// A child process that runs `PROGRAM worker`. It is killed with its owner,
/// even if the owner is killed.
class WorkerProcess {
 public:
  /// \param memory  bound on its address space [bytes]; 0: none
  /// \throws std::system_error
  WorkerProcess(const std::string& program, std::size_t memory);
  ~WorkerProcess();
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  /// Queues text for its standard input; flush() sends what fits.
  void send(const std::string& text) { outbox_ += text; }
  void flush();
  [[nodiscard]] bool has_mail() const { return !outbox_.empty(); }

  [[nodiscard]] int input() const { return input_; }    ///< to poll for room
  [[nodiscard]] int output() const { return output_; }  ///< to poll for data

  /// Reads what is there. \return the complete lines of it, ends cut off
  [[nodiscard]] std::vector<std::string> read_lines();
  /// True once the worker closed its output.
  [[nodiscard]] bool ended() const { return ended_; }

  /// Kills it if it still runs. \return how it ended, in words
  std::string finish();

 private:
  pid_t pid_ = -1;
  int input_ = -1, output_ = -1;
  std::string outbox_, inbox_;
  bool ended_ = false;
};

}  // namespace brachisto::sweep
