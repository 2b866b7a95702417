// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Conditions at the two ends of an extremal.

#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "extremal/arc_flow.hpp"
#include "model/contact.hpp"
#include "model/field.hpp"
#include "model/start_under_limits.hpp"

namespace brachisto::arcs {

/// How a path leaves A.
class Departure {
 public:
  enum class Kind {
    Free,     ///< with the slope that makes 𝓗 minimal
    Forced,   ///< along a limit on forces, from the border of the static cone
    Turning,  ///< along a limit of the curvature
  };

  /// \param natural  the scene, in natural units
  /// \param held     the limit that holds from A on
  /// \param near     a slope near the one at A [rad]
  /// \param corner   what is reached at A besides, by which the slope there is
  ///                 determined
  Departure(const Scene& natural, const std::optional<HeldLimit>& held,
            double near, const std::optional<HeldLimit>& corner = {});

  [[nodiscard]] Kind kind() const { return kind_; }
  /// Why this method does not know starts of the kind; empty if it does.
  [[nodiscard]] const std::string& refusal() const { return refusal_; }

  /// The rest is left after so much u by its series where the start is Forced:
  /// there the control is 0/0. With β and w right to the second order the
  /// states err by 1e-15.
  static constexpr double kLeftRest = 1e-5;
  /// States after that much or less, and no costates.
  [[nodiscard]] State left_rest(double u = kLeftRest) const;

  /// The slope with which A is touched. Where limits on forces hold at rest
  /// alone it is not that of a Free start: between both lies an arc along the
  /// limit, too short to tell.
  template <class Scalar>
  [[nodiscard]] Scalar contact_slope(const Values<Scalar>& v) const {
    return kind_ == Kind::Free && slope_ ? Scalar(*slope_) : v[kBeta];
  }
  /// Whether the contact keeps a limit at rest, whatever the slope behind it.
  [[nodiscard]] bool contact_keeps(const PathInequality& limit) const {
    return kind_ == Kind::Free && slope_ && limit.bounds_force();
  }
  /// What vanishes at the first node: states that are known, and p_β where β is
  /// a state that is not.
  template <class Scalar>
  [[nodiscard]] std::vector<Scalar> conditions(const Values<Scalar>& v) const;

 private:
  void leave_along(const HeldLimit& held);
  /// After so much u, by the series.
  template <class Scalar>
  [[nodiscard]] TurningPoint<Scalar> after(const Scalar& u) const;

  Scene scene_;
  Kind kind_ = Kind::Free;
  /// β₀, where the contact does not leave it to the path.
  std::optional<double> slope_;
  std::optional<HeldLimit> held_, corner_;
  // Where it is Forced, w = w₁ u + w₂ u²/2 + … and β = β₀ + β₁ u + β₂ u² + …
  double w_1_ = 0.0, w_2_ = 0.0;
  std::array<double, 2> rise_{};
  std::string refusal_;
};

/// Whether the slopes at A and B are free to turn about the contact.
[[nodiscard]] inline bool has_optimal_ends(const Scene& scene) {
  return scene.contact == Contact::Optimal && scene.body.rolls();
}

/// p_β, or where the slope is free to turn about the contact
/// p_β + r (p_x cos β + p_z sin β).
template <class Scalar>
[[nodiscard]] Scalar transversality(const Scene& scene,
                                    const Values<Scalar>& v) {
  using std::cos;
  using std::sin;
  if (!has_optimal_ends(scene)) return v[kPBeta];
  return v[kPBeta] + (v[kPX] * cos(v[kBeta]) + v[kPZ] * sin(v[kBeta])) *
                         Scalar(scene.body.radius);
}

/// How far the centre is from where it touches a place with the slope β: c −
/// P − r (sin β, −cos β).
template <class Scalar>
[[nodiscard]] std::vector<Scalar> off_place(const Scene& scene, Point place,
                                            const Values<Scalar>& v,
                                            const Scalar& beta) {
  using std::cos;
  using std::sin;
  const Scalar r(contact_radius(scene));
  return {v[kX] - sin(beta) * r - Scalar(place.x),
          v[kZ] + cos(beta) * r - Scalar(place.z)};
}

template <class Scalar>
TurningPoint<Scalar> Departure::after(const Scalar& u) const {
  const Scalar w = u * (u * (0.5 * w_2_) + Scalar(w_1_));
  const Scalar s = u * u * (u * (w_2_ / 6.0) + Scalar(0.5 * w_1_));
  const double slope = *slope_, r = contact_radius(scene_);
  return {s * std::cos(slope) + Scalar(r * std::sin(slope)),
          s * std::sin(slope) - Scalar(r * std::cos(slope)),
          s * rotation_per_length(scene_) + Scalar(scene_.body.theta_m),
          w,
          u * (u * rise_[1] + Scalar(rise_[0])) + Scalar(slope),
          u * (2.0 * rise_[1]) + Scalar(rise_[0])};
}

template <class Scalar>
std::vector<Scalar> Departure::conditions(const Values<Scalar>& v) const {
  using std::cos;
  std::vector<Scalar> out;
  if (kind_ == Kind::Forced) {
    const State rest = left_rest();
    for (std::size_t i = 0; i < kStates; ++i) {
      out.push_back(v[i] - Scalar(rest[i]));
    }
    return out;
  }
  const Body& body = scene_.body;
  out = off_place(scene_, {0.0, 0.0}, v, contact_slope(v));
  out.push_back(v[kTheta] - Scalar(body.theta_m));
  out.push_back(v[kW] - pushed_w(scene_, v[kBeta]));
  if (kind_ == Kind::Free) return out;
  if (slope_) {
    out.push_back(v[kBeta] - Scalar(*slope_));
    return out;
  }
  if (corner_) {
    const TurningPoint<Scalar> start =
        scene_.world.start_speed > 0.0
            ? with_control_at(
                  held_->limit, held_->bound, scene_,
                  TurningPoint<Scalar>{v[kX], v[kZ], v[kTheta], v[kW], v[kBeta],
                                       Scalar(0.0)})
            : resting_at(scene_, v[kBeta]);
    out.push_back(value_of(corner_->limit, scene_, start) -
                  Scalar(corner_->bound));
    return out;
  }
  out.push_back(transversality(scene_, v));
  if (has_optimal_ends(scene_) && scene_.world.start_speed > 0.0) {
    // w turns with the contact too.
    using On = math::Jet1<Scalar, 1>;
    out.back() +=
        v[kPW] * pushed_w(scene_, On::variable(v[kBeta], 0)).gradient[0];
  }
  return out;
}

/// What vanishes at B.
/// \param turns  whether β is a state there
template <class Scalar>
[[nodiscard]] std::vector<Scalar> end_conditions(const Scene& natural,
                                                 const Values<Scalar>& v,
                                                 bool turns) {
  std::vector<Scalar> out =
      off_place(natural, {natural.L, natural.H}, v, v[kBeta]);
  out.push_back(v[kPTheta]);
  out.push_back(v[kPW]);
  if (natural.contact == Contact::EndSlope) {
    out.push_back(v[kBeta] - Scalar(*natural.end_slope));
  } else if (turns || has_optimal_ends(natural)) {
    out.push_back(transversality(natural, v));
  }
  return out;
}

}  // namespace brachisto::arcs
