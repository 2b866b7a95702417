// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What `brachisto prove` and `brachisto check-proof` do, which stands in a
// program of its own: to load Arb and what it stands on takes longer than most
// of the other verbs do.

#pragma once

#include <string>

#include "app/verbs.hpp"

namespace brachisto::app {

struct ProveFlags : CommonFlags {
  int bits = 160;
  std::string out;
  bool force = false;
};

struct CheckFlags {
  std::string file;
  std::string problem;
  bool json = false;
  bool quiet = false;
};

/// \return exit code
[[nodiscard]] int prove(const ProveFlags& flags);
[[nodiscard]] int check_proof(const CheckFlags& flags);

}  // namespace brachisto::app
