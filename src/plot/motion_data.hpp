// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What the script of a page draws from, and the motion as a moving picture.

#pragma once

#include <string>

#include "brachisto/model/scene.hpp"
#include "plot/thinning.hpp"
#include "plot/trajectory_table.hpp"
#include "report/figure.hpp"
#include "report/path_frame.hpp"
#include "report/result_texts.hpp"

namespace brachisto::plot {

/// Numbers that a page has room for, each of ten letters at most: with them,
/// the library of the curves and its own words it stays below 600 kB.
inline constexpr std::size_t kMostNumbers = 36'000;

/// What a picture of the motion shows of the plane: the track with the body on
/// it everywhere, and some room around.
[[nodiscard]] report::Box motion_box(const TrajectoryTable& table,
                                     const Body& body);

/// The rows that a page holds.
/// \param most  numbers, in all columns together
[[nodiscard]] ThinnedTable rows_for_page(const TrajectoryTable& table,
                                         const Scene& scene,
                                         std::size_t most = kMostNumbers);

/// A JSON document, to stand within a page: no letter in it means anything to
/// HTML or XML. Numbers have seven digits; what is not finite is null.
/// \param result  the result document, of which the active arcs are told
/// \param box     what the picture shows of the plane
[[nodiscard]] std::string motion_data(const TrajectoryTable& rows,
                                      const Scene& scene,
                                      const report::Json& result,
                                      const report::Box& box);

/// Frames at equal times, some seconds long whatever the motion takes.
[[nodiscard]] report::Figure moving_figure(const Scene& scene,
                                           const TrajectoryTable& table);

}  // namespace brachisto::plot
