// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/lane_rates.hpp"

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
  std::vector<Scene> scenes;
  std::vector<std::pair<SceneCoordinate, double>> weights;
  for (const SceneCoordinate coordinate : coordinates) {
    math::central_difference_by_place(
        kShareOfStep * difference_step(scene_, coordinate),
        [&](double place, double weight) {
          scenes.push_back(moved(scene_, coordinate, place));
          weights.emplace_back(coordinate, weight);
        });
    direct_[static_cast<std::size_t>(coordinate)] =
        Rates{.open = Eigen::VectorXd::Zero(kSize)};
  }
  const std::vector<lanes::Landing> landed = lanes::land(scenes, *extremal_);
  for (std::size_t i = 0; i < landed.size(); ++i) {
    const auto& [coordinate, weight] = weights[i];
    Rates& by = *direct_[static_cast<std::size_t>(coordinate)];
    by.time += weight * landed[i].transit_time;
    by.beta += weight * landed[i].beta;
    by.start_beta += weight * landed[i].start_beta;
    for (Eigen::Index j = 0; j < kSize; ++j) {
      by.open[j] += weight * landed[i].residual[static_cast<std::size_t>(j)];
    }
  }
}

TimeRate LaneRates::by(SceneCoordinate coordinate) {
  const auto& direct = direct_[static_cast<std::size_t>(coordinate)];
  if (!direct) expect(std::array{coordinate});
  TimeRate out;
  out.total = closed_rate(*direct, unknowns_);
  // Both contacts turn about their points of the track, and with the slope at A
  // the w that a push stands for changes: ∂T/∂(start) = p, ∂T/∂(end) = −p.
  const double r = contact_radius(scene_), phi = extremal_->phi;
  const StartRates start = start_rates(scene_);
  const lanes::Place &from = extremal_->start(), &to = extremal_->end();
  out.at_fixed_contacts =
      out.total +
      r * (to.p_x * std::cos(phi) + to.p_z * std::sin(phi)) *
          slope_rate(&Rates::beta, *direct) -
      (from.p_x * start.x + from.p_z * start.z + from.p_w * start.w) *
          slope_rate(&Rates::start_beta, *direct);
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
