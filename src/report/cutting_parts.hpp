// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The parts of a track and of its body, each with what is cut and engraved.

#pragma once

#include <span>
#include <string>
#include <vector>

#include "brachisto/model/body.hpp"
#include "report/cutting_build.hpp"
#include "report/cutting_drawing.hpp"
#include "report/cutting_pieces.hpp"

namespace brachisto::report::cutting {

/// Something that is cut out of a sheet.
struct Part {
  std::string name;    ///< "3", "3-4" of the plate that laps their joint
  Shapes shapes = {};  ///< [mm]
  Box box{};           ///< around them, words included
  /// How it may be turned on a sheet [rad].
  std::vector<double> turns = {0.0};

  /// Turned so; other words than those within its outline only by 0.
  [[nodiscard]] Part turned(double angle) const;
};

/// What is on a sheet beside the strip: how far a flange of the body reaches
/// below the edge that it rolls on, which a line on each piece tells.
[[nodiscard]] double flange_of(const Build& build);

/// The pieces in order, each with the edge that is rolled on, level and plumb
/// lines and its number, for two strips twice; the plates that lap joints; the
/// spacers of two strips.
[[nodiscard]] std::vector<Part> track_parts(const Edge& edge,
                                            const std::vector<Piece>& pieces,
                                            const Build& build);

/// Of a cylinder two discs that roll and two flanges that keep it on its
/// strips, with the radius that touches the track at A, the centre of mass and
/// what the body is made of. Of a bead nothing.
/// \param start_angle  of the track [rad]
/// \param made_of      in metres; may be empty
[[nodiscard]] std::vector<Part> body_parts(const Body& body, double start_angle,
                                           std::span<const MassPart> made_of,
                                           const Build& build);

/// k of those discs and flanges, uniform and without holes.
[[nodiscard]] double k_of_discs(const Body& body, const Build& build);

}  // namespace brachisto::report::cutting
