// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/world_system.hpp"

#include <algorithm>
#include <cmath>

#include "extremal/boundary.hpp"
#include "model/contact.hpp"
#include "model/start_angle.hpp"

namespace brachisto::worlds {

namespace {

constexpr int kWidth = ArcEnd::kWidth;

}  // namespace

WorldSystem::WorldSystem(const Scene& natural, int num_arcs)
    : scene_(natural),
      flow_(natural),
      num_arcs_(num_arcs),
      open_(slope_at_A_is_open(natural)),
      rest_angle_(start_angle(natural)) {}

State WorldSystem::node(const Eigen::VectorXd& point, int i) const {
  State y;
  std::copy_n(point.data() + of_node(i), kSize, y.begin());
  return y;
}

double WorldSystem::slope_near(const Eigen::VectorXd& point) const {
  return open_ ? point(of_slope()) : rest_angle_;
}

bool WorldSystem::evaluate(const Eigen::VectorXd& point,
                           const shooting::StepControl& control,
                           Linearisation& out) const {
  const int n = num_unknowns();
  out.residual.setZero(n);
  out.jacobian.setZero(n, n);
  out.time_gradient.setZero(n);
  out.transit_time = 0.0;
  out.steps = 0;
  const double U = point(of_duration());
  if (!(U > 0.0)) return false;
  int row = 0;

  // At A.
  Scene scene = scene_;
  if (open_) scene.world.start_slope = point(of_slope());
  const double alpha = slope_near(point);
  const State first = node(point, 0);
  double beta = alpha;
  PhaseJet h;
  if (!flow_.find_slope(first, beta, h)) return false;
  const Point start = start_of_centre(scene);
  const double wanted[] = {start.x, start.z, scene.body.theta_m,
                           initial_w(scene)};
  const StartRates turn = open_ ? start_rates(scene) : StartRates{};
  const double moves[] = {turn.x, turn.z, 0.0, turn.w};
  for (const std::size_t i : {kX, kZ, kTheta, kW}) {
    out.residual(row) = first[i] - wanted[i];
    out.jacobian(row, static_cast<int>(i)) = 1.0;
    if (open_) out.jacobian(row, of_slope()) = -moves[i];
    ++row;
  }
  out.residual(row) = h.value;
  for (int i = 0; i < kWidth; ++i) {
    out.jacobian(row, i) = h.gradient[static_cast<std::size_t>(i)];
  }
  ++row;
  const auto put_slope_row = [&](const PhaseJet& at, int first_column) {
    for (std::size_t i = 0; i < kSize; ++i) {
      State v{};
      v[i] = 1.0;
      out.jacobian(row, first_column + static_cast<int>(i)) =
          WorldFlow::slope_variation(at, v);
    }
  };
  if (open_) {
    out.residual(row) = beta - alpha;
    put_slope_row(h, 0);
    out.jacobian(row, of_slope()) = -1.0;
    ++row;
  }

  // Arcs.
  double step = 0.0;
  for (int a = 0; a < num_arcs_; ++a) {
    ArcEnd end;
    if (!integrate_arc(flow_, node(point, a), beta, U / num_arcs_, control,
                       step, end)) {
      return false;
    }
    beta = end.beta;
    out.steps += end.steps;
    out.transit_time += end.t;
    out.time_gradient.segment(of_node(a), kWidth) += end.time_by_start;
    out.time_gradient(of_duration()) += end.time_rate / num_arcs_;
    const State next = node(point, a + 1);
    for (int i = 0; i < kWidth; ++i) {
      const auto c = static_cast<std::size_t>(i);
      out.residual(row + i) = next[c] - end.y[c];
      out.jacobian(row + i, of_node(a + 1) + i) = 1.0;
      out.jacobian(row + i, of_duration()) = -end.rates[c] / num_arcs_;
    }
    out.jacobian.block(row, of_node(a), kWidth, kWidth) -= end.by_start;
    row += kWidth;
  }

  // At B.
  const State last = node(point, num_arcs_);
  const int at_B = of_node(num_arcs_);
  const double phi = point(of_phi());
  if (!flow_.find_slope(last, beta, h)) return false;
  const Point goal = end_of_centre(scene, phi);
  const shooting::EndSlide slide = shooting::end_slide(scene, phi);
  const auto fix = [&](Component component, double value, double slides) {
    out.residual(row) = last[component] - value;
    out.jacobian(row, at_B + static_cast<int>(component)) = 1.0;
    out.jacobian(row, of_phi()) = -slides;
    ++row;
  };
  fix(kX, goal.x, slide.dx_dphi);
  fix(kZ, goal.z, slide.dz_dphi);
  fix(kPTheta, 0.0, 0.0);
  fix(kPW, 0.0, 0.0);
  out.residual(row) = beta - phi;
  put_slope_row(h, at_B);
  out.jacobian(row, of_phi()) = -1.0;
  return true;
}

bool WorldSystem::follow(const Eigen::VectorXd& point,
                         const shooting::StepControl& control,
                         const std::function<void(const Passed&)>& tell) const {
  const double span = point(of_duration()) / num_arcs_;
  double near = slope_near(point);
  double time = 0.0;
  for (int a = 0; a < num_arcs_; ++a) {
    Passed now;
    const auto on = [&](const Passed& passed) {
      now = passed;
      // The next arc starts where this one ends, but for the matching error.
      if (a > 0 && passed.u == 0.0) return;
      now.u += a * span;
      now.t += time;
      tell(now);
    };
    if (!follow_arc(flow_, node(point, a), near, span, control, on)) {
      return false;
    }
    near = now.beta;
    time = now.t;
  }
  return true;
}

}  // namespace brachisto::worlds
