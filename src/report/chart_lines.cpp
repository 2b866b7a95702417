// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/chart_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace brachisto::report {

namespace {

constexpr double kBeyond = 12.0;   // of the frame, more than a line is wide
constexpr double kNearest = 0.45;  // distance of two points

/// The part of a segment within a rectangle, by the shares of its length where
/// it enters and leaves (Liang and Barsky 1984).
struct Part {
  double enter = 0.0, leave = 1.0;
};

std::optional<Part> part_within(Pixel a, Pixel b, const PlotArea& area) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  // Each side: movement towards it and distance to it.
  const std::array<std::pair<double, double>, 4> sides{
      {{-dx, a.x - area.left + kBeyond},
       {dx, area.right + kBeyond - a.x},
       {-dy, a.y - area.top + kBeyond},
       {dy, area.bottom + kBeyond - a.y}}};
  Part part;
  for (const auto& [towards, distance] : sides) {
    if (towards == 0.0) {
      if (distance < 0.0) return {};
    } else if (towards < 0.0) {
      part.enter = std::max(part.enter, distance / towards);
    } else {
      part.leave = std::min(part.leave, distance / towards);
    }
  }
  if (!(part.enter <= part.leave)) return {};
  return part;
}

std::vector<Pixel> thinned(const std::vector<Pixel>& line) {
  std::vector<Pixel> out{line.front()};
  for (const Pixel& p : line) {
    if (std::hypot(p.x - out.back().x, p.y - out.back().y) >= kNearest) {
      out.push_back(p);
    }
  }
  // The end stays where it is.
  if (out.size() > 1) {
    out.back() = line.back();
  } else {
    out.push_back(line.back());
  }
  return out;
}

}  // namespace

std::vector<std::vector<Pixel>> visible_lines(const std::vector<Datum>& points,
                                              const ChartLayout& layout) {
  std::vector<std::vector<Pixel>> lines;
  bool joined = false;  // the last line goes on
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Pixel a = layout.at(points[i - 1]);
    const Pixel b = layout.at(points[i]);
    const bool finite = std::isfinite(a.x) && std::isfinite(a.y) &&
                        std::isfinite(b.x) && std::isfinite(b.y);
    const std::optional<Part> part =
        finite ? part_within(a, b, layout.area) : std::nullopt;
    if (!part) {
      joined = false;
      continue;
    }
    const auto at = [&](double share) {
      return Pixel{std::lerp(a.x, b.x, share), std::lerp(a.y, b.y, share)};
    };
    if (!joined || part->enter > 0.0) lines.push_back({at(part->enter)});
    lines.back().push_back(at(part->leave));
    joined = part->leave == 1.0;
  }
  for (std::vector<Pixel>& line : lines) line = thinned(line);
  return lines;
}

}  // namespace brachisto::report
