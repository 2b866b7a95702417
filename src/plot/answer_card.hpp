// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// An answer, or a race, in little: what a notebook shows of it, a drawing with
/// the figures that one looks for first.

#pragma once

#include <string>
#include <vector>

#include "brachisto/model/scene.hpp"
#include "plot/race_page.hpp"
#include "plot/trajectory_table.hpp"
#include "report/result_texts.hpp"

namespace brachisto::plot {

/// A piece of HTML that is well-formed XML: a drawing in SVG of the track, with
/// the body on it at equal times, and a list of figures with their units. It
/// has no script, and its words and axes have the colour of the text around it,
/// so that it can be read on light and on dark ground.
/// \param result  the document of a verified result
[[nodiscard]] std::string answer_card(const report::Json& result,
                                      const Scene& scene,
                                      const TrajectoryTable& table);

/// The same of a result without a path: how it ended, and why.
[[nodiscard]] std::string failure_card(const report::Json& result);

/// All tracks in one drawing, and a table of the order of arrival. A track that
/// covers another one has gaps through which that is seen.
/// \param racers  in the order of their arrival, at least one
[[nodiscard]] std::string race_card(const std::vector<Racer>& racers);

/// The colours of tracks, one after the other: each is seen on white and on
/// almost black alike.
inline constexpr const char* kCardColours[] = {"#1f7ab8", "#c8641b", "#2b8a5a",
                                               "#b0508f", "#8a7413", "#7a68c4"};

}  // namespace brachisto::plot
