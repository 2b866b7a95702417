// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A program as others read it from its .nl file.

#pragma once

#include <filesystem>
#include <memory>

#include "brachisto/nlp/problem.hpp"

namespace brachisto::benchmarks {

/// Whether the AMPL Solver Library was there when this was built.
[[nodiscard]] bool reads_nl_files();

/// A program and the start that is in its file.
struct NlProgram {
  std::unique_ptr<nlp::Problem> problem;
  PrimalDual start;
};

/// By the AMPL Solver Library, with its automatic derivatives.
/// \pre reads_nl_files()
/// \throws std::runtime_error  if the file is no program to it
[[nodiscard]] NlProgram read_nl_file(const std::filesystem::path& nl_file);

}  // namespace brachisto::benchmarks
