// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How a sweep gets on, for those who wait.

#pragma once

#include <chrono>
#include <string>

#include "sweep/manager.hpp"

namespace brachisto::sweep {

/// Writes to stderr: on a terminal a bar that is redrawn, elsewhere a line now
/// and then.
class Progress {
 public:
  enum class Form { None, Lines, Bar };

  explicit Progress(Form form)
      : form_(form), start_(Clock::now()), last_(start_) {}
  /// The form that suits stderr.
  [[nodiscard]] static Form form_of_stderr();

  void show(const Counts& counts);
  /// Shows the counts once more and leaves the line.
  void finish(const Counts& counts);

 private:
  using Clock = std::chrono::steady_clock;
  void write(const Counts& counts);

  Form form_;
  Clock::time_point start_, last_;
};

/// "1250/2501 scenes · 122/s · 10 s left · 0 failed".
[[nodiscard]] std::string progress_text(const Counts& counts, double seconds);

/// The same behind a bar, "[#####     ] 1250/2501 …", of at most `columns`
/// letters: the bar gives way first, then the end of the text.
[[nodiscard]] std::string progress_bar(const Counts& counts, double seconds,
                                       std::size_t columns);

}  // namespace brachisto::sweep
