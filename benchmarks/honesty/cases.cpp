// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "honesty/cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "brachisto/io/problem_file.hpp"
#include "brachisto/study/solve.hpp"
#include "limits/random_limits.hpp"
#include "support/criterion.hpp"
#include "support/limited_scenes.hpp"
#include "support/processes.hpp"
#include "support/reference_values.hpp"
#include "support/witness.hpp"

namespace brachisto::benchmarks {

std::vector<KnownScene> reference_scenes() {
  std::vector<KnownScene> scenes;
  for (const testing::ReferenceValue& row : testing::kReferenceValues) {
    scenes.push_back({row.name, row.scene(), row.tau});
  }
  return scenes;
}

std::vector<KnownScene> gallery_scenes(const std::string& folder, int jobs,
                                       std::vector<std::string>& left_out) {
  std::vector<KnownScene> wanted;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string path = entry.path().string();
    if (entry.path().extension() != ".yaml") continue;
    if (!read_intent(path).criterion.wants_a_path()) continue;
    const io::ProblemFile problem = io::read_problem_file(path);
    if (problem.options.of<Collocation>()->search == Search::Global ||
        problem.options.of<Collocation>()->guess != Guess::Cycloid) {
      continue;
    }
    wanted.push_back({entry.path().stem().string(), problem.scene, 0.0});
  }
  std::sort(
      wanted.begin(), wanted.end(),
      [](const KnownScene& a, const KnownScene& b) { return a.name < b.name; });

  constexpr double kTwelveDigits = 1e-12;
  constexpr double kSeconds = 5.0;
  std::vector<KnownScene> known;
  run_isolated<double>(
      static_cast<int>(wanted.size()),
      {.jobs = jobs, .seconds = 2 * static_cast<unsigned>(kSeconds)},
      [&](int i) {
        const ExtremalSolution witness =
            ask_witness(wanted[static_cast<std::size_t>(i)].scene, kSeconds);
        const bool good =
            witness.usable() && witness.error_estimate <= kTwelveDigits;
        return good ? witness.tau : 0.0;
      },
      [&](int i, const std::optional<double>& tau, const std::string&) {
        KnownScene& one = wanted[static_cast<std::size_t>(i)];
        if (tau && *tau > 0.0) {
          one.tau = *tau;
        } else {
          left_out.push_back(one.name);
        }
      });
  std::copy_if(wanted.begin(), wanted.end(), std::back_inserter(known),
               [](const KnownScene& one) { return one.tau > 0.0; });
  return known;
}

std::vector<KnownScene> limited_reference_scenes() {
  std::vector<KnownScene> scenes;
  for (testing::LimitedReference& row : testing::limited_references()) {
    scenes.push_back({row.name, std::move(row.scene), row.tau});
  }
  return scenes;
}

std::vector<KnownScene> random_limited_scenes(std::uint64_t seed, int count,
                                              int jobs) {
  constexpr double kTwelveDigits = 1e-12;
  constexpr unsigned kSeconds = 40;
  // Some are refused, some are not solved.
  const int drawn = 2 * count;
  std::vector<double> taus(static_cast<std::size_t>(drawn), 0.0);
  run_isolated<double>(
      drawn, {.jobs = jobs, .seconds = kSeconds},
      [&](int i) {
        const auto limited = random_limited_scene(seed, i);
        if (!limited || !validate(limited->scene).empty()) return 0.0;
        SolveOptions options;
        auto& mesh = options.use<Collocation>().discretisation;
        mesh.degree = kMaxDegree;
        mesh.tolerance = kTwelveDigits;
        const Solution found = solve(limited->scene, options);
        return found.verified() ? found.motion()->tau() : 0.0;
      },
      [&](int i, const std::optional<double>& tau, const std::string&) {
        taus[static_cast<std::size_t>(i)] = tau.value_or(0.0);
      });
  std::vector<KnownScene> known;
  for (int i = 0; i < drawn && std::ssize(known) < count; ++i) {
    const double tau = taus[static_cast<std::size_t>(i)];
    if (tau == 0.0) continue;
    Scene scene = random_limited_scene(seed, i)->scene;
    std::string name = fmt::format("random {}: {}", i, described(scene));
    known.push_back({std::move(name), std::move(scene), tau});
  }
  return known;
}

}  // namespace brachisto::benchmarks
