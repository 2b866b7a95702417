// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <cmath>

#include "brachisto/model/body.hpp"

namespace brachisto {

namespace {

/// The share of R by which a ball touches round rails nearer to its middle
/// plane than their axes are.
double towards_axes(const Ball& ball) {
  return ball.radius / (ball.radius + ball.rail_radius.value_or(0.0));
}

}  // namespace

double Ball::rolling_radius() const {
  if (gauge) {
    const double half = 0.5 * *gauge * towards_axes(*this);
    return std::sqrt((radius - half) * (radius + half));
  }
  return groove ? radius * std::sin(0.5 * *groove) : radius;
}

double Ball::folding_distance() const {
  if (groove) return radius / std::sin(0.5 * *groove);
  return rolling_radius() / towards_axes(*this);
}

Body Body::rolling_ball(const Ball& ball, double theta_m) {
  const double r = ball.rolling_radius();
  const double ratio = ball.radius / r;
  return {.shape = Shape::Ball,
          .radius = r,
          .eta_m = ball.eta_m * ratio,
          .theta_m = theta_m,
          .k = ball.k * ratio * ratio,
          .wall_ratio = ratio,
          .fold_ratio = ball.folding_distance() / r,
          .ball = ball};
}

Body as_stated(Body body) {
  if (!body.ball) return body;
  body.radius = body.ball->radius;
  body.eta_m = body.ball->eta_m;
  body.k = body.ball->k;
  return body;
}

Body as_it_rolls(const Body& stated) {
  if (stated.shape != Shape::Ball) {
    Body body = stated;
    body.ball.reset();
    return body;
  }
  Ball ball = stated.ball.value_or(Ball{});
  ball.radius = stated.radius;
  ball.eta_m = stated.eta_m;
  ball.k = stated.k;
  Body body = Body::rolling_ball(ball, stated.theta_m);
  body.mass = stated.mass;
  return body;
}

}  // namespace brachisto
