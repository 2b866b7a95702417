// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The page of a race: bodies that start together, each on its own track.

#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "brachisto/model/scene.hpp"
#include "plot/trajectory_table.hpp"
#include "report/path_frame.hpp"
#include "report/result_texts.hpp"

namespace brachisto::plot {

/// One of those that start.
struct Racer {
  std::string name;
  report::Json result;  ///< document of a verified result
  Scene scene;
  TrajectoryTable table;
};

/// Sorted by their transit times; where these are the same, as they were.
[[nodiscard]] std::vector<Racer> in_order_of_arrival(std::vector<Racer> racers);

/// By how much a racer comes after the first one, in ms with the digits that
/// the errors of both leave, at most three decimals: "+136.481", "0" of the
/// first one.
[[nodiscard]] std::string behind(const Racer& first, const Racer& racer);

/// What a picture shows of the plane for all of them; at least one.
[[nodiscard]] report::Box motion_box(const std::vector<Racer>& racers);

/// One file that needs no other one and no network. It is well-formed XML too,
/// and holds at most kMostNumbers numbers of all tables together.
/// Who comes first is hidden until it does, and may be guessed.
/// \param racers      by their numbers, at least one, whose tracks have the
/// same
///                    ends
/// \param same_track  all of them are on that of the first
[[nodiscard]] std::string race_page(const std::vector<Racer>& racers,
                                    bool same_track = false);

/// A name for each problem file: "uniform cylinder" of uniform_cylinder.yaml,
/// with as many of its folders before it as tell it from the others,
/// "steep/uniform cylinder". Files that no folder tells apart, such as
/// a.yaml and a.yml, are called as they are given.
[[nodiscard]] std::vector<std::string> racer_names(
    const std::vector<std::string>& files);

}  // namespace brachisto::plot
