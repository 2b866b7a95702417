// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Hamilton's equations of a free scene as a tape, from the one text of its
/// rates.

#pragma once

#include <array>
#include <vector>

#include "brachisto/model/scene.hpp"
#include "proof/tape.hpp"

namespace brachisto::proof {

/// Order of what is integrated. Nothing depends on x, z, t or s.
enum Component : std::size_t {
  kX,
  kZ,
  kTheta,
  kW,
  kPx,
  kPz,
  kPtheta,
  kPw,
  kBeta,
  kTime,
  kLength,
  kComponents
};

/// Everything in units of r (a bead: of metres) and with 2 g = 1, which makes
/// dθ/ds = 1 and leaves η, k and θ_m, numbers of 64 bits, as they are.
struct Equations {
  /// \param directions  in how many directions of the start derivatives are
  ///                    carried along; 0, 2 or 3
  Equations(const Scene& scene, int directions);
  Equations(const Equations&) = delete;
  Equations& operator=(const Equations&) = delete;

  Tape tape;
  int directions;
  /// Rates of the components, then of their derivatives, direction by
  /// direction.
  std::vector<Node> rates;
  /// Without directions alone: h_ββ, R_n per m g, and w − r β', which is
  /// w (1 − r κ_c).
  Node legendre = Node::none(), normal = Node::none(), unfolded = Node::none();
  Node tangential = Node::none();  ///< R_t per m g

  [[nodiscard]] std::size_t size() const { return rates.size(); }
  /// Where a derivative stands.
  [[nodiscard]] static std::size_t place(std::size_t component,
                                         std::size_t direction) {
    return kComponents * (1 + direction) + component;
  }
};

/// 𝓗 as a function of the slope, which need not be the extremal's: its value
/// and its second derivative.
struct SlopeFunction {
  explicit SlopeFunction(const Scene& scene);
  SlopeFunction(const SlopeFunction&) = delete;
  SlopeFunction& operator=(const SlopeFunction&) = delete;

  /// \param y  components up to and with β
  [[nodiscard]] std::array<Real, 2> operator()(
      const std::vector<Real>& y) const;

  Tape tape;
  Node value = Node::none(), bend = Node::none();
};

/// The scene in these units, without what they do not need.
[[nodiscard]] Scene in_own_units(const Scene& scene);

/// √A, or its square, at a slope.
[[nodiscard]] Real inertia_root(const Scene& scene, const Real& theta,
                                const Real& beta);

}  // namespace brachisto::proof
