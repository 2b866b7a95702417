// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/world_shooting.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "extremal/extremal_attempt.hpp"
#include "extremal/shooting_system.hpp"
#include "extremal/world_system.hpp"
#include "math/index.hpp"
#include "model/start_angle.hpp"
#include "model/world_part.hpp"

namespace brachisto {

namespace {

using worlds::WorldSystem;

/// Newton's method ended, and where.
struct WorldRoot {
  bool converged = false;
  Eigen::VectorXd point;
  WorldSystem::Linearisation at;
  Eigen::VectorXd last_change;
  int steps = 0;
  double residual = std::numeric_limits<double>::infinity();
};

WorldRoot find_world_root(const WorldSystem& system, Eigen::VectorXd start,
                          const shooting::StepControl& control,
                          int most_steps) {
  constexpr double kConverged = 1e-14, kRounding = 1e-10;
  constexpr double kSmallestFactor = 1e-2;
  WorldRoot out;
  out.point = std::move(start);
  if (!system.evaluate(out.point, control, out.at)) return out;
  while (true) {
    out.residual = out.at.residual.lpNorm<Eigen::Infinity>();
    out.last_change = -out.at.jacobian.partialPivLu().solve(out.at.residual);
    if (!out.last_change.allFinite()) return out;
    if (out.residual <= kConverged || out.steps == most_steps) break;
    WorldSystem::Linearisation there;
    double factor = 1.0;
    const auto closer = [&] {
      return system.evaluate(out.point + factor * out.last_change, control,
                             there) &&
             there.residual.norm() < out.at.residual.norm();
    };
    while (factor >= kSmallestFactor && !closer()) factor *= 0.5;
    if (factor < kSmallestFactor) break;  // rounding, or no way
    out.point += factor * out.last_change;
    out.at = std::move(there);
    ++out.steps;
  }
  out.converged = out.residual <= kRounding;
  return out;
}

/// What a solve has and does, in natural units.
class SolveInWorld : public shooting::ExtremalAttempt {
 public:
  SolveInWorld(const Scene& scene, const ExtremalOptions& options, int arcs)
      : ExtremalAttempt(options),
        scene_(scene),
        units_(natural_units(scene)),
        natural_(in_natural_units(scene)),
        // The number of arcs squared is the size of the matrix.
        arcs_(std::clamp(arcs, 4, 120)) {
    solution_.arcs = arcs_;
  }

  [[nodiscard]] Eigen::VectorXd unknowns_of(const ExtremalGuess& guess) const;
  /// From the ordinary world's extremal to the scene's; nothing if it fails.
  bool follow_into_world(Eigen::VectorXd& point);
  void finish(const Eigen::VectorXd& start);

 private:
  void fill(const WorldSystem& system, const WorldRoot& root);

  const Scene& scene_;
  Units units_;
  Scene natural_;
  int arcs_;
};

Eigen::VectorXd SolveInWorld::unknowns_of(const ExtremalGuess& guess) const {
  const WorldSystem system(natural_, arcs_);
  Eigen::VectorXd point(system.num_unknowns());
  const double per_speed = 1.0 / units_.speed();
  for (int i = 0; i <= arcs_; ++i) {
    const ExtremalState s = guess.state(static_cast<double>(i) / arcs_);
    const worlds::State y{s.x / units_.length,
                          s.z / units_.length,
                          s.theta,
                          s.w * per_speed,
                          s.p_x / per_speed,
                          s.p_z / per_speed,
                          s.p_theta / units_.time,
                          s.p_w / (units_.time * per_speed)};
    std::copy(y.begin(), y.end(), point.data() + WorldSystem::of_node(i));
  }
  point(system.of_duration()) = guess.rolling_time / units_.time;
  point(system.of_phi()) = guess.phi;
  if (system.open()) point(system.of_slope()) = guess.state(0.0).beta;
  return point;
}

bool SolveInWorld::follow_into_world(Eigen::VectorXd& point) {
  constexpr double kFirstStep = 0.25, kSmallestStep = 1.0 / 512.0;
  // Newton's method near its solution doubles the digits in each step.
  constexpr int kMostSteps = 8, kFewSteps = 5;
  constexpr double kLargestTurn = 0.25;
  double fraction = 0.0;
  double step = kFirstStep;
  while (fraction < 1.0) {
    const double next = std::min(1.0, fraction + step);
    const Scene part = part_of_world(natural_, next);
    const WorldSystem system(part, arcs_);
    const WorldRoot root = find_world_root(system, point, {}, kMostSteps);
    solution_.newton_steps += root.steps;
    const double turn =
        std::abs(root.point(system.of_phi()) - point(system.of_phi()));
    if (options_.stop.met()) {
      stop(fmt::format("{:.3g} of the way into the world", fraction));
      return false;
    }
    if (!root.converged || turn > kLargestTurn) {
      step = 0.5 * (next - fraction);
      if (step >= kSmallestStep) continue;
      fail(ExtremalStatus::NewtonFailed,
           fmt::format("beyond {:.3g} of the way from the uniform field "
                       "without air, from rest, into the world that is asked "
                       "for",
                       fraction));
      return false;
    }
    point = root.point;
    fraction = next;
    if (root.steps <= kFewSteps) step *= 2.0;
  }
  return true;
}

void SolveInWorld::finish(const Eigen::VectorXd& start) {
  // The local error is well below the wanted accuracy of the whole.
  constexpr double kShare = 0.1, kTightest = 1e-15;
  const double wanted = std::max(options_.tolerance, 1e-14);
  shooting::StepControl control{
      .tolerance = std::max(kShare * wanted, kTightest), .halve = false};
  const WorldSystem system(natural_, arcs_);
  const WorldRoot coarse =
      find_world_root(system, start, control, options_.max_newton_steps);
  solution_.newton_steps += coarse.steps;
  if (!coarse.converged) {
    if (options_.stop.met()) return stop("in Newton's method");
    return fail(ExtremalStatus::NewtonFailed,
                fmt::format("after {} steps the residual is {:.1e}; try a "
                            "better guess, or more arcs",
                            coarse.steps, coarse.residual));
  }
  control.halve = true;
  const WorldRoot fine =
      find_world_root(system, coarse.point, control, options_.max_newton_steps);
  solution_.newton_steps += fine.steps;
  if (!fine.converged) {
    if (options_.stop.met()) return stop("in Newton's method");
    return fail(ExtremalStatus::NewtonFailed,
                fmt::format("with every step halved the residual is {:.1e}",
                            fine.residual));
  }
  const auto time_of = [](const WorldRoot& root) {
    return root.at.transit_time + root.at.time_gradient * root.last_change;
  };
  const double T = time_of(fine);
  solution_.transit_time = T * units_.time;
  solution_.error_estimate =
      std::abs(time_of(coarse) / T - 1.0) +
      std::numeric_limits<double>::epsilon() * std::sqrt(1.0 + fine.at.steps);
  fill(system, fine);
  std::vector<ExtremalPath::Knot> knots;
  const bool followed =
      system.follow(fine.point, control, [&](const worlds::Passed& at) {
        const auto& y = at.y;
        knots.push_back(
            {.u = at.u,
             .y = {y[worlds::kX], y[worlds::kZ], y[worlds::kTheta],
                   y[worlds::kW], y[worlds::kPTheta], y[worlds::kPW]},
             .t = at.t,
             .beta = at.beta,
             .p_x = y[worlds::kPX],
             .p_z = y[worlds::kPZ]});
      });
  if (!followed) {
    return fail(ExtremalStatus::NewtonFailed,
                "the solution cannot be integrated again");
  }
  knots.back().u = fine.point(system.of_duration());
  // At rest exactly, not but for rounding.
  if (natural_.world.start_speed == 0.0) knots.front().y[shooting::kW] = 0.0;
  solution_.start_angle = knots.front().beta;
  const double p_x = knots.back().p_x;
  const double p_z = knots.back().p_z;
  solution_.path = ExtremalPath(natural_, units_, p_x, p_z, std::move(knots));
  judge();
}

void SolveInWorld::fill(const WorldSystem& system, const WorldRoot& root) {
  const worlds::State last = system.node(root.point, arcs_);
  solution_.tau =
      solution_.transit_time * std::sqrt(2.0 * scene_.gravity / scene_.H);
  solution_.rolling_time = root.point(system.of_duration()) * units_.time;
  solution_.phi = root.point(system.of_phi());
  // No-slip: S = r (θ_end − θ_m). For a bead θ counts arc length.
  const double turned = last[worlds::kTheta] - natural_.body.theta_m;
  solution_.rotation = natural_.body.rolls() ? turned : 0.0;
  solution_.centre_path_length =
      turned / shooting::inverse_radius(natural_.body) * units_.length;
  solution_.p_x = last[worlds::kPX] / units_.speed();
  solution_.p_z = last[worlds::kPZ] / units_.speed();
  solution_.integration_steps = root.at.steps;
  solution_.residual = root.residual;
}

}  // namespace

ExtremalSolution solve_extremal_in_world(const Scene& scene,
                                         const ExtremalGuess& guess,
                                         const ExtremalOptions& options) {
  SolveInWorld solve(
      scene, options,
      shooting::choose_arcs(in_natural_units(scene), guess, options.arcs));
  return solve.within_its_stop([&] { solve.finish(solve.unknowns_of(guess)); });
}

ExtremalSolution solve_extremal_in_world(const Scene& scene,
                                         const ExtremalSolution& ordinary,
                                         const ExtremalOptions& options) {
  ExtremalGuess guess;
  guess.rolling_time = ordinary.rolling_time;
  guess.phi = ordinary.phi;
  guess.p_x = ordinary.p_x;
  guess.p_z = ordinary.p_z;
  guess.state = [&](double sigma) { return ordinary.path.at(sigma); };
  SolveInWorld solve(
      scene, options,
      shooting::choose_arcs(in_natural_units(scene), guess, options.arcs));
  return solve.within_its_stop([&] {
    Eigen::VectorXd point = solve.unknowns_of(guess);
    if (solve.follow_into_world(point)) solve.finish(point);
  });
}

}  // namespace brachisto
