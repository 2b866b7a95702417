// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The motion along the found track, integrated anew: Lagrange's equation of a
// body with one degree of freedom in physical time, by another integrator.

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <cstdint>
#include <vector>

#include "brachisto/study/solve.hpp"
#include "study/answer_kinds.hpp"
#include "support/reference_values.hpp"

namespace brachisto {
namespace {

using State = std::vector<double>;  // s, ds/dt

/// Kinetic energy ½ m A(s) ṡ² and potential energy −m g E(s) give
///
///     d/dt (A ṡ) − ½ A_s ṡ² = g E_s,  so  s̈ = (g E_s − ½ A_s ṡ²)/A,
///
/// where the track enters as β(s) alone: θ = θ_m + s/r, E_s = sin β + η cos θ,
/// A = 1 + η² + k − 2η sin(θ − β).
class RollingBody {
 public:
  explicit RollingBody(const Trajectory& path)
      : path_(path), body_(path.scene().body) {}

  /// State after a time t so short that the acceleration, that of the body at
  /// rest, is constant. (A_s is infinite at s = 0, like 1/√s.)
  [[nodiscard]] State released_for(double t) const {
    const double beta = path_.start_angle();
    const double acceleration =
        path_.scene().gravity *
        (std::sin(beta) + body_.eta_m * std::cos(body_.theta_m)) /
        inertia(body_.theta_m, beta);
    return {0.5 * acceleration * t * t, acceleration * t};
  }

  void operator()(const State& state, State& rate, double /*t*/) const {
    const double sigma = sigma_at(state[0]);
    const double beta = path_.at(sigma).beta;
    const double theta = body_.theta_m + state[0] / body_.radius;
    const double slope = std::sin(beta) + body_.eta_m * std::cos(theta);
    const double v = state[1];
    rate = {v, (path_.scene().gravity * slope - 0.5 * dA_ds(sigma) * v * v) /
                   inertia(theta, beta)};
  }

 private:
  [[nodiscard]] double inertia(double theta, double beta) const {
    return 1.0 + body_.eta_m * body_.eta_m + body_.k -
           2.0 * body_.eta_m * std::sin(theta - beta);
  }
  [[nodiscard]] double inertia(double sigma) const {
    const TrajectoryPoint at = path_.at(sigma);
    return inertia(body_.theta_m + at.s / body_.radius, at.beta);
  }
  /// s(σ) inverted: s grows like σ², so it is √s that is nearly straight.
  [[nodiscard]] double sigma_at(double s) const {
    if (s <= 0.0) return 0.0;
    // A Runge–Kutta stage may look a little beyond the end.
    constexpr double kUpper = 1.01;
    std::uintmax_t iterations = 60;
    const auto bracket = boost::math::tools::toms748_solve(
        [&](double sigma) {
          return std::sqrt(std::max(0.0, path_.at(sigma).s)) - std::sqrt(s);
        },
        0.0, kUpper, boost::math::tools::eps_tolerance<double>(50), iterations);
    return 0.5 * (bracket.first + bracket.second);
  }
  /// By differences of fourth order in σ, one-sided next to the start.
  [[nodiscard]] double dA_ds(double sigma) const {
    const auto slope = [&](auto&& f) {
      const auto at = [&](double steps) { return f(sigma + steps * kStep); };
      return sigma < 2.0 * kStep ? -25.0 * at(0) + 48.0 * at(1) - 36.0 * at(2) +
                                       16.0 * at(3) - 3.0 * at(4)
                                 : 8.0 * (at(1) - at(-1)) - (at(2) - at(-2));
    };
    return slope([&](double q) { return inertia(q); }) /
           slope([&](double q) { return path_.at(q).s; });
  }

  static constexpr double kStep = 5e-4;
  const Trajectory& path_;
  Body body_;
};

TEST(Reintegration, InPhysicalTimeArrivesOnTimeWithTheSameSpeed) {
  // A fine mesh, so that β between nodes, of order p + 1, is no limit.
  SolveOptions options;
  Discretisation& mesh = options.use<Collocation>().discretisation;
  mesh.degree = 8;
  mesh.elements = 40;
  const Solution solution =
      solve(testing::reference("theta_-30").scene(), options);
  ASSERT_TRUE(solution.verified()) << solution.message;
  const Trajectory& path = *trajectory_of(solution);
  const double T = path.transit_time();
  constexpr double kIntegrator = 1e-11;
  constexpr double kRelease = 1e-5;  // share of T
  const RollingBody body(path);
  State state = body.released_for(kRelease * T);

  namespace odeint = boost::numeric::odeint;
  odeint::integrate_adaptive(
      odeint::make_controlled<odeint::runge_kutta_fehlberg78<State>>(
          kIntegrator, kIntegrator),
      body, state, kRelease * T, T, 0.1 * kRelease * T);

  // The released state lacks the change of the acceleration, a relative error
  // of kRelease times its rate, which is some tens per T; so the motion is out
  // of step by that share of kRelease T, 1e-10 · C with C below a hundred. (The
  // differences of fourth order err by some δ⁴/30 times a fifth derivative of
  // A in σ of at most 30⁵/4, below 1e-8 and of both signs along the way.)
  constexpr double kTolerance = 100.0 * kRelease * kRelease;
  const double v_end = path.at(1.0).motion.v_c;
  const double late_by = (path.centre_path_length() - state[0]) / v_end;
  EXPECT_NEAR(late_by / T, 0.0, kTolerance);
  EXPECT_NEAR(state[1], v_end, kTolerance * v_end);
}

}  // namespace
}  // namespace brachisto
