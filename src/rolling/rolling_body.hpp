// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The rolling body as a problem of optimal control in the rolling time u: one
/// text of its cost, its rates and its limits, in any field and in air.

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "brachisto/math/jet.hpp"
#include "brachisto/ocp/point_function.hpp"
#include "model/field.hpp"
#include "model/path_inequality.hpp"
#include "rolling/falling_forms.hpp"

namespace brachisto::rolling {

/// What both descriptions are made of.
class Moving {
 public:
  /// \param natural  the scene, in natural units
  /// \param limits   the ones that it knows
  /// \param rotation_per_length  dθ/ds: 1/r, or what suits where nothing
  ///                             depends on θ
  Moving(Scene natural, std::vector<PathInequality> limits,
         double rotation_per_length)
      : scene_(std::move(natural)),
        limits_(std::move(limits)),
        rotation_per_length_(rotation_per_length) {}

  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] const std::vector<PathInequality>& limits() const {
    return limits_;
  }

  /// As many with other bounds.
  void change_limits(std::vector<PathInequality> limits) {
    limits_ = std::move(limits);
  }

  [[nodiscard]] std::size_t num_limits() const { return limits_.size(); }
  [[nodiscard]] ocp::Bounds bounds(std::size_t i) const {
    return {limits_[i].lower, limits_[i].upper};
  }
  [[nodiscard]] std::string_view limit_name(std::size_t i) const {
    return name(limits_[i].kind);
  }
  [[nodiscard]] std::string_view state_name(std::size_t i) const {
    constexpr std::array<std::string_view, 5> kNames{"x", "z", "theta", "w",
                                                     "beta"};
    return kNames.at(i);
  }

  /// Whether the field has a kink.
  [[nodiscard]] bool has_surface() const {
    return brachisto::has_surface(scene_.world);
  }
  /// How far the centre of mass is above it.
  template <class Scalar, std::size_t Size>
  [[nodiscard]] Scalar height(const std::array<Scalar, Size>& y) const {
    return height_of_mass(scene_, y[kX], y[kZ], y[kTheta]);
  }
  void keep_to_side(bool above) {
    scene_.world.side = above ? FieldSide::Outside : FieldSide::Inside;
  }

  /// Why a point is none of a path; nullptr if it may be one. The body moves
  /// on, and its kinetic energy is positive.
  ///
  /// \param root  √A there
  template <std::size_t Size>
  [[nodiscard]] const char* refusal(const std::array<double, Size>& yu,
                                    double root) const {
    if (!(yu[kW] > 0.0)) return "the speed w is not positive";
    if (!std::isfinite(yu[kBeta])) return "the slope angle is not finite";
    return root > 0.0 ? nullptr : "the inertia factor A is not positive";
  }

  /// p_θ is r times a costate of arc length.
  [[nodiscard]] double costate_weight(std::size_t i) const {
    return i == kTheta ? rotation_per_length_ : 1.0;
  }

 protected:
  /// √A, and with it
  ///
  ///     x' = w cos β,  z' = w sin β,  r θ' = w,  w' = speed_gain().
  template <class Scalar>
  [[nodiscard]] ocp::Rates<Scalar, 4> rolling_rates(const Scalar& x,
                                                    const Scalar& z,
                                                    const Scalar& theta,
                                                    const Scalar& w,
                                                    const Scalar& beta) const {
    using std::cos;
    using std::sin;
    const Scalar root = root_of_inertia(scene_, theta, beta);
    return {root,
            {w * cos(beta), w * sin(beta), w * rotation_per_length_,
             speed_gain(scene_, x, z, theta, w, beta, root)}};
  }

  Scene scene_;
  std::vector<PathInequality> limits_;
  double rotation_per_length_;
};

/// ∂c/∂(x, z) of a limit of the place.
template <class Scalar>
struct Normal {
  Scalar x, z;
};
template <class Scalar>
[[nodiscard]] Normal<Scalar> normal_of(const PathInequality& limit,
                                       const Scalar& x, const Scalar& z) {
  using On = math::Jet1<Scalar, 2>;
  const On c = value_of(limit, ContactForce<On>{},
                        TurningPoint<On>{On::variable(x, 0), On::variable(z, 1),
                                         On(0.0), On(0.0), On(0.0), On(0.0)});
  return {c.gradient[0], c.gradient[1]};
}

/// The slope angle β is the control, as on free arcs and along boundaries.
class Steered : public Moving {
 public:
  static constexpr std::size_t kStates = 4;
  using Moving::Moving;

  template <class Scalar>
  [[nodiscard]] ocp::Rates<Scalar, kStates> rates(
      const std::array<Scalar, kStates + 1>& yu) const {
    const auto& [x, z, theta, w, beta] = yu;
    return rolling_rates(x, z, theta, w, beta);
  }
  /// Of a limit c of the place how fast it changes on the way, which has to be
  /// 0 for its boundary to be followed:
  ///
  ///     dc/du = w (∂c/∂x cos β + ∂c/∂z sin β).
  template <class Scalar>
  [[nodiscard]] Scalar limit(std::size_t i,
                             const std::array<Scalar, kStates + 1>& yu) const {
    using std::cos;
    using std::sin;
    const Normal<Scalar> n = normal_of(limits_[i], yu[kX], yu[kZ]);
    return yu[kW] * (n.x * cos(yu[kStates]) + n.z * sin(yu[kStates]));
  }
  [[nodiscard]] ocp::Bounds bounds(std::size_t) const {
    return {0.0, std::numeric_limits<double>::infinity()};
  }
};

/// Nothing depends on the place: p_x and p_z are constant.
class SteeredFalling : public Steered {
 public:
  static constexpr std::size_t kIgnorable = 2;
  using Forms = FallingForms<Body, double>;
  template <class Scalar>
  using Kept = Forms::Kept<Scalar>;
  using Steered::Steered;

  [[nodiscard]] Forms forms() const {
    return {scene_.body, scene_.gravity, rotation_per_length_};
  }
  template <class Scalar>
  [[nodiscard]] Kept<Scalar> kept(
      const std::array<Scalar, kStates + 1>& yu) const {
    return forms().kept(yu);
  }
  template <class Jet, class Scalar>
  [[nodiscard]] ocp::Rates<Jet, kStates> jets(
      const std::array<Scalar, kStates + 1>& yu) const {
    return forms().template jets<Jet>(yu);
  }
  template <class Jet, class Scalar>
  [[nodiscard]] ocp::Rates<Jet, kStates> rates_of(
      const Kept<Scalar>& at) const {
    return forms().template rates_of<Jet>(at);
  }
  template <class Scalar>
  [[nodiscard]] ocp::ByControl<Scalar> hamiltonian_by_control(
      const std::array<Scalar, 2 * kStates>& y, const Scalar& beta) const {
    return forms().hamiltonian_by_control(y, beta);
  }
};

/// β is a state, and how fast it turns the control, q = dβ/du.
class Turning : public Moving {
 public:
  static constexpr std::size_t kStates = 5;
  using Moving::Moving;

  template <class Scalar>
  [[nodiscard]] ocp::Rates<Scalar, kStates> rates(
      const std::array<Scalar, kStates + 1>& yu) const {
    const auto& [x, z, theta, w, beta, q] = yu;
    const auto [cost, f] = rolling_rates(x, z, theta, w, beta);
    return {cost, {f[kX], f[kZ], f[kTheta], f[kW], q}};
  }
  template <class Jet, class Scalar>
  [[nodiscard]] ocp::Rates<Jet, kStates> jets(
      const std::array<Scalar, kStates + 1>& yu) const {
    if (!scene_.world.ordinary()) return rates(ocp::as_variables<Jet>(yu));
    const auto [x, z, theta, w, beta, q] = yu;
    const auto [cost, f] =
        FallingForms(scene_.body, scene_.gravity, rotation_per_length_)
            .template jets<Jet>(
                std::array<Scalar, kStates>{x, z, theta, w, beta});
    return {cost, {f[kX], f[kZ], f[kTheta], f[kW], Jet::variable(q, kStates)}};
  }
  template <class Scalar>
  [[nodiscard]] Scalar limit(std::size_t i,
                             const std::array<Scalar, kStates + 1>& yu) const {
    return value(limits_[i], yu);
  }
  /// Forces are found once for all limits that bound them.
  template <class Scalar, class Asked, class Put>
  void each_limit(const std::array<Scalar, kStates + 1>& yu, Asked&& asked,
                  Put&& put) const {
    const auto& [x, z, theta, w, beta, q] = yu;
    const TurningPoint<Scalar> place{x, z, theta, w, beta, q};
    std::optional<ContactForce<Scalar>> force;
    for (std::size_t i = 0; i < limits_.size(); ++i) {
      if (!asked(i)) {
        put(i, Scalar(0.0));
        continue;
      }
      if (limits_[i].bounds_force() && !force) force = force_at(place);
      put(i,
          value_of(limits_[i], force.value_or(ContactForce<Scalar>{}), place));
    }
  }
  /// Of any limit.
  template <class Scalar>
  [[nodiscard]] Scalar value(const PathInequality& limit,
                             const std::array<Scalar, kStates + 1>& yu) const {
    const auto& [x, z, theta, w, beta, q] = yu;
    return value_of(limit, scene_,
                    TurningPoint<Scalar>{x, z, theta, w, beta, q});
  }

 private:
  template <class Scalar>
  [[nodiscard]] ContactForce<Scalar> force_at(
      const TurningPoint<Scalar>& at) const {
    if constexpr (std::is_same_v<Scalar, math::Jet2<double, kStates + 1>>) {
      if (scene_.world.ordinary()) return force_anywhere(at);
    }
    return contact_force(scene_, at);
  }
  /// Where it does not depend on the place: with derivatives of the forms by θ
  /// and β alone.
  /// \pre the point is of variables
  template <class Jet>
  [[nodiscard, gnu::flatten]] ContactForce<Jet> force_anywhere(
      const TurningPoint<Jet>& at) const {
    using Two = math::Jet2<double, 2>;
    const auto forms = ForceForms<Two>::of(
        scene_, field_at(scene_, Two(at.x.value), Two(at.z.value)),
        Two::variable(at.theta.value, 0), Two::variable(at.beta.value, 1));
    const double w = at.w.value, q = at.q.value;
    constexpr std::array<int, 2> kBoth{kTheta, kBeta};
    constexpr int kQ = kStates;
    const auto all = [&](const Two& rest, const Two& ww, const Two& wq) {
      const Two sum = rest + ww * (w * w) + wq * (w * q);
      const Two by_w = ww * (2.0 * w) + wq * q;
      Jet out(sum.value);
      out.gradient[kW] = by_w.value;
      out.gradient[kQ] = w * wq.value;
      out.hessian[Jet::pair(kW, kW)] = 2.0 * ww.value;
      out.hessian[Jet::pair(kQ, kW)] = wq.value;
      for (int a = 0; a < 2; ++a) {
        const auto of = static_cast<std::size_t>(a);
        const int i = kBoth[of];
        out.gradient[static_cast<std::size_t>(i)] = sum.gradient[of];
        out.hessian[Jet::pair(std::max<int>(i, kW), std::min<int>(i, kW))] =
            by_w.gradient[of];
        out.hessian[Jet::pair(kQ, i)] = w * wq.gradient[of];
        for (int b = 0; b <= a; ++b) {
          out.hessian[Jet::pair(i, kBoth[static_cast<std::size_t>(b)])] =
              sum.hessian[Two::pair(a, b)];
        }
      }
      return out;
    };
    const auto& [at_rest, by_ww, by_wq, by_drag, per_A] = forms;
    return {all(at_rest.normal, by_ww.normal, by_wq.normal),
            all(at_rest.tangential, by_ww.tangential, by_wq.tangential)};
  }
};

static_assert(ocp::PointFunction<Steered> &&
              ocp::PointFunction<SteeredFalling> &&
              ocp::PointFunction<Turning>);

}  // namespace brachisto::rolling
