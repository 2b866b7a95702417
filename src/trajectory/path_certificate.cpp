// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The checks of a motion on a given path.

#include <algorithm>
#include <cmath>

#include "brachisto/math/polynomial_basis.hpp"
#include "model/field.hpp"
#include "trajectory/certify.hpp"
#include "trajectory/reintegration.hpp"

namespace brachisto {

namespace {

/// How far the ends are from A and B, in x over L and in z over H.
double relative_contact_error(const PrescribedMotion& motion) {
  const Scene& scene = motion.scene();
  const bool smooth = scene.contact == Contact::Smooth;
  const auto distance = [&](const TrajectoryPoint& at, Point wanted) {
    const Point there = smooth ? at.motion.contact : at.centre;
    return std::max(std::abs(there.x - wanted.x) / scene.L,
                    std::abs(there.z - wanted.z) / scene.H);
  };
  return std::max(distance(motion.at(0.0), {0.0, 0.0}),
                  distance(motion.at(1.0), {scene.L, scene.H}));
}

/// What ½ w² has gained against the work done, at worst: over itself or, if it
/// is less, g H. Each part is counted in the way that the motion did not come
/// from: where nothing brakes and the speed is that of the potential, the work
/// of the field's force; otherwise, where it is that of the force, the fall of
/// the potential less the work of the drag and of the losses.
double energy_drift(const PrescribedMotion& motion) {
  const Scene& scene = motion.scene();
  const World& world = scene.world;
  const std::vector<TrajectoryPoint> cells = motion.at_nodes();
  // Of more points than the motion itself has in a cell.
  const math::QuadratureRule rule = math::gauss_legendre(15);
  const auto energy = [&](const TrajectoryPoint& at) {
    const double v = at.motion.v_c;
    return 0.5 * inertia_factor(scene.body, at.theta, at.beta) * v * v;
  };
  // Along the way of the centre. Where nothing brakes no speed matters to it.
  const auto force = [&](const TrajectoryPoint& at) {
    return world.brakes() ? -(drag(world.air, at.motion.v_c) +
                              world.losses.factor(scene.body) * scene.gravity *
                                  at.motion.R_n)
                          : speed_gain(scene, at.centre.x, at.centre.z,
                                       at.theta, 0.0, at.beta, 1.0);
  };
  const TrajectoryPoint& start = cells.front();
  double forced = 0.0, worst = 0.0;
  for (std::size_t c = 1; c < cells.size(); ++c) {
    const double from = cells[c - 1].sigma, width = cells[c].sigma - from;
    for (std::size_t i = 0; i < rule.points.size(); ++i) {
      const double q = from + width * rule.points[i];
      forced += rule.weights[i] * width * motion.curve().pace(q).speed *
                force(motion.at(q));
    }
    const double fallen = world.brakes()
                              ? potential_fall(scene, start.motion.mass_centre,
                                               cells[c].motion.mass_centre)
                              : 0.0;
    const double gained = energy(cells[c]) - energy(start);
    const double off = std::abs(gained - fallen - forced) /
                       std::max(scene.gravity * scene.H, energy(cells[c]));
    // Written so that a NaN is the worst of all.
    if (!(off <= worst) && !std::isnan(worst)) worst = off;
  }
  return worst;
}

}  // namespace

Certificate certify_path(const PrescribedMotion& motion, double tolerance) {
  // Of the integrator, over some hundred steps.
  constexpr double kIntegrator = 1e-10;
  const double reached = std::max(tolerance, kIntegrator);
  Certificate certificate;
  certificate.add("quadrature_error", motion.error_estimate(), tolerance);
  certificate.add("contact_error", relative_contact_error(motion),
                  kCloseToEnds);
  if (!motion.scene().world.ordinary()) {
    certificate.add("energy_drift", energy_drift(motion), reached);
  }
  certificate.add("reintegration_error", reintegration_error(motion), reached);
  return certificate;
}

}  // namespace brachisto
