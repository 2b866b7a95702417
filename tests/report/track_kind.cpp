// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/track_kind.hpp"

#include <gtest/gtest.h>

#include "support/scenes.hpp"

namespace brachisto::testing {
namespace {

using report::limits_in_words;

TEST(LimitsInWords, SayEveryBoundAndMakeTwoARange) {
  Scene scene = uniform_scene();
  EXPECT_EQ(limits_in_words(scene), "");

  scene.limits.friction = 0.5;
  scene.limits.normal_min = 0.1;
  scene.limits.curvature.valley = 2.0;
  scene.limits.fold_margin = 0.25;
  scene.limits.floor = 1.2;
  scene.limits.discs = {{{1.0, 2.0}, 0.5}};
  EXPECT_EQ(limits_in_words(scene),
            "|R_t| ≤ 0.5 R_n, R_n ≥ 0.1 m g, κ_b ≥ -2 1/m, 1 − r κ_c ≥ 0.25, "
            "floor at z = 1.2 m, clear of 1 disc");

  scene.limits = {};
  scene.limits.normal_min = 0.1;
  scene.limits.normal_max = 5.0;
  scene.limits.curvature = {3.0, 2.0, CurvatureLimit::Of::Centre};
  scene.limits.half_planes = {{{4.0, 0.0}, kPi}, {{-1.0, 0.0}, 0.0}};
  EXPECT_EQ(limits_in_words(scene),
            "R_n from 0.1 to 5 m g, κ_c from -2 to 3 1/m, clear of 2 "
            "half-planes");
}

}  // namespace
}  // namespace brachisto::testing
