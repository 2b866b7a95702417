// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/cutting_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "report/letters.hpp"

namespace brachisto::report::cutting {

namespace {

constexpr double kRuler = 100.0, kTick = 10.0;  // [mm]
constexpr double kRulerHeight = 10.0;           // with its words

void add_ruler(Shapes& out, Point at) {
  constexpr double kLong = 5.0, kShort = 3.0;
  out.polylines.push_back({Line::Engrave, {at, {at.x + kRuler, at.z}}});
  for (double x = 0.0; x <= kRuler; x += kTick) {
    const double length = x == 0.0 || x == kRuler ? kLong : kShort;
    out.polylines.push_back(
        {Line::Engrave, {{at.x + x, at.z}, {at.x + x, at.z - length}}});
  }
  out.labels.push_back({{at.x + kRuler + 2.0, at.z},
                        SheetFrame::kLetter,
                        fmt::format("{:g} mm", kRuler)});
}

/// Parts beside each other.
struct Row {
  std::size_t sheet;
  double top, height, used;  ///< [mm], from the corner of the room
};

/// In rows, the highest first.
Arrangement in_rows(const std::vector<Part>& parts, const SheetFrame& frame) {
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, std::greater<>(), [&](std::size_t i) {
    return parts[i].box.height();
  });
  const Box& room = frame.room();
  std::vector<Row> rows;
  std::vector<double> bottoms;  // of what is used of each sheet
  std::vector<Shapes> sheets;
  Arrangement out{{}, std::vector<int>(parts.size())};
  for (const std::size_t i : order) {
    const Box& box = parts[i].box;
    auto row = std::ranges::find_if(rows, [&](const Row& r) {
      return r.used + box.width() <= room.width() && box.height() <= r.height;
    });
    if (row == rows.end()) {
      const auto free = std::ranges::find_if(bottoms, [&](double bottom) {
        return bottom + box.height() <= room.height();
      });
      const auto sheet = static_cast<std::size_t>(free - bottoms.begin());
      if (free == bottoms.end()) {
        bottoms.push_back(0.0);
        sheets.emplace_back();
      }
      rows.push_back({sheet, bottoms[sheet], box.height(), 0.0});
      bottoms[sheet] += box.height() + kApart;
      row = rows.end() - 1;
    }
    sheets[row->sheet].add(parts[i].shapes,
                           {room.low.x + row->used - box.low.x,
                            room.low.z + row->top - box.low.z});
    row->used += box.width() + kApart;
    out.sheet_of[i] = static_cast<int>(row->sheet) + 1;
  }
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    Drawing sheet =
        frame.sheet(fmt::format("sheet-{:02}", i + 1),
                    fmt::format("Sheet {} of {}: red is cut, blue is engraved",
                                i + 1, sheets.size()));
    sheet.shapes.add(sheets[i], {0.0, 0.0});
    out.sheets.push_back(std::move(sheet));
  }
  return out;
}

}  // namespace

SheetFrame::SheetFrame(const Build& build,
                       const std::vector<std::string>& facts)
    : width_(build.width), height_(build.height) {
  const double wide = width_ - 2.0 * kMargin;
  const auto most = static_cast<std::size_t>(wide / width_of(1, kLetter));
  for (const std::string& fact : facts) {
    for (std::string& line : words_in_lines(fact, most)) {
      lines_.push_back(std::move(line));
    }
  }
  // And the title.
  const double words = kLine * static_cast<double>(lines_.size() + 1);
  room_ = {{kMargin, kMargin + words + kApart},
           {width_ - kMargin, height_ - kMargin - kRulerHeight}};
}

bool SheetFrame::fits(const Box& box) const {
  return box.width() <= room_.width() && box.height() <= room_.height();
}

Drawing SheetFrame::sheet(const std::string& name,
                          const std::string& title) const {
  Drawing out{name, title, width_, height_, {}};
  double z = kMargin + kLetter;
  out.shapes.labels.push_back({{kMargin, z}, kLetter, title});
  for (const std::string& line : lines_) {
    z += kLine;
    out.shapes.labels.push_back({{kMargin, z}, kLetter, line});
  }
  add_ruler(out.shapes, {kMargin, height_ - kMargin});
  return out;
}

Arrangement arranged(const std::vector<Part>& parts, const SheetFrame& frame) {
  std::vector<Part> hanging, low;
  for (const Part& part : parts) {
    std::vector<Part> fitting;
    for (const double angle : part.turns) {
      Part lying = part.turned(angle);
      if (frame.fits(lying.box)) fitting.push_back(std::move(lying));
    }
    if (fitting.empty()) {
      const Box &box = part.box, &room = frame.room();
      throw TemplateError(fmt::format(
          "part {} takes {:.4g} x {:.4g} mm, and a sheet has room for {:.4g} x "
          "{:.4g} mm beside its words; a larger --sheet or a smaller --scale "
          "makes room",
          part.name, box.width(), box.height(), std::max(0.0, room.width()),
          std::max(0.0, room.height())));
    }
    low.push_back(*std::ranges::min_element(
        fitting, {}, [](const Part& lying) { return lying.box.height(); }));
    hanging.push_back(std::move(fitting.front()));
  }
  Arrangement out = in_rows(hanging, frame), lower = in_rows(low, frame);
  return lower.sheets.size() < out.sheets.size() ? lower : out;
}

}  // namespace brachisto::report::cutting
