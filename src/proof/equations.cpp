// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "proof/equations.hpp"

#include <algorithm>

#include "brachisto/math/jet.hpp"
#include "model/contact.hpp"

namespace brachisto::proof {

namespace {

template <int Directions>
void write(const Scene& scene, const Held& held, Equations& out) {
  using S = math::Jet1<Node, Directions>;
  std::array<S, kComponents> y;
  for (std::size_t i = 0; i < kComponents; ++i) {
    y[i].value = out.tape.input(static_cast<int>(i));
    for (std::size_t j = 0; j < Directions; ++j) {
      y[i].gradient[j] =
          out.tape.input(static_cast<int>(Equations::place(i, j)));
    }
  }
  const At<S> here = at(scene, held, y);
  for (const S& rate : here.rates) out.rates.push_back(rate.value);
  for (std::size_t j = 0; j < Directions; ++j) {
    for (const S& rate : here.rates) out.rates.push_back(rate.gradient[j]);
  }
}

}  // namespace

Equations::Equations(const Scene& scene, int along, const Held& held)
    : directions(along) {
  const Tape::Recording recording(tape);
  const Scene own = in_own_units(scene);
  if (along == 0) {
    std::array<Node, kComponents> y;
    for (std::size_t i = 0; i < kComponents; ++i) {
      y[i] = tape.input(static_cast<int>(i));
    }
    const At<Node> here = at(own, held, y);
    rates.assign(here.rates.begin(), here.rates.end());
    legendre = here.legendre;
    multiplier = here.multiplier;
    const ContactForce<Node> force = contact_force(own, here.place);
    normal = force.normal;
    tangential = force.tangential;
    unfolded = own.body.rolls() ? y[kW] - here.place.q * Node(own.body.radius)
                                : Node(1.0);
    height = height_of_mass(own, y[kX], y[kZ], y[kTheta]);
    for (const PathInequality& each : inequalities(own.body, own.limits)) {
      limits.push_back(value_of(each, force, here.place));
    }
  } else {
    constexpr std::array kWrite{&write<2>, &write<3>, &write<7>, &write<8>,
                                &write<10>};
    constexpr std::array kDirections{2, 3, 7, 8, 10};
    const auto found = std::ranges::find(kDirections, along);
    if (found == kDirections.end()) throw std::logic_error("directions");
    kWrite[static_cast<std::size_t>(found - kDirections.begin())](own, held,
                                                                  *this);
  }
}

SlopeFunction::SlopeFunction(const Scene& scene) {
  using Jet = math::Jet2<Node, 1>;
  const Tape::Recording recording(tape);
  std::array<Node, kComponents> y;
  for (std::size_t i = 0; i <= kBeta; ++i) {
    y[i] = tape.input(static_cast<int>(i));
  }
  const Jet h =
      hamiltonian(rates_of(in_own_units(scene),
                           std::array{Jet(y[kX]), Jet(y[kZ]), Jet(y[kTheta]),
                                      Jet(y[kW]), Jet::variable(y[kBeta], 0)}),
                  y);
  value = h.value;
  bend = h.hessian[0];
}

std::array<Real, 2> SlopeFunction::operator()(
    const std::vector<Real>& y) const {
  const std::vector<Real> at = tape.values(y);
  return {at[static_cast<std::size_t>(value.id)],
          at[static_cast<std::size_t>(bend.id)]};
}

bool is_plain(const Scene& scene) {
  return scene.world.ordinary() && !scene.limits.any() &&
         (scene.contact == Contact::Smooth || scene.contact == Contact::Centre);
}

Scene in_own_units(const Scene& scene) {
  Scene own;
  if (!is_plain(scene)) {
    own = scene;
    if (has_surface(scene.world)) {
      own.world.side = side_of_surface(
          scene,
          mass_centre(scene.body, start_of_centre(scene), scene.body.theta_m));
    }
    return own;
  }
  own.body = scene.body;
  own.body.radius = scene.body.rolls() ? 1.0 : 0.0;
  own.gravity = 0.5;
  return own;
}

Real inertia_root(const Scene& scene, const Real& theta, const Real& beta) {
  Tape tape;
  const Tape::Recording recording(tape);
  const Node root = root_of_inertia(scene.body, tape.input(0), tape.input(1));
  return tape.values({theta, beta})[static_cast<std::size_t>(root.id)];
}

}  // namespace brachisto::proof
