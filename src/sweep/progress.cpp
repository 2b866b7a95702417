// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "math/wall_clock.hpp"
#include "report/letters.hpp"

namespace brachisto::sweep {

namespace {

std::string duration_text(double seconds) {
  if (seconds < 120.0) return fmt::format("{:.0f} s", seconds);
  if (seconds < 7200.0) return fmt::format("{:.0f} min", seconds / 60.0);
  return fmt::format("{:.1f} h", seconds / 3600.0);
}

}  // namespace

std::string progress_text(const Counts& counts, double seconds) {
  std::string text =
      fmt::format("{}/{} scenes", counts.finished(), counts.scenes);
  const std::size_t done = counts.finished() - counts.before;
  if (done > 0 && seconds > 0.0) {
    const double rate = static_cast<double>(done) / seconds;
    text += fmt::format(" · {:.3g}/s", rate);
    const std::size_t left = counts.scenes - counts.finished();
    if (left > 0) {
      text += fmt::format(" · {} left",
                          duration_text(static_cast<double>(left) / rate));
    }
  }
  return text + fmt::format(" · {} failed", counts.failed);
}

std::string progress_bar(const Counts& counts, double seconds,
                         std::size_t columns) {
  constexpr std::size_t kLongest = 24;
  constexpr std::size_t kShortest = 4;
  constexpr std::size_t kAround = 3;  // "[" and "] "
  const std::string text = progress_text(counts, seconds);
  const std::size_t taken = report::letters(text) + kAround;
  if (columns < taken + kShortest) return report::shortened(text, columns);
  const std::size_t length = std::min(kLongest, columns - taken);
  const std::size_t full =
      length * counts.finished() / std::max<std::size_t>(counts.scenes, 1);
  return fmt::format("[{:<{}}] {}", std::string(full, '#'), length, text);
}

Progress::Form Progress::form_of_stderr() {
  return ::isatty(STDERR_FILENO) == 1 ? Form::Bar : Form::Lines;
}

void Progress::show(const Counts& counts) {
  using std::chrono::milliseconds;
  const auto pause =
      form_ == Form::Bar ? milliseconds(100) : milliseconds(10'000);
  const auto now = Clock::now();
  if (form_ == Form::None || now - last_ < pause) return;
  last_ = now;
  write(counts);
}

void Progress::finish(const Counts& counts) {
  if (form_ != Form::Bar) return;
  write(counts);
  std::fputs("\n", stderr);
}

void Progress::write(const Counts& counts) {
  const double seconds = seconds_since(start_);
  // A sweep does not end because nobody listens: errors are ignored.
  if (form_ == Form::Bar) {
    // Back to the start of the line, and away with what was longer.
    const std::string bar =
        progress_bar(counts, seconds, report::columns_for_a_line());
    std::fputs(fmt::format("\r{}\033[K", bar).c_str(), stderr);
    std::fflush(stderr);
  } else {
    std::fputs((progress_text(counts, seconds) + "\n").c_str(), stderr);
  }
}

}  // namespace brachisto::sweep
