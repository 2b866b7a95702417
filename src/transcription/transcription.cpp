// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/transcription.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "brachisto/math/index.hpp"
#include "model/world_hamiltonian.hpp"

namespace brachisto {

Transcription::Transcription(const Scene& scene, Mesh mesh,
                             VariableLayout layout, Point origin,
                             const char* place)
    : Program(std::move(mesh), layout.num_variables(), layout.num_constraints(),
              place),
      scene_(scene),
      layout_(layout),
      origin_(origin) {}

void Transcription::change_scene(const Scene& scene) {
  scene_ = scene;
  forget_point();
}

void Transcription::set_end_angle(double phi) {
  const Point end = end_of_centre(scene_, phi);
  const int last = layout_.num_points();
  fix(layout_.state(last, StateComponent::X), end.x - origin_.x);
  fix(layout_.state(last, StateComponent::Z), end.z - origin_.z);
}

Transcription::End Transcription::end_of_states(
    std::span<const double> x) const {
  const int last = layout_.num_points();
  const int w = layout_.state(last, StateComponent::W);
  End out;
  out.state.w = x[at(w)];
  out.by_x.push_back({w, 0.0, 1.0, 0.0, 0.0});
  if (layout_.has_theta()) {
    const int theta = layout_.state(last, StateComponent::Theta);
    out.state.theta = x[at(theta)];
    out.by_x.push_back({theta, 1.0, 0.0, 0.0, 0.0});
  }
  return out;
}

double Transcription::end_slope(std::span<const double> x,
                                std::span<const double> lambda) {
  const std::optional<End> at_end = end(x, lambda);
  if (!at_end) return std::numeric_limits<double>::quiet_NaN();
  const Costates p = end_costates(lambda);
  // p_w = 0, so that of the world losses alone matter.
  if (scene_.world.losses.any()) {
    return minimising_slope(scene_, {{}, at_end->state.theta, at_end->state.w},
                            p, at_end->last_slope);
  }
  return minimising_slope(scene_.body, scene_.gravity, at_end->state, p,
                          at_end->last_slope);
}

double Transcription::rounding(std::span<const double> x) const {
  constexpr double kTerms = 64.0;
  double largest = 1.0;
  for (const double value : x) largest = std::max(largest, std::abs(value));
  return kTerms * std::numeric_limits<double>::epsilon() * largest;
}

}  // namespace brachisto
