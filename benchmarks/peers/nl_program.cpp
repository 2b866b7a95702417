// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "peers/nl_program.hpp"

#include "program_files/asl_program.hpp"

namespace brachisto::benchmarks {

bool reads_nl_files() {
  return true;
}

NlProgram read_nl_file(const std::filesystem::path& nl_file) {
  auto problem = std::make_unique<testing::AslProgram>(nl_file);
  PrimalDual start = problem->start();
  return {std::move(problem), std::move(start)};
}

}  // namespace brachisto::benchmarks
