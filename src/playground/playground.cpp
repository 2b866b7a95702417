// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The indirect method as a module of WebAssembly: what the page under
/// src/plot/web/playground calls. Numbers go in as arguments or through
/// table(), and come out as an array, a table and a text, all of which stay
/// where they are until the next call. Every function answers 0 for success.

#include <array>
#include <exception>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "brachisto/math/clock.hpp"
#include "brachisto/model/scene.hpp"
#include "brachisto/trajectory/motion.hpp"
#include "extremal/shooting.hpp"
#include "model/centre_curve.hpp"
#include "model/contact.hpp"
#include "trajectory/prescribed_motion.hpp"

namespace brachisto::playground {

namespace {

/// The module serves one page: its scene, and what was found last.
struct State {
  Scene scene;
  ExtremalSolution extremal;
  std::unique_ptr<const PrescribedMotion> ride;
  std::array<double, 12> numbers{};
  std::vector<double> table;
  std::string text;
};
State state;

/// A row of the table for a place: t, x_c, z_c, θ, β, x_b, z_b.
void add_row(double t, Point centre, double theta, double beta) {
  const Point track = track_below(centre, state.scene.body.radius, beta);
  state.table.insert(state.table.end(),
                     {t, centre.x, centre.z, theta, beta, track.x, track.z});
}

/// Newton's method from the extremal found last, whatever its scene was.
ExtremalSolution from_the_last(const ExtremalOptions& options) {
  const ExtremalSolution& last = state.extremal;
  const ExtremalGuess guess{
      .rolling_time = last.rolling_time,
      .phi = last.phi,
      .state = [&last](double sigma) { return last.path.at(sigma); }};
  return solve_extremal(state.scene, guess, options);
}

int refused(const char* why) {
  state.text = why;
  return 1;
}

}  // namespace

/// Room for so many numbers, and where it is.
[[clang::export_name("table")]] double* table(int size) {
  state.table.resize(static_cast<std::size_t>(size));
  return state.table.data();
}
[[clang::export_name("numbers")]] const double* numbers() {
  return state.numbers.data();
}
[[clang::export_name("text")]] const char* text() {
  return state.text.c_str();
}

/// The scene of the calls that follow; lengths in m, angles in rad. A radius of
/// zero makes a bead. If it is refused, text() says why.
///
/// \param friction  Coulomb's, of a bead; rolling resistance is none of this
///                  module, for it takes a limit on the load
/// \param drag      c₂ of the air [1/m]
[[clang::export_name("set_scene")]] int set_scene(double radius, double eta_m,
                                                  double theta_m, double k,
                                                  double L, double H,
                                                  double friction,
                                                  double drag) {
  state.scene = {};
  state.scene.body =
      radius > 0.0 ? Body::cylinder(radius, eta_m, theta_m, k) : Body::bead();
  state.scene.L = L;
  state.scene.H = H;
  state.scene.world.losses.sliding = friction;
  state.scene.world.air.quadratic = drag;
  const std::vector<SceneError> errors = validate(state.scene);
  if (errors.empty()) return 0;
  state.text = errors.front().key + ": " + errors.front().message;
  return 1;
}

/// The extremal, to a relative error of T. numbers(): τ, T, φ, β₀, S, rotation,
/// largest residual, error estimate, Newton steps, arcs, min ∂²𝓗/∂β², folds of
/// the branch that were passed.
///
/// \param nearby   1: by Newton's method from the extremal found last; 0: by
///                 continuation from the cycloid, as the command does it
/// \param seconds  after which it is given up
[[clang::export_name("solve")]] int solve(int nearby, double tolerance,
                                          double seconds) {
  if (nearby != 0 && state.extremal.path.empty()) {
    return refused("there is no extremal to start from");
  }
  const ExtremalOptions options{.tolerance = tolerance,
                                .follow_folds = true,
                                .stop = StopCondition(seconds, nullptr)};
  ExtremalSolution found = nearby != 0 ? from_the_last(options)
                                       : solve_extremal(state.scene, options);
  state.text = found.message;
  if (!found.usable()) return 1;
  state.numbers = {found.tau,
                   found.transit_time,
                   found.phi,
                   found.start_angle,
                   found.centre_path_length,
                   found.rotation,
                   found.residual,
                   found.error_estimate,
                   1.0 * found.newton_steps,
                   1.0 * found.arcs,
                   found.regularity.min_legendre,
                   1.0 * static_cast<double>(found.continuation.folds.size())};
  state.extremal = std::move(found);
  return 0;
}

/// `size` rows along the extremal found last, see add_row().
[[clang::export_name("sample_extremal")]] const double* sample_extremal(
    int size) {
  state.table.clear();
  for (int i = 0; i < size; ++i) {
    const ExtremalState at =
        state.extremal.path.at(static_cast<double>(i) / (size - 1));
    add_row(at.t, {at.x, at.z}, at.theta, at.beta);
  }
  return state.table.data();
}

/// The body on the track through the points that table() holds, from A to B:
/// numbers() are τ, T, the error estimate, the least R_n and x there, the least
/// 1 − r κ_c, and the grip μ that it takes from 1 % of the time on. If the body
/// does not arrive text() says where it stays.
[[clang::export_name("ride")]] int ride(int points) {
  GivenPath path;
  path.curve = GivenPath::Curve::Track;
  path.shape = GivenPath::Shape::Points;
  for (int i = 0; i < points; ++i) {
    const double* point = state.table.data() + 2 * i;
    path.points.push_back({point[0], point[1]});
  }
  state.ride.reset();
  try {
    Scene scene = state.scene;
    scene.path = std::make_shared<const GivenPath>(std::move(path));
    const std::vector<SceneError> errors = validate(scene);
    if (!errors.empty()) {
      state.text = errors.front().message;
      return 1;
    }
    auto motion =
        std::make_unique<const PrescribedMotion>(scene, centre_curve(scene));
    if (motion->stall()) {
      state.text = motion->stall()->message();
      return 1;
    }
    const PathDiagnostics found = motion->diagnose();
    state.numbers = {motion->tau(),
                     motion->transit_time(),
                     motion->error_estimate(),
                     found.min_normal_force.value,
                     found.min_normal_force.x,
                     found.min_fold_margin.value,
                     found.least_grip[1].mu};
    state.ride = std::move(motion);
  } catch (const std::exception& problem) {
    return refused(problem.what());
  }
  return 0;
}

/// `size` rows along the ride last arrived.
[[clang::export_name("sample_ride")]] const double* sample_ride(int size) {
  state.table.clear();
  for (int i = 0; i < size; ++i) {
    const TrajectoryPoint at =
        state.ride->at(static_cast<double>(i) / (size - 1));
    add_row(at.t, at.centre, at.theta, at.beta);
  }
  return state.table.data();
}

}  // namespace brachisto::playground
