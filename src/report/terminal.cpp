// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

namespace brachisto::report {

std::size_t columns_for_a_line() {
  constexpr std::size_t kUsual = 80;
  if (::isatty(STDERR_FILENO) == 0) return kNoTerminal;
  struct winsize window {};
  const bool known =
      ::ioctl(STDERR_FILENO, TIOCGWINSZ, &window) == 0 && window.ws_col > 1;
  return (known ? window.ws_col : kUsual) - 1;
}

}  // namespace brachisto::report
