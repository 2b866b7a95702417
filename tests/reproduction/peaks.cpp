// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Peaks and valleys of a track in closed form.

#include "reproduction/peaks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>

#include "brachisto/study/solve.hpp"
#include "support/numbers.hpp"

namespace brachisto::reproduction {
namespace {

using testing::kPi;

/// z = x/3 + a sin 2πx from (0, 0) to (3, 1): with z down it turns downwards,
/// z'' > 0, in the second half of each unit.
struct Wave {
  double a = 0.05;

  [[nodiscard]] double z(double x) const {
    return x / 3.0 + a * std::sin(2.0 * kPi * x);
  }
  [[nodiscard]] double slope(double x) const {
    return 1.0 / 3.0 + 2.0 * kPi * a * std::cos(2.0 * kPi * x);
  }
  [[nodiscard]] double curvature(double x) const {
    const double bend = -4.0 * kPi * kPi * a * std::sin(2.0 * kPi * x);
    return bend / std::pow(1.0 + slope(x) * slope(x), 1.5);
  }
  /// Where the curvature is greatest between two places, times a sign.
  [[nodiscard]] double sharpest(double from, double to, double sign) const {
    double best = from;
    constexpr int kSteps = 100'000;
    for (int i = 0; i <= kSteps; ++i) {
      const double x = from + (to - from) * i / kSteps;
      if (sign * curvature(x) > sign * curvature(best)) best = x;
    }
    return best;
  }
};

TEST(Peaks, OfAWaveAreWhereItTurnsDownwards) {
  const Wave wave;
  Scene scene;
  scene.body = Body::bead();
  scene.L = 3.0;
  scene.H = 1.0;
  GivenPath path;
  path.curve = GivenPath::Curve::Track;
  path.shape = GivenPath::Shape::Points;
  constexpr int kPoints = 600;
  for (int i = 0; i <= kPoints; ++i) {
    const double x = 3.0 * i / kPoints;
    path.points.push_back({x, i == kPoints ? 1.0 : wave.z(x)});
  }
  scene.path = std::make_shared<const GivenPath>(std::move(path));
  const Solution solution = solve(scene);
  ASSERT_NE(solution.motion(), nullptr) << solution.message;

  const PeaksAndValleys found = peaks_and_valleys(*solution.motion());

  // Slope and curvature of a cubic spline with the step h are off by h³ and
  // h², here 1e-7 and 3e-5 times derivatives up to (2π)⁴ 0.05 = 80; the peak's
  // place is that of one of 2000 samples, 2e-3 apart.
  constexpr double kAngle = 1e-4;
  constexpr double kPlace = 5e-3;
  const double rise = std::atan(wave.slope(1.0)) - std::atan(wave.slope(0.5));
  ASSERT_EQ(found.peaks.size(), 3u);
  ASSERT_EQ(found.valleys.size(), 2u);
  for (std::size_t i = 0; i < found.peaks.size(); ++i) {
    const auto unit = static_cast<double>(i);
    EXPECT_NEAR(found.peaks[i].turn, rise, kAngle) << i;
    EXPECT_NEAR(found.peaks[i].top.x, unit + wave.sharpest(0.5, 1.0, 1.0),
                kPlace)
        << i;
  }
  EXPECT_NEAR(found.valleys[0].x, 1.0 + wave.sharpest(0.0, 0.5, -1.0), kPlace);
  EXPECT_NEAR(found.turn(), 3.0 * rise, 3.0 * kAngle);
}

TEST(Peaks, AreNotOnTheTrackOfAnAxisymmetricBody) {
  Scene scene;
  scene.body = Body::cylinder(1.0 / 3.0, 0.0, 0.0, 0.5);
  scene.L = 3.0;
  scene.H = 1.0;
  const Solution solution = solve(scene);
  ASSERT_TRUE(solution.verified()) << solution.message;

  const PeaksAndValleys found = peaks_and_valleys(*solution.motion());

  EXPECT_TRUE(found.peaks.empty());
  EXPECT_TRUE(found.valleys.empty());
  EXPECT_EQ(found.turn(), 0.0);
}

}  // namespace
}  // namespace brachisto::reproduction
