// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "proof/plain_system.hpp"

#include <cmath>
#include <utility>

#include "extremal/shooting.hpp"
#include "model/start_angle.hpp"
#include "model/units.hpp"

namespace brachisto::proof {

namespace {

Real inertia(const Scene& scene, const Real& theta, const Real& beta) {
  const Real root = inertia_root(scene, theta, beta);
  return root * root;
}

// A cos β = a η cos(θ_m − β), a = sin β + η cos θ_m, by Newton's operator on
// an interval about the angle of 64 bits; with A_β = 2 η cos(θ_m − β),
// d/dβ (A cos β − a η cos δ) = η cos δ cos β − A sin β − a η sin δ.
Real enclosed_start_angle(const Scene& scene) {
  const Body& body = scene.body;
  const Real half_pi = Real::pi() * Real(0.5);
  if (!body.off_centred() || body.theta_m == 0.0) return half_pi;
  constexpr double kRadius = 1e-12;
  constexpr int kSteps = 12;
  const Real theta(body.theta_m), eta(body.eta_m);
  const auto newton = [&](const Real& box, bool& inside) {
    const auto terms = [&](const Real& beta) {
      return std::array{inertia(scene, theta, beta),
                        sin(beta) + eta * cos(theta), theta - beta};
    };
    const Real middle = box.middle();
    const auto [A, a, delta] = terms(middle);
    const Real value = A * cos(middle) - a * eta * cos(delta);
    const auto [A_box, a_box, delta_box] = terms(box);
    const Real slope = eta * cos(delta_box) * cos(box) - A_box * sin(box) -
                       a_box * eta * sin(delta_box);
    const Real next = middle - value / slope;
    inside = next.finite() && !slope.has_zero() && a_box.positive() &&
             next.inside(box);
    return next;
  };
  Real box = Real(brachisto::start_angle(body)).widened(Real(kRadius));
  bool inside = false;
  Real next = newton(box, inside);
  if (!inside) throw NotProven("the start angle is not enclosed");
  for (int i = 0; i < kSteps && inside; ++i) {
    box = next;
    next = newton(box, inside);
  }
  return box;
}

}  // namespace

std::string not_of_this_kind(const Scene& scene) {
  if (scene.world.losses.any()) {
    return "losses in proportion to the load, whose formulas have exponentials";
  }
  if (scene.path) return "given paths";
  if (scene.body.ball) return "balls";
  return "";
}

PlainSystem::PlainSystem(const Scene& scene)
    : scene_(scene),
      radius_(scene.body.rolls() && scene.contact == Contact::Smooth ? 1.0
                                                                     : 0.0) {
  const Real theta(scene.body.theta_m);
  beta_ = enclosed_start_angle(scene);
  // 𝓗 = √A + p_w g a = 0 at rest, g = 1/2.
  const Real a = sin(beta_) + Real(scene.body.eta_m) * cos(theta);
  p_w_ = -inertia_root(scene, theta, beta_) * Real(2.0) / a;
  if (!p_w_.finite()) throw NotProven("the start has no growth of speed");
}

ShootingSystem::Value PlainSystem::evaluate(const Vector& at,
                                            const Accuracy& accuracy,
                                            bool with_slopes) const {
  const int directions = with_slopes ? 3 : 0;
  Flow flow(scene_, directions, accuracy);
  State end = start(at, directions);
  Value out;
  out.steps = flow.go(end, at.back());
  out.rates = {flow.rates(end)};
  out.missed = missed(end);
  if (with_slopes) out.slopes = slopes(end, out.rates.front());
  out.ends = {std::move(end)};
  return out;
}

Real PlainSystem::unit() const {
  return Real(scene_.body.rolls() ? scene_.body.radius : 1.0);
}

State PlainSystem::start(const Vector& unknowns, int directions) const {
  State state(kComponents * static_cast<std::size_t>(1 + directions));
  state[kTheta] = Real(scene_.body.theta_m);
  state[kPx] = unknowns[0];
  state[kPz] = unknowns[1];
  state[kPtheta] = unknowns[2];
  state[kPw] = p_w_;
  state[kBeta] = beta_;
  if (directions > 0) {
    state[Equations::place(kPx, 0)] = Real(1.0);
    state[Equations::place(kPz, 1)] = Real(1.0);
    state[Equations::place(kPtheta, 2)] = Real(1.0);
  }
  return state;
}

// The centre starts at (r sin β₀, −r cos β₀) and ends at
// (L + r sin β, H − r cos β).
Vector PlainSystem::missed(const State& end) const {
  const Real r(radius_);
  const Real x = end[kX] + r * (sin(beta_) - sin(end[kBeta]));
  const Real z = end[kZ] - r * (cos(beta_) - cos(end[kBeta]));
  return {x - Real(scene_.L) / unit(), z - Real(scene_.H) / unit(),
          end[kPtheta], end[kPw]};
}

Matrix PlainSystem::slopes(const State& end, const State& rates) const {
  const Real r(radius_);
  const Real c = r * cos(end[kBeta]), s = r * sin(end[kBeta]);
  Matrix out(kUnknowns, Vector(kUnknowns));
  for (std::size_t j = 0; j < kUnknowns; ++j) {
    const auto by = [&](std::size_t component) {
      return j + 1 < kUnknowns ? end[Equations::place(component, j)]
                               : rates[component];
    };
    out[0][j] = by(kX) - c * by(kBeta);
    out[1][j] = by(kZ) - s * by(kBeta);
    out[2][j] = by(kPtheta);
    out[3][j] = by(kPw);
  }
  return out;
}

Vector approximation(const Scene& scene) {
  const ExtremalSolution found = solve_extremal(scene);
  if (!found.usable()) throw NotProven("no extremal: " + found.message);
  const double length = scene.body.rolls() ? scene.body.radius : 1.0;
  const double time = std::sqrt(length / (2.0 * scene.gravity));
  const double p_theta =
      scene.body.off_centred() ? found.path.at(0.0).p_theta / time : 0.0;
  return {Real(found.p_x * length / time), Real(found.p_z * length / time),
          Real(p_theta), Real(found.rolling_time / time)};
}

}  // namespace brachisto::proof
