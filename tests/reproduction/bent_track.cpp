// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Without limits there is no fastest track: docs/theory.md, section 3.

#include "reproduction/bent_track.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "reproduction/no_signal.hpp"

namespace brachisto::reproduction {
namespace {

using testing::kNoSignal;

// Of the time on a spline.
constexpr double kTolerance = 1e-8;

// Of the reference case, by an indirect method made elsewhere.
constexpr double kSmoothContact = 5.093444466618;
// inf V(φ), which is not attained (section 3).
constexpr double kInfimum = 4.5579;

Scene reference_scene() {
  Scene scene;
  scene.body = Body::cylinder(1.0 / 3.0, 2.0 / 3.0, 0.0, 0.5);
  scene.L = 3.0;
  scene.H = 1.0;
  return scene;
}

TEST(BentTrack, IsFasterThanTheSmoothContactAndFeasible) {
  constexpr double kPhi = -0.8;
  constexpr double kRadius = 0.1;
  const Scene bent = bent_track(reference_scene(), kPhi, kRadius, kNoSignal);

  const Solution solution = verified_solution(bent, kNoSignal, kTolerance);

  EXPECT_TRUE(solution.feasible());
  EXPECT_LT(solution.motion()->tau(), kSmoothContact - 0.3);
  EXPECT_GT(solution.motion()->tau(), kInfimum);
  const TrajectoryPoint end = solution.motion()->at(1.0);
  EXPECT_NEAR(end.motion.contact.x, 3.0, 1e-9);
  EXPECT_NEAR(end.motion.contact.z, 1.0, 1e-9);
  // A spline through points on an arc of 0.35, 3e-3 apart, turns by as much.
  EXPECT_NEAR(end.beta, kPhi, 1e-3);
}

/// From next to the smooth contact, at −0.108 rad, on: the track fits the body
/// at its start, where it has the radius of the body itself.
TEST(BentTrack, IsATrackForEveryBend) {
  double last = kSmoothContact;
  for (const double phi : {-0.11, -0.15, -0.2, -0.4, -0.6, -0.8}) {
    const Solution solution =
        verified_solution(bent_track(reference_scene(), phi, 0.1, kNoSignal),
                          kNoSignal, kTolerance);

    EXPECT_TRUE(solution.feasible()) << phi;
    EXPECT_LT(solution.motion()->tau(), last) << phi;
    EXPECT_GT(solution.motion()->tau(),
              tau_of_kinked_track(reference_scene(), phi, kNoSignal))
        << phi;
    last = solution.motion()->tau();
  }
}

TEST(BentTrack, IsTheFasterTheSharperItBends) {
  double last = kSmoothContact;
  for (const double radius : {0.4, 0.2, 0.1, 0.06}) {
    const double tau = verified_solution(bent_track(reference_scene(), -0.8,
                                                    radius, kNoSignal),
                                         kNoSignal, kTolerance)
                           .motion()
                           ->tau();

    EXPECT_LT(tau, last) << radius;
    last = tau;
  }
}

/// The limits of docs/theory.md, section 3: without a kink the smooth contact,
/// and inf V.
TEST(KinkedTrack, RunsFromTheSmoothContactToTheInfimum) {
  const Scene scene = reference_scene();
  const double smooth =
      verified_solution(scene, kNoSignal).motion()->end_angle();
  constexpr double kLeast = -1.768;  // as printed there
  constexpr double kPrinted = 0.5e-4;

  EXPECT_NEAR(tau_of_kinked_track(scene, smooth, kNoSignal), kSmoothContact,
              1e-11);
  EXPECT_NEAR(tau_of_kinked_track(scene, kLeast, kNoSignal), kInfimum,
              kPrinted);
}

TEST(KinkedTrack, IsFasterThanAnyArcToTheSameSlope) {
  constexpr double kPhi = -0.8;
  const double arc =
      verified_solution(bent_track(reference_scene(), kPhi, 0.06, kNoSignal),
                        kNoSignal, kTolerance)
          .motion()
          ->tau();

  EXPECT_LT(tau_of_kinked_track(reference_scene(), kPhi, kNoSignal), arc);
}

}  // namespace
}  // namespace brachisto::reproduction
