// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Micro-benchmarks of what a solve consists of. Options of Google Benchmark:
// --benchmark_filter=REGEX, --benchmark_out=FILE, ….

#include <benchmark/benchmark.h>

#include "support/table.hpp"

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::AddCustomContext("machine", brachisto::benchmarks::machine());
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
