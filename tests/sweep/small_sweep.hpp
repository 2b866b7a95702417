// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Sweeps and stores for tests.

#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sweep/job.hpp"
#include "sweep/outcome.hpp"
#include "sweep/store.hpp"

namespace brachisto::testing {

/// Two rows of `count` scenes each, chains of no more than 16.
[[nodiscard]] inline sweep::Job small_job(int count = 20,
                                          const std::string& k = "1/2") {
  const std::string text =
      "scene:\n"
      "  body: {shape: cylinder, radius: 1/3, k: " +
      k +
      "}\n"
      "  finish: {L: 3, H: 1}\n"
      "sweep:\n"
      "  warm_start: true\n"
      "  scene.body.eta_m: [0.1, 0.2]\n"
      "  scene.body.theta_m: {from: 0, to: 1, count: " +
      std::to_string(count) + "}\n";
  return {"small.yaml", text, {}, io::read_sweep_text(text, "small.yaml")};
}

[[nodiscard]] inline sweep::StoreInfo info_of(const sweep::Job& job) {
  return {.job = sweep::to_line(job),
          .input_hash = sweep::input_hash(job.file),
          .version = "1.2.3",
          .shard = "1/1",
          .provenance = R"({"brachisto":"1.2.3"})",
          .num_scenes = job.file.num_scenes()};
}

/// What a store has, in its order.
[[nodiscard]] inline std::vector<std::pair<std::size_t, std::string>> content(
    sweep::Store& store) {
  std::vector<std::pair<std::size_t, std::string>> rows;
  store.for_each_result([&](std::size_t scene, const std::string& document) {
    rows.emplace_back(scene, document);
  });
  return rows;
}

/// An answer as a worker might give it; `value` stands for its numbers.
[[nodiscard]] inline sweep::Answer answer(std::size_t scene, int value = 0,
                                          const std::string& state = "") {
  return {scene,
          R"({"status":"solved","verified":false,"message":")" +
              std::to_string(value) + R"(","seconds":{"total":)" +
              std::to_string(scene) + "}}",
          state};
}

}  // namespace brachisto::testing
