// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Conditions at the two ends of an extremal.

#pragma once

#include <Eigen/Core>

#include "brachisto/model/scene.hpp"
#include "extremal/canonical_flow.hpp"

namespace brachisto::shooting {

/// The start: all is known there but p_θ.
struct InitialState {
  double x, z, theta, w, p_w;
  double beta;
  double dx_deta, dz_deta, dp_w_deta;  ///< derivatives by η
};

/// C_A(β₀), θ_m, w = 0, and p_w = −√A/(g a) from 𝓗 = 0.
///
/// \param natural  the scene, in natural units
/// \param eta      offset to use instead of the body's
[[nodiscard]] InitialState start_conditions(const Scene& natural, double eta);

/// Derivatives of C_B(φ) by φ; zero with Contact::Centre.
struct EndSlide {
  double dx_dphi, dz_dphi;
};
[[nodiscard]] EndSlide end_slide(const Scene& natural, double phi);

}  // namespace brachisto::shooting
