// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A worker: it solves what it is told to, and nothing else.

#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

#include "process/child_process.hpp"

namespace brachisto::sweep {

/// Reads the job and then requests from `in`, one per line, until it ends;
/// writes one answer per scene to `out`. A solve that throws is an answer too.
void run_worker(std::istream& in, std::ostream& out);

/// A child process that runs `PROGRAM worker`.
class WorkerProcess {
 public:
  /// \param memory  bound on its address space [bytes]; 0: none
  /// \throws std::system_error
  WorkerProcess(const std::string& program, std::size_t memory)
      : child_(run_program(program, {"worker"}),
               {.input = true, .output = true, .error = false},
               {.memory = memory}) {}

  /// Queues text for its standard input; flush() sends what fits.
  void send(const std::string& text) { outbox_ += text; }
  void flush();
  [[nodiscard]] bool has_mail() const { return !outbox_.empty(); }

  [[nodiscard]] int input() const { return child_.input(); }
  [[nodiscard]] int output() const { return child_.output(); }

  /// Reads what is there. \return the complete lines of it, ends cut off
  [[nodiscard]] std::vector<std::string> read_lines();
  /// True once the worker closed its output.
  [[nodiscard]] bool ended() const { return ended_; }

  /// Kills it if it still runs. \return how it ended, in words
  std::string finish();

 private:
  ChildProcess child_;
  std::string outbox_, inbox_;
  bool ended_ = false;
};

}  // namespace brachisto::sweep
