// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// A problem file from its text to a validated scene with options.

#include <benchmark/benchmark.h>

#include <fstream>
#include <iterator>
#include <string>

#include "brachisto/io/problem_file.hpp"

namespace brachisto::benchmarks {

namespace {

void problem_file(benchmark::State& state, const std::string& name) {
  std::ifstream file(BRACHISTO_SOURCE_DIR "/problems/" + name);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  for (auto _ : state) {
    benchmark::DoNotOptimize(io::read_problem_text(text, name));
  }
  state.SetBytesProcessed(state.iterations() *
                          static_cast<std::int64_t>(text.size()));
}
BENCHMARK_CAPTURE(problem_file, reference_case,
                  "paper/fig04_reference_case.yaml")
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(problem_file, work_precision, "work_precision/base.yaml")
    ->Unit(benchmark::kMicrosecond);

}  // namespace

}  // namespace brachisto::benchmarks
