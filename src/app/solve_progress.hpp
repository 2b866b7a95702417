// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Lines about a solve that takes long.

#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace brachisto::app {

/// Nothing as long as the solve is short; then a line when a phase begins, its
/// last one when it ends, and in between one now and then.
class SolveProgress {
 public:
  using Clock = std::chrono::steady_clock;
  using Write = std::function<void(const std::string& line)>;

  SolveProgress(Write write, Clock::time_point start)
      : write_(std::move(write)), start_(start), last_(start) {}

  void note(Clock::time_point now, std::string_view phase,
            const std::string& text);

 private:
  void flush(Clock::time_point now);

  Write write_;
  Clock::time_point start_, last_;
  std::string phase_;
  std::string pending_;  ///< the last line of the phase, if not written
  std::vector<std::string> held_back_;  ///< of earlier phases
};

}  // namespace brachisto::app
