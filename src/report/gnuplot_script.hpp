// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Commands for gnuplot while they are written.

#pragma once

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <utility>

namespace brachisto::report {

struct GnuplotScript {
  std::string text;

  template <class... Args>
  void put(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text), format,
                   std::forward<Args>(args)...);
  }
  /// The frame of the plot, as shares of the picture from its lower left.
  void frame(double left, double right, double top, double bottom) {
    put("set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n"
        "set tmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n",
        left, right, top, bottom);
  }
};

}  // namespace brachisto::report
