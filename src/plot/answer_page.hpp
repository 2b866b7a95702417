// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The page of an answer, index.html: its motion to be played, curves, and all
/// that the result tells.

#pragma once

#include <string>

#include "brachisto/model/scene.hpp"
#include "plot/trajectory_table.hpp"
#include "report/result_texts.hpp"

namespace brachisto::plot {

/// One file that needs no other one and no network. It is well-formed XML too,
/// and below 600 kB whatever the mesh, as long as the result document is below
/// 50 kB.
/// \param result  the document of a verified result
[[nodiscard]] std::string answer_page(const report::Json& result,
                                      const Scene& scene,
                                      const TrajectoryTable& table);

}  // namespace brachisto::plot
