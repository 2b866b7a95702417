// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Times on tracks from closed forms.

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "brachisto/math/polynomial_basis.hpp"
#include "fit/fit_times.hpp"
#include "math/portable_random.hpp"
#include "model/centre_curve.hpp"
#include "support/scenes.hpp"

namespace brachisto::testing {

/// The scene with its centre led from A to B.
[[nodiscard]] inline Scene led_along(Scene scene, GivenPath::Shape shape,
                                     double start_angle = 1.2) {
  auto path = std::make_shared<GivenPath>();
  path->curve = GivenPath::Curve::Centre;
  path->shape = shape;
  if (path->has_start_angle()) path->start_angle = start_angle;
  scene.path = std::move(path);
  scene.contact = Contact::Centre;
  return scene;
}

/// t after the length s on an incline: √(2 s (1 + k)/(g (sin β − c cos β))).
[[nodiscard]] inline double time_on_incline(const Scene& scene, double s) {
  const double slope = std::atan2(scene.H, scene.L);
  const double c = scene.world.losses.factor(scene.body);
  const double pull = scene.gravity * (std::sin(slope) - c * std::cos(slope));
  return std::sqrt(2.0 * s * (1.0 + scene.body.k) / pull);
}

/// A circular valley from A to B.
struct Arc {
  double beta_0, radius, length;

  explicit Arc(const Scene& scene) : beta_0(*scene.path->start_angle) {
    const double half = beta_0 - std::atan2(scene.H, scene.L);
    radius = 0.5 * std::hypot(scene.L, scene.H) / std::sin(half);
    length = 2.0 * half * radius;
  }
};

/// t after the length s on an arc, of a body without an offset: with y = v²
///
///     (1 + k) dy/ds = 2 (g sin β − c (g cos β + y/R)),  β = β₀ − s/R,
///
/// is linear in y, and t = ∫ ds/√y is smooth in √s.
[[nodiscard]] inline double time_on_arc(const Scene& scene, double s) {
  const Arc arc(scene);
  const double inertia = 1.0 + scene.body.k;
  const double c = scene.world.losses.factor(scene.body);
  const double lambda = 2.0 * c / inertia;
  const double K = 2.0 * arc.radius * scene.gravity / inertia;
  const double P = K * (lambda + c) / (1.0 + lambda * lambda);
  const double Q = K - lambda * P;
  const auto particular = [&](double beta) {
    return P * std::sin(beta) + Q * std::cos(beta);
  };
  const auto y = [&](double length) {
    const double beta = arc.beta_0 - length / arc.radius;
    return particular(beta) -
           particular(arc.beta_0) * std::exp(lambda * (beta - arc.beta_0));
  };
  static const math::QuadratureRule rule = math::gauss_legendre(40);
  double t = 0.0;
  for (std::size_t i = 0; i < rule.points.size(); ++i) {
    const double q = rule.points[i];
    t += rule.weights[i] * 2.0 * q * s / std::sqrt(y(s * q * q));
  }
  return t;
}

/// Normal numbers of mean 0 and variance 1, by Box and Muller.
class Normal {
 public:
  explicit Normal(std::uint64_t seed) : uniform_(seed) {}
  double operator()() {
    const double radius = std::sqrt(-2.0 * std::log1p(-uniform_.uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform_.uniform());
  }

 private:
  SplitMix64 uniform_;
};

/// Places that share out the length of the path of a scene, and their times by
/// a closed form.
template <class Time>
[[nodiscard]] std::vector<fit::TimedPlace> timed(const Scene& scene, int rows,
                                                 double sigma,
                                                 const Time& time) {
  const PrescribedMotion motion(scene, centre_curve(scene));
  const double S = motion.centre_path_length();
  std::vector<fit::TimedPlace> out;
  for (int i = 1; i <= rows; ++i) {
    const double s = S * i / rows;
    out.push_back({motion.place_at_length(s), s, time(scene, s), sigma});
  }
  return out;
}

}  // namespace brachisto::testing
