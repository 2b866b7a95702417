// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What is told on stderr, if somebody listens. That nobody does, or that a log
// is full, ends no work.

#pragma once

#include <cstdio>
#include <string>

namespace brachisto::app {

inline void tell(const std::string& text) {
  std::fputs(text.c_str(), stderr);
}

}  // namespace brachisto::app
