// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/study/solution.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "math/central_difference.hpp"
#include "math/enum_table.hpp"
#include "model/units.hpp"
#include "refinement/free_rates.hpp"
#include "refinement/lane_rates.hpp"
#include "refinement/limited_rates.hpp"
#include "refinement/without_arcs.hpp"
#include "solvers/pivot_store.hpp"
#include "study/answer_kinds.hpp"
#include "study/tau_rates.hpp"

namespace brachisto {

namespace {

using Gradient = PerParameter<double>;

std::unique_ptr<TimeRates> rates_of(const Solution& solution) {
  if (const auto* found = answer_as<CollocationAnswer>(solution.answer)) {
    return FreeRates::make(found->trajectory.curve(), found->point, found->phi);
  }
  if (const auto* found = answer_as<LimitedPathAnswer>(solution.answer);
      found != nullptr && arcs_are_known(found->motion.curve())) {
    return LimitedRates::make(
        {found->arcs, found->ends, found->motion.curve(), {}});
  }
  if (const auto* found = answer_as<LaneAnswer>(solution.answer)) {
    return std::make_unique<LaneRates>(found->motion.natural(),
                                       found->motion.extremal());
  }
  return nullptr;
}

/// dτ from dT in natural units: τ = T/√H, times being those of 2 g = 1.
double tau_rate(const TimeRates& rates, SceneCoordinate by, double time_rate) {
  const double H = rates.scene().H;
  const double of_H = by == SceneCoordinate::H ? 0.5 * rates.time() / H : 0.0;
  return (time_rate - of_H) / std::sqrt(H);
}

/// Of a coordinate, in those of the scene.
double unit_of(SceneCoordinate coordinate, const Solution& solution) {
  return coordinate >= SceneCoordinate::Radius
             ? natural_units(solution.scene).length
             : 1.0;
}

/// By coordinates.
Gradient tau_gradient(TimeRates& rates) {
  Gradient out;
  out.fill(TimeDerivatives::kNone);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const SceneCoordinate by = kSceneCoordinates[i];
    if (!has_coordinate(rates.scene(), by)) continue;
    out[i] = tau_rate(rates, by, rates.by(by).total);
  }
  return out;
}

/// A step from answer to answer. In formulas of the scene that of
/// difference_step() will do, but where a small body arrives it has turned
/// another way for a finish that is further by a part of its radius.
double step_between_answers(const Scene& scene, SceneCoordinate by) {
  constexpr double kFewRadians = 10.0;
  const double rotation = scene.body.off_centred()
                              ? std::max(scene.L, scene.H) / scene.body.radius
                              : 0.0;
  return difference_step(scene, by) * std::min(1.0, kFewRadians / rotation);
}

/// By coordinates in natural units, from gradients of answers to either side.
std::optional<SecondDerivatives> second_by_coordinates(TimeRates& rates) {
  SecondDerivatives out;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const SceneCoordinate by = kSceneCoordinates[i];
    out[i].fill(0.0);
    if (!has_coordinate(rates.scene(), by)) {
      out[i].fill(TimeDerivatives::kNone);
      continue;
    }
    bool found = true;
    math::central_difference_by_place(
        step_between_answers(rates.scene(), by),
        [&](double place, double weight) {
          const auto next = found ? rates.next(by, place) : nullptr;
          found = next && next->regular();
          if (!found) return;
          const Gradient gradient = tau_gradient(*next);
          for (std::size_t j = 0; j < out.size(); ++j) {
            out[i][j] += weight * gradient[j];
          }
        });
    if (!found) return std::nullopt;
  }
  // Both are the same but for their errors.
  for (std::size_t i = 0; i < out.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      out[i][j] = out[j][i] = 0.5 * (out[i][j] + out[j][i]);
    }
  }
  return out;
}

/// By η_m and θ_m in place of the offset (η cos θ, η sin θ).
SecondDerivatives polar(const SecondDerivatives& cartesian,
                        const std::array<double, 2>& gradient,
                        const Body& body) {
  const double eta = body.eta_m;
  const double c = std::cos(body.theta_m), s = std::sin(body.theta_m);
  // ∂(offset)/∂η and ∂(offset)/∂θ
  const double d[2][2] = {{c, s}, {-eta * s, eta * c}};
  SecondDerivatives out = cartesian;
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 2; j < out.size(); ++j) {
      out[i][j] = out[j][i] =
          d[i][0] * cartesian[0][j] + d[i][1] * cartesian[1][j];
    }
    for (std::size_t j = 0; j < 2; ++j) {
      out[i][j] =
          d[i][0] * (d[j][0] * cartesian[0][0] + d[j][1] * cartesian[0][1]) +
          d[i][1] * (d[j][0] * cartesian[1][0] + d[j][1] * cartesian[1][1]);
    }
  }
  // And the second derivatives of the offset.
  const double across = -s * gradient[0] + c * gradient[1];
  out[0][1] += across;
  out[1][0] += across;
  out[1][1] -= eta * (c * gradient[0] + s * gradient[1]);
  return out;
}

}  // namespace

const char* name(SceneParameter parameter) {
  constexpr auto kNames =
      table_by<SceneParameter>("eta_m", "theta_m", "k", "radius", "L", "H");
  static_assert(kNames.values.size() == kNumSceneParameters);
  return kNames[parameter];
}

std::optional<TauRates> tau_rates(const Solution& solution,
                                  std::span<const SceneCoordinate> by) {
  const ChainScope chains(ChainScope::threads());
  const std::unique_ptr<TimeRates> rates = rates_of(solution);
  if (!rates || !rates->regular()) return std::nullopt;
  rates->expect(by);
  TauRates out;
  out.contact_response = rates->contact_response();
  for (const SceneCoordinate coordinate : by) {
    if (!has_coordinate(solution.scene, coordinate)) continue;
    const double rate =
        tau_rate(*rates, coordinate, rates->by(coordinate).total) /
        unit_of(coordinate, solution);
    if (!std::isfinite(rate)) return std::nullopt;
    out.by[static_cast<std::size_t>(coordinate)] = rate;
  }
  return out;
}

std::optional<Sensitivities> sensitivities(const Solution& solution,
                                           bool second) {
  // The same digits within a solve and after it.
  const ChainScope chains(ChainScope::threads());
  const std::unique_ptr<TimeRates> rates = rates_of(solution);
  if (!rates || !rates->regular()) return std::nullopt;
  const Units units = natural_units(solution.scene);
  const auto unit = [&](std::size_t i) {
    return unit_of(kSceneCoordinates[i], solution);
  };
  PerParameter<TimeDerivatives> by;
  rates->expect(kSceneCoordinates);
  for (std::size_t i = 0; i < by.size(); ++i) {
    const SceneCoordinate coordinate = kSceneCoordinates[i];
    if (!has_coordinate(solution.scene, coordinate)) continue;
    const TimeRate rate = rates->by(coordinate);
    const auto tau = [&](double time_rate) {
      return tau_rate(*rates, coordinate, time_rate) / unit(i);
    };
    by[i] = {tau(rate.total), rate.total * units.time / unit(i),
             tau(rate.at_fixed_contacts),
             rate.at_fixed_contacts * units.time / unit(i)};
    if (!std::isfinite(by[i].tau + by[i].tau_at_fixed_contacts)) {
      return std::nullopt;
    }
  }
  Sensitivities out{by, {by[0], by[1]}, {}, {}, rates->contact_response()};
  const Body body = as_stated(solution.scene.body);
  const double c = std::cos(body.theta_m), s = std::sin(body.theta_m);
  for (double TimeDerivatives::*of :
       {&TimeDerivatives::tau, &TimeDerivatives::transit_time,
        &TimeDerivatives::tau_at_fixed_contacts,
        &TimeDerivatives::transit_time_at_fixed_contacts}) {
    const double x = by[0].*of, z = by[1].*of;
    out.by[0].*of = c * x + s * z;
    out.by[1].*of = body.eta_m * (c * z - s * x);
  }
  if (!second) return out;
  out.second_by_offset = second_by_coordinates(*rates);
  if (!out.second_by_offset) return out;
  for (std::size_t i = 0; i < by.size(); ++i) {
    for (std::size_t j = 0; j < by.size(); ++j) {
      (*out.second_by_offset)[i][j] /= unit(i) * unit(j);
    }
  }
  out.second = polar(*out.second_by_offset, {by[0].tau, by[1].tau}, body);
  return out;
}

}  // namespace brachisto
