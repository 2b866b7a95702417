// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Scenes whose transit time is known.

#pragma once

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

}  // namespace brachisto::benchmarks
