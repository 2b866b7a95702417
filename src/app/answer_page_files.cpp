// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "app/answer_page_files.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "plot/answer_page.hpp"
#include "plot/motion_data.hpp"

namespace brachisto::app {

PageFiles page_files(const report::Json& result, const Scene& scene,
                     std::string_view csv, bool gif,
                     const std::atomic<int>& signal) {
  const auto table = plot::TrajectoryTable::read(csv);
  PageFiles out;
  if (gif) {
    report::DrawnFigure drawn = report::draw(plot::moving_figure(scene, table),
                                             report::Format::Gif, &signal);
    out.files = std::move(drawn.files);
    out.missing = std::move(drawn.missing);
  }
  out.files.push_back({"index.html", plot::answer_page(result, scene, table)});
  return out;
}

std::vector<std::string> page_file_names() {
  return {"index.html", "motion.csv", "motion.gp", "motion.gif"};
}

}  // namespace brachisto::app
