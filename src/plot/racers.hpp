// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Who may race: verified solutions whose tracks have the same ends.

#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "brachisto/study/solution.hpp"
#include "plot/race_page.hpp"

namespace brachisto::plot {

inline constexpr std::size_t kFewestRacers = 2, kMostRacers = 24;

/// What has to be known of a verified solution.
[[nodiscard]] Racer racer_of(const std::string& name, const Solution& solution);

/// The track of a verified solution as one that is given: beside the path of
/// its centre, for the track itself may turn as sharply as the body fits.
[[nodiscard]] std::shared_ptr<const GivenPath> track_of(
    const Solution& solution);
/// A scene whose body takes that track: its own path and limits do not count.
[[nodiscard]] Scene on_track(Scene scene,
                             std::shared_ptr<const GivenPath> track);

/// Of the first one, before it is solved, if others are to take its track.
/// \throws io::InputError  if that does not lead from A to B
void check_track(const std::string& file, const Scene& scene);

/// Before any is solved, where all take the track of the first one.
/// \throws io::InputError  as the next one
void check_finish(const std::string& file, const Scene& scene,
                  const std::string& first, const Scene& its_scene);
/// \param file  whose fault it is
/// \throws io::InputError  if a track does not begin and end where the first
///                         one does
void check_ends(const std::string& file, const Racer& first,
                const Racer& racer);

}  // namespace brachisto::plot
