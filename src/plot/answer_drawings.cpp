// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "plot/answer_drawings.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <iterator>
#include <set>
#include <utility>

#include "transcription/rolling_time.hpp"

namespace brachisto::plot {

std::string block_drawing(const Scene& scene, int degree, int elements) {
  // Its entries are where they are whatever the slope at B is.
  const RollingTime element(scene, uniform_mesh(degree, 1), 0.0);
  const int n = element.num_variables(), size = n + element.num_constraints();
  std::set<std::pair<int, int>> entries;  // row and column
  const auto put = [&](int row, int column) {
    entries.emplace(row, column);
    entries.emplace(column, row);
  };
  element.hess_lag_pattern().for_each(
      [&](std::size_t, int row, int column) { put(row, column); });
  element.jac_g_pattern().for_each(
      [&](std::size_t, int row, int column) { put(n + row, column); });
  // Entries side by side are one rectangle.
  std::string path;
  for (auto entry = entries.begin(); entry != entries.end();) {
    const auto [row, column] = *entry;
    int end = column;
    while (entry != entries.end() && *entry == std::pair{row, end}) {
      ++entry;
      ++end;
    }
    fmt::format_to(std::back_inserter(path), "M{} {}h{}v1h{}z", column, row,
                   end - column, column - end);
  }
  return fmt::format(
      "<figure class=\"small block\"><svg viewBox=\"-1 -1 {0} {0}\" "
      "role=\"img\" aria-label=\"Pattern of the KKT matrix of one element\">"
      "<path class=\"frame\" d=\"M0 0H{1}V{1}H0zM{2} 0V{1}M0 {2}H{1}\"/>"
      "<path class=\"entries\" d=\"{3}\"/></svg><figcaption>Where the KKT "
      "matrix of one element of degree {4} may have entries, {5} in all: the "
      "Hessian of its {2} variables to the upper left, the Jacobian of its {6} "
      "rows below. The mesh of this answer is a chain of {7}, neighbours "
      "sharing a node, bordered by one variable of all, "
      "U.</figcaption></figure>\n",
      size + 2, size, n, path, degree, entries.size(), size - n, elements);
}

}  // namespace brachisto::plot
