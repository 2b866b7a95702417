// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/scale.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace brachisto::report {
namespace {

/// CIE lightness L*, 0 for black, 100 for white, from the intensities of sRGB
/// (IEC 61966-2-1).
double lightness(const Colour& colour) {
  const auto intensity = [](double component) {
    const double c = component / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  const double luminance = 0.2126 * intensity(colour[0]) +
                           0.7152 * intensity(colour[1]) +
                           0.0722 * intensity(colour[2]);
  constexpr double kLinearBelow = 216.0 / 24389.0;  // CIE 15
  return luminance <= kLinearBelow ? luminance * 24389.0 / 27.0
                                   : 116.0 * std::cbrt(luminance) - 16.0;
}

TEST(SuitableScale, IsLogarithmicForWhatIsSpacedSo) {
  EXPECT_EQ(suitable_scale({0.1, 1.0, 10.0, 100.0}), Scale::Logarithmic);
  EXPECT_EQ(suitable_scale({0.1, 33.0, 66.0, 100.0}), Scale::Linear);
  EXPECT_EQ(suitable_scale({1.0, 2.0, 4.0, 8.0}), Scale::Linear);
  EXPECT_EQ(suitable_scale({0.0, 1.0, 10.0, 100.0}), Scale::Linear);
  EXPECT_EQ(suitable_scale({-1.0, 1.0}), Scale::Linear);
  EXPECT_EQ(suitable_scale({}), Scale::Linear);
}

TEST(Printed, HasARealMinusSign) {
  EXPECT_EQ(printed(-30.0), "−30");
  EXPECT_EQ(printed(1e-10), "1e−10");
  EXPECT_EQ(printed(-3e-9), "−3e−9");
  EXPECT_EQ(printed(1e6, 2), "1e6");
  EXPECT_EQ(printed(2.5e120), "2.5e120");
  EXPECT_EQ(printed(-0.0), "0");
  EXPECT_EQ(printed(0.1 + 0.2), "0.3");
}

TEST(ColourMap, GrowsLighterInEqualSteps) {
  constexpr int kSteps = 256;
  const double mean =
      (lightness(colour_at(1.0)) - lightness(colour_at(0.0))) / kSteps;
  for (int i = 0; i < kSteps; ++i) {
    const double step =
        lightness(colour_at(static_cast<double>(i + 1) / kSteps)) -
        lightness(colour_at(static_cast<double>(i) / kSteps));

    EXPECT_GT(step, 0.6 * mean) << i;
    EXPECT_LT(step, 1.4 * mean) << i;
  }
}

TEST(ColourMap, EndsAtItsEnds) {
  EXPECT_EQ(hex(colour_at(0.0)), "#440154");
  EXPECT_EQ(hex(colour_at(1.0)), "#fde725");
  EXPECT_EQ(colour_at(-1.0), colour_at(0.0));
  EXPECT_EQ(colour_at(2.0), colour_at(1.0));
}

}  // namespace
}  // namespace brachisto::report
