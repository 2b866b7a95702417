// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The equations of an extremal of a plain scene: one arc from rest, where all
/// but three costates is known.

#pragma once

#include <string>

#include "proof/root.hpp"

namespace brachisto::proof {

/// p_x, p_z, p_θ(0) and U, in the units of Equations.
inline constexpr std::size_t kUnknowns = 4;

/// Why nothing is proven of a scene at all; "" if it may be tried.
[[nodiscard]] std::string not_of_this_kind(const Scene& scene);

/// What an extremal has to satisfy where it ends: x, z, p_θ = 0 and p_w = 0.
class PlainSystem final : public ShootingSystem {
 public:
  /// \throws NotProven  if the start angle cannot be enclosed
  explicit PlainSystem(const Scene& scene);

  [[nodiscard]] const Scene& scene() const { return scene_; }

  [[nodiscard]] Value evaluate(const Vector& at, const Accuracy& accuracy,
                               bool with_slopes) const override;
  [[nodiscard]] std::size_t per_arc() const override { return kUnknowns; }
  [[nodiscard]] Real slope(const State& end, std::size_t /*arc*/, std::size_t i,
                           std::size_t j) const override {
    return end[Equations::place(i, j)];
  }
  [[nodiscard]] std::vector<double> units() const override {
    return std::vector<double>(kUnknowns, 1.0);
  }

  /// β₀, enclosed.
  [[nodiscard]] const Real& start_angle() const { return beta_; }
  /// The state that an extremal leaves from, and in three directions its
  /// derivatives by p_x, p_z and p_θ(0), which are the directions themselves.
  [[nodiscard]] State start(const Vector& unknowns, int directions) const;
  [[nodiscard]] Vector missed(const State& end) const;
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
[[nodiscard]] Vector approximation(const Scene& scene);

}  // namespace brachisto::proof
