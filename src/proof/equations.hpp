// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Hamilton's equations on one arc as a tape.

#pragma once

#include <array>
#include <vector>

#include "brachisto/model/scene.hpp"
#include "proof/hamilton.hpp"
#include "proof/tape.hpp"

namespace brachisto::proof {

/// In the units of in_own_units().
struct Equations {
  /// \param directions  in how many directions of the start derivatives are
  ///                    carried along; 0, 2, 3, 7, 8 or 10
  Equations(const Scene& scene, int directions, const Held& held = {});
  Equations(const Equations&) = delete;
  Equations& operator=(const Equations&) = delete;

  Tape tape;
  int directions;
  /// Rates of the components, then of their derivatives, direction by
  /// direction.
  std::vector<Node> rates;
  /// Without directions alone: h_ββ, R_n per m g, and w − r β', which is
  /// w (1 − r κ_c), of a bead 1.
  Node legendre = Node::none(), normal = Node::none(), unfolded = Node::none();
  Node tangential = Node::none();  ///< R_t per m g
  Node multiplier = Node::none();  ///< of the limit that holds
  Node height = Node::none();      ///< above the surface of the field
  std::vector<Node> limits;        ///< values of all

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

/// Whether its world, its limits and its contacts are those of the paper, for
/// which there are units of their own.
[[nodiscard]] bool is_plain(const Scene& scene);

/// Of a plain scene everything is in units of r (of a bead: of metres) and with
/// 2 g = 1, which makes dθ/ds = 1 and leaves η, k and θ_m, numbers of 64 bits,
/// as they are; what these do not need is left out. Other scenes have fields
/// and limits with lengths of their own, which stay what they are: SI. The
/// field has the law of the side of its surface on which the path starts.
[[nodiscard]] Scene in_own_units(const Scene& scene);

/// √A, or its square, at a slope.
[[nodiscard]] Real inertia_root(const Scene& scene, const Real& theta,
                                const Real& beta);

}  // namespace brachisto::proof
