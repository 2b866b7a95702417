// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Newton's and Euler's laws along a motion, from the force balance of the
/// paper, eqs. (2)–(3), (6), (11)–(12), (20)–(22), and plain mechanics: no
/// formula of the library stands in between.

#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <ostream>
#include <vector>

#include "brachisto/math/polynomial_basis.hpp"
#include "brachisto/study/solution.hpp"
#include "brachisto/trajectory/motion.hpp"

namespace brachisto::testing {

/// A rigid body of mass one and what acts on it beside its track, SI units, z
/// down; angles and moments from +x towards +z.
struct RigidBody {
  using Vector = Eigen::Vector2d;

  double radius = 0.0;
  double offset = 0.0;   ///< r_m [m]
  double inertia = 0.0;  ///< I_cm/m [m²]
  double weight = 0.0;   ///< what forces are told in, g [m/s²]
  double linear_drag = 0.0, quadratic_drag = 0.0;  ///< [1/s], [1/m]
  double loss = 0.0;  ///< of the load: force of a bead, moment/r of a cylinder
  double start_speed = 0.0;                        ///< of the centre [m/s]
  std::function<Vector(const Vector&)> field;      ///< [m/s²]
  std::function<double(const Vector&)> potential;  ///< [m²/s²]
};

/// The field of a homogeneous sphere is that of the mass within the distance d,
/// in its centre: g_s d/R inside, g_s (R/d)² outside.
[[nodiscard]] inline RigidBody rigid_body_of(const Scene& scene) {
  using Vector = RigidBody::Vector;
  const Body& body = scene.body;
  RigidBody out;
  out.radius = body.radius;
  out.offset = body.eta_m * body.radius;
  out.inertia = body.k * body.radius * body.radius;
  out.weight = scene.gravity;
  out.linear_drag = scene.world.air.linear;
  out.quadratic_drag = scene.world.air.quadratic;
  out.loss =
      body.rolls() ? scene.world.losses.rolling : scene.world.losses.sliding;
  out.start_speed = scene.world.start_speed;
  if (!scene.world.sphere) {
    const double g = scene.gravity;
    out.field = [g](const Vector&) { return Vector(0.0, g); };
    out.potential = [g](const Vector& at) { return -g * at.y(); };
    return out;
  }
  const Sphere sphere = *scene.world.sphere;
  const Vector centre(sphere.centre.x, sphere.centre.z);
  const double R = sphere.radius, strength = sphere.surface_gravity;
  out.field = [=](const Vector& at) -> Vector {
    const double d = (at - centre).norm();
    const double pull = d < R ? strength * d / R : strength * R * R / (d * d);
    return (centre - at) * (pull / d);
  };
  out.potential = [=](const Vector& at) {
    const double d = (at - centre).norm();
    return d < R ? 0.5 * strength * d * d / R : strength * R * (1.5 - R / d);
  };
  return out;
}

/// What the laws leave over, the largest along the motion from A on. With the
/// speed V = √(2 g H) of a fall to B:
struct LeftOver {
  double force = 0.0;  ///< of Newton's law: |v_cm(t) − v_cm(0) − ∫a dt|/V
  double moment = 0.0;  ///< of Euler's: |I (ω(t) − ω(0)) − ∫M dt|/r V
  double place = 0.0;   ///< |c(t) − c(0) − ∫v_c t dt|/H
  double slip = 0.0;  ///< |r (θ(t) − θ(0)) − ∫v_c dt|/H, and |r ω − v_c|/V
  double energy = 0.0;  ///< of kinetic energy and work since A, over g H
  double start = 0.0;   ///< |v_c(0) − v₀|/V

  /// NaN if one of them is.
  [[nodiscard]] double largest() const {
    double out = 0.0;
    for (const double value : {force, moment, place, slip, energy, start}) {
      if (std::isnan(value)) return value;
      out = std::max(out, value);
    }
    return out;
  }

  friend std::ostream& operator<<(std::ostream& out, const LeftOver& left) {
    return out << "force " << left.force << ", moment " << left.moment
               << ", place " << left.place << ", slip " << left.slip
               << ", energy " << left.energy << ", start " << left.start;
  }
};

/// What an answer may leave. Along the path of collocation values have order
/// p + 1 where T has 2p, so that an error ε of T leaves about ε^((p+1)/2p) of
/// the laws there, found to be below 0.3 of it; ε^(1/2) of what has no degree.
[[nodiscard]] inline double allowed_along(const Solution& solution) {
  const ProgramSize* program = solution.program();
  const double p =
      program != nullptr && program->degree ? *program->degree : 1e9;
  return std::pow(*solution.estimated_error, 0.5 * (p + 1.0) / p);
}

/// The laws integrated over time, so that nothing is differentiated but t(σ),
/// by the polynomial through places between two nodes of the motion: by the law
/// between them, for all nodes, is as much said as by the law itself. With t =
/// (cos β, sin β), n = (sin β, −cos β) away from the track, D the drag,
///
///     m a_cm = m G(x_cm) + R_n n + R_t t − D t,
///     I_cm ω̇ = (x_b − x_cm) × (R_n n + R_t t) − (x_c − x_cm) × D t − c r R_n,
///
/// and of a bead with friction R_t = −μ R_n, by what it loses.
///
/// \param body  at rest or with its speed at the first of the rows
/// \param read  what is made of a point of the motion before it is judged
[[nodiscard]] inline LeftOver left_over(
    const Motion& motion, const RigidBody& body,
    const std::function<void(TrajectoryPoint&)>& read = {}) {
  using Vector = RigidBody::Vector;
  constexpr int kPoints = 8;
  const math::QuadratureRule rule = math::gauss_legendre(kPoints);
  std::vector<double> places = rule.points;
  places.insert(places.begin(), 0.0);
  places.push_back(1.0);
  const math::SmallMatrix slopes =
      math::LagrangeBasis(places).slopes_at(rule.points);

  const auto along = [](double angle) {
    return Vector(std::cos(angle), std::sin(angle));
  };
  const auto across = [](double angle) {
    return Vector(-std::sin(angle), std::cos(angle));
  };
  const auto cross = [](const Vector& a, const Vector& b) {
    return a.x() * b.y() - a.y() * b.x();
  };
  const auto centre = [](const TrajectoryPoint& p) {
    return Vector(p.centre.x, p.centre.z);
  };
  const auto heavy = [&](const TrajectoryPoint& p) -> Vector {
    return centre(p) + body.offset * along(p.theta);
  };
  const auto velocity = [&](const TrajectoryPoint& p) -> Vector {
    return p.motion.v_c * along(p.beta) +
           p.motion.omega * body.offset * across(p.theta);
  };
  const auto kinetic = [&](const TrajectoryPoint& p) {
    return 0.5 * velocity(p).squaredNorm() +
           0.5 * body.inertia * p.motion.omega * p.motion.omega;
  };
  const auto point = [&](double sigma) {
    TrajectoryPoint p = motion.at(sigma);
    if (read) read(p);
    return p;
  };

  const double V = std::sqrt(2.0 * motion.scene().gravity * motion.scene().H);
  const double H = motion.scene().H;
  const double r = body.radius;
  const TrajectoryPoint first = point(0.0);
  // As the body is let go.
  TrajectoryPoint let_go = first;
  let_go.motion.v_c = body.start_speed;
  let_go.motion.omega = r > 0.0 ? body.start_speed / r : 0.0;
  LeftOver out;
  out.start = std::abs(first.motion.v_c - body.start_speed) / V;
  const auto see = [](double& largest, double value) {
    if (!(value <= largest)) largest = value;
  };

  Vector impulse(0.0, 0.0), way(0.0, 0.0);
  double twist = 0.0, length = 0.0, braked = 0.0;
  TrajectoryPoint from = first;
  for (const TrajectoryPoint& node : motion.at_nodes()) {
    if (!(node.sigma > from.sigma)) continue;
    const double width = node.sigma - from.sigma;
    const TrajectoryPoint to = point(node.sigma);
    std::vector<TrajectoryPoint> inner;
    for (const double t : rule.points) {
      inner.push_back(point(from.sigma + t * width));
    }
    for (int i = 0; i < kPoints; ++i) {
      double dt = slopes(i, 0) * from.t + slopes(i, kPoints + 1) * to.t;
      for (int j = 0; j < kPoints; ++j) {
        dt += slopes(i, j + 1) * inner[static_cast<std::size_t>(j)].t;
      }
      dt *= rule.weights[static_cast<std::size_t>(i)];
      const TrajectoryPoint& p = inner[static_cast<std::size_t>(i)];
      const double v = p.motion.v_c;
      const Vector forward = along(p.beta);
      const Vector track = body.weight * (p.motion.R_t * forward -
                                          p.motion.R_n * across(p.beta));
      const Vector drag =
          -(body.linear_drag * v + body.quadratic_drag * v * v) * forward;
      const double lost = body.loss * body.weight * p.motion.R_n;
      const Vector contact = centre(p) + r * across(p.beta);
      impulse += dt * (body.field(heavy(p)) + track + drag);
      twist += dt * (cross(contact - heavy(p), track) +
                     cross(centre(p) - heavy(p), drag) - r * lost);
      way += dt * v * forward;
      length += dt * v;
      braked += dt * v * (lost - drag.dot(forward));
    }
    see(out.force, (velocity(to) - velocity(let_go) - impulse).norm() / V);
    see(out.place, (centre(to) - centre(first) - way).norm() / H);
    see(out.energy,
        std::abs(kinetic(to) - kinetic(let_go) + body.potential(heavy(to)) -
                 body.potential(heavy(first)) + braked) /
            (body.weight * H));
    if (r > 0.0) {
      const double spin = to.motion.omega - let_go.motion.omega;
      see(out.moment, std::abs(body.inertia * spin - twist) / (r * V));
      see(out.slip, std::abs(r * (to.theta - first.theta) - length) / H);
      see(out.slip, std::abs(r * to.motion.omega - to.motion.v_c) / V);
    }
    from = to;
  }
  return out;
}

}  // namespace brachisto::testing
