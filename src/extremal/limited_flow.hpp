// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Hamilton's equations under limits, on one arc.

#pragma once

#include <array>
#include <optional>

#include "brachisto/model/scene.hpp"
#include "math/jet1.hpp"
#include "model/path_inequality.hpp"

namespace brachisto::limited {

/// Order of states and costates; everything is in natural units.
enum Component : std::size_t {
  kX,
  kZ,
  kTheta,
  kW,
  kBeta,
  kPX,
  kPZ,
  kPTheta,
  kPW,
  kPBeta,
  kSize
};
inline constexpr std::size_t kStates = kPX;

template <class Scalar>
using Values = std::array<Scalar, kSize>;
using State = Values<double>;
/// Numbers with their derivatives by all components.
using Jet = math::Jet1<double, static_cast<int>(kSize)>;

/// dθ/ds as far as the motion depends on θ: 1/r, or 0 without an offset. A θ
/// that no row but its own knew would be all that Newton's method sees of a
/// guess whose program has none.
[[nodiscard]] double rotation_per_length(const Body& body);

/// A limit that holds at one of its bounds.
struct HeldLimit {
  PathInequality limit;
  double bound = 0.0;

  [[nodiscard]] bool at_upper() const { return bound == limit.upper; }
};

/// The motion and its costates along an arc, on which at most one limit c = b
/// holds, with multiplier ν per unit of u:
///
///     y' = f(y, q),   p' = −∂𝓗/∂y + ν ∂c/∂y,   p_β' = −∂𝓗/∂β + ν ∂c/∂β.
///
/// - Free: ∂𝓗/∂β = p_β = 0. They stay so with q from d/du ∂𝓗/∂β = 0.
/// - A limit of the control holds: q from c(y, q) = b, which is affine in q,
///   and ν = p_β/(∂c/∂q).
/// - A limit of the place holds: the path follows its boundary, q from
///   d²c/du² = 0, and p_β = ∂𝓗/∂β = 0, which ν keeps so.
///
/// What is constant along an arc has to be put right at its start; see
/// LimitedSystem. All derivatives are those of jets, of 𝓗 = √A + p·f and of
/// value_of().
class LimitedFlow {
 public:
  enum class Kind { Free, Control, Place };

  /// \param scene  in natural units
  LimitedFlow(const Scene& scene, std::optional<HeldLimit> held);

  [[nodiscard]] Kind kind() const { return kind_; }
  [[nodiscard]] const std::optional<HeldLimit>& held() const { return held_; }
  [[nodiscard]] double rotation_per_length() const {
    return rotation_per_length_;
  }

  /// What changes along the arc, per unit of u.
  template <class Scalar>
  struct Rates {
    Values<Scalar> y;
    Scalar t;   ///< √A
    Scalar nu;  ///< multiplier of the limit that holds
  };
  template <class Scalar>
  [[nodiscard]] Rates<Scalar> rates(const Values<Scalar>& y) const;

  /// dβ/du.
  template <class Scalar>
  [[nodiscard]] Scalar control(const Values<Scalar>& y) const;
  /// 𝓗 + p_β q, which is zero on an extremal.
  template <class Scalar>
  [[nodiscard]] Scalar hamiltonian(const Values<Scalar>& y) const;
  /// ∂𝓗/∂β.
  template <class Scalar>
  [[nodiscard]] Scalar slope_condition(const Values<Scalar>& y) const;
  /// ∂²𝓗/∂β².
  [[nodiscard]] double legendre(const State& y) const;
  /// The value of a limit along this arc, with its control.
  template <class Scalar>
  [[nodiscard]] Scalar value(const PathInequality& limit,
                             const Values<Scalar>& y) const;
  /// Its derivatives by the states.
  template <class Scalar>
  [[nodiscard]] std::array<Scalar, kStates> gradient(
      const PathInequality& limit, const Values<Scalar>& y) const;
  /// And by u, along the arc.
  template <class Scalar>
  [[nodiscard]] Scalar rate_of(const PathInequality& limit,
                               const Values<Scalar>& y) const;
  /// ∂c/∂q at a place of the arc.
  [[nodiscard]] double by_control(const PathInequality& limit,
                                  const State& y) const;

 private:
  template <class Scalar>
  struct Slopes;
  template <class Scalar>
  [[nodiscard]] Slopes<Scalar> slopes(const Values<Scalar>& y) const;
  template <class Scalar>
  [[nodiscard]] std::array<Scalar, kStates> state_rates(
      const Values<Scalar>& y) const;

  Body body_;
  double g_;
  double rotation_per_length_;
  std::optional<HeldLimit> held_;
  Kind kind_;
};

}  // namespace brachisto::limited
