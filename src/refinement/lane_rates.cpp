// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/lane_rates.hpp"

#include <cmath>
#include <utility>

#include "brachisto/math/index.hpp"
#include "math/central_difference.hpp"
#include "model/contact.hpp"
#include "model/start_angle.hpp"

namespace brachisto {

namespace {

constexpr Eigen::Index kSize = lanes::Extremal::kUnknowns;

}  // namespace

LaneRates::LaneRates(const Scene& natural,
                     std::shared_ptr<const lanes::Extremal> extremal)
    : scene_(with_rotation(natural)), extremal_(std::move(extremal)) {
  for (const lanes::Landing& by : lanes::respond(scene_, *extremal_)) {
    unknowns_.push_back(
        {by.transit_time, by.beta,
         Eigen::Map<const Eigen::VectorXd>(by.residual.data(), kSize)});
  }
}

void LaneRates::expect(std::span<const SceneCoordinate> coordinates) {
  std::vector<Scene> scenes;
  std::vector<std::pair<SceneCoordinate, double>> weights;
  for (const SceneCoordinate coordinate : coordinates) {
    math::central_difference_by_place(
        difference_step(scene_, coordinate), [&](double place, double weight) {
          scenes.push_back(moved(scene_, coordinate, place));
          weights.emplace_back(coordinate, weight);
        });
    direct_[static_cast<std::size_t>(coordinate)] =
        Direct{{0.0, 0.0, Eigen::VectorXd::Zero(kSize)}};
  }
  const std::vector<lanes::Landing> landed = lanes::land(scenes, *extremal_);
  for (std::size_t i = 0; i < landed.size(); ++i) {
    const auto& [coordinate, weight] = weights[i];
    Direct& by = *direct_[static_cast<std::size_t>(coordinate)];
    by.rates.time += weight * landed[i].transit_time;
    by.rates.beta += weight * landed[i].beta;
    for (Eigen::Index j = 0; j < kSize; ++j) {
      by.rates.open[j] +=
          weight * landed[i].residual[static_cast<std::size_t>(j)];
    }
    by.start_angle += weight * start_angle(scenes[i].body);
  }
}

TimeRate LaneRates::by(SceneCoordinate coordinate) {
  const auto& direct = direct_[static_cast<std::size_t>(coordinate)];
  if (!direct) expect(std::array{coordinate});
  const Rates& rates = direct->rates;
  TimeRate out;
  out.total = closed_rate(rates, unknowns_);
  // Both contacts turn about their points of the track.
  const double r = contact_radius(scene_);
  const auto pull = [&](double angle) {
    return r * (extremal_->p_x() * std::cos(angle) +
                extremal_->p_z() * std::sin(angle));
  };
  out.at_fixed_contacts = out.total + pull(extremal_->phi) * slope_rate(rates) -
                          pull(start_angle(scene_.body)) * direct->start_angle;
  return out;
}

double LaneRates::slope_rate(const Rates& direct) const {
  std::vector<Rates> slopes = unknowns_;
  for (Rates& slope : slopes) slope.time = slope.beta;
  return closed_rate(Rates{direct.beta, 0.0, direct.open}, slopes);
}

/// With a kink κ = φ − β_end, the centre being where φ has it: R_y y_κ = φ_κ−1
/// of what the contact does, hence φ_κ = 1 + β_y R_y⁻¹ (r cos φ, r sin φ, 0,
/// 0).
double LaneRates::contact_response() {
  if (scene_.contact != Contact::Smooth) return std::nan("");
  const double r = contact_radius(scene_);
  Rates kink{0.0, 1.0, Eigen::VectorXd::Zero(kSize)};
  kink.open[0] = -r * std::cos(extremal_->phi);
  kink.open[1] = -r * std::sin(extremal_->phi);
  return slope_rate(kink);
}

}  // namespace brachisto
