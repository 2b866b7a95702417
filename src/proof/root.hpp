// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Exactly one extremal in a box: Krawczyk's operator on the unknowns of
/// shooting.

#pragma once

#include <vector>

#include "proof/flow.hpp"

namespace brachisto::proof {

using Vector = std::vector<Real>;
using Matrix = std::vector<Vector>;

/// Of numbers near, of which some ten digits are enough.
inline constexpr Accuracy kRough{
    .bits = 96, .terms = 24, .share = 0.18, .near = true};

/// As many equations as unknowns, of one arc or of several: of each arc some
/// numbers at its start and its length, and others behind all arcs.
class ShootingSystem {
 public:
  virtual ~ShootingSystem() = default;

  struct Value {
    Vector missed;             ///< F
    Matrix slopes;             ///< F', if asked for
    std::vector<State> ends;   ///< of each arc, with derivatives if asked for
    std::vector<State> rates;  ///< there
    int steps = 0;
  };
  [[nodiscard]] virtual Value evaluate(const Vector& at,
                                       const Accuracy& accuracy,
                                       bool with_slopes) const = 0;

  /// Unknowns of each arc, the last of them its length.
  [[nodiscard]] virtual std::size_t per_arc() const = 0;

  /// ∂(component i at the end of an arc)/∂(number j at its start).
  [[nodiscard]] virtual Real slope(const State& end, std::size_t arc,
                                   std::size_t i, std::size_t j) const = 0;

  /// Of each unknown a power of two near its size, in which boxes are about as
  /// wide in all directions.
  [[nodiscard]] virtual std::vector<double> units() const = 0;

  /// Gives an approximation what it need not have.
  virtual void settle(Vector& /*near*/) const {}

  /// \throws NotProven  if the ends are none although the equations hold
  virtual void check_ends(const std::vector<State>& /*ends*/) const {}
};

/// What Krawczyk's operator has shown.
struct Root {
  Vector searched;          ///< X: exactly one root in it
  Vector found;             ///< the part of it that holds the root
  std::vector<State> ends;  ///< of each arc, of a mean value form
  int steps = 0;            ///< of one integration
};

/// From an approximation: Newton's method to the digits of the accuracy, and
/// Krawczyk's operator on a box about where that ends.
/// \throws NotProven
[[nodiscard]] Root find_root(const ShootingSystem& system, Vector near,
                             const Accuracy& accuracy);

/// Krawczyk's operator on a box X about m, with C near the inverse of F'(m):
///
///     K = m − C F(m) + (1 − C F'(X)) (X − m)  in the interior of X.
///
/// \throws NotProven  if it is not
[[nodiscard]] Root verify_root(const ShootingSystem& system, const Vector& box,
                               const Accuracy& accuracy);

/// A part of a box in which a root is, with that root.
[[nodiscard]] Vector narrowed(const ShootingSystem& system, const Vector& found,
                              const Accuracy& accuracy);

}  // namespace brachisto::proof
