// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The field, the drag, and what they and losses do to the speed: for
/// numbers and jets.

#pragma once

#include <cmath>

#include "brachisto/model/scene.hpp"
#include "model/inertia.hpp"
#include "model/losses.hpp"

namespace brachisto {

/// A force per mass.
template <class Scalar>
struct Pull {
  Scalar x, z;
};

/// The number in a jet.
template <class Scalar>
[[nodiscard]] double plain(const Scalar& number) {
  if constexpr (requires { number.value; }) {
    return plain(number.value);
  } else {
    return static_cast<double>(number);
  }
}

/// above() where a number lies above a bound, otherwise below(): decided by its
/// value, or by whatever stands for it.
template <class Scalar, class Above, class Below>
[[nodiscard]] Scalar where_above(const Scalar& number, double bound,
                                 const Above& above, const Below& below) {
  return plain(number) > bound ? above() : below();
}

/// On which side of the surface of the scene's sphere a place is; on the
/// surface itself inside.
[[nodiscard]] SphereSide side_of_surface(const Scene& scene, Point place);

/// d − R, how far a place is beyond the surface of the scene's sphere.
template <class Scalar>
[[nodiscard]] Scalar height_above_surface(const Scene& scene, const Scalar& x,
                                          const Scalar& z) {
  using std::sqrt;
  const Sphere& sphere = *scene.world.sphere;
  const Scalar dx = x - Scalar(sphere.centre.x);
  const Scalar dz = z - Scalar(sphere.centre.z);
  return sqrt(dx * dx + dz * dz) - Scalar(sphere.radius);
}
[[nodiscard]] inline double height_above_surface(const Scene& scene,
                                                 Point place) {
  return height_above_surface(scene, place.x, place.z);
}

/// Force per mass of the field at a place: (0, g), or towards the centre of a
/// sphere of radius R with the surface gravity g_s, at the distance d,
///
///     g_s d/R inside,  g_s (R/d)² outside.
template <class Scalar>
[[nodiscard]] Pull<Scalar> field_at(const Scene& scene, const Scalar& x,
                                    const Scalar& z) {
  using std::sqrt;
  const World& world = scene.world;
  if (!world.sphere) return {Scalar(0.0), Scalar(scene.gravity)};
  const Sphere& sphere = *world.sphere;
  const double R = sphere.radius;
  const Scalar dx = x - Scalar(sphere.centre.x);
  const Scalar dz = z - Scalar(sphere.centre.z);
  const Scalar square = dx * dx + dz * dz;
  const double share = world.sphere_share;
  const double at_surface = share * sphere.surface_gravity / R;
  const auto inside = [&] { return Scalar(-at_surface); };
  const auto outside = [&]() -> Scalar {
    return Scalar(-at_surface * R * R * R) / (square * sqrt(square));
  };
  const Scalar per_length = !world.side
                                ? where_above(square, R * R, outside, inside)
                            : *world.side == SphereSide::Outside ? outside()
                                                                 : inside();
  return {dx * per_length,
          dz * per_length + Scalar((1.0 - share) * scene.gravity)};
}

/// By how much the potential of that field per mass falls from one place to
/// another [m²/s²], the potential being −g z, or with a sphere
///
///     Φ = g_s (d² − 3 R²)/(2 R) inside,  −g_s R²/d outside,
///
/// without the digits that the difference loses where the sphere is large
/// beside their distance.
///
/// \param by  to − from, which may be known to more digits than the places
[[nodiscard]] double potential_fall(const Scene& scene, Point from, Point to,
                                    Point by);
[[nodiscard]] inline double potential_fall(const Scene& scene, Point from,
                                           Point to) {
  return potential_fall(scene, from, to, {to.x - from.x, to.z - from.z});
}

/// The centre of mass, eqs. (2)–(3).
[[nodiscard]] inline Point mass_centre(const Body& body, Point centre,
                                       double theta) {
  const double r_m = body.radius * body.eta_m;
  return {centre.x + r_m * std::cos(theta), centre.z + r_m * std::sin(theta)};
}

/// The field there.
template <class Scalar>
[[nodiscard]] Pull<Scalar> pull_on(const Scene& scene, const Scalar& x,
                                   const Scalar& z, const Scalar& theta) {
  using std::cos;
  using std::sin;
  if (!scene.body.off_centred()) return field_at(scene, x, z);
  const double r_m = scene.body.radius * scene.body.eta_m;
  return field_at(scene, Scalar(x + cos(theta) * r_m),
                  Scalar(z + sin(theta) * r_m));
}

/// Drag on the centre per mass, c₁ v + c₂ v².
template <class Scalar>
[[nodiscard]] Scalar drag(const Air& air, const Scalar& v) {
  return v * (v * air.quadratic + Scalar(air.linear));
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
  using std::cos;
  using std::sin;
  const Body& body = scene.body;
  const Pull<Scalar> G = pull_on(scene, x, z, theta);
  Scalar along_x = cos(beta), along_z = sin(beta);
  if (body.off_centred()) {
    along_x = along_x - sin(theta) * body.eta_m;
    along_z = along_z + cos(theta) * body.eta_m;
  }
  Scalar gain = G.x * along_x + G.z * along_z;
  if (scene.world.air.any()) {
    gain = gain - drag(scene.world.air, Scalar(w / root));
  }
  return gain;
}

/// The same of the state that stands for w with losses.
template <class Scalar>
[[nodiscard, gnu::noinline, gnu::cold]] Scalar braked_gain(
    const Scene& scene, const Scalar& x, const Scalar& z, const Scalar& theta,
    const Scalar& w, const Scalar& beta, const Scalar& root) {
  using std::cos;
  using std::sin;
  const Pull<Scalar> G = pull_on(scene, x, z, theta);
  return losses::speed_gain(scene.body, scene.world.losses.factor(scene.body),
                            theta, beta, w, root,
                            work_gain(scene, x, z, theta, w, beta, root),
                            Scalar(G.z * cos(beta) - G.x * sin(beta)));
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
