// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "reproduction/bent_track.hpp"

#include <cmath>
#include <memory>
#include <utility>

#include "model/contact.hpp"

namespace brachisto::reproduction {

namespace {

/// What an arc of the centre's path that turns upwards, from one slope angle to
/// a smaller one, leads on by: ∫(cos β, sin β) ds with ds = −radius dβ.
Point along_arc(double radius, double from, double to) {
  return {radius * (std::sin(from) - std::sin(to)),
          radius * (std::cos(to) - std::cos(from))};
}

/// The scene without a condition on the slope at the end, the centre's path
/// ending at `end`.
Scene free_end(const Scene& scene, Point end) {
  const Point start = start_of_centre(scene);
  Scene free = scene;
  free.contact = Contact::Centre;
  free.L = end.x - start.x;
  free.H = end.z - start.z;
  return free;
}

}  // namespace

Scene bent_track(const Scene& scene, double phi, double radius,
                 const Interrupt& interrupt) {
  constexpr double kClosed = 1e-10;
  constexpr int kMostRounds = 50;
  constexpr int kSamples = 1000;
  constexpr int kOnArc = 100;
  const Point start = start_of_centre(scene);
  const Point end = end_of_centre(scene, phi);
  // The track starts with the radius of the body itself (κ_b → −1/r), and at
  // its start a spline through points bends less: by 11/12 h² κ_b'', the error
  // of the cubic through four points h apart, |κ_b| being convex there. So the
  // body fits if the points have no larger errors of their own. Those of
  // shooting are near rounding; collocation is as accurate in τ, but on the
  // mesh that suffices for it β is off by 1e-5 next to the start.
  SolveOptions shooting;
  shooting.method = Shooting{};
  // The arc begins with the slope that the extremal to its beginning ends with.
  double beta = phi;
  for (int round = 0; round < kMostRounds; ++round) {
    const Point arc = along_arc(radius, beta, phi);
    const Solution extremal = verified_solution(
        free_end(scene, {end.x - arc.x, end.z - arc.z}), interrupt, shooting);
    const double before = std::exchange(beta, extremal.motion()->end_angle());
    if (std::abs(beta - before) > kClosed) continue;

    GivenPath track;
    track.curve = GivenPath::Curve::Track;
    track.shape = GivenPath::Shape::Points;
    for (const TrajectoryPoint& at : extremal.motion()->fine_sample(kSamples)) {
      track.points.push_back(
          {start.x + at.motion.contact.x, start.z + at.motion.contact.z});
    }
    const Point bend{end.x - arc.x, end.z - arc.z};
    for (int i = 1; i <= kOnArc; ++i) {
      const double slope = beta + (phi - beta) * i / kOnArc;
      const Point on = along_arc(radius, beta, slope);
      track.points.push_back(track_below({bend.x + on.x, bend.z + on.z},
                                         scene.body.radius, slope));
    }
    // To the last digit, as a given path has to be.
    track.points.front() = {0.0, 0.0};
    track.points.back() = {scene.L, scene.H};
    Scene out = scene;
    out.path = std::make_shared<const GivenPath>(std::move(track));
    return out;
  }
  throw NotVerified("the bent track does not close");
}

double tau_of_kinked_track(const Scene& scene, double phi,
                           const Interrupt& interrupt) {
  const Scene free = free_end(scene, end_of_centre(scene, phi));
  // τ refers to the H of the other scene.
  return verified_tau(free, interrupt) * std::sqrt(free.H / scene.H);
}

}  // namespace brachisto::reproduction
