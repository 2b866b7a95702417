// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What the certificates of all solutions have in common.

#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "model/contact.hpp"
#include "model/hamiltonian.hpp"
#include "trajectory/certify.hpp"

namespace brachisto {

inline constexpr double kUnmeasured = std::numeric_limits<double>::quiet_NaN();
inline constexpr CertificateThresholds kThresholds;

/// The largest of values that belong to places of the path, σ or the number of
/// a piece; a NaN is larger.
struct Largest {
  double value = 0.0;
  double place = 0.0;

  void see(double candidate, double at) {
    if (std::isnan(value) || candidate <= value) return;
    value = candidate;
    place = at;
  }
  [[nodiscard]] std::string where() const {
    return fmt::format("σ = {:.6g}", place);
  }
};

inline constexpr Largest kBelowAll{-std::numeric_limits<double>::infinity(),
                                   0.0};

/// What an extremal keeps of its costates in a field that may be turned about
/// O: p_z (x − x₀) − p_x (z − z₀) + p_θ.
[[nodiscard]] inline double turning_costate(Point O, Point centre,
                                            const Costates& p) {
  return p.p_z * (centre.x - O.x) - p.p_x * (centre.z - O.z) + p.p_theta;
}
/// By what its changes are measured, of a path that takes T.
[[nodiscard]] inline double turning_scale(Point O, double T) {
  return T * std::max(1.0, std::hypot(O.x, O.z));
}

/// How far the ends of the track are from A and B, or with Contact::Centre how
/// far the ends of the centre's path are, in the units of the scene.
/// \param rounding  what that cannot fall below
inline void check_contact(const Scene& scene, Point start, double beta_0,
                          Point end, double beta_end, double rounding,
                          Certificate& certificate) {
  const double r = contact_radius(scene);
  const Point first = track_below(start, r, beta_0);
  const Point last = track_below(end, r, beta_end);
  const double at_A = std::hypot(first.x, first.z);
  const double at_B = std::hypot(last.x - scene.L, last.z - scene.H);
  // The larger of two may not be the one that is no number.
  certificate.add("contact_error",
                  std::isnan(at_A + at_B) ? kUnmeasured : std::max(at_A, at_B),
                  std::max(kThresholds.contact_error, rounding));
}

}  // namespace brachisto
