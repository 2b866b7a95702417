// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What the script of a sweep's page, web/sweep.js, draws from.

#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <vector>

#include "brachisto/model/scene.hpp"
#include "report/figure.hpp"
#include "report/result_texts.hpp"
#include "report/sweep_table.hpp"

namespace brachisto::plot {

/// The track that a sweep kept of a scene.
struct SweepTrack {
  std::size_t number = 0;  ///< of the scene
  Scene scene;
  report::Json kept;  ///< see kept_track()
};

/// The cells of each picture in its pixels, which scenes lie on the other side
/// of an edge, what is to be said of single scenes, and the tracks. What a
/// scene's values are the script reads from the table of the page.
[[nodiscard]] report::Json sweep_data(
    const SweepTable& table, const std::vector<report::Figure>& figures,
    const std::vector<SweepTrack>& tracks);

}  // namespace brachisto::plot
