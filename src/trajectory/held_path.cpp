// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/held_path.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "model/contact.hpp"
#include "model/plane_curve.hpp"

namespace brachisto {

namespace {

/// Bends slopes between A and B and scales their length until the track ends at
/// B, by as little as splines through them are off.
void close(SlopesAlong& slopes, const Scene& scene) {
  const double r = contact_radius(scene);
  const Point start = centre_above({}, r, slopes.beta.front());
  const Point end = centre_above({scene.L, scene.H}, r, slopes.beta.back());
  const std::vector<double>& q = slopes.q;
  const auto weight = [](double at) { return at * at * (1.0 - at * at); };
  constexpr int kSteps = 3;  // each of which leaves a thousandth
  for (int step = 0; step < kSteps; ++step) {
    const Point way = curve_of_slopes({}, slopes)->at(1.0).offset;
    Point bent;  // what the end moves by with β += weight δ
    for (std::size_t i = 1; i < q.size(); ++i) {
      const double middle = 0.5 * (q[i - 1] + q[i]);
      const double ds = (q[i] - q[i - 1]) * 2.0 * middle * slopes.length;
      const double beta = 0.5 * (slopes.beta[i - 1] + slopes.beta[i]);
      bent.x -= std::sin(beta) * weight(middle) * ds;
      bent.z += std::cos(beta) * weight(middle) * ds;
    }
    const Point missed{end.x - start.x - way.x, end.z - start.z - way.z};
    const double area = way.x * bent.z - way.z * bent.x;
    const double longer = (missed.x * bent.z - missed.z * bent.x) / area;
    const double delta = (way.x * missed.z - way.z * missed.x) / area;
    // A path that returns almost to A is left as it is.
    constexpr double kLittle = 1e-3;
    if (!(std::abs(longer) < kLittle && std::abs(delta) < kLittle)) break;
    slopes.length *= 1.0 + longer;
    for (std::size_t i = 0; i < q.size(); ++i) {
      slopes.beta[i] += delta * weight(q[i]);
    }
  }
}

}  // namespace

Scene on_its_path(const Motion& motion) {
  Scene scene = motion.scene();
  if (scene.path) return scene;
  // A turn makes the path go up and down once.
  constexpr double kFewest = 1000.0, kPerTurn = 50.0, kMost = 1e5;
  const double turns =
      motion.rotation().value_or(0.0) / (2.0 * std::numbers::pi);
  const std::vector<TrajectoryPoint> sample = motion.fine_sample(
      static_cast<int>(std::clamp(kPerTurn * turns, kFewest, kMost)));
  const TrajectoryPoint& last = sample.back();
  // Places divided by s would be rounding at A; slopes are not.
  const StartLimits start = motion.at_start();
  const std::vector<double> joints = motion.joints();
  SlopesAlong slopes{
      last.s,
      {0.0},
      {motion.start_angle()},
      std::isfinite(start.fold_margin) && std::isfinite(start.curvature)};
  for (const TrajectoryPoint& at : sample) {
    // From rest the slope is a smooth function of the speed, and so of √s.
    const double q = &at == &last ? 1.0 : std::sqrt(at.s / last.s);
    if (!(q > slopes.q.back())) continue;
    slopes.q.push_back(q);
    slopes.beta.push_back(at.beta);
    if (std::ranges::binary_search(joints, at.sigma)) {
      slopes.q.push_back(q);
      slopes.beta.push_back(at.beta);
    }
  }
  close(slopes, scene);
  GivenPath path;
  path.shape = GivenPath::Shape::Slopes;
  path.slopes = std::move(slopes);
  scene.path = std::make_shared<const GivenPath>(std::move(path));
  // What is given has its slopes at A and B, and is bound by nothing.
  if (scene.contact != Contact::Centre) scene.contact = Contact::Smooth;
  scene.end_slope.reset();
  scene.limits = {};
  return scene;
}

}  // namespace brachisto
