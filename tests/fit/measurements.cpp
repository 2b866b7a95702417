// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "fit/measurements.hpp"

#include <gtest/gtest.h>

#include <string>

#include "brachisto/io/problem_file.hpp"
#include "fit/synthetic.hpp"

namespace brachisto {
namespace {

using namespace testing;
using fit::Measurements;
using fit::read_measurements_text;

std::string refusal(const std::string& text) {
  Scene scene = led_along(uniform_scene(), GivenPath::Shape::Straight);
  const PrescribedMotion motion(scene, centre_curve(scene));
  try {
    (void)fit::places_of(read_measurements_text(text, "m.csv"), motion);
  } catch (const io::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Measurements, HaveTheirColumnsInAnyOrder) {
  const Measurements read = read_measurements_text(
      "\xEF\xBB\xBFt, sigma ,s\r\n0.5,1/1000,1\r\n\r\n0.7,0.002,2\r\n",
      "m.csv");

  ASSERT_EQ(read.rows.size(), 2U);
  EXPECT_FALSE(read.by_x);
  EXPECT_TRUE(read.has_sigma());
  EXPECT_EQ(read.rows[0].t, 0.5);
  EXPECT_EQ(*read.rows[0].sigma, 0.001);
  EXPECT_EQ(read.rows[1].place, 2.0);
  EXPECT_EQ(read.rows[1].line, 4);
}

TEST(Measurements, AreRefusedWithFileAndLine) {
  const std::string head =
      "expected a line with the columns s or x, t and, if known, sigma, as in "
      "s,t,sigma";
  EXPECT_EQ(refusal("s,sigma\n"), "m.csv:1:1: there is no column t; " + head);
  EXPECT_EQ(refusal("t\n"), "m.csv:1:1: there is no column s or x; " + head);
  EXPECT_EQ(refusal("s,x,t\n"),
            "m.csv:1:1: there are both columns s and x; " + head);
  EXPECT_EQ(refusal("s,t,t\n"), "m.csv:1:5: \"t\" is named twice; " + head);
  EXPECT_NE(refusal("s,t,sgma\n").find("did you mean sigma?"),
            std::string::npos);
  EXPECT_EQ(refusal("s,t\n1,2,3\n"),
            "m.csv:2:1: \"1,2,3\" was read; expected 2 numbers s,t");
  for (const char* word : {"nan", "NaN", "inf", ""}) {
    const std::string told = refusal("s,t\n1,0.5\n2," + std::string(word));
    if (std::string(word).empty()) {
      EXPECT_EQ(told.substr(0, 12), "m.csv:3:3: t") << told;
      continue;
    }
    EXPECT_EQ(told.substr(0, 12), "m.csv:3:3: t") << told;
    EXPECT_NE(told.find("is not a number"), std::string::npos) << told;
  }
  for (const char* sigma : {"0", "1e-300", "1e+300"}) {
    EXPECT_EQ(refusal(std::string("s,t,sigma\n1,0.5,") + sigma + "\n"),
              std::string("m.csv:2:7: sigma: ") + sigma +
                  " was read; expected a number in s from 1e-12 to 1e+12");
  }
}

TEST(Measurements, GoAlongThePath) {
  EXPECT_EQ(refusal("s,t\n1,0.5\n2,0.4\n"),
            "m.csv:3:1: t = 0.4 s is not after t = 0.5 s of the place before; "
            "expected times that ascend along the path");
  EXPECT_EQ(refusal("s,t\n2,0.5\n1,0.6\n"),
            "m.csv:3:1: s = 1 m lies before that of the row above; expected "
            "rows along the path");
  EXPECT_EQ(refusal("s,t\n4,0.5\n"),
            "m.csv:2:1: s = 4 m lies beyond the path of the centre, which is "
            "3.16227766 m long");
  EXPECT_EQ(refusal("x,t\n-1,0.5\n"),
            "m.csv:2:1: x = -1 m lies beyond the path of the centre, which "
            "leads from x = 0 to 3 m");
}

TEST(Measurements, MayRepeatAPlace) {
  EXPECT_EQ(refusal("s,t\n1,0.5\n1,0.49\n2,0.7\n2,0.71\n"), "");
}

TEST(Measurements, HaveTheSamePlacesByX) {
  const Scene scene =
      led_along(uniform_scene(), GivenPath::Shape::CircularArc, 0.9);
  const PrescribedMotion motion(scene, centre_curve(scene));
  Measurements by_s{"m.csv", false, {}}, by_x{"m.csv", true, {}};
  for (const double q : {0.1, 0.5, 0.9, 1.0}) {
    const TrajectoryPoint at = motion.at(q);
    by_s.rows.push_back({2, at.s, at.t, {}});
    by_x.rows.push_back({2, at.centre.x, at.t, {}});
  }

  const auto from_s = fit::places_of(by_s, motion);
  const auto from_x = fit::places_of(by_x, motion);

  for (std::size_t i = 0; i < from_s.size(); ++i) {
    EXPECT_NEAR(from_s[i].q, from_x[i].q, 1e-12);
    EXPECT_NEAR(from_s[i].s, from_x[i].s, 1e-12);
  }
}

TEST(Measurements, BySAreNeededWhereXIsPassedTwice) {
  // The arc swings back beyond the vertical.
  Scene scene = led_along(uniform_scene(), GivenPath::Shape::CircularArc, 2.2);
  const PrescribedMotion motion(scene, centre_curve(scene));
  ASSERT_FALSE(motion.stall());
  const Measurements measured{"m.csv", true, {{2, -0.01, 0.5, {}}}};
  try {
    (void)fit::places_of(measured, motion);
    FAIL();
  } catch (const io::InputError& error) {
    EXPECT_STREQ(error.what(),
                 "m.csv:2:1: the centre passes x = -0.01 m 2 times; give its "
                 "place by s");
  }
}

}  // namespace
}  // namespace brachisto
