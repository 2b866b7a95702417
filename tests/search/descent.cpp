// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "search/descent.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "model/units.hpp"
#include "refinement/turn_meshes.hpp"
#include "search/continuation.hpp"
#include "solvers/inertia.hpp"
#include "transcription/prolongation.hpp"

namespace brachisto {
namespace {

Scene scene_of(double L) {
  Scene scene;
  scene.body = Body::cylinder(1.0 / 3.0, 2.0 / 3.0, 0.0, 0.5);
  scene.L = L;
  scene.H = 1.0;
  return in_natural_units(scene);
}

ContactCandidate principal(const Scene& scene) {
  const CycloidArc arc = *axisymmetric_optimum(scene);
  const Continuation found =
      continue_from_cycloid(scene, arc, coarse_mesh(scene, arc), {});
  return {found.curve.value(), found.phi};
}

double tau(const Scene& scene, const ContactCandidate& contact) {
  return contact.curve.transit_time() *
         std::sqrt(2.0 * scene.gravity / scene.H);
}

TEST(Descent, LeadsFromTheSaddleOfALongWayToTheMinimaBesideIt) {
  // The contacts as found by shooting backwards from B, which shares nothing
  // with the descent but the physics; on the coarse mesh to six digits or so.
  struct Expected {
    double tau, phi;
    double turns;  // from the saddle on
  };
  constexpr double kSaddle = 62.335649;
  constexpr double kCoarse = 1e-6 * kSaddle;
  constexpr double kTurn = 6.283185307179586;
  const Scene scene = scene_of(200.0);
  const ContactCandidate saddle = principal(scene);
  ASSERT_NEAR(tau(scene, saddle), kSaddle, kCoarse);

  const Descent descent = descend(scene, saddle, {});

  EXPECT_GT(descent.work.passes, 0);
  for (const Expected& expected : {Expected{62.284256, -1.0445, 0.5},
                                   Expected{62.351526, -1.0415, -0.5}}) {
    const auto found = std::find_if(
        descent.minima.begin(), descent.minima.end(),
        [&](const ContactCandidate& minimum) {
          return std::abs(tau(scene, minimum) - expected.tau) <= kCoarse;
        });
    ASSERT_NE(found, descent.minima.end()) << expected.tau;
    const ExtremalPoint end = found->curve.at(1.0);
    EXPECT_NEAR(found->phi, expected.phi, 1e-4);
    EXPECT_NEAR(end.beta, found->phi, 1e-9) << "the contact is smooth";
    EXPECT_NEAR((end.theta - saddle.curve.at(1.0).theta) / kTurn,
                expected.turns, 0.05);
    RollingTime problem(scene, found->curve.mesh(), found->phi);
    const Inertia inertia =
        kkt_inertia(problem, prolong(found->curve, problem));
    EXPECT_EQ(inertia.negative, problem.num_constraints());
    EXPECT_EQ(inertia.zero, 0);
  }
}

TEST(Descent, HasNowhereToGoFromAMinimum) {
  const Scene scene = scene_of(3.0);

  const Descent descent = descend(scene, principal(scene), {});

  EXPECT_TRUE(descent.minima.empty());
  EXPECT_EQ(descent.work.passes, 0);
}

}  // namespace
}  // namespace brachisto
