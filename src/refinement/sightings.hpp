// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What holds at places along a path, from which its arcs follow.

#pragma once

#include <optional>
#include <vector>

#include "refinement/arcs.hpp"

namespace brachisto {

/// Which limits hold at a place.
struct Sighting {
  double sigma;
  std::vector<nlp::Held> held;
  std::optional<Touch> touch = {};  ///< ends the arc here
  double excess = 0.0;              ///< of the limit that is touched
};

/// Arcs from what holds at places in order; junctions lie half-way between two.
[[nodiscard]] std::vector<Arc> arcs_from(
    const std::vector<Sighting>& sightings, int elements,
    const std::vector<PathInequality>& limits);

/// Whether a limit of the control is touched at the last place before it holds.
[[nodiscard]] bool touches_before_it_holds(
    const std::vector<Sighting>& seen, std::size_t place,
    const std::vector<PathInequality>& limits);

/// Of a run of places at which a limit is exceeded it is touched where it is so
/// most, or at the last one, if it is a limit of the control and holds from
/// there on.
void touch_once(std::vector<Sighting>& seen,
                const std::vector<PathInequality>& limits);

/// At B the place is given: a limit of it is not touched there.
void leave_end(const LimitedTime& problem, std::vector<Sighting>& seen);

}  // namespace brachisto
