// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "proof/equations.hpp"

#include "brachisto/math/jet.hpp"
#include "rolling/rolling_body.hpp"

namespace brachisto::proof {

namespace {

/// Rates of the components, and what belongs to a point besides.
template <class S>
struct At {
  std::array<S, kComponents> rates;
  S legendre, normal, tangential, unfolded;
};

/// 𝓗 = L + p·f.
template <class Jet, class S>
Jet hamiltonian(const ocp::Rates<Jet, 4>& rates,
                const std::array<S, kComponents>& y) {
  Jet h = rates.cost;
  for (std::size_t i = 0; i < 4; ++i) {
    const S& p = y[kPx + i];
    h += rates.states[i].chain(rates.states[i].value * p, p);
  }
  return h;
}

// By rolling::Steered; y' = f, p' = −𝓗_y, and from h_β = 0 all along
//
//     h_ββ β' = −(h_βy · f + f_β · p').
template <class S>
At<S> at(const Scene& scene, const std::array<S, kComponents>& y) {
  using Jet = math::Jet2<S, 5>;
  constexpr std::size_t kControl = 4;
  const rolling::Steered problem(scene, {}, 1.0);
  const auto rates = problem.rates(ocp::as_variables<Jet>(
      std::array<S, 5>{y[kX], y[kZ], y[kTheta], y[kW], y[kBeta]}));
  const Jet h = hamiltonian(rates, y);
  At<S> out;
  S moved(0.0);
  for (std::size_t i = 0; i < kControl; ++i) {
    const S& f = rates.states[i].value;
    const S p_rate = -h.gradient[i];
    out.rates[kX + i] = f;
    out.rates[kPx + i] = p_rate;
    moved += h.hessian[Jet::pair(kControl, static_cast<int>(i))] * f +
             rates.states[i].gradient[kControl] * p_rate;
  }
  out.legendre = h.hessian[Jet::pair(kControl, kControl)];
  out.rates[kBeta] = -moved / out.legendre;
  out.rates[kTime] = rates.cost.value;
  out.rates[kLength] = y[kW];
  out.unfolded = y[kW] - out.rates[kBeta];
  const ContactForce<S> force =
      contact_force(scene, TurningPoint<S>{y[kX], y[kZ], y[kTheta], y[kW],
                                           y[kBeta], out.rates[kBeta]});
  out.normal = force.normal;
  out.tangential = force.tangential;
  return out;
}

template <int Directions>
void write(const Scene& scene, Equations& out) {
  using S = math::Jet1<Node, Directions>;
  std::array<S, kComponents> y;
  for (std::size_t i = 0; i < kComponents; ++i) {
    y[i].value = out.tape.input(static_cast<int>(i));
    for (std::size_t j = 0; j < Directions; ++j) {
      y[i].gradient[j] =
          out.tape.input(static_cast<int>(Equations::place(i, j)));
    }
  }
  const At<S> here = at(scene, y);
  for (const S& rate : here.rates) out.rates.push_back(rate.value);
  for (std::size_t j = 0; j < Directions; ++j) {
    for (const S& rate : here.rates) out.rates.push_back(rate.gradient[j]);
  }
}

}  // namespace

Equations::Equations(const Scene& scene, int along) : directions(along) {
  const Tape::Recording recording(tape);
  const Scene own = in_own_units(scene);
  if (along == 0) {
    std::array<Node, kComponents> y;
    for (std::size_t i = 0; i < kComponents; ++i) {
      y[i] = tape.input(static_cast<int>(i));
    }
    const At<Node> here = at(own, y);
    rates.assign(here.rates.begin(), here.rates.end());
    legendre = here.legendre;
    normal = here.normal;
    tangential = here.tangential;
    unfolded = here.unfolded;
  } else if (along == 2) {
    write<2>(own, *this);
  } else {
    write<3>(own, *this);
  }
}

SlopeFunction::SlopeFunction(const Scene& scene) {
  using Jet = math::Jet2<Node, 1>;
  const Tape::Recording recording(tape);
  std::array<Node, kComponents> y;
  for (std::size_t i = 0; i <= kBeta; ++i) {
    y[i] = tape.input(static_cast<int>(i));
  }
  const rolling::Steered problem(in_own_units(scene), {}, 1.0);
  const Jet h = hamiltonian(
      problem.rates(std::array{Jet(y[kX]), Jet(y[kZ]), Jet(y[kTheta]),
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

Scene in_own_units(const Scene& scene) {
  Scene own;
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
