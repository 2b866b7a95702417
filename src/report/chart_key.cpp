// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/chart_key.hpp"

#include <algorithm>
#include <utility>

#include "report/chart_style.hpp"
#include "report/letters.hpp"
#include "report/rich_text.hpp"

namespace brachisto::report {

namespace {

constexpr double kSample = 36.0;   // length of the line
constexpr double kToName = 44.0;   // from the left end of the line
constexpr double kBetween = 26.0;  // of a name and the next column
constexpr double kSize = 13.0;

bool look_the_same(const Curve& a, const Curve& b) {
  return a.name == b.name && a.stroke == b.stroke && a.colour == b.colour &&
         a.width == b.width && a.mark == b.mark;
}

}  // namespace

std::vector<KeyEntry> key_entries(const Chart& chart) {
  std::vector<KeyEntry> entries;
  for (const Curve& curve : chart.curves) {
    const bool known =
        std::any_of(entries.begin(), entries.end(), [&](const KeyEntry& entry) {
          return look_the_same(*entry.curve, curve);
        });
    if (curve.name.empty() || known) continue;
    entries.push_back({curve.name, &curve, nullptr});
  }
  for (const Area& area : chart.areas) {
    if (!area.name.empty()) entries.push_back({area.name, nullptr, &area});
  }
  if (entries.size() == 1) entries.clear();
  return entries;
}

KeyTable::KeyTable(std::vector<KeyEntry> entries, double width)
    : entries_(std::move(entries)) {
  if (entries_.empty()) return;
  std::size_t longest = 0;
  for (const KeyEntry& entry : entries_) {
    longest = std::max(longest, letters(plain_words(entry.name)));
  }
  column_ = kToName + width_of(longest, kSize) + kBetween;
  const auto most =
      static_cast<std::size_t>(std::max(1.0, (width + kBetween) / column_));
  rows_ = (entries_.size() + most - 1) / most;
  columns_ = (entries_.size() + rows_ - 1) / rows_;
}

void KeyTable::draw(Svg& svg, Pixel corner) const {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const KeyEntry& entry = entries_[i];
    const double x = corner.x + column_ * static_cast<double>(i / rows_);
    const double y = corner.y + kLine * (static_cast<double>(i % rows_) + 0.5);
    if (entry.area != nullptr) {
      svg.rectangle({x, y - 6.0}, kSample, 12.0,
                    fmt::format("fill=\"{}\" stroke=\"#999999\" "
                                "stroke-width=\"0.6\"",
                                xml_escaped(entry.area->fill)));
    } else {
      if (entry.curve->width > 0.0) {
        svg.line({x, y}, {x + kSample, y}, line_style(*entry.curve));
      }
      draw_mark(svg, {x + 0.5 * kSample, y}, entry.curve->mark,
                entry.curve->colour);
    }
    svg.text({x + kToName, y + 4.5}, "class=\"key\" font-size=\"13\"",
             svg_words(entry.name));
  }
}

ChartFoot chart_foot(const Chart& chart, const ChartLayout& layout) {
  constexpr double kLeft = 20.0;
  constexpr double kBelowLabel = 14.0;
  const double labelled = layout.area.bottom + kAxisDepth + kBelowLabel;
  KeyTable key(key_entries(chart), kChartWidth - 2.0 * kLeft);
  // Below the middle of the plot if there is room.
  const double middle = 0.5 * (layout.area.left + layout.area.right);
  const double x =
      std::clamp(middle - 0.5 * key.width(), kLeft,
                 std::max(kLeft, kChartWidth - kLeft - key.width()));
  const double bottom = labelled + key.height();
  return {std::move(key), {x, labelled}, bottom + 4.0};
}

}  // namespace brachisto::report
