// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/map_geometry.hpp"

#include <algorithm>
#include <utility>

#include "report/key_label.hpp"

namespace brachisto::report {

MapGeometry map_geometry(const SweepTable& table, const SweepMap& map,
                         const PlotArea& area) {
  const SweepColumn& x_column = table.columns[map.x_column];
  const SweepColumn& y_column = table.columns[map.y_column];
  const Scale x_scale = scale_of(x_column, map.scenes);
  const Scale y_scale = scale_of(y_column, map.scenes);
  Lattice lattice{map.nx, map.ny, {}, {}};
  for (const std::size_t scene : map.scenes) {
    lattice.nodes.push_back(
        {Axis::laid_out(x_scale, shown_number(x_column, scene)),
         Axis::laid_out(y_scale, shown_number(y_column, scene))});
    lattice.values.push_back(table.outcomes[scene].tau);
  }

  Cells cells(lattice);
  // Where the border is bent outwards, scenes lie beyond their cells.
  Extent x_extent, y_extent;
  for (const std::vector<Pixel>* points : {&cells.corners(), &lattice.nodes}) {
    for (const Pixel& p : *points) {
      x_extent.include(p.x);
      y_extent.include(p.y);
    }
  }
  const Axis x(x_scale, x_extent.low, x_extent.high, area.left, area.right);
  const Axis y(y_scale, y_extent.low, y_extent.high, area.bottom, area.top);
  const auto place = [&](Pixel& p) { p = {x.pixel(p.x), y.pixel(p.y)}; };
  std::for_each(lattice.nodes.begin(), lattice.nodes.end(), place);
  std::for_each(cells.corners().begin(), cells.corners().end(), place);
  return {x, y, std::move(lattice), std::move(cells)};
}

}  // namespace brachisto::report
