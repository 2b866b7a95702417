// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Words of notes that would lie on each other.

#include "report/note_places.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace brachisto::report {
namespace {

// One pixel per unit, y up.
const PlotPixels kPlot{{0.0, 600.0, 0.0, 600.0, false},
                       {0.0, 400.0, 400.0, 0.0, false}};
constexpr double kLetter = 13.0;  // height of letters [px]

Note note(double x, double y) {
  Note out;
  out.at = {x, y};
  out.text = "some words";
  return out;
}

TEST(NotePlaces, WordsAloneStandBesideTheirMark) {
  const std::vector<Note> placed = apart({note(300.0, 200.0)}, kPlot);

  EXPECT_GT(placed[0].dx, 0.0);
  EXPECT_EQ(placed[0].dy, 0.0);
}

TEST(NotePlaces, WordsDoNotLeaveThePlot) {
  const std::vector<Note> placed = apart({note(590.0, 200.0)}, kPlot);

  EXPECT_LT(placed[0].dx, 0.0) << "they end at the mark";
}

TEST(NotePlaces, WordsAtOnePlaceMoveApart) {
  const std::vector<Note> placed =
      apart(std::vector<Note>(5, note(300.0, 200.0)), kPlot);

  for (std::size_t i = 0; i < placed.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const bool one_side = (placed[i].dx > 0.0) == (placed[j].dx > 0.0);
      EXPECT_TRUE(!one_side || std::abs(placed[i].dy - placed[j].dy) >= kLetter)
          << i << " and " << j;
    }
  }
}

}  // namespace
}  // namespace brachisto::report
