// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Hamilton's equations in the rolling time, and their exact linearisation.

#pragma once

#include <array>

#include "brachisto/model/body.hpp"
#include "brachisto/model/hamiltonian.hpp"

namespace brachisto::shooting {

/// Order of the states and costates; everything is in natural units.
enum Component : std::size_t { kX, kZ, kTheta, kW, kPTheta, kPW, kStates };
using State = std::array<double, kStates>;

/// The numbers that the equations depend on.
struct FlowParameters {
  double p_x = 0.0, p_z = 0.0, eta = 0.0;
};

/// The right-hand side (f, −∂𝓗/∂y) with β eliminated by ∂𝓗/∂β = 0.
class CanonicalFlow {
 public:
  /// A bead gets 1/r = 1, which turns its θ into the arc length s; nothing
  /// depends on it.
  CanonicalFlow(const Body& body, double gravity,
                const FlowParameters& parameters);

  /// The slope at one state and all that depends on it. R = √A(δ, η) with
  /// δ = θ − β; p_s and p_n are (p_x, p_z) along and across the slope.
  struct Slope {
    double beta, sin_beta, cos_beta, sin_theta, cos_theta;
    double R, R_d, R_dd, R_eta, R_d_eta;
    double p_s, p_n;
    double legendre;  ///< ∂²𝓗/∂β²
  };

  /// Finds the minimum of 𝓗 nearest to the slope angle `near`; false if there
  /// is none.
  [[nodiscard]] bool find_slope(const State& y, double near,
                                Slope& slope) const;

  [[nodiscard]] State rates(const State& y, const Slope& slope) const;

  /// Rates of a variation v of the state with a variation of the parameters.
  [[nodiscard]] State variation_rates(const State& y, const Slope& slope,
                                      const State& v,
                                      const FlowParameters& dp) const;
  /// The change of β with a variation.
  [[nodiscard]] double slope_variation(const State& y, const Slope& slope,
                                       const State& v,
                                       const FlowParameters& dp) const;

  [[nodiscard]] double inverse_radius() const { return inverse_radius_; }

 private:
  Body body_;
  double g_;
  double inverse_radius_;
  FlowParameters parameters_;
};

/// 1/r, or 1 for a bead.
[[nodiscard]] double inverse_radius(const Body& body);

}  // namespace brachisto::shooting
