// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Random scenes whose feasibility is told twice: by the program, and by a dense
// evaluation that shares neither forces nor samples with it.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "brachisto/study/solve.hpp"
#include "campaign/random_scene.hpp"
#include "feasibility/dense_motion.hpp"
#include "study/answer_kinds.hpp"
#include "support/drawn_scenes.hpp"
#include "support/table.hpp"

using namespace brachisto;
using namespace brachisto::benchmarks;

namespace {

struct Record {
  bool verified = false;
  bool lifts_off = false;  ///< according to the program
  bool folds = false;
  double least_force = 0.0;
  double force_rate = 0.0;
  double least_margin = 0.0;
  DenseMotion dense;
};

Record examine(const Scene& scene) {
  Record out;
  const Solution solution = solve(scene);
  out.verified = solution.verified();
  if (!out.verified) return out;
  const PathDiagnostics& found = *solution.diagnostics;
  for (const std::string& reason : solution.infeasible_because()) {
    out.lifts_off = out.lifts_off || reason.find("lift off") != reason.npos;
    out.folds = out.folds || reason.find("folds") != reason.npos;
  }
  out.least_force = found.min_normal_force.value;
  out.force_rate = found.at_start.normal_force_rate;
  out.least_margin = found.min_fold_margin.value;
  out.dense = look_densely(trajectory_of(solution)->curve());
  return out;
}

/// A miss above this says that the equations amplified what the solution is
/// off, and that the dense motion is not that of the solution.
constexpr double kLargestMiss = 1e-5;

}  // namespace

int main(int argc, char** argv) {
  DrawnScenes drawn{
      .count = 1000,
      .limits = {.jobs = 2, .seconds = 300},
      .out = BRACHISTO_SOURCE_DIR "/benchmarks/results/feasibility.csv"};
  CLI::App app{"Feasibility, told by two independent evaluations"};
  drawn.read_from(app);
  CLI11_PARSE(app, argc, argv);
  const auto& [seed, count, first, limits, out] = drawn;

  std::vector<Scene> scenes;
  for (int i = 0; i < count; ++i) {
    scenes.push_back(random_scene(seed, first + i, std::numbers::pi));
  }
  std::vector<std::string> lines(scenes.size());
  int solved = 0, compared = 0, feasible = 0, at_start = 0, differ = 0;
  run_isolated<Record>(
      count, limits,
      [&](int i) { return examine(scenes[static_cast<std::size_t>(i)]); },
      [&](int i, const std::optional<Record>& record, const std::string& fate) {
        const Scene& scene = scenes[static_cast<std::size_t>(i)];
        const Body& body = scene.body;
        std::string& line = lines[static_cast<std::size_t>(i)];
        line =
            fmt::format("{},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}", first + i,
                        scene.L, body.radius, body.eta_m, body.theta_m, body.k);
        if (!record || !record->verified) {
          line += fmt::format(",{},,,,,,,,\n",
                              record ? "not verified" : "failed: " + fate);
          return;
        }
        ++solved;
        const DenseMotion& dense = record->dense;
        const bool comparable = dense.miss <= kLargestMiss;
        const bool same = record->lifts_off == dense.lifts_off() &&
                          record->folds == dense.folds();
        compared += comparable;
        feasible += !record->lifts_off && !record->folds;
        at_start += record->force_rate < 0.0;
        differ += comparable && !same;
        line += fmt::format(",{},{},{},{},{:.3g},{:.9g},{:.9g},{:.9g},{:.9g}\n",
                            !comparable ? "not compared"
                            : same      ? "agrees"
                                        : "DIFFERS",
                            record->lifts_off, record->folds,
                            record->force_rate < 0.0, dense.miss,
                            record->least_force, dense.least_force,
                            record->least_margin, dense.least_margin);
        if (comparable && !same) fmt::print(stderr, "{}", line);
      });

  std::string csv =
      "scene,L,r,eta_m,theta_m,k,outcome,lifts_off,folds,lifts_off_at_start,"
      "miss,R_n_min,R_n_min_dense,fold_margin,fold_margin_dense\n";
  for (const std::string& line : lines) csv += line;
  write_file(out, csv);
  Rows table{{"scenes", "verified", "compared", "neither lifts off nor folds",
              "lifts off at the start", "differ"}};
  table.push_back({std::to_string(count), std::to_string(solved),
                   std::to_string(compared), std::to_string(feasible),
                   std::to_string(at_start), std::to_string(differ)});
  fmt::print("{}\n\n{}", drawn.described(), markdown_table(table));
  return differ == 0 && compared > 0 ? 0 : 1;
}
