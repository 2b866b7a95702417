// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// DXF read back from its text, and pieces found in it.

#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "brachisto/model/body.hpp"
#include "report/cutting_drawing.hpp"

namespace brachisto::testing {

/// One entity: its kind, and the values of each group code; a polyline has
/// those of its vertices.
struct DxfEntity {
  std::string kind;
  std::map<int, std::vector<std::string>> groups;

  [[nodiscard]] std::string text(int code) const {
    const auto found = groups.find(code);
    return found == groups.end() ? "" : found->second.front();
  }
  [[nodiscard]] double number(int code) const { return std::stod(text(code)); }
  [[nodiscard]] std::string layer() const { return text(8); }
};

/// With the axis up, in the units that it says.
struct Dxf {
  std::map<std::string, std::string> header;  ///< variables of one value
  std::vector<DxfEntity> entities;
  bool whole = false;  ///< sections end, and the file does
};

[[nodiscard]] inline Dxf read_dxf(const std::string& text) {
  Dxf out;
  std::istringstream lines(text);
  std::string section, variable;
  int open = 0;
  bool begun = false;
  for (std::string code_line, value;
       std::getline(lines, code_line) && std::getline(lines, value);) {
    const int code = std::stoi(code_line);
    if (code == 0 && value == "SECTION") {
      ++open;
      begun = true;
    } else if (code == 0 && value == "ENDSEC") {
      --open;
      section.clear();
    } else if (code == 0 && value == "EOF") {
      out.whole = open == 0 && lines.peek() == std::char_traits<char>::eof();
    } else if (code == 2 && begun) {
      section = value;
      begun = false;
    } else if (section == "HEADER") {
      if (code == 9)
        variable = value;
      else
        out.header.emplace(variable, value);
    } else if (section == "ENTITIES") {
      if (code == 0 && value != "VERTEX" && value != "SEQEND") {
        out.entities.push_back({value, {}});
      } else if (code != 0) {
        out.entities.back().groups[code].push_back(value);
      }
    }
  }
  return out;
}

/// The corners of a polyline [mm]; the first place is that of the whole.
[[nodiscard]] inline std::vector<Point> corners(const DxfEntity& polyline) {
  std::vector<Point> out;
  const auto& x = polyline.groups.at(10);
  const auto& y = polyline.groups.at(20);
  for (std::size_t i = 1; i < x.size(); ++i) {
    out.push_back({std::stod(x[i]), std::stod(y[i])});
  }
  return out;
}

[[nodiscard]] inline bool is_within(Point p, const std::vector<Point>& area) {
  bool within = false;
  for (std::size_t i = 0, j = area.size() - 1; i < area.size(); j = i++) {
    const Point a = area[i], b = area[j];
    if ((a.z > p.z) != (b.z > p.z) &&
        p.x < a.x + (b.x - a.x) * (p.z - a.z) / (b.z - a.z)) {
      within = !within;
    }
  }
  return within;
}

/// A piece as it hangs, the word "level" on it being level, with the axis up
/// [mm].
struct CutPiece {
  int number = 0, of = 0;
  std::string side;
  std::vector<Point> edge;   ///< that is rolled on, from A to B
  std::vector<Point> holes;  ///< their middles
  int slots = 0;
  double turned = 0.0;  ///< on its sheet, to the left [rad]
};

[[nodiscard]] inline double length_of(const std::vector<Point>& points) {
  double sum = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    sum += std::hypot(points[i].x - points[i - 1].x,
                      points[i].z - points[i - 1].z);
  }
  return sum;
}

/// The pieces of a file, by the numbers that are engraved on them.
[[nodiscard]] inline std::vector<CutPiece> pieces_in(const Dxf& dxf) {
  static const std::regex kNumber(R"((\d+)([LR]?) of (\d+) -> B)");
  std::vector<CutPiece> out;
  for (const DxfEntity& words : dxf.entities) {
    std::smatch match;
    const std::string text = words.text(1);
    if (words.kind != "TEXT" || !std::regex_match(text, match, kNumber)) {
      continue;
    }
    const Point at{words.number(10), words.number(20)};
    CutPiece piece{std::stoi(match[1]), std::stoi(match[3]), match[2], {}, {}};
    std::vector<Point> outline;
    for (const DxfEntity& entity : dxf.entities) {
      if (entity.kind != "POLYLINE" || entity.layer() != "CUT") continue;
      const std::vector<Point> area = corners(entity);
      if (is_within(at, area)) outline = area;
    }
    for (const DxfEntity& entity : dxf.entities) {
      if (entity.layer() != "CUT") continue;
      if (entity.kind == "CIRCLE") {
        const Point middle{entity.number(10), entity.number(20)};
        if (is_within(middle, outline)) piece.holes.push_back(middle);
      } else if (entity.kind == "POLYLINE") {
        const std::vector<Point> area = corners(entity);
        if (area.size() == 4 && is_within(area.front(), outline)) {
          ++piece.slots;
        }
      }
    }
    const auto level =
        std::ranges::find_if(dxf.entities, [&](const DxfEntity& entity) {
          return entity.text(1) == "level" &&
                 is_within({entity.number(10), entity.number(20)}, outline);
        });
    if (level == dxf.entities.end()) continue;
    piece.turned = level->number(50) * std::numbers::pi / 180.0;
    const auto hang = [&](Point& p) {
      const double c = std::cos(piece.turned), s = std::sin(piece.turned);
      p = {c * p.x + s * p.z, c * p.z - s * p.x};
    };
    std::ranges::for_each(outline, hang);
    std::ranges::for_each(piece.holes, hang);
    // From A to B along the track, and back along its parallel.
    piece.edge.assign(
        outline.begin(),
        outline.begin() + static_cast<std::ptrdiff_t>(outline.size() / 2));
    out.push_back(std::move(piece));
  }
  return out;
}

/// Those of all drawings on one side, in order.
[[nodiscard]] inline std::vector<CutPiece> pieces_in(
    const std::vector<report::cutting::Drawing>& drawings,
    const std::string& side = "") {
  std::vector<CutPiece> out;
  for (const report::cutting::Drawing& drawing : drawings) {
    for (CutPiece& piece : pieces_in(read_dxf(as_dxf(drawing)))) {
      if (piece.side == side) out.push_back(std::move(piece));
    }
  }
  std::ranges::sort(out, {}, &CutPiece::number);
  return out;
}

/// Pieces joined from A = (0, 0), with z down: the track [mm].
[[nodiscard]] inline std::vector<Point> joined(
    const std::vector<CutPiece>& pieces) {
  std::vector<Point> out{{0.0, 0.0}};
  for (const CutPiece& piece : pieces) {
    const Point end = out.back(), start = piece.edge.front();
    for (std::size_t i = 1; i < piece.edge.size(); ++i) {
      out.push_back({end.x + piece.edge[i].x - start.x,
                     end.z - (piece.edge[i].z - start.z)});
    }
  }
  return out;
}

}  // namespace brachisto::testing
