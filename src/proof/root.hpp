// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Exactly one smooth-contact extremal in a box: Krawczyk's operator on the
/// unknowns of shooting.

#pragma once

#include <string>

#include "proof/flow.hpp"
#include "proof/linear.hpp"

namespace brachisto::proof {

/// p_x, p_z, p_θ(0) and U, in the units of Equations.
inline constexpr std::size_t kUnknowns = 4;
using Unknowns = Vector;

/// Why nothing is proven of a scene at all; "" if it may be tried.
[[nodiscard]] std::string not_of_this_kind(const Scene& scene);

/// What an extremal has to satisfy where it ends: x, z, p_θ = 0 and p_w = 0.
class Ends {
 public:
  /// \throws NotProven  if the start angle cannot be enclosed
  explicit Ends(const Scene& scene);

  /// β₀, enclosed.
  [[nodiscard]] const Real& start_angle() const { return beta_; }
  /// The state that an extremal leaves from, and in three directions its
  /// derivatives by p_x, p_z and p_θ(0), which are the directions themselves.
  [[nodiscard]] State start(const Unknowns& unknowns, int directions) const;
  [[nodiscard]] Unknowns missed(const State& end) const;
  /// Their derivatives by the unknowns.
  /// \param rates  of the components at the end
  [[nodiscard]] Matrix slopes(const State& end, const State& rates) const;
  /// x of the centre there.
  [[nodiscard]] Real start_place() const { return Real(radius_) * sin(beta_); }
  /// A length in these units: r, or of a bead metres.
  [[nodiscard]] Real unit() const;

 private:
  Scene scene_;
  Real beta_, p_w_;
  double radius_;  ///< of the circle about A and B, in own units: 1 or 0
};

/// The unknowns near an extremal of numbers of 64 bits.
/// \throws NotProven  if there is none
[[nodiscard]] Unknowns approximation(const Scene& scene);

/// What Krawczyk's operator has shown.
struct Root {
  Unknowns searched;  ///< X: exactly one root in it
  Unknowns found;     ///< the part of it that holds the root
  State end;          ///< where that ends, of a mean value form
  int steps = 0;      ///< of one integration
};

/// From an approximation: Newton's method to the digits of the accuracy, and
/// Krawczyk's operator on a box about where that ends.
/// \throws NotProven
[[nodiscard]] Root find_root(const Scene& scene, const Unknowns& near,
                             const Accuracy& accuracy);

/// Krawczyk's operator on a box X:
///
///     K = m − C F(m) + (1 − C F'(X)) (X − m)  in the interior of X.
///
/// \throws NotProven  if it is not
[[nodiscard]] Root verify_root(const Scene& scene, const Unknowns& box,
                               const Accuracy& accuracy);

/// A part of a box in which a root is, with that root.
[[nodiscard]] Unknowns narrowed(const Scene& scene, const Unknowns& found,
                                const Accuracy& accuracy);

}  // namespace brachisto::proof
