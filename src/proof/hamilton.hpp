// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Hamilton's equations on one arc, along which a limit holds or none, from the
/// one text of the rates, for any scalar.

#pragma once

#include <array>
#include <optional>

#include "brachisto/math/jet.hpp"
#include "extremal/arc_flow.hpp"
#include "math/constant_of.hpp"
#include "model/path_inequality.hpp"
#include "rolling/rolling_body.hpp"

namespace brachisto::proof {

/// Order of what is integrated. Of the free scenes of a uniform field nothing
/// depends on x and z, and of no scene on t and s.
enum Component : std::size_t {
  kX,
  kZ,
  kTheta,
  kW,
  kPx,
  kPz,
  kPtheta,
  kPw,
  kBeta,
  kPbeta,
  kTime,
  kLength,
  kComponents
};
/// What an arc is left from.
inline constexpr std::size_t kNode = kTime;

using Held = std::optional<arcs::HeldLimit>;

/// Whether a limit of the place holds.
[[nodiscard]] inline bool along_boundary(const Held& held) {
  return held && !held->limit.bounds_control();
}
/// Whether a limit of the control holds.
[[nodiscard]] inline bool along_bound(const Held& held) {
  return held && held->limit.bounds_control();
}

/// Rates of the components, and what belongs to a point besides.
template <class S>
struct At {
  std::array<S, kComponents> rates;
  S hamiltonian;  ///< 0 all along
  S by_slope;  ///< ∂(L + p·f)/∂β, 0 but where a limit of the control holds
  S legendre;    ///< and its second derivative
  S multiplier;  ///< of the limit that holds, per u; ≤ 0 at a lower bound
  TurningPoint<S> place;
};

/// L and f with derivatives by (x, z, θ, w, β), r dθ/ds = 1. A bead has no θ.
template <class Jet>
[[nodiscard]] ocp::Rates<Jet, 4> rates_of(const Scene& scene,
                                          const std::array<Jet, 5>& yu) {
  const rolling::Steered problem(scene, {}, 1.0);
  auto rates = problem.rates(yu);
  if (scene.body.rolls()) {
    using Constant = math::ConstantOf<Jet>;
    rates.states[kTheta] =
        rates.states[kTheta] * (Constant(1.0) / scene.body.radius);
  }
  return rates;
}

/// h = L + p·f.
template <class Jet, class S>
[[nodiscard]] Jet hamiltonian(const ocp::Rates<Jet, 4>& rates,
                              const std::array<S, kComponents>& y) {
  Jet h = rates.cost;
  for (std::size_t i = 0; i < 4; ++i) {
    const S& p = y[kPx + i];
    h += rates.states[i].chain(rates.states[i].value * p, p);
  }
  return h;
}

// y' = f and p' = −h_y − μ c_y.
//
// Free: h_β = 0 all along, h_ββ β' = −(h_βy·f + f_β·p').
//
// A limit c(y, q) = b of the control, affine in q = β', holds: p_β' = −h_β −
// μ c_β, μ = −p_β/c_q.
//
// A limit c(x, z) = b of the place holds, n = ∂c/∂(x, z), t = (cos β, sin β):
// n·t = 0 all along gives β', h_β = 0 all along
//
//     μ w n·t_β = h_ββ β' + h_βy·f − f_β·h_y.
template <class S>
[[nodiscard]] At<S> at(const Scene& scene, const Held& held,
                       const std::array<S, kComponents>& y) {
  using Jet = math::Jet2<S, 5>;
  constexpr std::size_t kControl = 4;
  const auto rates =
      rates_of(scene, ocp::as_variables<Jet>(std::array<S, 5>{
                          y[kX], y[kZ], y[kTheta], y[kW], y[kBeta]}));
  const Jet h = hamiltonian(rates, y);
  At<S> out;
  S moved(0.0);  // h_βy·f − f_β·h_y
  for (std::size_t i = 0; i < kControl; ++i) {
    const S& f = rates.states[i].value;
    const S p_rate = -h.gradient[i];
    out.rates[kX + i] = f;
    out.rates[kPx + i] = p_rate;
    moved += h.hessian[Jet::pair(kControl, static_cast<int>(i))] * f +
             rates.states[i].gradient[kControl] * p_rate;
  }
  out.by_slope = h.gradient[kControl];
  out.legendre = h.hessian[Jet::pair(kControl, kControl)];
  out.hamiltonian = h.value;
  out.rates[kPbeta] = S(0.0);
  out.multiplier = S(0.0);
  out.place = {y[kX], y[kZ], y[kTheta], y[kW], y[kBeta], S(0.0)};
  S& q = out.place.q;
  if (along_bound(held)) {
    q = with_control_at(held->limit, held->bound, scene, out.place).q;
    using Six = math::Jet1<S, 6>;
    const Six c = value_of(
        held->limit, scene,
        TurningPoint<Six>{Six::variable(y[kX], 0), Six::variable(y[kZ], 1),
                          Six::variable(y[kTheta], 2), Six::variable(y[kW], 3),
                          Six::variable(y[kBeta], 4), Six::variable(q, 5)});
    const S& p_beta = y[kPbeta];
    out.multiplier = -p_beta / c.gradient[5];
    for (std::size_t i = 0; i < kControl; ++i) {
      out.rates[kPx + i] -= out.multiplier * c.gradient[i];
    }
    out.rates[kPbeta] = -out.by_slope - out.multiplier * c.gradient[kControl];
    out.hamiltonian += p_beta * q;
  } else if (along_boundary(held)) {
    using std::cos;
    using std::sin;
    using Two = math::Jet1<S, 2>;
    const auto n = rolling::normal_of(held->limit, Two::variable(y[kX], 0),
                                      Two::variable(y[kZ], 1));
    const S c = cos(y[kBeta]), s = sin(y[kBeta]);
    const Two along = n.x * Two(c) + n.z * Two(s);
    const S across = n.z.value * c - n.x.value * s;
    q = -(along.gradient[0] * out.rates[kX] +
          along.gradient[1] * out.rates[kZ]) /
        across;
    out.multiplier = (out.legendre * q + moved) / (y[kW] * across);
    out.rates[kPx] -= out.multiplier * n.x.value;
    out.rates[kPz] -= out.multiplier * n.z.value;
  } else {
    q = -moved / out.legendre;
  }
  out.rates[kBeta] = q;
  out.rates[kTime] = rates.cost.value;
  out.rates[kLength] = y[kW];
  return out;
}

}  // namespace brachisto::proof
