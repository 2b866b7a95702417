// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Several bodies side by side as one problem of optimal control, by the closed
/// forms of one.

#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <string_view>
#include <type_traits>

#include "lanes/kernels.hpp"
#include "lanes/lane.hpp"
#include "model/field.hpp"
#include "model/inertia.hpp"
#include "rolling/rolling_body.hpp"

namespace brachisto::lanes {

/// Numbers of bodies, as Body has those of one.
template <class Number>
struct Bodies {
  Number eta_m, theta_m, k;
  Number radius;  ///< where a field differs from place to place

  void set(std::size_t lane, const Milestone& at) {
    eta_m.set(lane, at.eta_m);
    theta_m.set(lane, at.theta_m);
    k.set(lane, at.k);
    radius.set(lane, at.body_radius);
  }
  /// Nothing is left out for those that are not.
  [[nodiscard]] static constexpr bool off_centred() { return true; }
};

template <class Number, class Scalar>
[[nodiscard]] Scalar root_of_inertia(const Bodies<Number>& bodies,
                                     const Scalar& theta, const Scalar& beta) {
  return sqrt(inertia_factor(bodies, theta, beta));
}

/// As Air has those of one drag.
template <class Number>
struct Airs {
  Number linear, quadratic;
};
/// It is linear in both.
template <class Number, class Scalar>
[[nodiscard]] Scalar drag(const Airs<Number>& air, const Scalar& v) {
  return brachisto::drag(Air{1.0, 0.0}, v) * Scalar(air.linear) +
         brachisto::drag(Air{0.0, 1.0}, v) * Scalar(air.quadratic);
}

/// As Sphere has those of one.
template <class Number>
struct Spheres {
  InPlane<Number> centre;
  Number radius, surface_gravity;
};

/// What bodies fall in. Of numbers that Surroundings leave out none means
/// anything.
template <class Number>
struct Worlds {
  Airs<Number> air;
  Spheres<Number> sphere;
  Number field_share;
  FieldSide side = FieldSide::Outside;

  void set(std::size_t lane, const Milestone& at) {
    air.linear.set(lane, at.air.linear);
    air.quadratic.set(lane, at.air.quadratic);
    sphere.centre.x.set(lane, at.sphere.centre.x);
    sphere.centre.z.set(lane, at.sphere.centre.z);
    sphere.radius.set(lane, at.sphere.radius);
    sphere.surface_gravity.set(lane, at.sphere.surface_gravity);
    field_share.set(lane, at.field_share);
  }
};

/// Bodies steered by their slope angles, in natural units.
template <class Number, Surroundings In>
class FallingLanes {
 public:
  static constexpr std::size_t kStates = rolling::Steered::kStates;
  static constexpr std::size_t kIgnorable =
      In.field ? 0 : rolling::SteeredFalling::kIgnorable;
  using Point = std::array<Number, kStates + 1>;

  /// \param rotation_per_length  dθ/ds of each
  FallingLanes(const Bodies<Number>& bodies, const Number& rotation_per_length,
               const Worlds<Number>& world)
      : bodies_(bodies),
        rotation_per_length_(rotation_per_length),
        world_(world) {}

  [[nodiscard]] const Bodies<Number>& bodies() const { return bodies_; }
  /// Force per mass on bodies, the first states.
  template <class Scalar, std::size_t Size>
  [[nodiscard]] Pull<Scalar> pull(const std::array<Scalar, Size>& y) const {
    if constexpr (In.field) {
      const auto heavy = place_of_mass(bodies_, y[rolling::kX], y[rolling::kZ],
                                       y[rolling::kTheta]);
      return part_of_field(world_.sphere, world_.field_share, world_.side,
                           gravity_, heavy.x, heavy.z);
    } else {
      return {Scalar(0.0), Scalar(gravity_)};
    }
  }
  [[nodiscard]] const Number& rotation_per_length() const {
    return rotation_per_length_;
  }

  [[nodiscard]] ocp::Rates<Number, kStates> rates(const Point& yu) const {
    return jets<Number>(yu);
  }
  template <class Jet>
  [[nodiscard]] ocp::Rates<Jet, kStates> jets(const Point& yu) const {
    auto out = forms().template jets<Jet>(yu);
    Jet& gain = out.states[rolling::kW];
    if constexpr (In.field) {
      std::array<Jet, kStates + 1> at;
      for (std::size_t i = 0; i <= kStates; ++i) at[i] = variable<Jet>(yu, i);
      const Pull<Jet> G = pull(at);
      const auto along =
          way_of_mass(bodies_, at[rolling::kTheta], at[rolling::kBeta]);
      gain = G.x * along.x + G.z * along.z;
    }
    if constexpr (In.air) {
      gain = gain -
             drag(world_.air, Jet(variable<Jet>(yu, rolling::kW) / out.cost));
    }
    return out;
  }
  /// Of each by itself: Newton's method, which stands still where it arrived,
  /// and no number where it does not, or finds no minimum.
  [[nodiscard]] Number least_control(const std::array<Number, 2 * kStates>& y,
                                     const Number& near) const {
    constexpr int kMostSteps = 12;
    constexpr double kLastStep = 1e-8;  // its square is below rounding
    const Number last(kLastStep);
    Number at = near;
    const Pull<Number> G = pull(y);
    auto moving = Number(1.0) > Number(0.0);
    for (int i = 0; i < kMostSteps && any(moving); ++i) {
      const auto h = by_control(y, at, G);
      const Number step = -h.first / h.second;
      const auto lost = moving & !(h.second > Number(0.0));
      at = where(moving, Number(at + step), at);
      at = where(lost, Number(kNone), at);
      moving = moving & !lost & (abs(step) > last);
    }
    return where(moving, Number(kNone), at);
  }

  // No limits, and no surface.
  [[nodiscard]] static std::size_t num_limits() { return 0; }
  template <class Scalar>
  [[nodiscard]] Scalar limit(std::size_t,
                             const std::array<Scalar, kStates + 1>&) const {
    return Scalar(0.0);
  }
  [[nodiscard]] static ocp::Bounds bounds(std::size_t) { return {-1.0, 1.0}; }
  [[nodiscard]] static std::string_view state_name(std::size_t) { return {}; }
  [[nodiscard]] static std::string_view limit_name(std::size_t) { return {}; }
  [[nodiscard]] static double costate_weight(std::size_t) { return 1.0; }
  [[nodiscard]] static bool has_surface() { return false; }
  template <class Scalar, std::size_t Size>
  [[nodiscard]] static Scalar height(const std::array<Scalar, Size>&) {
    return Scalar(1.0);
  }

 private:
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  [[nodiscard]] rolling::FallingForms<Bodies<Number>, Number> forms() const {
    return {bodies_, gravity_, rotation_per_length_};
  }

  /// One of a point's numbers as a variable.
  template <class Jet>
  [[nodiscard]] static Jet variable(const Point& yu, std::size_t i) {
    if constexpr (std::is_same_v<Jet, Number>) {
      return yu[i];
    } else {
      return Jet::variable(yu[i], static_cast<int>(i));
    }
  }
  [[nodiscard]] ocp::ByControl<Number> by_control(
      const std::array<Number, 2 * kStates>& y, const Number& beta,
      const Pull<Number>& G) const {
    auto h = In.field ? forms().hamiltonian_by_control(y, beta, G)
                      : forms().hamiltonian_by_control(y, beta);
    if constexpr (In.air) {
      using Jet = math::Jet2<Number, 1>;
      const Jet root = root_of_inertia(bodies_, Jet(y[rolling::kTheta]),
                                       Jet::variable(beta, 0));
      const Jet lost = drag(world_.air, Jet(Jet(y[rolling::kW]) / root)) *
                       Jet(y[kStates + rolling::kW]);
      h.value -= lost.value;
      h.first -= lost.gradient[0];
      h.second -= lost.hessian[0];
    }
    return h;
  }

  Bodies<Number> bodies_;
  Number gravity_{0.5};  ///< 2 g = 1
  Number rotation_per_length_;
  Worlds<Number> world_;
};

}  // namespace brachisto::lanes
