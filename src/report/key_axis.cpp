// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/key_axis.hpp"

#include <algorithm>
#include <cmath>

#include "report/key_label.hpp"

namespace brachisto::report {

KeyAxis::KeyAxis(const SweepColumn& column, const Scenes& scenes,
                 const PlotArea& area)
    : column_(column),
      words_(column.numeric() ? std::vector<std::string>{}
                              : distinct_words(column, scenes)),
      axis_(make_axis(scenes, area)) {}

Axis KeyAxis::make_axis(const Scenes& scenes, const PlotArea& area) const {
  if (!column_.numeric()) {
    return {Scale::Linear, -0.5, static_cast<double>(words_.size()) - 0.5,
            area.left, area.right};
  }
  constexpr double kMargin = 0.03;
  const Scale scale = scale_of(column_, scenes);
  Extent extent;
  for (const std::size_t scene : scenes) {
    extent.include(Axis::laid_out(scale, shown_number(column_, scene)));
  }
  const double margin = kMargin * (extent.high - extent.low);
  return {scale, extent.low - margin, extent.high + margin, area.left,
          area.right};
}

double KeyAxis::operator()(std::size_t scene) const {
  if (column_.numeric()) return axis_(shown_number(column_, scene));
  const auto word =
      std::find(words_.begin(), words_.end(), column_.words[scene]);
  // Multiples of the golden ratio fill the room of a word evenly.
  constexpr double kRoom = 0.5;
  constexpr double kGoldenRatio = 0.6180339887498949;
  const double turns = static_cast<double>(scene) * kGoldenRatio;
  return axis_(static_cast<double>(word - words_.begin()) +
               kRoom * (turns - std::floor(turns) - 0.5));
}

void KeyAxis::draw(Svg& svg, const PlotArea& area) const {
  const std::string label = key_label(column_.key)
                                .within(letters_of_x_label(area))
                                .text(Markup::Svg, true);
  if (column_.numeric()) {
    draw_x_axis(svg, area, axis_, label);
  } else {
    draw_categories(svg, area, axis_, words_, label);
  }
}

double KeyAxis::depth(const PlotArea& area) const {
  return column_.numeric() ? kAxisDepth : categories_depth(area, words_);
}

}  // namespace brachisto::report
