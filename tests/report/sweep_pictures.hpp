// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Maps of whole sweeps, and pictures as they are drawn.

#pragma once

#include <gtest/gtest.h>

#include <string>

#include "report/sweep_plots.hpp"
#include "report/xml.hpp"

namespace brachisto::testing {

/// The map of all scenes of a sweep of two axes.
[[nodiscard]] inline report::SweepMap whole(const SweepTable& table) {
  return {.name = "map",
          .first = 0,
          .second = 1,
          .n_first = table.axes[0].count,
          .n_second = table.axes[1].count,
          .scenes = report::all_scenes(table)};
}

/// The picture; it has to be drawn and well formed.
[[nodiscard]] inline std::string svg_of(const report::Figure& figure) {
  const report::DrawnFiles drawn =
      report::draw(figure, report::Format::Svg, nullptr);
  EXPECT_EQ(drawn.missing, "") << figure.commands;
  EXPECT_EQ(xml_flaw(drawn.files.back().content), "");
  return drawn.files.back().content;
}

}  // namespace brachisto::testing
