// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "app/solve_progress.hpp"

#include <fmt/format.h>

#include "math/wall_clock.hpp"

namespace brachisto::app {

namespace {

constexpr std::chrono::seconds kShort{2};
constexpr std::chrono::seconds kPause{5};

}  // namespace

void SolveProgress::note(Clock::time_point now, std::string_view phase,
                         const std::string& text) {
  const bool begins = phase != phase_;
  if (begins && !pending_.empty()) held_back_.push_back(std::move(pending_));
  phase_ = phase;
  pending_ = fmt::format("[{:4.0f} s] {}: {}", seconds_between(start_, now),
                         phase, text);
  if (now - start_ >= kShort && (begins || now - last_ >= kPause)) flush(now);
}

void SolveProgress::flush(Clock::time_point now) {
  for (const std::string& line : held_back_) write_(line);
  held_back_.clear();
  write_(pending_);
  pending_.clear();
  last_ = now;
}

}  // namespace brachisto::app
