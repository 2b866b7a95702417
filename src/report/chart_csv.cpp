// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <iterator>

#include "report/chart_layout.hpp"
#include "report/csv.hpp"

namespace brachisto::report {

std::string chart_csv(const Chart& chart) {
  const ChartIds ids = chart_ids(chart);
  std::string out = "curve,x,y\n";
  const auto rows = [&](const std::string& id,
                        const std::vector<Datum>& points) {
    const std::string field = csv_field(id);
    for (const Datum& p : points) {
      fmt::format_to(std::back_inserter(out), "{},{:.12g},{:.12g}\n", field,
                     p.x, p.y);
    }
  };
  for (std::size_t i = 0; i < chart.areas.size(); ++i) {
    rows(ids.areas[i], chart.areas[i].outline);
  }
  for (std::size_t i = 0; i < chart.curves.size(); ++i) {
    rows(ids.curves[i], chart.curves[i].points);
  }
  return out;
}

}  // namespace brachisto::report
