// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/axis.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "report/colour_map.hpp"

namespace brachisto::report {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::Pointwise;

constexpr double kRounding = 1e-12;

TEST(TickStep, IsARoundNumber) {
  EXPECT_DOUBLE_EQ(tick_step(1.0, 10), 0.1);
  EXPECT_DOUBLE_EQ(tick_step(1.0, 7), 0.2);
  EXPECT_DOUBLE_EQ(tick_step(30.0, 8), 5.0);
  EXPECT_DOUBLE_EQ(tick_step(70.0, 8), 10.0);
}

TEST(Axis, HasRoundTicksWithinIt) {
  const Axis axis(Scale::Linear, -0.13, 0.7, 0.0, 100.0);

  EXPECT_THAT(axis.ticks(5),
              Pointwise(DoubleNear(kRounding), {0.0, 0.2, 0.4, 0.6}));
  EXPECT_FALSE(std::signbit(axis.ticks(5)[0]));
}

TEST(Axis, KeepsTheTicksAtItsEnds) {
  const Axis axis(Scale::Linear, 0.0, 0.3, 0.0, 1.0);

  EXPECT_THAT(axis.ticks(3),
              Pointwise(DoubleNear(kRounding), {0.0, 0.1, 0.2, 0.3}));
}

TEST(Axis, OfDegreesHasPartsOfATurn) {
  EXPECT_THAT(Axis(Scale::Degrees, -180.0, 180.0, 0.0, 1.0).ticks(7),
              ElementsAre(-180.0, -120.0, -60.0, 0.0, 60.0, 120.0, 180.0));
  EXPECT_THAT(Axis(Scale::Degrees, -90.0, 90.0, 0.0, 1.0).ticks(7),
              ElementsAre(-90.0, -60.0, -30.0, 0.0, 30.0, 60.0, 90.0));
  EXPECT_THAT(Axis(Scale::Degrees, 0.0, 10.0, 0.0, 1.0).ticks(5),
              ElementsAre(0.0, 2.0, 4.0, 6.0, 8.0, 10.0));
}

TEST(Axis, OfLogarithmsHasDecades) {
  const Axis axis(Scale::Logarithmic, -1.0, 2.0, 0.0, 300.0);

  EXPECT_DOUBLE_EQ(axis(0.1), 0.0);
  EXPECT_DOUBLE_EQ(axis(10.0), 200.0);
  EXPECT_THAT(axis.ticks(3),
              Pointwise(DoubleNear(kRounding), {0.1, 1.0, 10.0, 100.0}));
}

TEST(Axis, OfNoLengthStillHasPixels) {
  const Axis point(Scale::Linear, 3.0, 3.0, 0.0, 100.0);
  const Axis nothing(Scale::Linear, std::numeric_limits<double>::infinity(),
                     -std::numeric_limits<double>::infinity(), 0.0, 100.0);

  EXPECT_DOUBLE_EQ(point(3.0), 50.0);
  EXPECT_FALSE(point.ticks(5).empty());
  EXPECT_TRUE(std::isfinite(nothing(0.0)));
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

TEST(Lightness, RunsFromBlackToWhite) {
  EXPECT_NEAR(lightness({0.0, 0.0, 0.0}), 0.0, 1e-12);
  EXPECT_NEAR(lightness({255.0, 255.0, 255.0}), 100.0, 1e-12);
  // L* of the middle grey of sRGB, CIE.
  EXPECT_NEAR(lightness({119.0, 119.0, 119.0}), 50.03, 0.01);
}

}  // namespace
}  // namespace brachisto::report
