// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/track_kind.hpp"

#include <gtest/gtest.h>

#include "support/scenes.hpp"
#include "support/world_scenes.hpp"

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
            "|R_t| ≤ 0.5 R_n, R_n ≥ 0.1 m g, κ_b ≥ −2 1/m, 1 − r κ_c ≥ 0.25, "
            "floor at z = 1.2 m, clear of 1 disc");

  scene.limits = {};
  scene.limits.normal_min = 0.1;
  scene.limits.normal_max = 5.0;
  scene.limits.curvature = {3.0, 2.0, CurvatureLimit::Of::Centre};
  scene.limits.half_planes = {{{4.0, 0.0}, kPi}, {{-1.0, 0.0}, 0.0}};
  EXPECT_EQ(limits_in_words(scene),
            "R_n from 0.1 to 5 m g, κ_c from −2 to 3 1/m, clear of 2 "
            "half-planes");
}

TEST(TrackKind, TellsOfOtherWorlds) {
  Scene scene = bead_scene();
  EXPECT_EQ(report::in_words(scene), "bead; L = 3 m, H = 1 m, g = 9.81 m/s²");

  scene = in_air(with_push(about_sphere(scene, below()), 1.5), 0.1, 0.2);
  EXPECT_EQ(report::in_words(scene),
            "bead; L = 3 m, H = 1 m, g = 8.64865 m/s² at A of a sphere of 4 m "
            "about (1, 6), v_0 = 1.5 m/s, drag 0.1/s v + 0.2/m v²");
}

}  // namespace
}  // namespace brachisto::testing
