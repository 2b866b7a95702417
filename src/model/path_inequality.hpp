// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Limits along the path as inequalities at a point of it, for numbers and
/// jets: one formula for values, derivatives and checks.

#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "brachisto/model/body.hpp"
#include "brachisto/model/scene.hpp"
#include "model/field.hpp"
#include "model/inertia.hpp"
#include "model/units.hpp"

namespace brachisto {

/// A point of the path and how fast its slope turns.
template <class Scalar>
struct TurningPoint {
  Scalar x, z;   ///< of the centre
  Scalar theta;  ///< [rad]
  Scalar w;      ///< √(2 g E)
  Scalar beta;   ///< slope angle [rad]
  Scalar q;      ///< dβ/du = w κ_c
};

/// dw/du there.
template <class Scalar>
[[nodiscard]] Scalar speed_gain(const Scene& scene,
                                const TurningPoint<Scalar>& at) {
  return speed_gain(scene, at.x, at.z, at.theta, at.w, at.beta,
                    root_of_inertia(scene, at.theta, at.beta));
}

/// Force of the track on the body, per m g.
template <class Scalar>
struct ContactForce {
  Scalar normal, tangential;
};

/// Newton's law for the centre of mass, along the track and across it. With
/// δ = θ − β, q̂ = 1 − η sin δ, the field G at the centre of mass, the drag D on
/// the centre and w' by work_gain(),
///
///     v̇ = w'/A + w η cos δ (w/r − q)/A²,
///     R_t = (q̂ v̇ − η v_c ω cos δ − G·(cos β, sin β) + D)/g,
///     R_n = (G·(−sin β, cos β) − w q/A − η v̇ cos δ + η v_c ω sin δ)/g,
///
/// v_c ω = w²/(A r): at_rest + by_ww w² + by_wq w q,
/// plus by_drag D/g, (1 − q̂/A) along and η cos δ/A across. Without losses.
template <class Scalar>
struct ForceForms {
  ContactForce<Scalar> at_rest, by_ww, by_wq, by_drag;
  Scalar per_A;

  /// \param G  at the centre of mass
  [[nodiscard]] static ForceForms of(const Scene& scene, const Pull<Scalar>& G,
                                     const Scalar& theta, const Scalar& beta);

  /// Without drag.
  [[nodiscard, gnu::always_inline]] ContactForce<Scalar> operator()(
      const Scalar& w, const Scalar& q) const {
    return {
        at_rest.normal + w * (w * by_ww.normal + q * by_wq.normal),
        at_rest.tangential + w * (w * by_ww.tangential + q * by_wq.tangential)};
  }
};

template <class Scalar>
[[gnu::always_inline]] inline ForceForms<Scalar> ForceForms<Scalar>::of(
    const Scene& scene, const Pull<Scalar>& G, const Scalar& theta,
    const Scalar& beta) {
  using std::cos;
  using std::sin;
  const Body& body = scene.body;
  using Constant = math::ConstantOf<Scalar>;
  const Constant per_g = Constant(1.0) / scene.gravity;
  const Scalar cos_beta = cos(beta), sin_beta = sin(beta);
  const Scalar pressing =
      pull_along(scene, G, Scalar(-sin_beta), cos_beta) * per_g;
  const Scalar gain = field_gain(scene, G, theta, beta) * per_g;
  if (!body.off_centred()) {
    const Constant per_A =
        Constant(1.0) / axisymmetric_inertia_factor<Constant>(body);
    return {{pressing, gain * (per_A - 1.0)},
            {Scalar(0.0), Scalar(0.0)},
            {Scalar(per_A * -per_g), Scalar(0.0)},
            {Scalar(0.0), Scalar(Constant(1.0) - per_A)},
            Scalar(per_A)};
  }
  const Constant per_rg = per_g / body.radius;
  const Scalar pulling = pull_along(scene, G, cos_beta, sin_beta) * per_g;
  const Scalar delta = theta - beta;
  const Scalar lever = Scalar(1.0) - sin(delta) * body.eta_m;
  const Scalar per_A = Scalar(1.0) / inertia_factor(body, theta, beta);
  const Scalar gain_per_A = gain * per_A;
  const Scalar cos_per_A = cos(delta) * body.eta_m * per_A;  // η cos δ/A
  const Scalar lever_per_A = lever * per_A;
  const Scalar across = per_A - cos_per_A * cos_per_A;
  const Scalar along = lever_per_A * cos_per_A;
  return {{pressing - cos(delta) * body.eta_m * gain_per_A,
           lever * gain_per_A - pulling},
          {(across - lever_per_A) * per_rg, (along - cos_per_A) * per_rg},
          {across * -per_g, along * -per_g},
          {cos_per_A, Scalar(1.0) - lever_per_A},
          per_A};
}

/// In any field and with drag.
template <class Scalar>
[[nodiscard, gnu::always_inline]] inline ContactForce<Scalar>
lossless_contact_force(const Scene& scene, const TurningPoint<Scalar>& at) {
  using std::sqrt;
  using Constant = math::ConstantOf<Scalar>;
  const bool on_axis = !scene.body.off_centred();
  const auto forms = ForceForms<Scalar>::of(
      scene, pull_on(scene, at.x, at.z, at.theta), at.theta, at.beta);
  const ContactForce<Scalar> force =
      on_axis ? ContactForce<Scalar>{forms.at_rest.normal +
                                         at.w * at.q * forms.by_wq.normal,
                                     forms.at_rest.tangential}
              : forms(at.w, at.q);
  if (!scene.world.air.any()) return force;
  const Scalar braking =
      drag(scene.world.air, Scalar(at.w * sqrt(forms.per_A))) *
      (Constant(1.0) / scene.gravity);
  const Scalar along = force.tangential + forms.by_drag.tangential * braking;
  if (on_axis) return {force.normal, along};
  return {force.normal + forms.by_drag.normal * braking, along};
}

/// The same with losses, which brake by c g R_n/A:
///
///     R_n = R_n⁰ A/D,   R_t = R_t⁰ − q̂ c R_n/A.
template <class Scalar>
[[nodiscard, gnu::noinline, gnu::cold]] ContactForce<Scalar>
braked_contact_force(const Scene& scene, const TurningPoint<Scalar>& at) {
  using std::sin;
  const Body& body = scene.body;
  const double c = scene.world.losses.factor(body);
  // w and q of ds = w du from those of ds = W du.
  const Scalar root = root_of_inertia(body, at.theta, at.beta);
  const Scalar share = root / root_of_inertia(scene, at.theta, at.beta);
  const ContactForce<Scalar> without = lossless_contact_force(
      scene, TurningPoint<Scalar>{at.x, at.z, at.theta, at.w * share, at.beta,
                                  at.q * share});
  const Scalar normal =
      losses::load(body, c, at.theta, at.beta, without.normal);
  const Scalar brakes = normal / (root * root) * c;
  if (!body.off_centred()) return {normal, without.tangential - brakes};
  const Scalar lever = Scalar(1.0) - sin(at.theta - at.beta) * body.eta_m;
  return {normal, without.tangential - lever * brakes};
}

/// Of either.
template <class Scalar>
[[nodiscard]] ContactForce<Scalar> contact_force(
    const Scene& scene, const TurningPoint<Scalar>& at) {
  if (scene.world.losses.any()) return braked_contact_force(scene, at);
  return lossless_contact_force(scene, at);
}

/// The factor of limits with a μ or K: 1 but for numbers so large that what
/// they bound would be rounding beside them. It differs between units of
/// length.
[[nodiscard]] constexpr double scale_of_ratio(double number) {
  constexpr double kLargest = 1e4;
  return number > kLargest ? kLargest / number : 1.0;
}

/// One inequality lower ≤ value ≤ upper along the path.
struct PathInequality {
  enum class Kind {
    FrictionForward,   ///< (μ R_n − R_t) scale(); of a ball μ R/r_e
    FrictionBackward,  ///< (μ R_n + R_t) scale()
    NormalForce,       ///< R_n
    Hump,              ///< (K w − q) scale()
    Valley,            ///< (K w + q) scale()
    Floor,             ///< D − R − z ≥ 0
    Disc,              ///< distance from it
    HalfPlane,         ///< distance from it
  };
  Kind kind;
  double lower = 0.0;
  double upper = std::numeric_limits<double>::infinity();
  double number = 0.0;  ///< μ, K, D − R, of a disc R + radius, or R
  Point place = {};     ///< of a disc or a half-plane
  Point normal = {};    ///< of a half-plane

  bool operator==(const PathInequality&) const = default;

  /// Whether it depends on q; if not, on the place alone.
  [[nodiscard]] bool bounds_control() const { return kind <= Kind::Valley; }
  /// Whether it is one of forces, which at rest β alone decides.
  [[nodiscard]] bool bounds_force() const { return kind <= Kind::NormalForce; }
  /// Of the value and its bounds; see scale_of_ratio().
  [[nodiscard]] double scale() const {
    const bool of_ratio = bounds_control() && kind != Kind::NormalForce;
    return of_ratio ? scale_of_ratio(number) : 1.0;
  }
};

[[nodiscard]] constexpr const char* name(PathInequality::Kind kind) {
  constexpr std::array kNames{"friction", "friction",  "normal_force",
                              "hump",     "valley",    "floor",
                              "disc",     "half_plane"};
  return kNames[static_cast<std::size_t>(kind)];
}

/// All of a scene's, with bounds on the track's curvature converted to the
/// centre's: K_v = K/(1 − r K), none if r K ≥ 1, K_h = K/(1 + r K); a fold
/// margin m is K_h = (1 − m)/r. The body reaches R, which is r but for a ball,
/// whose walls press with R_n R/r in sum and whose margin is that of its
/// folding_distance().
[[nodiscard]] std::vector<PathInequality> inequalities(
    const Body& body, const PathLimits& limits);

/// The same limits in other units; forces are told per m g anyhow.
[[nodiscard]] PathLimits in_units_of(const Units& units, PathLimits limits);

/// Greatest curvature of the centre's path downwards and upwards, ∞ if free.
[[nodiscard]] double hump_of_centre(const Body& body, const PathLimits& limits);
[[nodiscard]] double valley_of_centre(const Body& body,
                                      const PathLimits& limits);
[[nodiscard]] bool bound_valleys(const std::vector<PathInequality>& limits);

/// The value of a limit, to be kept between its bounds.
/// \param force  of the track; without effect on limits that bound none
template <class Scalar>
[[nodiscard]] Scalar value_of(const PathInequality& limit,
                              const ContactForce<Scalar>& force,
                              const TurningPoint<Scalar>& at) {
  using std::sqrt;
  using Kind = PathInequality::Kind;
  const double scale = limit.scale();
  const auto scaled = [&](const Scalar& value) {
    return scale == 1.0 ? value : value * scale;
  };
  switch (limit.kind) {
    case Kind::FrictionForward:
      return scaled(force.normal * limit.number - force.tangential);
    case Kind::FrictionBackward:
      return scaled(force.normal * limit.number + force.tangential);
    case Kind::NormalForce:
      return force.normal;
    case Kind::Hump:
      return scaled(at.w * limit.number - at.q);
    case Kind::Valley:
      return scaled(at.w * limit.number + at.q);
    case Kind::Floor:
      return Scalar(limit.number) - at.z;
    case Kind::Disc: {
      const Scalar dx = at.x - Scalar(limit.place.x);
      const Scalar dz = at.z - Scalar(limit.place.z);
      return sqrt(dx * dx + dz * dz) - Scalar(limit.number);
    }
    case Kind::HalfPlane:
      return (at.x - Scalar(limit.place.x)) * limit.normal.x +
             (at.z - Scalar(limit.place.z)) * limit.normal.z -
             Scalar(limit.number);
  }
  return Scalar(0.0);
}

template <class Scalar>
[[nodiscard]] Scalar value_of(const PathInequality& limit, const Scene& scene,
                              const TurningPoint<Scalar>& at) {
  return value_of(
      limit,
      limit.bounds_force() ? contact_force(scene, at) : ContactForce<Scalar>{},
      at);
}

/// The point with the control at which a limit of the control, affine in it,
/// reaches a bound.
template <class Scalar>
[[nodiscard]] TurningPoint<Scalar> with_control_at(const PathInequality& limit,
                                                   double bound,
                                                   const Scene& scene,
                                                   TurningPoint<Scalar> at) {
  at.q = Scalar(0.0);
  const Scalar without = value_of(limit, scene, at);
  at.q = Scalar(1.0);
  const Scalar by_control = value_of(limit, scene, at) - without;
  at.q = (Scalar(bound) - without) / by_control;
  return at;
}

/// Where on the segment from a to b, from 0 to 1, it is next to c.
[[nodiscard]] double next_to(Point a, Point b, Point c);

/// By how much a place exceeds the limit that it exceeds most; ≤ 0: it keeps
/// all, and the next one is so far. What is not a number exceeds everything.
struct Excess {
  double value = -std::numeric_limits<double>::infinity();
  int limit = -1;
  bool above = false;  ///< the upper bound
};
[[nodiscard]] Excess worst_excess(const std::vector<PathInequality>& limits,
                                  const Scene& scene,
                                  const TurningPoint<double>& place);

}  // namespace brachisto
