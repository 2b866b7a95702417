// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Scenes whose transit time is known.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "brachisto/model/scene.hpp"

namespace brachisto::benchmarks {

/// A scene and what is known of its τ.
struct KnownScene {
  std::string name;
  Scene scene;
  double tau = 0.0;
};

/// The reference values of the tests.
[[nodiscard]] std::vector<KnownScene> reference_scenes();

/// The problems of a folder whose answer is the extremal that continues from
/// the cycloid, with τ by the indirect method at 1e-13. Left out is where that
/// method fails, takes long, or knows fewer than twelve digits; `left_out`
/// names those.
[[nodiscard]] std::vector<KnownScene> gallery_scenes(
    const std::string& folder, int jobs, std::vector<std::string>& left_out);

/// The reference values under limits.
[[nodiscard]] std::vector<KnownScene> limited_reference_scenes();

/// The first `count` random scenes under random limits (random_limited_scene())
/// that are verified at degree 8, which is not the one that is tested, to an
/// estimated error of 1e-12; that is their τ.
[[nodiscard]] std::vector<KnownScene> random_limited_scenes(std::uint64_t seed,
                                                            int count,
                                                            int jobs);

}  // namespace brachisto::benchmarks
