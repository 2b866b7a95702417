// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Is the estimated error honest? Scenes whose τ is known, solved to several
// tolerances.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

#include "brachisto/study/solve.hpp"
#include "honesty/cases.hpp"
#include "honesty/summary.hpp"
#include "support/processes.hpp"
#include "support/table.hpp"

using namespace brachisto;
using namespace brachisto::benchmarks;

namespace {

Measurement measure(const KnownScene& known, double tolerance) {
  SolveOptions options;
  options.use<Collocation>().discretisation.tolerance = tolerance;
  const Solution solution = solve(known.scene, options);
  Measurement measured;
  measured.tolerance = tolerance;
  measured.verified = solution.verified();
  measured.reason = FixedText<300>(why_not_verified(solution));
  if (solution.motion() != nullptr) {
    measured.true_error =
        std::abs(solution.motion()->tau() - known.tau) / known.tau;
  }
  if (!solution.effort.meshes.empty()) {
    measured.degree = solution.effort.meshes.back().degree;
    measured.elements = solution.effort.meshes.back().elements;
  }
  if (solution.estimated_error) measured.estimate = *solution.estimated_error;
  measured.meshes = static_cast<int>(solution.effort.meshes.size());
  measured.iterations = solution.effort.iterations;
  measured.newton_steps = solution.effort.newton_steps;
  measured.seconds = solution.effort.seconds;
  return measured;
}

}  // namespace

int main(int argc, char** argv) {
  std::string folder = BRACHISTO_SOURCE_DIR "/problems/hard";
  std::string out = BRACHISTO_SOURCE_DIR "/benchmarks/results/honesty.csv";
  ProcessLimits limits{.jobs = 1, .seconds = 900};
  CLI::App app{"Estimated against true errors"};
  app.add_option("--folder", folder, "Of further problems")
      ->capture_default_str();
  app.add_option("--jobs", limits.jobs, "Processes at a time")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--out", out, "CSV file")->capture_default_str();
  bool under_limits = false;
  int count_of_random = 60;
  std::uint64_t seed = 1;
  app.add_flag("--limited", under_limits,
               "Scenes under limits in place of those without: the reference "
               "values and random ones");
  app.add_option("--random", count_of_random, "How many of these")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--seed", seed, "Of these")->capture_default_str();
  CLI11_PARSE(app, argc, argv);

  std::vector<std::string> left_out;
  std::vector<KnownScene> scenes;
  const auto add = [&](std::vector<KnownScene> more) {
    std::ranges::move(more, std::back_inserter(scenes));
  };
  if (under_limits) {
    add(limited_reference_scenes());
    add(random_limited_scenes(seed, count_of_random, limits.jobs));
  } else {
    add(reference_scenes());
    add(gallery_scenes(folder, limits.jobs, left_out));
  }
  std::vector<double> tolerances{1e-4, 1e-6, 1e-8};
  if (!under_limits) tolerances.push_back(1e-10);
  const auto scene_of = [&](int i) {
    return static_cast<std::size_t>(i) / tolerances.size();
  };
  const auto tolerance_of = [&](int i) {
    return tolerances[static_cast<std::size_t>(i) % tolerances.size()];
  };
  const auto count = static_cast<int>(scenes.size() * tolerances.size());
  std::vector<Named> all(static_cast<std::size_t>(count));
  run_isolated<Measurement>(
      count, limits,
      [&](int i) { return measure(scenes[scene_of(i)], tolerance_of(i)); },
      [&](int i, const std::optional<Measurement>& measured,
          const std::string& fate) {
        Named& one = all[static_cast<std::size_t>(i)];
        one.name = scenes[scene_of(i)].name;
        if (measured) {
          one.measured = *measured;
        } else {
          one.measured.tolerance = tolerance_of(i);
          one.measured.reason = FixedText<300>(fate);
        }
      });
  write_file(out, csv(all));
  fmt::print("{}\n\n{}\n", machine(), summary(all, tolerances));
  for (const std::string& name : left_out) {
    fmt::print("left out, no reference to twelve digits: {}\n", name);
  }
  const bool honest =
      std::none_of(all.begin(), all.end(), [](const Named& one) {
        return one.measured.too_small_an_estimate() ||
               one.measured.misses_tolerance();
      });
  return honest ? 0 : 1;
}
