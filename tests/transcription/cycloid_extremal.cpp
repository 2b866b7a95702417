// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The cycloid with its multipliers is where every continuation starts.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "brachisto/nlp/problem.hpp"
#include "support/observed_order.hpp"
#include "support/rounding.hpp"
#include "support/scenes.hpp"
#include "transcription/contact_equation.hpp"
#include "transcription/initial_guess.hpp"

namespace brachisto::testing {
namespace {

/// The uniform cylinder as an off-centred one, its θ among the unknowns.
Scene nearly_uniform() {
  Scene scene = natural(uniform_scene());
  scene.body.eta_m = 1e-14;
  return scene;
}

TEST(CycloidExtremal, SatisfiesTheOptimalityConditionsToTheOrderOfTheMesh) {
  // Interpolated states miss the slopes at Gauss points by h^{p+1}, an integral
  // over h: defects of order p + 2, as in the tests of the guess. Multipliers
  // are exact at the points; that the sum over them stands for an integral
  // against polynomials of degree p makes p + 1 or more in stationarity.
  for (const Scene& scene :
       {natural(bead_scene()), natural(uniform_scene()), nearly_uniform()}) {
    const CycloidArc arc = *axisymmetric_optimum(scene);
    const double phi = arc.slope_angle(arc.psi_end);
    for (int p = 1; p <= 5; ++p) {
      std::array<double, 4> h{}, defects{}, stationarity{};
      for (std::size_t level = 0; level < h.size(); ++level) {
        const int elements = 3 << level;
        RollingTime problem(scene, uniform_mesh(p, elements), phi);

        const PrimalDual point = cycloid_extremal(problem, arc);

        const nlp::KktResidual residual = nlp::kkt_residual(problem, point);
        h[level] = 1.0 / elements;
        defects[level] = residual.infeasibility;
        stationarity[level] = residual.stationarity;
        EXPECT_LE(residual.bound_violation, ulps(20.0));
      }

      EXPECT_NEAR(observed_order(h, defects), p + 2.0, 0.5) << "degree " << p;
      EXPECT_GE(observed_order(h, stationarity), p + 0.5)
          << "degree " << p << ": " << stationarity.front() << " … "
          << stationarity.back();
      // It is the whole condition that falls: far below the size of its terms.
      EXPECT_LE(stationarity.back(), p == 1 ? 1e-2 : 1e-3) << "degree " << p;
    }
  }
}

TEST(CycloidExtremal, ClosesTheContact) {
  for (const Scene& scene :
       {natural(bead_scene()), natural(uniform_scene()), nearly_uniform()}) {
    const CycloidArc arc = *axisymmetric_optimum(scene);
    const double phi = arc.slope_angle(arc.psi_end);
    RollingTime problem(scene, uniform_mesh(3, 8), phi);
    ContactEquation contact(problem);
    const PrimalDual point = cycloid_extremal(problem, arc);

    contact.set_parameter(phi);

    // p_x and p_z are exact, w at the end too: (p_x, p_z) ∥ (cos φ, sin φ).
    EXPECT_NEAR(contact.linearise(point.x, point.lambda).residual, 0.0,
                ulps(50.0));
  }
}

TEST(CycloidExtremal, IsTheCycloidGuessWithMultipliers) {
  const Scene scene = natural(uniform_scene());
  const CycloidArc arc = *axisymmetric_optimum(scene);
  const RollingTime problem(scene, uniform_mesh(4, 6), 0.0);

  EXPECT_EQ(cycloid_extremal(problem, arc).x, cycloid_guess(problem, arc).x);
  EXPECT_TRUE(cycloid_guess(problem, arc).lambda.empty());
}

}  // namespace
}  // namespace brachisto::testing
