// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// In place of nl_program.cpp where the AMPL Solver Library is missing.

#include <stdexcept>

#include "peers/nl_program.hpp"

namespace brachisto::benchmarks {

bool reads_nl_files() {
  return false;
}

NlProgram read_nl_file(const std::filesystem::path& nl_file) {
  throw std::runtime_error("nothing reads " + nl_file.string());
}

}  // namespace brachisto::benchmarks
