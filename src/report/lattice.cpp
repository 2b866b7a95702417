// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/lattice.hpp"

#include <algorithm>

namespace brachisto::report {

Cells::Cells(const Lattice& lattice) : ny_(lattice.ny) {
  corners_.reserve((lattice.nx + 1) * (lattice.ny + 1));
  // The indices on both sides of a corner; at the border they are the same.
  const auto around = [](std::size_t corner, std::size_t count) {
    return std::array{corner == 0 ? 0 : corner - 1,
                      std::min(corner, count - 1)};
  };
  for (std::size_t a = 0; a <= lattice.nx; ++a) {
    for (std::size_t b = 0; b <= lattice.ny; ++b) {
      Pixel mean{0.0, 0.0};
      for (const std::size_t i : around(a, lattice.nx)) {
        for (const std::size_t j : around(b, lattice.ny)) {
          const Pixel node = lattice.nodes[lattice.at(i, j)];
          mean = {mean.x + 0.25 * node.x, mean.y + 0.25 * node.y};
        }
      }
      corners_.push_back(mean);
    }
  }
}

}  // namespace brachisto::report
