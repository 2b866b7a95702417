// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "plot/answer_drawings.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "math/angle.hpp"
#include "report/rich_text.hpp"
#include "report/scale.hpp"
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

using report::Json;
using report::printed;
using report::xml_escaped;

std::string continuation_drawing(const Json& steps) {
  constexpr std::size_t kFewest = 3;
  if (!steps.is_array() || steps.size() < kFewest) return {};
  std::vector<std::pair<double, double>> points;
  report::Extent across, up;
  for (const Json& step : steps) {
    const Json eta = step.value("eta_m", Json()),
               phi = step.value("phi", Json());
    if (!eta.is_number() || !phi.is_number()) return {};
    points.emplace_back(eta.get<double>(), math::in_degrees(phi.get<double>()));
    across.include(points.back().first);
    up.include(points.back().second);
  }
  if (!(across.high > across.low) || !(up.high > up.low)) return {};
  constexpr double kLeft = 52.0, kTop = 12.0, kWidth = 380.0, kHeight = 120.0;
  std::string line, dots;
  for (const auto& [eta, phi] : points) {
    const double x =
        kLeft + kWidth * (eta - across.low) / (across.high - across.low);
    // Down on the drawing is down on the track.
    const double y = kTop + kHeight * (phi - up.low) / (up.high - up.low);
    line += fmt::format("{}{:.1f},{:.1f}", line.empty() ? "" : " ", x, y);
    dots +=
        fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.6\"/>", x, y);
  }
  const auto label = [](double x, double y, std::string_view anchor,
                        const std::string& text) {
    return fmt::format(
        "<text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"{}\">{}</text>", x, y,
        anchor, xml_escaped(text));
  };
  constexpr double kRight = kLeft + kWidth, kBottom = kTop + kHeight;
  return fmt::format(
      "<figure class=\"small\"><svg viewBox=\"0 0 450 160\" role=\"img\" "
      "aria-label=\"The slope angle at B over the offset, step by step\">"
      "<path class=\"frame\" d=\"M{0} {1}V{2}H{3}\"/>"
      "<polyline points=\"{4}\"/>{5}{6}{7}{8}{9}</svg>"
      "<figcaption>The slope at B at each step from the uniform cylinder, η = "
      "{10}, to the body, η = {11}.</figcaption></figure>\n",
      kLeft, kTop, kBottom, kRight, line, dots,
      label(kLeft - 6.0, kTop + 4.0, "end", printed(up.low, 3) + "°"),
      label(kLeft - 6.0, kBottom, "end", printed(up.high, 3) + "°"),
      label(kLeft, kBottom + 18.0, "start", printed(across.low, 3)),
      label(kRight, kBottom + 18.0, "end", printed(across.high, 3)),
      printed(points.front().first, 3), printed(points.back().first, 3));
}

}  // namespace brachisto::plot
