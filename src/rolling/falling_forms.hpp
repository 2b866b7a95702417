// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The rolling body in a uniform field without air: closed forms of its rates
/// with their derivatives. With them, and with no derivatives by ignorable
/// states, a free extremal took 9 s where jets in all of them took 26, and a
/// limited solve 1.42 G instructions where it took 1.55.

#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "brachisto/math/jet.hpp"
#include "brachisto/ocp/point_function.hpp"
#include "model/field.hpp"

namespace brachisto::rolling {

/// Order of the states.
enum State : std::size_t { kX, kZ, kTheta, kW, kBeta };

/// The closed forms, of one body or of several side by side.
///
/// \tparam AnyBody  Body, or what has such numbers and root_of_inertia()
/// \tparam Number   of what they are numbers
template <class AnyBody, class Number>
class FallingForms {
 public:
  static constexpr std::size_t kStates = 4;

  FallingForms(const AnyBody& body, const Number& gravity,
               const Number& rotation_per_length)
      : body_(body),
        gravity_(gravity),
        rotation_per_length_(rotation_per_length) {}

  /// What the rates at a point and their derivatives are made of.
  template <class Scalar>
  struct Kept {
    Scalar w, c, s, pull, turn, root, first, second;
  };
  template <class Scalar>
  [[nodiscard]] Kept<Scalar> kept(
      const std::array<Scalar, kStates + 1>& yu) const {
    using std::cos;
    using std::sin;
    const auto& [x, z, theta, w, beta] = yu;
    const Scalar gain = Scalar(gravity_) * Scalar(body_.eta_m);
    const Root<Scalar> root = root_at(theta, beta);
    return {w,
            cos(beta),
            sin(beta),
            gain * cos(theta),
            gain * sin(theta),
            root.value,
            root.first,
            root.second};
  }

  /// The rates with their derivatives by (x, z, θ, w, β), of the first order or
  /// of the first two.
  template <class Jet, class Scalar>
  [[nodiscard]] ocp::Rates<Jet, kStates> jets(
      const std::array<Scalar, kStates + 1>& yu) const {
    return rates_of<Jet>(kept(yu));
  }
  template <class Jet, class Scalar>
  [[nodiscard]] ocp::Rates<Jet, kStates> rates_of(
      const Kept<Scalar>& at) const {
    const auto& [w, c, s, pull, turn, root, first, second] = at;
    const Scalar g(gravity_), per_length(rotation_per_length_);
    ocp::Rates<Jet, kStates> out{
        Jet(root),
        {Jet(w * c), Jet(w * s), Jet(w * per_length), Jet(g * s + pull)}};
    if constexpr (std::is_same_v<Jet, Scalar>) return out;
    auto& [by_x, by_z, by_theta, by_w] = out.states;
    out.cost.gradient[kTheta] = first;
    out.cost.gradient[kBeta] = -first;
    by_x.gradient[kW] = c;
    by_x.gradient[kBeta] = -(w * s);
    by_z.gradient[kW] = s;
    by_z.gradient[kBeta] = w * c;
    by_theta.gradient[kW] = per_length;
    by_w.gradient[kTheta] = -turn;
    by_w.gradient[kBeta] = g * c;
    if constexpr (requires { out.cost.hessian; }) {
      constexpr std::size_t kTheta2 = Jet::pair(kTheta, kTheta);
      constexpr std::size_t kBeta2 = Jet::pair(kBeta, kBeta);
      constexpr std::size_t kThetaBeta = Jet::pair(kBeta, kTheta);
      constexpr std::size_t kWBeta = Jet::pair(kBeta, kW);
      out.cost.hessian[kTheta2] = out.cost.hessian[kBeta2] = second;
      out.cost.hessian[kThetaBeta] = -second;
      by_x.hessian[kWBeta] = -s;
      by_x.hessian[kBeta2] = -(w * c);
      by_z.hessian[kWBeta] = c;
      by_z.hessian[kBeta2] = -(w * s);
      by_w.hessian[kTheta2] = -pull;
      by_w.hessian[kBeta2] = -(g * s);
    }
    return out;
  }

  /// 𝓗 but for what does not depend on β, with its derivatives by it:
  ///
  ///     √A + w (p_x cos β + p_z sin β) + p_w g sin β.
  template <class Scalar>
  [[nodiscard]] ocp::ByControl<Scalar> hamiltonian_by_control(
      const std::array<Scalar, 2 * kStates>& y, const Scalar& beta) const {
    const auto& [x, z, theta, w, p_x, p_z, p_theta, p_w] = y;
    return by_direction(theta, beta, Scalar(w * p_x),
                        Scalar(w * p_z + p_w * Scalar(gravity_)));
  }
  /// The same with another pull in place of (0, g).
  template <class Scalar>
  [[nodiscard]] ocp::ByControl<Scalar> hamiltonian_by_control(
      const std::array<Scalar, 2 * kStates>& y, const Scalar& beta,
      const Pull<Scalar>& G) const {
    const auto& [x, z, theta, w, p_x, p_z, p_theta, p_w] = y;
    return by_direction(theta, beta, Scalar(w * p_x + p_w * G.x),
                        Scalar(w * p_z + p_w * G.z));
  }

 private:
  /// √A + along cos β + down sin β.
  template <class Scalar>
  [[nodiscard, gnu::always_inline]] ocp::ByControl<Scalar> by_direction(
      const Scalar& theta, const Scalar& beta, const Scalar& along,
      const Scalar& down) const {
    using std::cos;
    using std::sin;
    const Scalar c = cos(beta), s = sin(beta);
    const Root<Scalar> root = root_at(theta, beta);
    const Scalar linear = along * c + down * s;
    return {root.value + linear, (down * c - along * s) - root.first,
            root.second - linear};
  }

  /// √A and its derivatives by δ = θ − β.
  template <class Scalar>
  struct Root {
    Scalar value, first, second;
  };
  // A' = −2 η cos δ, A'' = 2 η sin δ.
  template <class Scalar>
  [[nodiscard]] Root<Scalar> root_at(const Scalar& theta,
                                     const Scalar& beta) const {
    using std::cos;
    using std::sin;
    const Scalar eta(body_.eta_m);
    const Scalar value = root_of_inertia(body_, theta, beta);
    if (!body_.off_centred()) return {value, Scalar(0.0), Scalar(0.0)};
    const Scalar delta = theta - beta;
    const Scalar first = -(eta * cos(delta)) / value;
    return {value, first, (eta * sin(delta) - first * first) / value};
  }

  const AnyBody& body_;
  const Number& gravity_;
  const Number& rotation_per_length_;
};

}  // namespace brachisto::rolling
