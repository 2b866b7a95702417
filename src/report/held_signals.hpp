// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// No signal in the middle of what is to be done in full or not at all.

#pragma once

#include <array>
#include <csignal>

namespace brachisto::report {

/// Lets the signals that ask the process to end wait as long as this lives; one
/// that came meanwhile is raised then. One object at a time.
class HeldSignals {
 public:
  HeldSignals();
  ~HeldSignals();
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;

  /// Whether one waits.
  [[nodiscard]] static bool waiting();

 private:
  static constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP, SIGQUIT};
  std::array<struct sigaction, kSignals.size()> before_{};
};

}  // namespace brachisto::report
