// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Principal extremals against values that were computed by another indirect
// method (single shooting, states x, w, θ) and confirmed by collocation.

#include <gtest/gtest.h>

#include <string>

#include "extremal/scenes.hpp"
#include "extremal/shooting.hpp"
#include "support/numbers.hpp"

namespace brachisto {
namespace {

using testing::kPi;
using testing::scene_of;

/// The values have 12 digits of τ and 10 of the rest; one is left as margin.
constexpr double kTimeTolerance = 1e-11;
constexpr double kFigureTolerance = 1e-9;

struct Row {
  const char* name;
  double L, r, eta_m, theta_m, k;
  double tau, path_length, start_angle, end_angle;
};

class Reference : public ::testing::TestWithParam<Row> {};

TEST_P(Reference, IsReproduced) {
  const Row& row = GetParam();
  const Scene scene =
      scene_of(Body::cylinder(row.r, row.eta_m, row.theta_m, row.k), row.L);

  const ExtremalSolution found = solve_extremal(scene);

  ASSERT_TRUE(found.solved()) << found.message;
  EXPECT_NEAR(found.tau / row.tau, 1.0, kTimeTolerance);
  EXPECT_NEAR(found.centre_path_length, row.path_length, kFigureTolerance);
  EXPECT_NEAR(found.start_angle, row.start_angle, kFigureTolerance);
  EXPECT_NEAR(found.phi, row.end_angle, kFigureTolerance);
  EXPECT_LT(found.error_estimate, 1e-13);
}

INSTANTIATE_TEST_SUITE_P(
    Table, Reference,
    ::testing::Values(
        Row{"base", 3.0, 1.0 / 3.0, 2.0 / 3.0, 0.0, 0.5, 5.093444466618,
            3.075522817639, 1.570796326795, -0.1078631701479},
        Row{"L2", 2.0, 1.0 / 3.0, 2.0 / 3.0, 0.0, 0.5, 3.904264219696,
            1.753895038452, 1.570796326795, -0.429085124025},
        Row{"L4", 4.0, 1.0 / 3.0, 2.0 / 3.0, 0.0, 0.5, 6.335557087985,
            4.81170195888, 1.570796326795, -0.385854963594},
        Row{"fast", 3.0, 1.0 / 3.0, 0.8, -kPi / 6.0, 0.1, 4.337613992601,
            3.263940123863, 1.955063432132, 0.123332492362},
        Row{"theta_up", 3.0, 1.0 / 3.0, 2.0 / 3.0, -kPi / 2.0, 0.5,
            5.250772194035, 3.370207295006, 1.97888432788, -0.1234246889093},
        Row{"theta_down", 3.0, 1.0 / 3.0, 2.0 / 3.0, kPi / 2.0, 0.5,
            6.101018360078, 3.040729791006, 1.16270832571, -0.5440037596743},
        Row{"small_radius", 3.0, 0.2, 2.0 / 3.0, 0.0, 0.5, 5.424799216979,
            3.204811428451, 1.570796326795, -0.1527046345562},
        Row{"large_radius", 3.0, 0.5, 2.0 / 3.0, 0.0, 0.5, 4.925534526943,
            2.362236254224, 1.570796326795, -0.6907787660369},
        Row{"rim", 3.0, 1.0 / 3.0, 0.7071067811865476, 0.0, 0.5, 5.119746384279,
            3.083457334468, 1.570796326795, -0.09288661625351}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Principal, IsFollowedToASmallRadius) {
  const Scene scene = scene_of(Body::cylinder(0.05, 2.0 / 3.0, 0.0, 0.5), 3.0);

  const ExtremalSolution found = solve_extremal(scene);

  ASSERT_TRUE(found.solved()) << found.message;
  EXPECT_NEAR(found.tau, 5.7071701888, 5e-10);
  EXPECT_NEAR(found.centre_path_length, 3.597843, 5e-7);
  EXPECT_NEAR(found.phi, -0.055025, 5e-7);
}

TEST(Principal, IsNotLeftForAFasterExtremal) {
  // Another smooth contact of this scene has τ = 6.2360317.
  const Scene scene =
      scene_of(Body::cylinder(0.4041, 0.458, -0.0867, 0.2594), 4.6395);

  const ExtremalSolution found = solve_extremal(scene);

  ASSERT_TRUE(found.solved()) << found.message;
  EXPECT_NEAR(found.tau, 6.3038676, 5e-8);
}

}  // namespace
}  // namespace brachisto
