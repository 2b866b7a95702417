// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Where the scenes of a map lie.

#pragma once

#include "report/axis.hpp"
#include "report/heat_map_svg.hpp"
#include "report/lattice.hpp"
#include "report/plot_frame.hpp"

namespace brachisto::report {

/// Axes that hold all cells and scenes, the scenes with their τ as a grid, and
/// their cells [px]. A scene without finite coordinates has a cell without
/// them.
struct MapGeometry {
  Axis x, y;
  Lattice lattice;
  Cells cells;
};
[[nodiscard]] MapGeometry map_geometry(const SweepTable& table,
                                       const SweepMap& map,
                                       const PlotArea& area);

}  // namespace brachisto::report
