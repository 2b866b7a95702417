// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The field, the drag, and what they and losses do to the speed: for
/// numbers and jets.

#pragma once

#include <cmath>

#include "brachisto/model/scene.hpp"
#include "model/field_formulas.hpp"
#include "model/inertia.hpp"
#include "model/losses.hpp"

namespace brachisto {

/// Whether the field has a kink on a surface.
[[nodiscard]] constexpr bool has_surface(const World& world) {
  return world.by_field([] { return false; },
                        [](const auto& field) {
                          return requires {
                            fields::height(field, 0.0, 0.0);
                          };
                        });
}

/// On which side of that surface a place is; on the surface itself inside.
[[nodiscard]] FieldSide side_of_surface(const Scene& scene, Point place);

/// How far a place is beyond that surface.
template <class Scalar>
[[nodiscard]] Scalar height_above_surface(const Scene& scene, const Scalar& x,
                                          const Scalar& z) {
  return scene.world.by_field(
      [] { return Scalar(0.0); },
      [&](const auto& field) {
        if constexpr (requires { fields::height(field, x, z); }) {
          return fields::height(field, x, z);
        } else {
          return Scalar(0.0);
        }
      });
}
[[nodiscard]] inline double height_above_surface(const Scene& scene,
                                                 Point place) {
  return height_above_surface(scene, place.x, place.z);
}

/// So much of a field, the rest being uniform.
template <class AnyField, class Share, class Side, class Number, class Scalar>
[[nodiscard]] Pull<Scalar> part_of_field(const AnyField& field,
                                         const Share& share, const Side& side,
                                         const Number& gravity, const Scalar& x,
                                         const Scalar& z) {
  const auto pull = fields::pull(field, share, side, x, z);
  return {pull.x, pull.z + Scalar((1.0 - share) * gravity)};
}

/// Force per mass of the field at a place: (0, g), or that of the field that
/// stands in its place.
template <class Scalar>
[[nodiscard]] Pull<Scalar> field_at(const Scene& scene, const Scalar& x,
                                    const Scalar& z) {
  const World& world = scene.world;
  return world.by_field(
      [&]() -> Pull<Scalar> {
        return {Scalar(0.0), Scalar(scene.gravity)};
      },
      [&](const auto& field) -> Pull<Scalar> {
        return part_of_field(field, world.field_share, world.side,
                             scene.gravity, x, z);
      });
}

/// g, or the strength there of the field that stands in its place.
[[nodiscard]] inline double gravity_at_A(const Scene& scene) {
  return scene.world.by_field([&] { return scene.gravity; },
                              [](const auto& field) {
                                return fields::strength(field, {0.0, 0.0});
                              });
}

/// The place about which all of a field of places may be turned, if any.
[[nodiscard]] inline std::optional<Point> turning_centre(const World& world) {
  using Centre = std::optional<Point>;
  return world.by_field(
      [] { return Centre(); },
      [](const auto& field) -> Centre {
        if constexpr (requires { fields::turning_centre(field); }) {
          return fields::turning_centre(field);
        } else {
          return {};
        }
      });
}

/// By how much the potential of that field per mass falls from one place to
/// another [m²/s²], the uniform one being −g z, without the digits that the
/// difference loses where a sphere is large beside their distance.
///
/// \param by  to − from, which may be known to more digits than the places
[[nodiscard]] double potential_fall(const Scene& scene, Point from, Point to,
                                    Point by);
[[nodiscard]] inline double potential_fall(const Scene& scene, Point from,
                                           Point to) {
  return potential_fall(scene, from, to, {to.x - from.x, to.z - from.z});
}

/// The centre of mass of a body, or of several side by side, eqs. (2)–(3).
template <class AnyBody, class Scalar>
[[nodiscard]] InPlane<Scalar> place_of_mass(const AnyBody& body,
                                            const Scalar& x, const Scalar& z,
                                            const Scalar& theta) {
  using std::cos;
  using std::sin;
  using Constant = math::ConstantOf<Scalar>;
  const Constant r_m = Constant(body.radius) * body.eta_m;
  return {x + cos(theta) * r_m, z + sin(theta) * r_m};
}

/// How far the centre of mass is beyond the surface of the field.
template <class Scalar>
[[nodiscard]] Scalar height_of_mass(const Scene& scene, const Scalar& x,
                                    const Scalar& z, const Scalar& theta) {
  const auto heavy = place_of_mass(scene.body, x, z, theta);
  return height_above_surface(scene, heavy.x, heavy.z);
}

/// The same as a point.
[[nodiscard]] inline Point mass_centre(const Body& body, Point centre,
                                       double theta) {
  const auto heavy = place_of_mass(body, centre.x, centre.z, theta);
  return {heavy.x, heavy.z};
}

/// What the field gives from the start until the centre is off by `offset` and
/// the body turned by θ − θ_m, per mass [m²/s²]: as accurate next to the start
/// as these are.
///
/// \param start  of the centre
[[nodiscard]] double work_of_field(const Scene& scene, Point start,
                                   Point offset, double turned);

/// The field there.
template <class Scalar>
[[nodiscard]] Pull<Scalar> pull_on(const Scene& scene, const Scalar& x,
                                   const Scalar& z, const Scalar& theta) {
  if (!scene.body.off_centred() || !scene.world.field_varies()) {
    return field_at(scene, x, z);
  }
  const auto heavy = place_of_mass(scene.body, x, z, theta);
  return field_at(scene, heavy.x, heavy.z);
}

/// G·(cosine, sine) of that field, with one product where it is uniform.
template <class Scalar>
[[nodiscard]] Scalar pull_along(const Scene& scene, const Pull<Scalar>& G,
                                const Scalar& cosine, const Scalar& sine) {
  if (!scene.world.field_varies()) {
    return sine * math::ConstantOf<Scalar>(scene.gravity);
  }
  return G.x * cosine + G.z * sine;
}

/// Drag on the centre per mass, c₁ v + c₂ v².
template <class Scalar>
[[nodiscard]] Scalar drag(const Air& air, const Scalar& v) {
  return v * (v * air.quadratic + Scalar(air.linear));
}

/// Where the centre of mass goes as the centre goes by 1,
///
///     (cos β − η sin θ, sin β + η cos θ).
template <class AnyBody, class Scalar>
[[nodiscard, gnu::always_inline]] inline InPlane<Scalar> way_of_mass(
    const AnyBody& body, const Scalar& theta, const Scalar& beta) {
  using std::cos;
  using std::sin;
  InPlane<Scalar> along{cos(beta), sin(beta)};
  if (body.off_centred()) {
    along.x = along.x - sin(theta) * body.eta_m;
    along.z = along.z + cos(theta) * body.eta_m;
  }
  return along;
}

/// What the field adds to dw/du, G·way_of_mass().
template <class Scalar>
[[nodiscard, gnu::always_inline]] inline Scalar field_gain(
    const Scene& scene, const Pull<Scalar>& G, const Scalar& theta,
    const Scalar& beta) {
  const auto along = way_of_mass(scene.body, theta, beta);
  return pull_along(scene, G, along.x, along.z);
}

/// dw/du without losses, from the work of the field G at the centre of mass and
/// of the drag on the way ds = w du, which the kinetic energy ½ w² gains:
///
///     w' = G·(cos β − η sin θ, sin β + η cos θ) − c₁ w/√A − c₂ w²/A :
///
/// regular at rest, and g (sin β + η cos θ) in a uniform field without air.
///
/// \param root  √A(θ, β)
template <class Scalar>
[[nodiscard, gnu::always_inline]] inline Scalar work_gain(
    const Scene& scene, const Scalar& x, const Scalar& z, const Scalar& theta,
    const Scalar& w, const Scalar& beta, const Scalar& root) {
  const Scalar gain =
      field_gain(scene, pull_on(scene, x, z, theta), theta, beta);
  if (!scene.world.air.any()) return gain;
  return gain - drag(scene.world.air, Scalar(w / root));
}

/// The same of the state that stands for w with losses.
template <class Scalar>
[[nodiscard, gnu::noinline, gnu::cold]] Scalar braked_gain(
    const Scene& scene, const Scalar& x, const Scalar& z, const Scalar& theta,
    const Scalar& w, const Scalar& beta, const Scalar& root) {
  using std::cos;
  using std::sin;
  const Pull<Scalar> G = pull_on(scene, x, z, theta);
  return losses::speed_gain(
      scene.body, scene.world.losses.factor(scene.body), theta, beta, w, root,
      work_gain(scene, x, z, theta, w, beta, root),
      pull_along(scene, G, Scalar(-sin(beta)), Scalar(cos(beta))));
}

/// dw/du: work_gain(), and with losses the rate of the state that stands for w
/// there; see model/losses.hpp.
///
/// \param root  root_of_inertia() of the scene
template <class Scalar>
[[nodiscard]] Scalar speed_gain(const Scene& scene, const Scalar& x,
                                const Scalar& z, const Scalar& theta,
                                const Scalar& w, const Scalar& beta,
                                const Scalar& root) {
  if (scene.world.losses.any()) {
    return braked_gain(scene, x, z, theta, w, beta, root);
  }
  return work_gain(scene, x, z, theta, w, beta, root);
}

/// √A of a scene's body; θ is of no matter unless it is off-centred.
template <class Scalar>
[[nodiscard]] Scalar root_of_inertia(const Body& body, const Scalar& theta,
                                     const Scalar& beta) {
  using std::sqrt;
  if (!body.off_centred()) {
    using Constant = math::ConstantOf<Scalar>;
    return Scalar(sqrt(axisymmetric_inertia_factor<Constant>(body)));
  }
  return sqrt(inertia_factor(body, theta, beta));
}

/// dt/du, by which v_c = w/root: √A, and with losses what stands for it.
template <class Scalar>
[[nodiscard]] Scalar root_of_inertia(const Scene& scene, const Scalar& theta,
                                     const Scalar& beta) {
  const Losses& lost = scene.world.losses;
  return lost.any() ? losses::root_of_inertia(
                          scene.body, lost.factor(scene.body), theta, beta)
                    : root_of_inertia(scene.body, theta, beta);
}

/// w where a body is pushed off in the direction β: v₀ √A(θ_m, β).
template <class Scalar>
[[nodiscard]] Scalar pushed_w(const Scene& scene, const Scalar& beta) {
  return root_of_inertia(scene, Scalar(scene.body.theta_m), beta) *
         scene.world.start_speed;
}

}  // namespace brachisto
