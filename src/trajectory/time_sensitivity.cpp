// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/time_sensitivity.hpp"

#include <Eigen/LU>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/index.hpp"
#include "brachisto/math/jet.hpp"
#include "model/inertia.hpp"
#include "trajectory/acceleration.hpp"

namespace brachisto {

namespace {

constexpr int kPoints = gauss_step::kPoints;
constexpr int kNumbers = static_cast<int>(kMotionNumbers);

/// By v, and by each MotionNumber.
using Jet = math::Jet1<double, 1 + kNumbers>;

/// v̇ at a point of a step.
Jet acceleration_jet(const PrescribedMotion& motion,
                     const PrescribedMotion::Step& step, std::size_t point) {
  constexpr std::size_t kLoss =
      1 + static_cast<std::size_t>(MotionNumber::Loss);
  constexpr std::size_t kInertia =
      1 + static_cast<std::size_t>(MotionNumber::Inertia);
  const Scene& scene = motion.scene();
  const CurvePlace& place = step.places[point];
  const double s = step.s[point];
  const double theta = scene.body.theta_m + s * rotation_per_length(scene.body);
  OnTheWay<Jet> at;
  at.s = s;
  at.place = point_of(motion.curve(), place);
  at.along = direction_of(place.beta);
  at.v = Jet::variable(step.v[point], 0);
  at.v_kappa = at.v * (place.turning / place.speed);
  at.A = inertia_factor(scene.body, theta, place.beta);
  at.A.gradient[kInertia] = 1.0;  // A = k + …
  Jet c(scene.world.losses.factor(scene.body));
  c.gradient[kLoss] = scene.body.wall_ratio;
  return acceleration_with_losses(scene, at, c,
                                  acceleration_without_losses(scene, at));
}

}  // namespace

TimeSensitivity::TimeSensitivity(const PrescribedMotion& motion)
    : motion_(motion) {
  for (int cell = 0; cell < motion.num_cells(); ++cell) {
    check_stop();
    cells_.push_back(advance(
        cells_.back(), motion.step_to(cell, motion.start_of_cell(cell + 1))));
  }
}

SensitiveTime TimeSensitivity::at(double q) const {
  if (!(q > 0.0)) return {};
  const int cell = motion_.cell_of(q);
  const PrescribedMotion::Step step = motion_.step_to(cell, q);
  return {step.t, advance(cells_[brachisto::at(cell)], step).time};
}

TimeSensitivity::State TimeSensitivity::advance(
    const State& from, const PrescribedMotion::Step& step) const {
  using Columns = Eigen::Matrix<double, kPoints, kNumbers>;
  const math::SmallMatrix& to_point = gauss_step::integration_to_points();
  const std::vector<double>& weights = gauss_step::rule().weights;
  // Per q: e' = gain + growth e.
  Columns gain;
  Eigen::Vector<double, kPoints> growth;
  for (int j = 0; j < kPoints; ++j) {
    const std::size_t point = brachisto::at(j);
    const Jet found = acceleration_jet(motion_, step, point);
    const double pace = step.width * step.places[point].speed;
    growth[j] = pace * found.gradient[0] / step.v[point];
    for (int p = 0; p < kNumbers; ++p) {
      gain(j, p) = pace * found.gradient[brachisto::at(1 + p)];
    }
  }
  Eigen::Matrix<double, kPoints, kPoints> matrix;
  Columns energy;
  for (int i = 0; i < kPoints; ++i) {
    for (int p = 0; p < kNumbers; ++p) {
      energy(i, p) = from.energy[brachisto::at(p)];
    }
    for (int j = 0; j < kPoints; ++j) {
      matrix(i, j) = (i == j ? 1.0 : 0.0) - to_point(i, j) * growth[j];
      energy.row(i) += to_point(i, j) * gain.row(j);
    }
  }
  energy = matrix.partialPivLu().solve(energy).eval();
  State to = from;
  for (int j = 0; j < kPoints; ++j) {
    const std::size_t point = brachisto::at(j);
    const double v = step.v[point];
    const double pace = step.width * step.places[point].speed;
    for (int p = 0; p < kNumbers; ++p) {
      to.energy[brachisto::at(p)] +=
          weights[point] * (gain(j, p) + growth[j] * energy(j, p));
      to.time[brachisto::at(p)] -=
          weights[point] * pace * energy(j, p) / (v * v * v);
    }
  }
  return to;
}

}  // namespace brachisto
