// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/lane_rates.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "brachisto/math/index.hpp"
#include "math/central_difference.hpp"
#include "model/contact.hpp"

namespace brachisto {

namespace {

constexpr Eigen::Index kSize = lanes::Extremal::kUnknowns;

/// Of difference_step(): where a small body arrives, a shot changes over a
/// shorter length than formulas of the scene do. Of the error, a sixth power,
/// 4e-6 is left, less than rounding makes by then.
constexpr double kShareOfStep = 0.125;

}  // namespace

LaneRates::LaneRates(const Scene& natural,
                     std::shared_ptr<const lanes::Extremal> extremal)
    : scene_(with_rotation(natural)), extremal_(std::move(extremal)) {
  scene_.world.start_slope = extremal_->start().beta;
  for (const lanes::Landing& by : lanes::respond(scene_, *extremal_)) {
    unknowns_.push_back(
        {by.transit_time, by.beta, by.start_beta,
         Eigen::Map<const Eigen::VectorXd>(by.residual.data(), kSize)});
  }
}

void LaneRates::expect(std::span<const SceneCoordinate> coordinates) {
  struct Weighted {
    SceneCoordinate coordinate;
    double weight, of_high_orders;
  };
  const Rates none{.open = Eigen::VectorXd::Zero(kSize)};
  std::vector<Scene> scenes;
  std::vector<Weighted> weights;
  for (const SceneCoordinate coordinate : coordinates) {
    const double step = kShareOfStep * difference_step(scene_, coordinate);
    math::central_difference_by_place(step, [&](double place, double weight) {
      scenes.push_back(moved(scene_, coordinate, place));
      weights.push_back(
          {coordinate, weight, math::less_order_four(step, place, weight)});
    });
    direct_[static_cast<std::size_t>(coordinate)] = Direct{none, none};
  }
  const std::vector<lanes::Landing> landed = lanes::land(scenes, *extremal_);
  for (std::size_t i = 0; i < landed.size(); ++i) {
    Direct& by = *direct_[static_cast<std::size_t>(weights[i].coordinate)];
    const auto add = [&](Rates& to, double weight) {
      to.time += weight * landed[i].transit_time;
      to.beta += weight * landed[i].beta;
      to.start_beta += weight * landed[i].start_beta;
      for (Eigen::Index j = 0; j < kSize; ++j) {
        to.open[j] += weight * landed[i].residual[static_cast<std::size_t>(j)];
      }
    };
    add(by.rates, weights[i].weight);
    add(by.of_high_orders, weights[i].of_high_orders);
  }
}

TimeRate LaneRates::by(SceneCoordinate coordinate) {
  const auto& known = direct_[static_cast<std::size_t>(coordinate)];
  if (!known) expect(std::array{coordinate});
  const Rates& direct = known->rates;
  TimeRate out;
  out.total = closed_rate(direct, unknowns_);
  // Order six has about the power 3/2 of what orders above four have.
  constexpr double kOfHighOrders = 1e-7;
  const double high = std::abs(closed_rate(known->of_high_orders, unknowns_));
  if (!(high <= kOfHighOrders * std::max(1.0, std::abs(out.total)))) {
    out.total = std::nan("");
  }
  // Both contacts turn about their points of the track, and with the slope at A
  // the w that a push stands for changes: ∂T/∂(start) = p, ∂T/∂(end) = −p.
  const double r = contact_radius(scene_), phi = extremal_->phi;
  const StartRates start = start_rates(scene_);
  const lanes::Place &from = extremal_->start(), &to = extremal_->end();
  out.at_fixed_contacts =
      out.total +
      r * (to.p_x * std::cos(phi) + to.p_z * std::sin(phi)) *
          slope_rate(&Rates::beta, direct) -
      (from.p_x * start.x + from.p_z * start.z + from.p_w * start.w) *
          slope_rate(&Rates::start_beta, direct);
  return out;
}

double LaneRates::slope_rate(double Rates::*slope, Rates direct) const {
  std::vector<Rates> unknowns = unknowns_;
  for (Rates& by : unknowns) by.time = by.*slope;
  direct.time = direct.*slope;
  return closed_rate(direct, unknowns);
}

/// With a kink κ = φ − β_end, the centre being where φ has it: R_y y_κ = φ_κ−1
/// of what the contact does, hence φ_κ = 1 + β_y R_y⁻¹ (r cos φ, r sin φ, 0,
/// 0).
double LaneRates::contact_response() {
  if (scene_.contact != Contact::Smooth) return std::nan("");
  const double r = contact_radius(scene_);
  Rates kink{.beta = 1.0, .open = Eigen::VectorXd::Zero(kSize)};
  kink.open[0] = -r * std::cos(extremal_->phi);
  kink.open[1] = -r * std::sin(extremal_->phi);
  return slope_rate(&Rates::beta, kink);
}

}  // namespace brachisto
