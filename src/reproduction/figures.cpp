// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "reproduction/figures.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace brachisto::reproduction {

report::Chart chart_of(const char* name, const char* title, const char* x,
                       const char* y) {
  report::Chart chart;
  chart.name = name;
  chart.title = title;
  chart.x.label = x;
  chart.y.label = y;
  return chart;
}

Figure figure(const report::Chart& chart, std::string heading,
              std::string caption) {
  return {.heading = std::move(heading),
          .caption = std::move(caption),
          .drawing = report::chart_figure(chart)};
}

std::vector<Figure> all_figures(const Results& found) {
  std::vector<Figure> out = motion_figures(found.cases);
  for (std::vector<Figure> more :
       {path_figures(found.cases), parameter_figures(found)}) {
    std::move(more.begin(), more.end(), std::back_inserter(out));
  }
  // Those of the paper by number, "Fig. 3" before "Fig. 10"; then the others.
  constexpr int kLast = 1000;
  const auto number = [](const Figure& figure) {
    return figure.heading.starts_with("Fig. ")
               ? std::stoi(figure.heading.substr(5))
               : kLast;
  };
  std::ranges::stable_sort(out, {}, number);
  return out;
}

}  // namespace brachisto::reproduction
