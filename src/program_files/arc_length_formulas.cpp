// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "program_files/arc_length_formulas.hpp"

#include "model/energy.hpp"
#include "transcription/program_formulas.hpp"

namespace brachisto::program_files {

namespace {

using enum StateComponent;

}  // namespace

int ArcLengthFormulas::num_quantities() const {
  return kParts * problem_.num_intervals();
}

Formula ArcLengthFormulas::quantity(int index) const {
  const int node = index / kParts + 1;
  switch (static_cast<Part>(index % kParts)) {
    case kDx:
      return growth(node, X);
    case kDz:
      return growth(node, Z);
    case kLength:
      return length(node);
    case kMiddle:
      return middle(node);
    case kSpeed:
      return speed(node);
  }
  return {};
}

Formula ArcLengthFormulas::state(int node, StateComponent component) const {
  return node == 0 ? 0.0 : Formula::unknown(layout().state(node, component));
}

Formula ArcLengthFormulas::S() const {
  return Formula::unknown(layout().arc_length());
}

Formula ArcLengthFormulas::length(int node) const {
  return layout().has_theta()
             ? problem_.scene().body.radius * growth(node, Theta)
             : S() * problem_.share(node);
}

Formula ArcLengthFormulas::middle(int node) const {
  Formula out = problem_.scene().body.theta_m;
  if (!layout().has_theta()) return out;
  out += state(node - 1, Theta) + ArcLength::middle(node) * growth(node, Theta);
  return out;
}

Formula ArcLengthFormulas::speed(int node) const {
  const Scene& scene = problem_.scene();
  const Formula turned = layout().has_theta() ? state(node, Theta) : 0.0;
  return fall_speed(scene.gravity,
                    energy_height_after(scene.body, state(node, Z), turned));
}

int ArcLengthFormulas::num_objective_parts() const {
  return problem_.num_intervals();
}

Formula ArcLengthFormulas::objective_part(int index) const {
  const int node = index + 1;
  const Body& body = problem_.scene().body;
  // The rotation of a body without θ is a number.
  const Formula angle = layout().has_theta() ? of(node, kMiddle) : middle(node);
  return sqrt(piece_square(body, of(node, kDx), of(node, kDz),
                           of(node, kLength), sin(angle), cos(angle))) *
         inverse_mean_speed(w(node - 1), w(node));
}

Formula ArcLengthFormulas::constraint(int index) const {
  const int node = layout().point_of(index) + 1;
  if (index == layout().no_slip(node)) {
    return slip(of(node, kDx), of(node, kDz), of(node, kLength),
                problem_.reference_length(node));
  }
  return misplacement(problem_.scene().body.radius, state(node, Theta), S(),
                      problem_.sigma(node));
}

}  // namespace brachisto::program_files
