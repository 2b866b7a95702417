// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/progress.hpp"

#include <gtest/gtest.h>

#include <string>

#include "io/visible_text.hpp"
#include "report/letters.hpp"

namespace brachisto::sweep {
namespace {

Counts half_done() {
  Counts counts;
  counts.scenes = 2501;
  counts.verified = 1250;
  counts.failed = 1;
  return counts;
}

TEST(ProgressBar, HasRoomForABar) {
  EXPECT_EQ(progress_bar(half_done(), 10.0, 79),
            "[############            ] 1251/2501 scenes · 125/s · 10 s left · "
            "1 failed");
}

TEST(ProgressBar, FitsIntoEveryWidthAndBreaksNoCharacter) {
  for (std::size_t columns = 1; columns <= 120; ++columns) {
    const std::string bar = progress_bar(half_done(), 10.0, columns);

    EXPECT_LE(report::letters(bar), columns);
    // Half a character would be no UTF-8 and become visible.
    EXPECT_EQ(io::visible(bar), bar) << columns;
  }
}

TEST(ProgressBar, GivesWayToTheText) {
  const std::string text = progress_text(half_done(), 10.0);
  const std::size_t length = report::letters(text);

  EXPECT_EQ(progress_bar(half_done(), 10.0, length + 7), "[##  ] " + text);
  EXPECT_EQ(progress_bar(half_done(), 10.0, length + 6), text);
  EXPECT_TRUE(progress_bar(half_done(), 10.0, length - 1).ends_with("…"));
}

}  // namespace
}  // namespace brachisto::sweep
